//! What a declaration costs the compiler grows with its length, or is refused with a reason.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::sync::LazyLock;
use std::time::{Duration, Instant};

use plm_compiler::compile;
use plm_compiler::token::Sources;

/// No declaration may take longer; these take a fraction of a second.
const LONGEST: Duration = Duration::from_secs(10);

/// The emitted text, or the codes of the errors.
fn compiled(text: &str) -> Result<String, Vec<&'static str>> {
    let began = Instant::now();
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let expansion = compile(&mut sources);
    let took = began.elapsed();
    assert!(took < LONGEST, "{took:?} for {} characters", text.len());
    let codes = expansion.diagnostics.iter().map(|diagnostic| diagnostic.code.id());
    let codes: Vec<_> = codes.filter(|code| code.starts_with('E')).collect();
    if expansion.diagnostics.has_errors() { Err(codes) } else { Ok(expansion.code.unwrap().text().clone()) }
}

/// A pendulum that is pushed by what some lines of `let` lead to.
fn pushed(first: &str, lines: impl Iterator<Item = String>, last: &str) -> String {
    let lines: Vec<String> = lines.collect();
    format!(
        "pub P {{
            param one: 1 = -0.5; param other: 1 = 0.25; {first} {}
            ground {{ port o: (0, 0) m; }}
            body arm {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }}
            revolute pin(ground.o, arm.o);
            force push(arm.o) {{ torque: {last}*1 N*m; }}
        }}",
        lines.join("\n")
    )
}

fn chain(count: usize) -> String {
    format!(
        "pub Chain {{
            gravity: 9.81 m/s^2; ground {{ port o: (0, 0) m; }}
            repeat i in 0..{count} {{ body b[i] {{ mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; port q: (1, 0) m; }} }}
            revolute first(ground.o, b[0].p);
            repeat i in 1..{count} {{ revolute r[i](b[i - 1].q, b[i].p); }}
        }}"
    )
}

#[test]
fn lets_on_lets_grow_linearly() {
    let text = |count: usize| {
        let line = |k: usize| format!("let a{k} = a{p}*a{p} + a{p};", p = k - 1);
        compiled(&pushed("let a0 = one;", (1..=count).map(line), &format!("a{count}"))).unwrap().len()
    };
    // Numbers of lines become longer too; of something quadratic it would be 5/3.
    let [some, twice, thrice] = [100, 200, 300].map(text);
    assert!(thrice - twice < (twice - some) * 14 / 10, "{some}, {twice}, {thrice}");
    text(600);
}

#[test]
fn products_of_products_stay_products() {
    let lines = |k: usize| {
        let p = k - 1;
        format!("let a{k} = a{p}*a{p}*b{p}; let b{k} = b{p}*b{p}*a{p};")
    };
    compiled(&pushed("let a0 = one; let b0 = other;", (1..=40).map(lines), "a40")).unwrap();
    let squares = |k: usize| format!("let a{k} = a{p}*a{p};", p = k - 1);
    compiled(&pushed("let a0 = sin(arm.angle) + other;", (1..=40).map(squares), "a40")).unwrap();
}

/// Text of an item by its number.
type Items<'a> = &'a dyn Fn(usize) -> String;

/// Time on a processor that this thread has had, where Linux tells it: what else runs does not count. Elsewhere the time of the clock.
fn time_of_thread() -> Duration {
    static BEGAN: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|told| told.split(' ').next()?.parse().ok());
    nanoseconds.map_or_else(|| BEGAN.elapsed(), Duration::from_nanos)
}

/// Eight times as many items take about eight times as long; what grows with the square of their number takes up to 64 times.
#[test]
fn many_items_cost_as_much_as_they_are_many() {
    let pinned = |items: String| {
        format!(
            "pub P {{ ground {{ port o: (0, 0) m; }}
                body arm {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; port p: (1, 0) m; }}
                revolute pin(ground.o, arm.o);
                {items}
            }}"
        )
    };
    let each = |count: usize, item: &dyn Fn(usize) -> String| pinned((0..count).map(item).collect());
    let cases: [(&str, Items); 8] = [
        ("wrong outputs", &|i| format!("output w{i} = arm.nope{i};\n")),
        ("wrong names", &|i| format!("let a{i} = 1; output w{i} = b{i};\n")),
        ("wrong rows", &|i| format!("constraint w{i}: arm.angle = nope{i};\n")),
        ("parts that are not known", &|i| format!("springs s{i}(ground.o, arm.o);\n")),
        ("squares in one sum", &|i| match i {
            0 => "let s0 = arm.x/1 m; output s = s1;\n".to_owned(),
            _ => format!("let s{i} = s{} + (arm.x/1 m + {i})^2;\n", i - 1),
        }),
        ("factors of one product", &|i| match i {
            0 => "let s0 = arm.x/1 m; output s = s1;\n".to_owned(),
            _ => format!("let s{i} = s{}*(arm.x/1 m + {i});\n", i - 1),
        }),
        ("springs", &|i| {
            format!(
                "ground {{ port g{i}: ({i}, 1) m; }} spring s{i}(ground.g{i}, arm.p) {{ stiffness: {i} N/m; damping: 1 N*s/m; }}\n"
            )
        }),
        ("requirements", &|i| format!("require r{i}: arm.angle < {i} rad + 9 rad;\n")),
    ];
    for (what, item) in cases {
        let time = |count: usize| {
            let text = each(count, item);
            let began = time_of_thread();
            let _ = compiled(&text);
            time_of_thread().saturating_sub(began).as_secs_f64()
        };
        let [some, many] = [150, 1200].map(|count| time(count).min(time(count)));
        assert!(many < 20.0 * some, "{what}: {some} s, and {many} s for eight times as many");
    }
}

/// Of each code so many are told that a person reads, and how many there are.
#[test]
fn of_many_mistakes_the_first_are_told_and_the_others_counted() {
    let wrong: Vec<String> = (0..250).map(|i| format!("output w{i} = nope{i};\n")).collect();
    let wrong = wrong.concat();
    let mut sources = Sources::new();
    sources.add_text("declaration", &format!("pub P {{ param late: kg = 1 m; {wrong} body b {{ mass: 1 kg; }} body c {{ inertia: 1 kg*m^2; }} }}"));
    let found = compile(&mut sources).diagnostics;
    let of = |code: &str| found.iter().filter(|one| one.code.id() == code).count();
    assert_eq!((of("E0201"), of("E0301"), of("E0401")), (100, 1, 2));
    let notes = found.iter().flat_map(|one| &one.notes);
    let counted: Vec<&str> =
        notes.map(|note| note.text.as_str()).filter(|note| note.contains("more")).collect();
    assert_eq!(counted, ["E0201 stands for 150 places more, which are not shown"]);
}

/// The function of a name, as lines.
fn lines_of<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
    let after = text.lines().skip_while(|line| !line.trim_start().starts_with(&format!("fn {name}(")));
    after.take_while(|line| *line != "            }").collect()
}

#[test]
fn what_repeats_itself_is_written_once_where_the_code_would_be_long() {
    let functions =
        ["motion", "pose", "to_chart", "phi", "phi_dot", "phi_q_entries", "min_norm", "linearised"];
    let [short, long, longer] = [20, 200, 400].map(|count| compiled(&chain(count)).unwrap());
    for name in functions {
        assert!(lines_of(&short, name).iter().all(|line| !line.trim_start().starts_with("for ")), "{name}");
        let [some, twice] = [&long, &longer].map(|text| lines_of(text, name).len());
        assert!(
            some > 5 && some < 600 && twice < some + 20,
            "{name}: {some} lines, {twice} for twice the bars"
        );
    }
}

#[test]
fn chains_grow_linearly() {
    // From 64 bodies on sums along the chain have names, and from 100 entries on tables are written in short.
    for (code, count) in [("rolled", 120), ("unrolled", 70)] {
        let [some, twice, thrice] = [1, 2, 3].map(|times| {
            let count = times * count;
            let ordered = chain(count).replace("gravity", &format!("code: {code}; gravity"));
            compiled(&ordered).unwrap().len()
        });
        assert!(thrice - twice < (twice - some) * 11 / 10, "{code}: {some}, {twice}, {thrice}");
    }
}

#[test]
fn mechanisms_of_too_many_coordinates_and_rows_are_refused() {
    let free = |count: usize| {
        let body = "body b[i] { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; }";
        format!("pub Free {{ repeat i in 0..{count} {{ {body} }} }}")
    };
    assert!(compiled(&free(300)).is_ok());
    // 3 coordinates a body and 2 rows a joint; 5000 may be.
    for text in [chain(1001), free(1667)] {
        assert_eq!(compiled(&text), Err(vec!["E0413"]));
    }
}

#[test]
fn too_many_repetitions_are_told_at_once() {
    let bodies = "repeat i in 0..5000 { body b[i] { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; } }";
    assert_eq!(compiled(&format!("pub P {{ {bodies} }}")), Err(vec!["E0413"]));
}

#[test]
fn rows_that_all_meet_each_other_are_refused() {
    let all = |count: usize| {
        let body = |i: usize| {
            let ports: Vec<String> = (0..count).map(|j| format!("port p{j}: ({j}, 0) m;")).collect();
            format!("body b{i} {{ mass: 1 kg; inertia: 1 kg*m^2; {} }}\n", ports.concat())
        };
        let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j)));
        let joints: Vec<String> =
            pairs.map(|(i, j)| format!("revolute r{i}_{j}(b{i}.p{j}, b{j}.p{i});\n")).collect();
        let bodies: Vec<String> = (0..count).map(body).collect();
        format!("pub All {{ {} {} }}", bodies.concat(), joints.concat())
    };
    assert_eq!(compiled(&all(25)), Err(vec!["E0413"]));
}

fn scissor_lift(stages: usize) -> String {
    let ports = "port lo: (-0.25, 0) m; port mid: (0, 0) m; port hi: (0.25, 0) m;";
    let at = "start x: 0.19 m; start y: (i + 0.5)*0.32 m;";
    format!(
        "pub Lift {{
            gravity: 9.81 m/s^2; ground {{ port o: (0, 0) m; }}
            repeat i in 0..{stages} {{
                body l[i] {{ mass: 1 kg; inertia: 0.02 kg*m^2; {ports} start angle: 40 deg; {at} }}
                body r[i] {{ mass: 1 kg; inertia: 0.02 kg*m^2; {ports} start angle: 140 deg; {at} }}
                revolute cross[i](l[i].mid, r[i].mid);
            }}
            repeat i in 1..{stages} {{ revolute left[i](r[i - 1].hi, l[i].lo); revolute right[i](l[i - 1].hi, r[i].lo); }}
            revolute foot(ground.o, l[0].lo); pin_slot slide(ground.o, r[0].lo);
        }}"
    )
}

/// Operations of a right-hand side, as the report counts them.
fn operations(text: &str) -> usize {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let report = compile(&mut sources).report.unwrap().to_string();
    let line = report.lines().find_map(|line| line.trim().strip_prefix("One right-hand side: ")).unwrap();
    line.split(|c: char| !c.is_ascii_digit()).filter_map(|number| number.parse::<usize>().ok()).sum()
}

#[test]
fn operations_grow_linearly_where_loops_hang_on_loops() {
    let [some, more, most] = [8, 16, 24].map(|stages| operations(&scissor_lift(stages)));
    assert_eq!(most - more, more - some, "{some}, {more}, {most}");
}

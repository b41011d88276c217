//! Malformed input never panics: declarations with tokens removed, doubled, swapped, replaced, or cut off.

use plm_compiler::diag::Diagnostics;
use plm_compiler::front::parse_and_resolve;
use plm_compiler::token::Sources;

use crate::random::Random;
use crate::token_texts::token_texts;

/// Declarations that use every rule of the grammar.
const SEEDS: [&str; 2] = [
    "/// Doc.
    crate = a::b; parts { part p(a: frame) { choice c: x | y = x; force on a: (1, 2) N; } }
    pub(crate) Name {
        gravity: 9.81 m/s^2; stabilisation: baumgarte(0.1 s); allow(W0002);
        param k: N*m/(rev/min) = -1e-3 N^1*m*min/(rev); input u: bar; let a = if not 1 < 2 and 3 >= 2 or 1 > 2 then t else 2 s;
        state q[0]: 1 = 0; rate q[0] = table(t, (0 s, 1), (1 s, 2))/1 s + max(1, 2)*1 Hz;
        ground { port o: (0, 0) m, axis: 30 deg; }
        repeat i in 0..=3 { body bar[i] { mass: 1 kg*(i + 1); inertia: 1 kg*m^2; centre: (0, 0) m; coordinates: absolute;
            drawing_angle: 20 deg; port a: (0.5, 0) m; port b: (1, 1) m, angle: 45 deg; start angle: 1 rev, locked; } }
        revolute first(ground.o, bar[0].a) { damping: 1 N*m*s/rad; drive: dot((1, 2), (3, 4))*1 N*m; }
        p push(bar[1].b) { c: y; }
        constraint row: bar[2].x - 1 m*sin(t*1 rad/s) = 0;
        output bar[1].angle in deg, tip = bar[2].a.position, first.force;
    }",
    "S { joint j(a: frame, b: frame) { pair: weld; param free: m; constraint x: cross(b.position - a.position, a.axis) = free;
            torque on b from a: -2 N*m*(b.angle - a.angle)/1 rad; output f = reaction(x); state p: Pa = 0; rate p = rate(free)*1 Pa/m; }
        ground { port o: (0, 0) m; } body m { mass: 2^3*1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; start x: 1 mm; }
        j one(ground.o, m.a) { free: 0.1 m; } output one.f in kN; }",
];

const SPARE: [&str; 24] = [
    "body", "part", "joint", "repeat", "if", "then", "i", "bar", "m", "N", "ground", "a", ".", ",", ";", ":",
    "=", "/", "^", "-", "<", "|", "#", "output",
];

fn spare(random: &mut Random) -> String {
    let brackets = ["(", ")", "[", "]", "{", "}"];
    let numbers = ["0", "1e999", "64", "0.5m", "4294967296"];
    let text = match random.below(8) {
        0 | 1 => random.one_of(&brackets),
        2 => random.one_of(&numbers),
        _ => random.one_of(&SPARE),
    };
    let is_joint = text.len() == 1 && random.below(2) == 0;
    format!("{text}{}", if is_joint { "" } else { " " })
}

fn disturb(tokens: &mut Vec<String>, random: &mut Random) {
    let (at, other) = (random.below(tokens.len()), random.below(tokens.len()));
    if tokens.is_empty() {
        return;
    }
    match random.below(7) {
        0 => drop(tokens.remove(at)),
        1 => tokens.insert(at, tokens[other].clone()),
        2 => tokens.swap(at, other),
        3 => tokens[at] = spare(random),
        4 => tokens.insert(at, spare(random)),
        5 if random.below(8) == 0 => tokens.truncate(at),
        _ => {
            let (first, last) = (at.min(other), at.max(other).min(at.min(other) + 12));
            let moved: Vec<String> = tokens[first..last].to_vec();
            let to = random.below(tokens.len());
            tokens.splice(to..to, moved);
        }
    }
}

#[test]
fn disturbed_declarations_never_panic() {
    for seed in 0..1500 {
        let mut random = Random(seed);
        let mut sink = Diagnostics::new();
        let mut tokens = token_texts(SEEDS[random.below(SEEDS.len())]);
        for _ in 0..=random.below(12) {
            disturb(&mut tokens, &mut random);
        }
        let mut disturbed = Sources::new();
        disturbed.add_text("declaration", &tokens.concat());
        let outcome = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            let model = parse_and_resolve(&mut disturbed, &mut sink);
            assert!(model.is_some() != sink.has_errors(), "a model or errors, not both or neither");
            sink.sorted().iter().map(|diagnostic| diagnostic.render(&disturbed).len()).sum::<usize>()
        }));
        assert!(outcome.is_ok(), "seed {seed}");
    }
}

#[test]
fn the_undisturbed_declarations_use_the_whole_grammar() {
    for text in SEEDS {
        let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
        sources.add_text("declaration", text);
        parse_and_resolve(&mut sources, &mut sink);
        sink.drop_hints();
        let messages: Vec<String> =
            sink.sorted().iter().map(|diagnostic| diagnostic.render(&sources)).collect();
        assert!(messages.is_empty(), "{}", messages.join("\n"));
    }
}

#[test]
fn deep_nesting_ends_in_an_error() {
    for (open, close) in [
        ("(", ")"),
        ("-", ""),
        ("if 1 < 2 then ", " else 0"),
        ("abs(", ")"),
        ("2^", ""),
        ("1 N*(", ")"),
        ("b[", "]"),
    ] {
        let text = format!("P {{ let a = {}1{}; }}", open.repeat(20_000), close.repeat(20_000));
        let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
        sources.add_text("declaration", &text);
        assert!(parse_and_resolve(&mut sources, &mut sink).is_none());
        assert!(sink.iter().any(|diagnostic| diagnostic.code.id() == "E0106"), "{open}");
    }
    let items = format!("P {{ {} {} }}", "repeat i in 0..1 {".repeat(20_000), "}".repeat(20_000));
    let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
    sources.add_text("declaration", &items);
    assert!(parse_and_resolve(&mut sources, &mut sink).is_none());
}

/// Runs the front end with little stack: rustc has 8 MB, tools that expand macros in threads of theirs 2 MB.
fn with_one_megabyte(text: String) -> Vec<&'static str> {
    let run = move || {
        let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
        sources.add_text("declaration", &text);
        parse_and_resolve(&mut sources, &mut sink);
        sink.iter().map(|diagnostic| diagnostic.code.id()).collect()
    };
    std::thread::Builder::new().stack_size(1 << 20).spawn(run).unwrap().join().unwrap()
}

#[test]
fn little_stack_is_enough() {
    let sum = format!("P {{ let a = 1{}; output b = a; }}", " + 1".repeat(20_000));
    assert!(with_one_megabyte(sum).is_empty());
    let ways = format!("P {{ let a = t{}; }}", ".x".repeat(20_000));
    assert_eq!(with_one_megabyte(ways), ["E0203"]);
    // Definitions that need the one below, through operators, functions, pairs and conditions.
    for form in ["@ + 1", "max(table(@, (0, 1), (1, 2)), 3)", "if @ < 1 then (@, 1).x else abs(2*(-@))"] {
        let line = |k: usize| format!("let n{k} = {};", form.replace('@', &format!("n{}", k + 1)));
        let chain: Vec<String> = (0..5000).map(line).collect();
        let found = with_one_megabyte(format!("P {{ {} let n5000 = 1; }}", chain.concat()));
        assert!(!found.is_empty() && found.iter().all(|code| *code == "E0106"), "{form}");
    }
    let deep = format!("P {{ let _a = {}1{}; }}", "max(1, (2*".repeat(30), "))".repeat(30));
    assert!(with_one_megabyte(deep).is_empty());
}

#[test]
fn few_lines_cannot_ask_for_millions_of_parts() {
    let part = |k: usize| format!("part p{k}(a: frame) {{ p{n} x(a); p{n} y(a); }}", n = k + 1);
    let parts: Vec<String> = (0..25).map(part).collect();
    let text = format!(
        "{} part p25(a: frame) {{ }} P {{ ground {{ port o: 0; }} p0 all(ground.o); }}",
        parts.concat()
    );
    assert_eq!(with_one_megabyte(text), ["E0413"]);
}

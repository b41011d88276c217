//! Bad input never panics the compiler: all of it, from tokens to emitted source, on declarations that were cut, shuffled,
//! doubled and mixed at random. The seed of a case is in every message.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

#[path = "../../../tests/support/random.rs"]
mod random;
#[path = "front/token_texts.rs"]
mod token_texts;

use std::fs;
use std::path::Path;

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::parse;
use plm_compiler::token::Sources;
use plm_compiler::{Expansion, compile, names_only, without_panic};
use proc_macro2::TokenStream;
use random::Random;
use token_texts::token_texts;

/// Disturbed declarations of one run.
const CASES: u64 = 3000;

/// Right declarations that reach every pass: loops, redundancy, drawing coordinates, states, inputs, parts, repetition, contact.
const RIGHT: [&str; 4] = [
    "pub FourBar {
        gravity: 9.81 m/s^2; stabilisation: baumgarte(0.1 s); param k: N*m/rad = 2 N*m/rad; input lift: N = 3 N;
        ground { port a: (0, 0) m; port d: (1, 0) m, angle: 30 deg; }
        body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.1, 0) m; port b: (0.1, 0) m; start angle: 60 deg, locked; start omega: 1 rad/s, locked; }
        body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (-0.5, 0) m; port c: (0.5, 0) m; start angle: 10 deg; }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (-0.3, 0) m; port c: (0.3, 0) m; start angle: 90 deg; }
        revolute drive(ground.a, crank.a) { stiffness: k; drive: 1 N*m*sin(2*pi*t*1 rad/s); }
        revolute pin(crank.b, coupler.b);
        revolute wrist(coupler.c, rocker.c);
        revolute pivot(ground.d, rocker.d);
        force push(coupler.c) { axes: body; y: lift; }
        spring cord(ground.a, coupler.c) { stiffness: 10 N/m; free_length: 0.2 m; }
        output drive.force, pin.force.x, crank.alpha, tip = coupler.c.position, seen = to_relative(coupler.c.position, (0, 0) m, crank.angle), rocker.angle in deg;
        observe all;
    }",
    "pub Rails {
        ground { port low: (0, 0) m; port high: (0, 1) m; }
        body slider { mass: 1 kg; inertia: 0.1 kg*m^2; centre: (0.1, 0) m; port low: (0, 0) m; port high: (0, 1) m; }
        body wheel { mass: 2 kg; inertia: 1 kg*m^2; coordinates: absolute; drawing_angle: 20 deg; port o: (0, 0) m; start vx: 1 m/s; }
        prismatic first(ground.low, slider.low) { damping: 1 N*s/m; }
        prismatic second(ground.high, slider.high);
        body cap { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0.1) m, angle: 10 deg; }
        pin_slot slot(slider.high, wheel.o) { stiffness: 3 N/m; }
        weld glue(wheel.o, cap.o);
        state level: 1 = 0.5; rate level = (1 - level)/(2 s) + rate(slider.x)/(1 m);
        output level, glue.torque, first.force;
        observe wheel, slot, slider.high;
    }",
    "pub Rope {
        gravity: 9.81 m/s^2; allow(W0001, W0002);
        joint hinge(a: frame, b: frame) { param d: N*m*s/rad = 0; let w = b.omega - a.omega; constraint x: a.x - b.x = 0; constraint y: a.y - b.y = 0; torque on b from a: -d*w; output force = reaction(x, y); }
        ground { port o: (0, 0) m; }
        repeat i in 0..3 { body bar[i] { mass: 1 kg*(i + 1); inertia: 0.01 kg*m^2; port a: (-0.1, 0) m; port b: (0.1, 0) m; start x: 0.1 m + i*0.2 m; } }
        hinge hook(ground.o, bar[0].a);
        repeat i in 1..3 { hinge pin[i](bar[i - 1].b, bar[i].a) { d: 0.1 N*m*s/rad; } }
        let length = norm(bar[2].b.position) / max(abs(bar[0].x), 1 mm);
        output length, hook.force, bar[1].y;
        repeat i in 0..2 { observe bar[i], pin[i + 1]; }
    }",
    "pub Walker {
        gravity: 9.81 m/s^2; impacts: newton; param e: 1 = 0.2; input grip: N = 4 N;
        part foot(sole: frame) { param mu: 1; unilateral gap: sole.y >= 0 { restitution: 0.1; } friction slip: rate(sole.x) within mu*reaction(gap) { static: 2*mu*reaction(gap) + 1 N; } output push = reaction(gap); }
        ground { port o: (0, 1) m; }
        body leg { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0.5) m; port b: (0, -0.5) m; start angle: 10 deg; }
        body toe { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0.2) m; port b: (0.1, -0.2) m; start x: 2 m; }
        revolute hip(ground.o, leg.a);
        foot left(leg.b) { mu: 0.3; }
        foot right(toe.b) { mu: 0.5; }
        unilateral knee: leg.angle <= 40 deg { restitution: e; }
        friction belt: rate(leg.angle) within -1 N*m .. 0.2 m*grip;
        output left.push, belt = reaction(belt), toe.ay;
        observe right, leg;
    }",
];

/// Declarations, right and wrong: those above, the caret tests, the example, the parts library.
fn corpus() -> Vec<Vec<String>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut texts: Vec<String> = Vec::new();
    for folder in ["tests/diagnostics", "examples", "parts"] {
        let mut files: Vec<_> =
            fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.retain(|file| file.extension().is_some_and(|extension| extension == "plm"));
        files.sort();
        texts.extend(files.iter().map(|file| fs::read_to_string(file).unwrap()));
    }
    // What compiles reaches the passes after the front end: it comes up as often as all that does not.
    let right = RIGHT.map(str::to_owned).into_iter().cycle().take(texts.len());
    let all = right.chain(texts).collect::<Vec<_>>();
    // Brackets without partners come by chance.
    let is_tree = |text: &&String| text.parse::<TokenStream>().is_ok();
    all.iter().filter(is_tree).map(|text| token_texts(text)).collect()
}

const NUMBERS: &[&str] =
    &["0", "0.1", "0.5", "0.9", "1", "2", "2.5", "3", "7", "90", "1e-308", "1e308", "1e999", "0.5m"];
const WORDS: &[&str] =
    &["body", "ground", "a", "b", "x", "m", "rad", "locked", "if", "let", "repeat", "force", "param"];
const MARKS: &[char] = &['.', ',', ';', ':', '=', '/', '*', '^', '-', '+', '<', '|', '#'];

const BRACKETS: &[&str] = &["(", ")", "[", "]", "{", "}"];

fn spare(random: &mut Random) -> String {
    let text = match random.below(6) {
        0 | 1 => *random.one_of(BRACKETS),
        2 => *random.one_of(NUMBERS),
        3 if random.below(2) == 0 => return random.one_of(MARKS).to_string(),
        3 => return format!("{} ", random.one_of(MARKS)),
        _ => *random.one_of(WORDS),
    };
    format!("{text} ")
}

fn is_end(token: &str) -> bool {
    token.trim_end() == ";"
}

/// What changes of one kind keep: a number stays a number, a name a name.
fn kind(token: &str) -> Option<bool> {
    let first = token.chars().next()?;
    (first == '_' || first.is_alphanumeric()).then_some(first.is_ascii_digit())
}

/// The token after the statement that a position stands in: after the next `;`.
fn end_of_statement(tokens: &[String], at: usize) -> usize {
    tokens[at..].iter().position(|token| is_end(token)).map_or(tokens.len(), |length| at + length + 1)
}

/// The first token of the statement that a position stands in.
fn start_of_statement(tokens: &[String], at: usize) -> usize {
    tokens[..at].iter().rposition(|token| is_end(token)).map_or(0, |before| before + 1)
}

/// Other values, or one statement less: what mostly passes the front end.
fn vary(tokens: &mut Vec<String>, random: &mut Random) {
    let numbers: Vec<usize> =
        (0..tokens.len()).filter(|&k| kind(&tokens[k]) == Some(true) && tokens[k].contains('.')).collect();
    for _ in 0..numbers.len().min(3) {
        let value = ["0.0", "0.1", "0.5", "0.9", "2.5", "1e-308", "1e300"][random.below(7)];
        tokens[*random.one_of(&numbers)] = format!("{value} ");
    }
    let (at, which) = (random.below(tokens.len()), random.below(4));
    if which == 0 && at > tokens.len() / 2 {
        tokens.drain(start_of_statement(tokens, at)..end_of_statement(tokens, at));
    }
}

/// One change: to single tokens, to numbers, to names, to whole statements.
fn disturb(tokens: &mut Vec<String>, corpus: &[Vec<String>], random: &mut Random) {
    if tokens.is_empty() {
        return;
    }
    let (at, other) = (random.below(tokens.len()), random.below(tokens.len()));
    let same_kind = |is_number: bool, from: usize| {
        let mut all = (from..tokens.len()).chain(0..from);
        all.find(|&k| kind(&tokens[k]) == Some(is_number)).unwrap_or(from)
    };
    match random.below(20) {
        0 => drop(tokens.remove(at)),
        1 => tokens.insert(at, tokens[other].clone()),
        2 => tokens.swap(at, other),
        3 => tokens[at] = spare(random),
        4 => tokens.insert(at, spare(random)),
        5 if random.below(8) == 0 => tokens.truncate(at),
        6..=10 => {
            let number = same_kind(true, at);
            tokens[number] = format!("{} ", random.one_of::<&str>(NUMBERS));
        }
        11 | 12 => {
            let (name, to) = (same_kind(false, at), same_kind(false, other));
            tokens[name] = tokens[to].clone();
        }
        13 | 14 => drop(tokens.drain(start_of_statement(tokens, at)..end_of_statement(tokens, at))),
        15 | 16 => {
            let statement = tokens[start_of_statement(tokens, at)..end_of_statement(tokens, at)].to_vec();
            let to = end_of_statement(tokens, other);
            tokens.splice(to..to, statement);
        }
        _ => {
            let foreign = random.one_of(corpus);
            let from = random.below(foreign.len());
            let tokens_in = foreign[from..(from + random.below(20)).min(foreign.len())].to_vec();
            tokens.splice(at..at, tokens_in);
        }
    }
}

/// What holds of every compilation.
fn examine(text: &str) -> Expansion {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let expansion = compile(&mut sources);
    let wrong = expansion.diagnostics.has_errors();
    assert_eq!(expansion.report.is_none(), wrong, "a report or an error, not both or neither");
    assert_eq!(expansion.oracle.is_none(), wrong, "an oracle or an error, not both or neither");
    assert!(expansion.code.is_some() || wrong, "neither code nor an error");
    let declaration = parse(sources.get(0).unwrap(), &mut Diagnostics::new());
    assert_eq!(expansion.code.is_some(), declaration.mechanism.is_some(), "what has a name has code");
    if let Some(code) = &expansion.code {
        // proc-macro2 reads it, or this panics.
        let emitted = token_texts(&code.text());
        let no_number = emitted.iter().find(|token| ["inf", "NaN"].contains(&token.trim_end()));
        assert!(no_number.is_none(), "`{}` is no literal of Rust", no_number.unwrap());
    }
    for diagnostic in expansion.diagnostics.sorted() {
        let anchor = diagnostic.anchor();
        assert_eq!(anchor.source, 0, "{} points nowhere in the declaration", diagnostic.code);
        assert!(anchor.first <= anchor.last, "{} points backwards", diagnostic.code);
        assert!(!diagnostic.render(&sources).is_empty());
        let message = diagnostic.message(&sources, &|span| Some(format!("token {}", span.first)));
        assert!(message.contains(&diagnostic.message), "{message}");
    }
    expansion
}

#[test]
fn disturbed_declarations_are_answered() {
    let corpus = corpus();
    let (mut whole, mut in_form) = (0, 0);
    for seed in 0..CASES {
        let mut random = Random(seed);
        let mut tokens = random.one_of(&corpus).clone();
        if random.below(3) == 0 {
            vary(&mut tokens, &mut random);
        } else {
            (0..=random.below(3)).for_each(|_| disturb(&mut tokens, &corpus, &mut random));
        }
        match without_panic(|| examine(&tokens.concat())) {
            Ok(found) => {
                let mut codes = found.diagnostics.iter().map(|diagnostic| diagnostic.code.id());
                whole += u64::from(found.report.is_some());
                in_form += u64::from(found.report.is_some() || codes.any(|code| code.starts_with("E05")));
            }
            Err(panic) => {
                panic!("seed {seed}: {panic}\n{}", tokens.concat());
            }
        }
    }
    println!("{CASES} declarations: {whole} compile, {in_form} reach the checks after the front end");
    // The cases are worth something only if enough of them pass the front end, and most do not.
    assert!(whole > CASES / 20 && in_form > CASES / 10 && in_form < CASES / 2, "{whole}, {in_form}");
}

#[test]
fn what_is_right_compiles_and_twice_the_same() {
    for text in RIGHT {
        let (one, two) = (examine(text), examine(text));
        let said: Vec<&str> = one.diagnostics.iter().map(|diagnostic| diagnostic.message.as_str()).collect();
        assert!(!one.diagnostics.has_errors(), "{said:?}");
        assert_eq!(one.code.map(|code| code.text()), two.code.map(|code| code.text()));
    }
}

/// The names of the emitted types, and the types of what can be read.
fn surface(code: &plm_compiler::Code) -> Vec<String> {
    let text = code.text();
    let lines = text.lines().map(str::trim);
    let is_public = |line: &&str| line.starts_with("pub ") && !line.starts_with("pub const");
    // How many rows and loops there are is not known without the joints, nor how implicit methods keep derivatives.
    let is_told = |line: &&str| {
        !["fn undetermined", "fn branches", "struct Augmented"].iter().any(|name| line.contains(name))
    };
    lines.filter(is_public).filter(is_told).map(str::to_owned).collect()
}

#[test]
fn after_errors_the_types_are_those_of_the_right_declaration() {
    for text in RIGHT {
        let mut sources = Sources::new();
        sources.add_text("declaration", text);
        let right = compile(&mut sources).code.unwrap();
        let stub = names_only(&mut sources).unwrap();
        assert_eq!(surface(&right), surface(&stub));
        assert!(surface(&stub).len() > 12, "{:?}", surface(&stub));
    }
}

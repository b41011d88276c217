//! What emitted code shows to people: its documentation; and that it is what rustc gets.
#![allow(clippy::unwrap_used, reason = "tests")]

use plm_compiler::token::Sources;
use plm_compiler::{Code, compile};
use proc_macro2::{TokenStream, TokenTree};

/// A crank with a loop, parameters of all kinds, and a condition.
const CRANK: &str = "
    /// A crank.
    pub Crank {
        /// Stiffness of the return spring.
        param stiffness: N*m/rad = 100 N*m/rad;
        param begin = 45 deg;
        param load: kg;
        param double: N*m/rad = 2*stiffness;
        param tiny: m = 1e-9 m;
        input road: m = 10 mm;
        ground { port o: (0, 0) m; port p: (2, 0) m; }
        body crank { mass: load; inertia: 1 kg*m^2; port o: (0, 0) m; port e: (1 m, tiny); start angle: begin, locked; }
        body rod { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (1.5, 0) m; start angle: 10 deg; }
        body rocker { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (1, 0) m; start angle: 80 deg; }
        revolute shaft(ground.o, crank.o) { drive: if road > crank.y then 1 N*m else 0 N*m; }
        revolute pin(crank.e, rod.a) { stiffness: double; }
        revolute wrist(rod.b, rocker.b) { stiffness: stiffness; }
        revolute pivot(ground.p, rocker.a);
    }";

fn emitted(text: &str) -> String {
    code(text).text()
}

fn code(text: &str) -> Code {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let expansion = compile(&mut sources);
    let messages: Vec<String> =
        expansion.diagnostics.sorted().iter().map(|diagnostic| diagnostic.render(&sources)).collect();
    assert!(messages.is_empty(), "{}", messages.join("\n"));
    expansion.code.unwrap()
}

#[test]
fn parameters_and_inputs_say_what_they_are_by_default() {
    let code = emitted(CRANK);
    for line in [
        "/// In N*m/rad; 100 N*m/rad by default.",
        "/// Parameter `begin`, rad; 45 deg by default.",
        "/// Parameter `load`, kg; it has no default.",
        "/// Parameter `double`, N*m/rad; `2*stiffness` by default.",
        "/// Parameter `tiny`, m; 1e-9 m by default.",
        "/// Input `road`, m; 0.01 m by default.",
    ] {
        assert!(code.lines().any(|found| found.trim() == line), "{line}");
    }
}

/// rustdoc shows a constant argument in the heading of an implementation by its source: the whole declaration.
#[test]
fn implementations_with_constant_arguments_are_hidden() {
    let mut seen = 0;
    for rung in ["loops", "absolute"] {
        let code = emitted(
            &CRANK.replacen("param", &format!("rung: {rung}; param"), 1).replace("/// Stiffness", "// "),
        );
        let lines: Vec<&str> = code.lines().map(str::trim).collect();
        for (above, line) in lines.iter().zip(&lines[1..]).filter(|(_, line)| line.starts_with("impl")) {
            let of_trait = line.rsplit_once(" for ").map_or("", |(of_trait, _)| of_trait);
            let arguments = of_trait.rsplit_once('<').map_or("", |(_, arguments)| arguments);
            let is_constant = |of: &str| of == "NQ" || of == "NC" || of.parse::<u32>().is_ok();
            if arguments.trim_end_matches('>').split(", ").any(is_constant) {
                seen += 1;
                assert!(above.starts_with("#[doc(hidden)]"), "{line}");
            }
        }
    }
    assert_eq!(seen, 4);
}

/// Every token, groups opened.
fn flat(stream: TokenStream, words: &mut Vec<String>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => {
                words.push(format!("{:?}", group.delimiter()));
                flat(group.stream(), words);
                words.pop_if(|last| last == ",");
                words.push("end".to_owned());
            }
            // Documentation is a raw string in tokens, and a plain one that was a comment.
            TokenTree::Literal(literal) => words.push(literal.to_string().trim_start_matches('r').to_owned()),
            other => words.push(other.to_string()),
        }
    }
}

#[test]
fn people_read_what_rustc_gets() {
    for rung in ["loops", "absolute"] {
        let code = code(&CRANK.replacen("param", &format!("rung: {rung}; param"), 1));
        let [mut shown, mut given] = [Vec::new(), Vec::new()];
        flat(code.text().parse().unwrap(), &mut shown);
        flat(code.tokens().unwrap(), &mut given);
        let differs = shown.iter().zip(&given).position(|(shown, given)| shown != given);
        let around = differs.map(|at| (&shown[at.saturating_sub(9)..=at], &given[at]));
        assert!(around.is_none() && shown.len() == given.len(), "{around:?}");
        assert!(shown.len() > 3000, "{}", shown.len());
    }
}

/// A mechanism may be called as anything that its code names, which then has another name for it.
#[test]
fn code_names_nothing_else_as_the_mechanism() {
    let mut seen = 0;
    for rung in ["loops", "absolute"] {
        let text = CRANK.replacen("param", &format!("rung: {rung}; param"), 1);
        let mut words = Vec::new();
        flat(code(&text).tokens().unwrap(), &mut words);
        let mut defined: Vec<&str> = words
            .windows(2)
            .filter(|two| ["struct", "trait", "enum"].contains(&two[0].as_str()))
            .map(|two| two[1].as_str())
            .collect();
        defined.extend([
            "Option", "Result", "Default", "Sim", "Method", "Real", "Scalar", "S", "T", "N", "K", "I", "NQ",
            "Assembly",
        ]);
        for name in defined.into_iter().filter(|name| *name != "Crank") {
            let code = emitted(&text.replace("pub Crank", &format!("pub {name}")));
            assert!(code.contains(&format!("use super::type_::{name} as Mechanism_;")), "{name}");
            seen += 1;
        }
        assert!(emitted(&text).contains("use super::type_::Crank;"));
    }
    assert!(seen > 30, "{seen}");
}

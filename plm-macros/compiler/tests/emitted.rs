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
    for formulation in ["loops", "absolute"] {
        let code = emitted(
            &CRANK
                .replacen("param", &format!("formulation: {formulation}; param"), 1)
                .replace("/// Stiffness", "// "),
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

/// A follower on a cam that rises by a power of its angle: from the third on accelerations do not jump where it begins.
/// The unit after the colon is the one that is shown; without it that of the default.
#[test]
fn a_parameter_is_shown_in_its_own_unit_or_in_that_of_its_default() {
    for (param, shown) in [
        ("speed: rad/s = 300 rev/min", "unit: \"rad/s\", factor: 1.0,"),
        ("speed: rev/min = 300 rev/min", "unit: \"rev/min\", factor: 0.10471975511965978,"),
        ("speed = 300 rev/min", "unit: \"rev/min\", factor: 0.10471975511965978,"),
        ("speed: rev/min = 10 rad/s", "unit: \"rev/min\", factor: 0.10471975511965978,"),
    ] {
        let wheel = "body wheel { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start omega: speed; }";
        let hub = "revolute hub(ground.o, wheel.o);";
        let code =
            emitted(&format!("pub P {{ param {param}; ground {{ port o: (0, 0) m; }} {wheel} {hub} }}"));
        assert!(code.contains(&format!("name: \"speed\", docs: \"\", {shown}")), "{param}");
    }
}

/// rustc says why there is no energy, and not that there is no such method.
#[test]
fn energies_ask_for_masses_where_a_body_has_none() {
    let wheel = |mass: &str| {
        let wheel = format!("body wheel {{ {mass} port o: (0, 0) m; }}");
        let code = emitted(&format!(
            "pub P {{ ground {{ port o: (0, 0) m; }} {wheel} revolute hub(ground.o, wheel.o); constraint turns: wheel.angle = 3 rad/s*t; }}"
        ));
        code.matches("HasMasses").count()
    };
    assert_eq!([wheel(""), wheel("mass: 1 kg; inertia: 1 kg*m^2;")], [2, 0]);
}

#[test]
fn a_condition_in_a_constraint_is_held_where_accelerations_jump() {
    for (power, held) in [(2, 1), (3, 0), (4, 0)] {
        let code = emitted(&format!(
            "pub Cam {{
                ground {{ port o: (0, 0) m; }}
                body cam {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start angle: -10 deg, locked; }}
                body follower {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }}
                revolute shaft(ground.o, cam.o);
                constraint rise: follower.y - (if cam.angle > 0 then 0.1 m*cam.angle^{power} else 0 m) = 0;
                constraint guide: follower.x = 0; constraint upright: follower.angle = 0;
            }}"
        ));
        let guards: Vec<&str> =
            code.lines().map(str::trim).filter(|line| line.starts_with("type Guards = ")).collect();
        assert!(guards.contains(&format!("type Guards = [S; {held}];").as_str()), "{power}: {guards:?}");
    }
}

/// What jumps is held and looked at as a guard; what only bends is looked at as a kink.
#[test]
fn forces_that_jump_have_guards_and_those_that_bend_have_kinks() {
    for (force, guards, kinks) in [
        ("if cart.x > 0 then 1 N else -1 N", 1, 0),
        ("if cart.x > 0.1 m then 3 N/m*cart.x else 0.3 N", 0, 1),
        ("if cart.x > 0.1 m then 3 N/m*cart.x else 0.4 N", 1, 0),
        ("if cart.vx > 2*t*1 m/s^2 then 1 N else -1 N", 1, 0),
        ("min(cart.x, 0.2 m)*1 N/m", 0, 1),
        ("max(cart.vx, cart.x*1 rad/s)*1 N*s/m", 0, 1),
        ("abs(cart.x - 0.1 m)*1 N/m", 0, 1),
        ("abs(cart.x)*1 N/m + max(cart.x, -cart.x)*1 N/m + min(cart.x, 1 m)*1 N/m", 0, 3),
        ("min(stiff, 2 N/m)*cart.x", 0, 0),
        ("stiff*cart.x^2/1 m", 0, 0),
    ] {
        let code = emitted(&format!(
            "pub Cart {{
                param stiff: N/m = 1 N/m;
                ground {{ port o: (0, 0) m; }}
                body cart {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }}
                prismatic rail(ground.o, cart.o);
                force push(cart.o) {{ x: {force} + 0*stiff*1 m; }}
            }}"
        ));
        let number = |before: &str| {
            let digits = code.split_once(before).map_or("0", |(_, after)| after);
            let end = digits.find(|digit: char| !digit.is_ascii_digit()).unwrap_or(digits.len());
            digits[..end].parse::<usize>().unwrap()
        };
        let found = (number("type Guards = [S; "), number("kinks: "));
        assert_eq!(found, (guards, kinks), "{force}");
    }
}

/// Positions, velocities, states of first order: in both formulations each entry of the rate is written once.
#[test]
fn rates_are_written_in_the_order_of_the_state() {
    for (formulation, length) in [("tree", 4), ("absolute", 8)] {
        let code = emitted(&format!(
            "pub Tank {{
                formulation: {formulation};
                state level: m = 1 m; rate level = -level/1 s;
                state heat: K = 300 K; rate heat = 1 K/s*level/1 m;
                ground {{ port o: (0, 0) m; }}
                body wheel {{ mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }}
                revolute shaft(ground.o, wheel.o) {{ drive: level*1 N; }}
            }}"
        ));
        let mut written: Vec<usize> = code
            .lines()
            .filter_map(|line| line.trim().strip_prefix("dx[")?.split_once("] = ")?.0.parse().ok())
            .collect();
        written.sort_unstable();
        assert_eq!(written, (0..length).collect::<Vec<_>>(), "{formulation}");
    }
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
    for formulation in ["loops", "absolute"] {
        let code = code(&CRANK.replacen("param", &format!("formulation: {formulation}; param"), 1));
        let [mut shown, mut given] = [Vec::new(), Vec::new()];
        flat(code.text().parse().unwrap(), &mut shown);
        flat(code.tokens(str::parse).unwrap(), &mut given);
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
    for formulation in ["loops", "absolute"] {
        let text = CRANK.replacen("param", &format!("formulation: {formulation}; param"), 1);
        let mut words = Vec::new();
        flat(code(&text).tokens(str::parse).unwrap(), &mut words);
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

//! What emitted code shows to people: its documentation.
#![allow(clippy::unwrap_used, reason = "tests")]

use plm_compiler::compile;
use plm_compiler::token::Sources;

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
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let expansion = compile(&mut sources);
    let messages: Vec<String> =
        expansion.diagnostics.sorted().iter().map(|diagnostic| diagnostic.render(&sources)).collect();
    assert!(messages.is_empty(), "{}", messages.join("\n"));
    expansion.code.unwrap().text()
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

/// A follower on a cam that rises by a power of its angle: from the third on accelerations do not jump where it begins.
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
            code.lines().map(str::trim).filter(|line| line.starts_with("type G = ")).collect();
        assert!(guards.contains(&format!("type G = [S; {held}];").as_str()), "{power}: {guards:?}");
    }
}

//! Operations of one right-hand side: what a scene costs may fall, not grow.

use plm_compiler::compile;
use plm_compiler::token::Sources;

use crate::scenes::{s1, s2, s5, s6};

#[test]
fn right_hand_sides_cost_no_more_than_committed() {
    // (scene, operations now, committed); a sine and cosine of one angle count as one.
    let table = [
        ("S1", s1::double_pendulum::OPERATIONS.total(), COMMITTED[0]),
        ("S2", s2::four_bar::OPERATIONS.total(), COMMITTED[1]),
        ("S6", s6::slider_crank::OPERATIONS.total(), COMMITTED[2]),
        ("S5", s5::andrews::OPERATIONS.total(), COMMITTED[3]),
    ];
    for (scene, now, committed) in table {
        assert!(now <= committed, "{scene}: {now} operations, {committed} committed");
        assert!(now + now / 20 >= committed, "{scene}: {now} operations: commit the new count");
    }
}

/// S1, S2, S6, S5. The side of a loop is a factor: an operation more in S5, and 62 instructions fewer in its step on a Cortex-M4F.
const COMMITTED: [u32; 4] = [30, 86, 60, 256];

#[test]
fn the_reactions_of_a_tree_cost_a_few_dozen_operations_more_than_its_motion() {
    let damped = include_str!("../../plm-macros/compiler/examples/double_pendulum.plm");
    let mut sources = Sources::new();
    sources.add_text("declaration", &damped.replace("damping: 1 N*m/(rev/min);", ""));
    let report = compile(&mut sources).report.unwrap();
    let reactions = report.functions.iter().find(|function| function.0 == "reactions").unwrap().1;
    let (motion, all) = (report.rate.total(), reactions.total());
    assert_eq!((motion, all), (30, 56), "operations of the motion, and with reactions");
}

/// A chain of so many uniform bars, 1 m and 1 kg in all.
fn chain(bars: u32, setting: &str) -> String {
    format!(
        "pub Chain {{
            {setting}
            gravity: 9.81 m/s^2;
            ground {{ port o: (0, 0) m; }}
            repeat i in 0..{bars} {{
                body bar[i] {{
                    mass: 1 kg / {bars}; inertia: 1 kg*m^2 / (12 * {bars}^3);
                    port a: (-0.5 / {bars}, 0) m; port b: (0.5 / {bars}, 0) m;
                    start x: (i + 0.5) / {bars} * 1 m;
                }}
            }}
            revolute pin[0](ground.o, bar[0].a);
            repeat i in 1..{bars} {{ revolute pin[i](bar[i-1].b, bar[i].a); }}
        }}"
    )
}

/// The right-hand side, and another function: per bar from 16 to 32 bars, and from 32 to 64.
fn grows_linearly(setting: &str, function: &str) {
    let counts = [16, 32, 64].map(|bars| {
        let mut sources = Sources::new();
        sources.add_text("declaration", &chain(bars, setting));
        let report = compile(&mut sources).report.unwrap();
        let other = report.functions.iter().find(|of| of.0 == function).unwrap().1;
        [report.rate.total(), other.total()]
    });
    for (k, name) in ["rate", function].into_iter().enumerate() {
        let [few, some, many] = counts.map(|of| of[k]);
        let (per_bar, later) = ((some - few) as f64 / 16.0, (many - some) as f64 / 32.0);
        assert!(
            (later / per_bar - 1.0).abs() < 0.02,
            "{setting} {name}: {few}, {some}, {many}: {per_bar} then {later} per bar"
        );
    }
}

#[test]
fn operations_grow_linearly_along_a_chain() {
    grows_linearly("", "reactions");
    grows_linearly("formulation: absolute;", "closing step");
}

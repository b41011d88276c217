//! The scenes in their order, and the formulations of each.

use plm::Rate;
use plm::runtime::{Ports, Vector};

use crate::arms::{arms_absolute, arms_tree};
use crate::measure::{Formulation, Line, Scene};
use crate::methods::every;
use crate::references;
use crate::scenes::{
    a01_absolute, a01_tree, car_axis_absolute, s1_absolute, s1_tree, s2_absolute, s2_loops, s3_absolute,
    s3_tree, s4_absolute, s4_loops, s5_absolute, s5_loops, s6_absolute, s6_loops,
};

/// All methods in the formulations of a scene, the least one first: the name of the formulation, and the mechanism that was declared for it.
macro_rules! formulations {
    ($($name:literal: $scene:ident::$module:ident::$mechanism:ident),+) => {
        |bench| {
            let mut lines: Vec<Line> = Vec::new();
            let mut variants = 0..;
            $({
                type Scene = $scene::$mechanism<f64>;
                check_names(bench.scene.id, <Scene as Ports>::OUTPUTS);
                let states = <<Scene as Rate>::X as Vector<f64>>::LEN;
                lines.extend(every(&Formulation {
                    bench,
                    mechanism: Scene::new(),
                    name: $name,
                    variant: variants.next().unwrap_or(0),
                    facts: facts($name, states, $scene::$module::OPERATIONS.total()),
                }));
            })+
            lines
        }
    };
}

fn facts(formulation: &str, states: usize, operations: u32) -> String {
    format!("{formulation} {operations} ({states} states)")
}

/// What a scene measures has to be what its reference holds.
fn check_names(scene: &str, outputs: &[(&str, &str)]) {
    let measured = outputs.iter().map(|(name, _)| *name);
    assert!(measured.eq(references::of(scene).into_iter().map(|(name, _)| name)), "{scene}: {outputs:?}");
}

const fn scene(
    id: &'static str,
    title: &'static str,
    until: f64,
    run: fn(&crate::Bench) -> Vec<Line>,
) -> Scene {
    Scene { id, title, facts: "", until, fewest_steps: 20, relative: false, hopeless: 0.1, run }
}

/// Every scene.
pub const SCENES: &[Scene] = &[
    Scene {
        facts: "2 bodies, 2 degrees of freedom. Later it is chaotic: to 10 s rounding grows to 1e-7.",
        ..scene(
            "S1",
            "double pendulum over 1 s",
            1.0,
            formulations!("tree": s1_tree::double_pendulum::DoublePendulum, "absolute": s1_absolute::double_pendulum::DoublePendulum),
        )
    },
    Scene {
        facts: "3 bodies, 1 loop, 1 degree of freedom.",
        ..scene(
            "S2",
            "four-bar linkage over 1 s",
            1.0,
            formulations!("loops": s2_loops::four_bar::FourBar, "absolute": s2_absolute::four_bar::FourBar),
        )
    },
    Scene {
        facts: "16 bodies, 16 degrees of freedom.",
        fewest_steps: 200,
        ..scene(
            "S3",
            "chain of 16 bars over 1 s",
            1.0,
            formulations!("tree": s3_tree::chain::Chain, "absolute": s3_absolute::chain::Chain),
        )
    },
    Scene {
        facts: "5 bodies, 2 loops, 1 degree of freedom; at 0.71 s, after the end, it lies flat.",
        ..scene(
            "S4",
            "ladder of two four-bars over 0.6 s",
            0.6,
            formulations!("loops": s4_loops::ladder::Ladder, "absolute": s4_absolute::ladder::Ladder),
        )
    },
    Scene {
        facts: "7 bodies, 3 loops, 1 degree of freedom; relative error of the seven angles of the IVP test set.",
        fewest_steps: 300,
        relative: true,
        ..scene(
            "S5",
            "Andrews' squeezing mechanism over 0.03 s",
            0.03,
            formulations!("loops": s5_loops::andrews::Andrews, "absolute": s5_absolute::andrews::Andrews),
        )
    },
    Scene {
        facts: "3 bodies, 1 loop, 1 degree of freedom.",
        fewest_steps: 50,
        ..scene(
            "S6",
            "slider-crank over 1 s",
            1.0,
            formulations!("loops": s6_loops::slider_crank::SliderCrank, "absolute": s6_absolute::slider_crank::SliderCrank),
        )
    },
    Scene {
        facts: "1 body, 1 degree of freedom, 4.2 periods.",
        fewest_steps: 100,
        ..scene(
            "A01",
            "simple pendulum over 10 s",
            10.0,
            formulations!("tree": a01_tree::pendulum::Pendulum, "absolute": a01_absolute::pendulum::Pendulum),
        )
    },
    Scene {
        facts: "1 body, 2 degrees of freedom, a wheel that moves; error of the ends of the axis.",
        fewest_steps: 100,
        ..scene(
            "car axis",
            "bumpy road over 3 s",
            3.0,
            formulations!("absolute": car_axis_absolute::car_axis::CarAxis),
        )
    },
    Scene {
        facts: "The manual's ConnectPlmHyd: 1 body, 10 states, jumps at known times, and a stop of 1e8 N/m; relative error.",
        fewest_steps: 8000,
        relative: true,
        ..scene(
            "arm",
            "arm on a hydraulic jack over 4 s",
            4.0,
            formulations!("tree": arms_tree::arm::Arm, "absolute": arms_absolute::arm::Arm),
        )
    },
    Scene {
        facts: "The manual's DoubleArm: 2 bodies, 20 states, two stops; relative error.",
        fewest_steps: 8000,
        relative: true,
        ..scene(
            "arms",
            "two arms on hydraulic jacks over 4 s",
            4.0,
            formulations!("tree": arms_tree::arms::Arms, "absolute": arms_absolute::arms::Arms),
        )
    },
];

//! The demos of single joints.

use plm::Stabilise;
use plm::view::Program;

use super::figure::Across::{Column, Time};
use super::figure::{Figure, curve, panel};
use super::{AT_START, Picture, Shown, USUAL, WIDE, run};
use crate::command::Command;
use crate::demos::plmemb01::Plmemb01;
use crate::demos::plmj00::Plmj00;
use crate::demos::plmpiv10::Plmpiv10;
use crate::demos::plmtra00::Plmtra00;
use crate::demos::plmtra10::Plmtra10;
use crate::demos::plmtrpi00::Plmtrpi00;

pub const PLMPIV10: Shown = Shown {
    demo: "PLMPIV10",
    section: "4.2.2.3",
    text: "An eccentric wheel on a driven pivot. It turns with 1000 rev/min after some 10 ms; the pivot carries the centrifugal \
           force. At the start, off the scale of the curves, it carries 700 N.",
    runs: || Ok(vec![run("from rest", Plmpiv10::new(), [0.3, 2e-4])?]),
    program: Command::new(|options| Program::new(Plmpiv10::new()).until(0.3).every(2e-4).with(options)),
    figures: &[Figure {
        number: 42,
        caption: "force in the rotary joint in both absolute directions",
        across: Time(0.3),
        panels: &[panel(
            "force",
            "N",
            &[curve("from rest", "pivot.force.x", "x"), curve("from rest", "pivot.force.y", "y")],
        )
        .within(-250.0, 150.0)],
    }],
    pictures: &[Picture {
        file: "plmpiv10.svg",
        caption: "The force on the pivot, 0.1 s after the start",
        shows: "t=0.1&forces=1&arrows=2",
        size: WIDE,
    }],
};

pub const PLMTRA00: Shown = Shown {
    demo: "PLMTRA00",
    section: "4.2.3.2",
    text: "Where the axis of a prismatic joint lies, in four cases.",
    runs: || {
        let case = |alpha1: f64, alpha2: f64| Plmtra00 {
            alpha1: alpha1.to_radians(),
            alpha2: alpha2.to_radians(),
            ..Plmtra00::new()
        };
        Ok(vec![
            run("Example 1", case(0.0, 0.0), AT_START)?,
            run("Example 2", case(0.0, -45.0), AT_START)?,
            run("Example 3", case(20.0, 0.0), AT_START)?,
            run("Example 4", case(-20.0, -45.0), AT_START)?,
        ])
    },
    program: Command::new(|options| Program::new(Plmtra00::new()).until(1.0).with(options)),
    figures: &[],
    pictures: &[
        Picture {
            file: "figure-52.svg",
            caption: "Figure 52: ALPHA1 = 0 deg, ALPHA2 = 0 deg",
            shows: "run=Example 1",
            size: USUAL,
        },
        Picture {
            file: "figure-53.svg",
            caption: "Figure 53: ALPHA1 = 0 deg, ALPHA2 = -45 deg",
            shows: "run=Example 2",
            size: USUAL,
        },
        Picture {
            file: "figure-54.svg",
            caption: "Figure 54: ALPHA1 = 20 deg, ALPHA2 = 0 deg",
            shows: "run=Example 3",
            size: USUAL,
        },
        Picture {
            file: "figure-55.svg",
            caption: "Figure 55: ALPHA1 = -20 deg, ALPHA2 = -45 deg",
            shows: "run=Example 4",
            size: USUAL,
        },
    ],
};

pub const PLMTRA10: Shown = Shown {
    demo: "PLMTRA10",
    section: "4.2.3.3",
    text: "A mass on four slopes, held by a spring on the driven prismatic joint.",
    runs: || {
        let slope = |degrees: f64| {
            run(
                &format!("{degrees} deg"),
                Plmtra10 { alpha: degrees.to_radians(), ..Plmtra10::new() },
                [1.0, 1e-3],
            )
        };
        [0.0, 30.0, 60.0, 90.0].into_iter().map(slope).collect()
    },
    program: Command::new(|options| Program::new(Plmtra10::new()).until(1.0).every(1e-3).with(options)),
    figures: &[Figure {
        number: 59,
        caption: "spring force for four slope angles",
        across: Time(1.0),
        panels: &[panel(
            "spring force",
            "N",
            &[
                curve("0 deg", "push", "0°"),
                curve("30 deg", "push", "30°"),
                curve("60 deg", "push", "60°"),
                curve("90 deg", "push", "90°"),
            ],
        )],
    }],
    pictures: &[Picture {
        file: "plmtra10.svg",
        caption: "The four slopes at the start",
        shows: "layout=side&zoom=0.7",
        size: [640, 480],
    }],
};

pub const PLMTRPI00: Shown = Shown {
    demo: "PLMTRPI00",
    section: "4.2.4.3",
    text: "A bar hangs on a pin in a slot; a torque of 100 N·m turns it to and fro, and the pin slides.",
    runs: || Ok(vec![run("4 s", Plmtrpi00::new(), [4.0, 2e-3])?]),
    program: Command::new(|options| Program::new(Plmtrpi00::new()).until(4.0).every(2e-3).with(options)),
    figures: &[Figure {
        number: 67,
        caption: "displacement of point A in the xy plane",
        across: Column("bar.a.position.x", "x", "m"),
        panels: &[panel("y", "m", &[curve("4 s", "bar.a.position.y", "A")])],
    }],
    pictures: &[Picture {
        file: "plmtrpi00.svg",
        caption: "The bar after 0.4 s, and the path of A",
        shows: "t=0.4&paths=bar.a",
        size: USUAL,
    }],
};

pub const PLMJ00: Shown = Shown {
    demo: "PLMJ00",
    section: "4.2.5.3",
    text: "An arm that a spring in a jack holds up. The stabilising run finds the force, 4086.32 N, and nothing moves.",
    runs: || Ok(vec![run("stabilised", Plmj00::new().stabilise()?.mechanism, AT_START)?]),
    program: Command::new(|options| Program::new(Plmj00::new()).until(2.0).every(2e-3).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "figure-73.svg",
        caption: "Figure 73: visualization of the model, at rest at 0 deg",
        shows: "",
        size: USUAL,
    }],
};

pub const PLMEMB01: Shown = Shown {
    demo: "PLMEMB01",
    section: "4.5.3",
    text: "The same arm with the jack on a second ground, at (-0.05, -0.25) m.",
    runs: || Ok(vec![run("stabilised", Plmemb01::new().stabilise()?.mechanism, AT_START)?]),
    program: Command::new(|options| Program::new(Plmemb01::new()).until(2.0).every(2e-3).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "figure-100.svg",
        caption: "Figure 100: example of the ground parameter settings",
        shows: "",
        size: USUAL,
    }],
};

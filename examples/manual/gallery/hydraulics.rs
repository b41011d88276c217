//! Arms on hydraulic jacks.

use plm::view::Program;

use super::figure::Across::Time;
use super::figure::{Figure, curve, panel};
use super::{Picture, Shown, USUAL, WIDE, run};
use crate::command::Command;
use crate::demos::connect_plm_hcd::{self, ConnectPlmHcd};
use crate::demos::connect_plm_hyd::{self, ConnectPlmHyd};
use crate::demos::double_arm::{self, DoubleArm};

/// The manual's final time and communication interval.
const CYCLE: [f64; 2] = [4.0, 0.005];
const RUN: &str = "stabilised, then 4 s";

pub const CONNECT_PLM_HYD: Shown = Shown {
    demo: "ConnectPlmHyd",
    section: "3.2.1",
    text: "An arm on a hydraulic jack with a servo-valve and two lines. The valve lets 20 L/min through at 0.5 bar, so that the jack \
           reaches its end stop, as the manual says. The diameters are those of Table 4, whose rod is wider than its piston.",
    runs: || Ok(vec![run(RUN, connect_plm_hyd::on_the_stop()?, CYCLE)?]),
    program: Command::new(|options| {
        Program::new(connect_plm_hyd::at_rest(&ConnectPlmHyd::new())?).until(4.0).every(0.005).with(options)
    }),
    figures: &[Figure {
        number: 20,
        caption: "servo-valve reference, cylinder position, cylinder pressures",
        across: Time(4.0),
        panels: &[
            panel("A/ reference", "", &[curve(RUN, "command.value", "reference")]),
            panel("B/ pressure 1", "bar", &[curve(RUN, "press.pressure1", "chamber 1")]),
            panel("C/ position", "m", &[curve(RUN, "ram.displacement", "jack")]),
            panel("D/ pressure 2", "bar", &[curve(RUN, "press.pressure2", "chamber 2")]),
        ],
    }],
    pictures: &[Picture {
        file: "connectplmhyd.svg",
        caption: "At rest at 20 deg, and the path of the tip",
        shows: "paths=arm.tip",
        size: USUAL,
    }],
};

/// As the arm of ConnectPlmHyd: its friction, its valve, its oil.
fn same_arm() -> ConnectPlmHcd {
    ConnectPlmHcd { friction: 1000.0, rated_drop: 0.5e5, gas: 0.001, ..ConnectPlmHcd::new() }
}

pub const CONNECT_PLM_HCD: Shown = Shown {
    demo: "ConnectPlmHCD",
    section: "3.2.2",
    text: "The same arm, its cylinder put together from pistons, volumes and an end stop; with the same valve and friction, the results are \
           the same.",
    runs: || Ok(vec![run(RUN, connect_plm_hcd::at_rest(&same_arm())?, CYCLE)?]),
    program: Command::new(|options| {
        Program::new(connect_plm_hcd::at_rest(&ConnectPlmHcd::new())?).until(4.0).every(0.005).with(options)
    }),
    figures: &[Figure {
        number: 22,
        caption: "servo-valve reference, cylinder position, cylinder pressures",
        across: Time(4.0),
        panels: &[
            panel("A/ reference", "", &[curve(RUN, "command.value", "reference")]),
            panel("B/ pressure 1", "bar", &[curve(RUN, "cap.pressure", "chamber 17")]),
            panel("C/ position", "m", &[curve(RUN, "ram.displacement", "jack")]),
            panel("D/ pressure 2", "bar", &[curve(RUN, "ring.pressure", "chamber 16")]),
        ],
    }],
    pictures: &[Picture {
        file: "connectplmhcd.svg",
        caption: "On the end stop, after 4 s",
        shows: "t=4",
        size: USUAL,
    }],
};

/// With the valves that the text names; with those of the demo a line comes below vacuum after 2.1 s.
fn arms() -> DoubleArm {
    DoubleArm { rated_drop: 1.5e5, ..DoubleArm::new() }
}

pub const DOUBLE_ARM: Shown = Shown {
    demo: "DoubleArm",
    section: "3.3",
    text: "A second arm slides along the first; each has a hydraulic cylinder. The valves let 20 L/min through at 1.5 bar: then the forces \
           end as the manual says.",
    runs: || Ok(vec![run(RUN, double_arm::at_rest(&arms())?, CYCLE)?]),
    program: Command::new(|options| {
        Program::new(double_arm::at_rest(&arms())?).until(4.0).every(0.005).with(options)
    }),
    figures: &[
        Figure {
            number: 29,
            caption: "servo-valve reference and jack displacement",
            across: Time(4.0),
            panels: &[
                panel("A/ reference", "", &[curve(RUN, "lower.value", "left valve")]),
                panel("B/ displacement", "m", &[curve(RUN, "ram.displacement", "left jack")]),
                panel("C/ reference", "", &[curve(RUN, "extend.value", "right valve")]),
                panel("D/ displacement", "m", &[curve(RUN, "guide.displacement", "right jack")]),
            ],
        },
        Figure {
            number: 30,
            caption: "jack pressures and force",
            across: Time(4.0),
            panels: &[
                panel(
                    "A/ left jack",
                    "bar",
                    &[curve(RUN, "left.pressure1", "chamber 1"), curve(RUN, "left.pressure2", "chamber 2")],
                ),
                panel(
                    "B/ right jack",
                    "bar",
                    &[curve(RUN, "right.pressure1", "chamber 1"), curve(RUN, "right.pressure2", "chamber 2")],
                ),
                panel("C/ left jack", "N", &[curve(RUN, "left.force", "force")]),
                panel("D/ right jack", "N", &[curve(RUN, "right.force", "force")]),
            ],
        },
    ],
    pictures: &[
        Picture { file: "doublearm.svg", caption: "At rest", shows: "", size: WIDE },
        Picture { file: "doublearm-end.svg", caption: "After 4 s", shows: "t=4", size: WIDE },
    ],
};

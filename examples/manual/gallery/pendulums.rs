//! Pendulums: single, double, drawn in several axes.

use plm::view::Program;

use super::figure::Across::Time;
use super::figure::{Figure, curve, panel};
use super::{AT_START, Picture, Shown, USUAL, WIDE, run};
use crate::command::Command;
use crate::demos::double_pendulum::DoublePendulum;
use crate::demos::plmassembly::Plmassembly;
use crate::demos::plmbod02::{Drawn, Relative};
use crate::demos::plmpiv00::Plmpiv00;

pub const DOUBLE_PENDULUM: Shown = Shown {
    demo: "DoublePendulum",
    section: "2.2 and 5.2",
    text: "Two bars on two damped pivots. Without locks assembly moves both to the nearest closed pose; with both angles locked the \
           centres follow.",
    runs: || {
        let mut free = DoublePendulum::new();
        free.start.arm.angle.locked = false;
        free.start.forearm.angle.locked = false;
        Ok(vec![
            run("without locks", free, AT_START)?,
            run("with locks", DoublePendulum::new(), AT_START)?,
            run("falling", DoublePendulum::new(), [40.0, 0.02])?,
        ])
    },
    program: Command::new(|options| {
        Program::new(DoublePendulum::new()).until(40.0).every(0.02).with(options)
    }),
    figures: &[
        Figure {
            number: 9,
            caption: "force in the grounded pivot joint in x and y direction",
            across: Time(40.0),
            panels: &[panel(
                "force",
                "N",
                &[curve("falling", "shoulder.force.x", "x"), curve("falling", "shoulder.force.y", "y")],
            )],
        },
        Figure {
            number: 10,
            caption: "force in the pivot joint connecting body 1 and 2 in x and y direction",
            across: Time(40.0),
            panels: &[panel(
                "force",
                "N",
                &[curve("falling", "elbow.force.x", "x"), curve("falling", "elbow.force.y", "y")],
            )],
        },
    ],
    pictures: &[
        Picture {
            file: "figure-06.svg",
            caption: "Figure 6: assembled without locks, at 68.19 and -25.76 deg",
            shows: "run=without locks",
            size: USUAL,
        },
        Picture {
            file: "figure-08.svg",
            caption: "Figure 8: the initial position, both angles locked",
            shows: "run=with locks",
            size: USUAL,
        },
        Picture {
            file: "figure-115.png",
            caption: "Figure 115: the whole tool",
            shows: "run=falling&curves=shoulder.force.x|shoulder.force.y&view=0,0,150,0.9,0.3,0",
            size: [960, 600],
        },
        Picture {
            file: "figure-118.svg",
            caption: "Figure 118: reduced and moved, so that the whole movement is seen; the path of the tip",
            shows: "run=falling&t=1.2&paths=forearm.G",
            size: USUAL,
        },
    ],
};

pub const PLMPIV00: Shown = Shown {
    demo: "PLMPIV00",
    section: "4.2.2.2",
    text: "A bar on a damped pivot, released horizontal.",
    runs: || Ok(vec![run("falling", Plmpiv00::new(), [10.0, 0.01])?]),
    program: Command::new(|options| Program::new(Plmpiv00::new()).every(0.01).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "plmpiv00.svg",
        caption: "0.3 s after the release",
        shows: "t=0.3&forces=1&velocities=1&arrows=0.4&zoom=0.7",
        size: WIDE,
    }],
};

pub const PLMBOD02: Shown = Shown {
    demo: "PLMBOD02",
    section: "4.3.5",
    text: "One pendulum in relative and in absolute coordinates. The axes of the body are drawn in orange.",
    runs: || {
        let drawn = |drawing: f64, start: f64| {
            let mut beam = Drawn { drawing: drawing.to_radians(), ..Drawn::new() };
            beam.start.beam.angle.value = start.to_radians();
            beam
        };
        Ok(vec![
            run("Example 1", Relative::new(), AT_START)?,
            run("Example 2", drawn(0.0, 0.0), AT_START)?,
            run("Example 3", drawn(20.0, 0.0), AT_START)?,
            run("Example 4", drawn(20.0, 45.0), AT_START)?,
        ])
    },
    program: Command::new(|options| Program::new(Drawn::new()).until(5.0).every(0.005).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "figure-91.svg",
        caption: "Figure 91: example of the relative and absolute coordinate system",
        shows: "layout=side&select=body:0&zoom=0.6",
        size: [640, 480],
    }],
};

pub const PLMASSEMBLY: Shown = Shown {
    demo: "PLMASSEMBLY",
    section: "4.4",
    text: "A pendulum with three locks, which cannot be assembled: two of them are too many. With the angle alone locked it can.",
    runs: || Ok(vec![run("one lock", one_lock(), [2.0, 0.005])?]),
    program: Command::new(|options| Program::new(one_lock()).until(2.0).every(0.005).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "plmassembly.svg",
        caption: "The start with one lock, and the path of the centre of gravity",
        shows: "paths=bob.G",
        size: WIDE,
    }],
};

fn one_lock() -> Plmassembly {
    let mut pendulum = Plmassembly::new();
    pendulum.start.bob.x.locked = false;
    pendulum.start.bob.y.locked = false;
    pendulum
}

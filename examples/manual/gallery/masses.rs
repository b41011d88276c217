//! Masses on springs of the joints and of the 1-D library.

use plm::Stabilise;
use plm::view::Program;

use super::figure::Across::Time;
use super::figure::{Figure, Panel, curve, panel};
use super::{Picture, Shown, USUAL, WIDE, run};
use crate::command::Command;
use crate::demos::plmt01d::Plmt01d;
use crate::demos::plmt01d01::Plmt01d01;
use crate::demos::prismatic_joint::{System1, Systems23};

/// The manual's final time and communication interval.
const SECOND: [f64; 2] = [1.0, 1e-3];

pub const PRISMATIC_JOINT: Shown = Shown {
    demo: "PrismaticJoint",
    section: "3.1",
    text: "A mass on a spring, three times: the spring in the joint, outside of it with a state, and outside without one. Only the one with \
           a state is held by the stabilising run.",
    runs: || {
        Ok(vec![
            run("System 1", System1::new(), SECOND)?,
            run("Systems 2 and 3", Systems23::new(), SECOND)?,
            run("System 1, stabilised", System1::new().stabilise()?.mechanism, SECOND)?,
            run("Systems 2 and 3, stabilised", Systems23::new().stabilise()?.mechanism, SECOND)?,
        ])
    },
    program: Command::new(|options| Program::new(Systems23::new()).until(1.0).every(1e-3).with(options)),
    figures: &[
        Figure {
            number: 13,
            caption: "body position; simulation done with no stabilising run",
            across: Time(1.0),
            panels: &HEIGHTS,
        },
        Figure {
            number: 14,
            caption: "body position; simulation done with stabilising run",
            across: Time(1.0),
            panels: &HEIGHTS_STABILISED,
        },
    ],
    pictures: &[Picture {
        file: "prismaticjoint.svg",
        caption: "Systems 2 and 3 at the start",
        shows: "run=Systems 2 and 3",
        size: USUAL,
    }],
};

const HEIGHTS: [Panel; 3] = [
    panel("System 1, y", "m", &[curve("System 1", "block.y", "body 1")]).within(0.965, 1.005),
    panel("System 2, y", "m", &[curve("Systems 2 and 3", "second.y", "body 2")]).within(0.965, 1.005),
    panel("System 3, y", "m", &[curve("Systems 2 and 3", "third.y", "body 3")]).within(0.965, 1.005),
];

const HEIGHTS_STABILISED: [Panel; 3] = [
    panel("System 1, y", "m", &[curve("System 1, stabilised", "block.y", "body 1")]).within(0.965, 1.005),
    panel("System 2, y", "m", &[curve("Systems 2 and 3, stabilised", "second.y", "body 2")])
        .within(0.965, 1.005),
    panel("System 3, y", "m", &[curve("Systems 2 and 3, stabilised", "third.y", "body 3")])
        .within(0.965, 1.005),
];

pub const PLMT01D: Shown = Shown {
    demo: "PLMT01D",
    section: "4.6.1",
    text: "A body that falls onto a spring of the 1-D library, which holds the port below by its y alone. Such springs are not drawn.",
    runs: || Ok(vec![run("falling", Plmt01d::new(), [0.5, 5e-4])?]),
    program: Command::new(|options| Program::new(Plmt01d::new()).until(0.5).every(5e-4).with(options)),
    figures: &[],
    pictures: &[Picture { file: "plmt01d.svg", caption: "The body at the start", shows: "", size: WIDE }],
};

pub const PLMT01D01: Shown = Shown {
    demo: "PLMT01D01",
    section: "4.6.2",
    text: "A 1-D mass carries a prismatic joint with a body that a force pushes.",
    runs: || Ok(vec![run("transient", Plmt01d01::new(), [0.2, 1e-4])?]),
    program: Command::new(|options| Program::new(Plmt01d01::new()).until(0.2).every(1e-4).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "plmt01d01.svg",
        caption: "The prismatic joint at the start",
        shows: "",
        size: WIDE,
    }],
};

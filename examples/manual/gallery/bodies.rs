//! Bodies: contours, many of them, axes of their own.

use plm::view::Program;

use super::{AT_START, Picture, Shown, USUAL, WIDE, run};
use crate::command::Command;
use crate::demos::plmcalcul::Plmcalcul;
use crate::demos::quadrorhomb::Quadrorhomb;

plm::mechanism! {
    /// A hook whose contour is a file, as in the manual's section 4.3.3; its points are our own, since those of Table 16 are
    /// a picture.
    pub Hook {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body hook {
            mass: 2 kg;
            inertia: 0.01 kg*m^2;
            centre: (0.01, -0.14) m;
            port eye: (0, 0) m;
            contour: "examples/manual/contours/hook.csv";
            start angle: 20 deg, locked;
        }
        revolute pin(ground.o, hook.eye) { pin_diameter: 24 mm; damping: 0.02 N*m*s/rad; }
        output hook.angle in deg, pin.force;
    }
}

pub const CONTOUR: Shown = Shown {
    demo: "Hook",
    section: "4.3.3",
    text: "A body whose [contour](language/bodies.md#pictures) is a file of points; those of the manual's Table 16 are a picture, these are \
           our own.",
    runs: || Ok(vec![run("swinging", Hook::new(), [4.0, 0.005])?]),
    program: Command::new(|options| Program::new(Hook::new()).until(4.0).every(0.005).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "figure-79.svg",
        caption: "Figure 79: example of the body contour facility",
        shows: "preset=isometric&zoom=1.3",
        size: USUAL,
    }],
};

pub const QUADRORHOMB: Shown = Shown {
    demo: "Quadrorhomb",
    section: "4.3.4",
    text: "13 bodies, 19 pivots, one degree of freedom; the geometry is our own, since the manual prints none. The crank turns with 1 rad/s \
           at the start.",
    runs: || {
        Ok(vec![
            run("start", Quadrorhomb::new(), AT_START)?,
            run("turning", Quadrorhomb::new(), [1.0, 0.01])?,
        ])
    },
    program: Command::new(|options| Program::new(Quadrorhomb::new()).until(1.0).every(0.01).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "figure-83.svg",
        caption: "Figure 83: the start, at which the angle and the speed of the horizontal bar are locked",
        shows: "select=body:0",
        size: WIDE,
    }],
};

pub const PLMCALCUL: Shown = Shown {
    demo: "PLMCALCUL",
    section: "4.8",
    text: "Points in relative and absolute axes: a plate stands at (1, 0.5) m, turned by 30 deg.",
    runs: || Ok(vec![run("fixed", Plmcalcul::new(), AT_START)?]),
    program: Command::new(|options| Program::new(Plmcalcul::new()).until(1.0).with(options)),
    figures: &[],
    pictures: &[Picture {
        file: "plmcalcul.svg",
        caption: "The plate with its axes and ports",
        shows: "select=body:0&zoom=0.75",
        size: WIDE,
    }],
};

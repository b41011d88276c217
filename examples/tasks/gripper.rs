//! How hard does a gripper press on a part, and which force of its cylinder keeps the part from slipping out?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A cylinder pulls a slide up, whose pins turn the fingers inwards; their pads hold the part from both sides.
    pub Gripper {
        param pull: N;
        gravity: 9.81 m/s^2;
        ground { port slide: (0, 0) mm, axis: 90 deg; port left: (-30, 0) mm; port right: (30, 0) mm; }
        body slide {
            mass: 0.3 kg; inertia: 1e-4 kg*m^2;
            port guide: (0, 0) mm, angle: 90 deg; port left: (-10, 0) mm; port right: (10, 0) mm;
        }
        body left {
            mass: 0.2 kg; inertia: 2e-4 kg*m^2; port pivot: (0, 0) mm; port pad: (10, -80) mm;
            start x: -30 mm;
        }
        body right {
            mass: 0.2 kg; inertia: 2e-4 kg*m^2; port pivot: (0, 0) mm; port pad: (-10, -80) mm;
            start x: 30 mm;
        }
        body part {
            mass: 1 kg; inertia: plate(1 kg, 40 mm, 60 mm);
            port left: (-20, 0) mm, angle: 90 deg; port right: (20, 0) mm, angle: -90 deg;
            start y: -80 mm;
        }
        prismatic cylinder(ground.slide, slide.guide) { drive: pull; }
        revolute left_pivot(ground.left, left.pivot);
        revolute right_pivot(ground.right, right.pivot);
        pin_slot left_slot(left.pivot, slide.left);
        pin_slot right_slot(right.pivot, slide.right);
        point_on_line left_pad(part.left, left.pad) { friction: 0.4; }
        point_on_line right_pad(part.right, right.pad) { friction: 0.4; }
        output left_pad.push, part.ay;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let strong = Gripper::new(150.0).start()?;
    let weak = Gripper::new(80.0).start()?;
    let (mut slips, mut holds) = (80.0, 150.0);
    for _ in 0..40 {
        let pull = 0.5 * (slips + holds);
        let falls = Gripper::new(pull).start()?.part_ay() < -1e-9;
        *(if falls { &mut slips } else { &mut holds }) = pull;
    }
    Ok(vec![
        Answer::new("a pad presses with, at 150 N", strong.left_pad_push(), "N"),
        Answer::new("the part is held from a pull of", holds, "N"),
        Answer::new("a pad presses with, at 80 N", weak.left_pad_push(), "N"),
        Answer::new("the part falls then with", -weak.part_ay(), "m/s^2"),
    ])
}

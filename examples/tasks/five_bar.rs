//! How must the two motors of a five-bar linkage turn, so that its pen draws a circle?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// The pen moves as it is told, and the motors follow: inverse kinematics.
    pub FiveBar {
        param period: s = 2 s;
        ground { port left: (-50, 0) mm; port right: (50, 0) mm; }
        body left_arm {
            port motor: (0, 0) mm; port elbow: (120, 0) mm; start angle: 120 deg; start x: -50 mm;
        }
        body right_arm {
            port motor: (0, 0) mm; port elbow: (120, 0) mm; start angle: 60 deg; start x: 50 mm;
        }
        body left_rod {
            port elbow: (0, 0) mm; port pen: (160, 0) mm;
            start angle: 45 deg; start x: -110 mm; start y: 104 mm;
        }
        body right_rod {
            port elbow: (0, 0) mm; port pen: (160, 0) mm;
            start angle: 135 deg; start x: 110 mm; start y: 104 mm;
        }
        revolute left_motor(ground.left, left_arm.motor);
        revolute right_motor(ground.right, right_arm.motor);
        revolute left_elbow(left_arm.elbow, left_rod.elbow);
        revolute right_elbow(right_arm.elbow, right_rod.elbow);
        revolute pen(left_rod.pen, right_rod.pen);
        constraint across: left_rod.pen.x = 40 mm*cos(2*pi*t/period);
        constraint up: left_rod.pen.y = 200 mm + 40 mm*sin(2*pi*t/period);
        output left_arm.alpha, right_arm.alpha;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = FiveBar::new().start()?;
    sim.step_to(0.3)?;
    let (left, right) = (sim.left_arm(), sim.right_arm());
    let mut fastest = 0.0_f64;
    let (angle, other) = (left.angle.to_degrees(), right.angle.to_degrees());
    let (gain, other_gain) = (sim.left_arm_alpha(), sim.right_arm_alpha());
    sim.reset()?;
    sim.run(2.0, 0.01, |state| fastest = fastest.max(state.left_arm().omega.abs()))?;
    Ok(vec![
        Answer::new("left motor at 0.3 s", angle, "deg"),
        Answer::new("right motor at 0.3 s", other, "deg"),
        Answer::new("left motor turns with", left.omega, "rad/s"),
        Answer::new("right motor turns with", right.omega, "rad/s"),
        Answer::new("left motor speeds up by", gain, "rad/s^2"),
        Answer::new("right motor speeds up by", other_gain, "rad/s^2"),
        Answer::new("left motor turns with at most", fastest, "rad/s"),
    ])
}

//! A six-bar as a declaration of the language.

use super::{Chain, Host, SixBar};
use crate::synthesis::four_bar::{Beside, Body};

impl SixBar {
    /// Declaration of the linkage, as [`FourBar::declaration`](crate::synthesis::FourBar::declaration): the dyad has the bodies `arm` and `swing`, and the
    /// arm's port `tracer` is the point, whose position is an output. Of [`Chain::StephensonTwo`] the point is the coupler's, and the
    /// link that turns is the crank in which the four-bar moves. `None` where a loop does not close at that angle.
    pub fn declaration(&self, name: &str, angle: f64) -> Option<String> {
        let pose = self.pose(angle)?;
        if self.chain == Chain::StephensonTwo {
            return Some(self.moving_text(name, &pose));
        }
        let [from, to, _] = pose.pins;
        let mut beside = Beside::default();
        let mut joints = Vec::new();
        let bars = [("shoulder", "arm", from), ("hinge", "swing", to)];
        for ((host, local), (joint, bar, place)) in self.chain.hosts().into_iter().zip(self.ends).zip(bars) {
            // The ground has no frame of its own in the text.
            let (index, link, port) = match host {
                Host::Ground => (0, "ground", place),
                Host::Crank => (1, "crank", local),
                Host::Coupler => (2, "coupler", local),
                Host::Rocker => (3, "rocker", local),
            };
            beside.ports[index].push((joint, port));
            joints.push(format!("    revolute {joint}({link}.{joint}, {bar}.{joint});\n"));
        }
        let start = [0.0, 0.0];
        let body = |name, ports, place, angle| Body { name, ports, place, angle, mass: None };
        let arm = vec![("shoulder", start), ("elbow", [self.bars[0], 0.0]), ("tracer", self.point)];
        let swing = vec![("hinge", start), ("elbow", [self.bars[1], 0.0])];
        beside.bodies =
            vec![body("arm", arm, from, pose.angles[0]), body("swing", swing, to, pose.angles[1])];
        joints.push("    revolute elbow(arm.elbow, swing.elbow);\n".to_owned());
        joints.push("    output arm.tracer.position, arm.angle, swing.angle;\n".to_owned());
        beside.lines = joints.concat();
        Some(self.four_bar.text(name, &pose.four_bar, None, beside))
    }
}

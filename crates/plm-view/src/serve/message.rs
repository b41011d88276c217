//! Messages of a served page to the program.

use serde::Deserialize;

/// An action of a user in a served page. All in SI; indices as in the tables of the mechanism. The receiver must check that an index
/// exists.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Message {
    /// Go on.
    Run,
    /// Stand still.
    Pause,
    /// Make steps, and stand still.
    Step {
        /// How long each is, s.
        dt: f64,
        /// How many.
        count: u32,
    },
    /// Run so many seconds in a second.
    Speed {
        /// Positive.
        speed: f64,
    },
    /// Begin again with parameters and inputs as they are.
    Restart,
    /// Begin again as declared.
    Reset,
    /// Set an input.
    Input {
        /// Its number.
        index: usize,
        /// SI.
        value: f64,
    },
    /// Set a parameter.
    Parameter {
        /// Its number.
        index: usize,
        /// SI.
        value: f64,
    },
    /// Pull a body, until the next message of this kind; without a pull, let go.
    Pull {
        /// How.
        pull: Option<Pull>,
    },
}

/// A spring with a damper from a point of a body to a place; or a constant force at that point.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
pub struct Pull {
    /// The number of the body.
    pub body: usize,
    /// From the centre of gravity, in the axes of the body, m.
    pub point: [f64; 2],
    /// Target to which the point is pulled, absolute axes, m.
    pub target: [f64; 2],
    /// N/m.
    pub stiffness: f64,
    /// N*s/m.
    pub damping: f64,
    /// In place of the spring: absolute axes, N.
    pub force: Option<[f64; 2]>,
}

/// No step of a page takes longer, s.
const LONGEST_STEPS: f64 = 1000.0;

impl Message {
    /// The message in these bytes of JSON; nothing if they are none, or if its numbers make no sense.
    pub(super) fn read(bytes: &[u8]) -> Option<Self> {
        let message: Self = serde_json::from_slice(bytes).ok()?;
        let makes_sense = match message {
            Self::Speed { speed } => speed > 0.0,
            Self::Step { dt, count } => dt > 0.0 && dt * f64::from(count) <= LONGEST_STEPS,
            _ => true,
        };
        makes_sense.then_some(message)
    }
}

impl Pull {
    /// Force (N, absolute axes) and torque about the centre of gravity (N*m) on the body where it is at `[x, y, angle]` (m, m,
    /// rad) and moves by `[vx, vy, omega]` (m/s, m/s, rad/s).
    pub fn wrench(&self, [x, y, angle]: [f64; 3], [vx, vy, omega]: [f64; 3]) -> [f64; 3] {
        let ((sin, cos), [u, v]) = (angle.sin_cos(), self.point);
        let [dx, dy] = [cos * u - sin * v, sin * u + cos * v];
        let spring = |target: f64, at: f64, rate: f64| self.stiffness * (target - at) - self.damping * rate;
        let [fx, fy] = self.force.unwrap_or([
            spring(self.target[0], x + dx, vx - omega * dy),
            spring(self.target[1], y + dy, vy + omega * dx),
        ]);
        [fx, fy, dx * fy - dy * fx]
    }
}

#[cfg(test)]
mod tests {
    use super::{Message, Pull};

    #[test]
    fn messages_are_read() {
        let read = |text: &str| Message::read(text.as_bytes());
        assert_eq!(read(r#"{"kind":"pause"}"#), Some(Message::Pause));
        let set = Message::Input { index: 2, value: -1.5e-3 };
        assert_eq!(read(r#"{"kind":"input","index":2,"value":-1.5e-3}"#), Some(set));
        assert_eq!(read(r#"{"kind":"pull","pull":null}"#), Some(Message::Pull { pull: None }));
        for wrong in [
            "",
            "{}",
            "null",
            r#"{"kind":"explode"}"#,
            r#"{"kind":"input","index":-1,"value":1}"#,
            r#"{"kind":"input","index":0,"value":1e999}"#,
            r#"{"kind":"input","index":0,"value":null}"#,
            r#"{"kind":"speed","speed":0}"#,
            r#"{"kind":"step","dt":1,"count":4000000000}"#,
        ] {
            assert_eq!(read(wrong), None, "{wrong}");
        }
    }

    /// The spring's power is that of its force at the point.
    #[test]
    fn a_pull_does_the_work_of_its_force_at_the_point() {
        let pull = Pull {
            body: 0,
            point: [0.3, -0.2],
            target: [2.0, 1.0],
            stiffness: 50.0,
            damping: 3.0,
            force: None,
        };
        let (pose, rate) = ([0.4, 0.1, 0.7], [0.2, -0.3, 1.1]);
        let place = |t: f64| {
            let [x, y, angle] = [0, 1, 2].map(|k| pose[k] + t * rate[k]);
            let (sin, cos) = f64::sin_cos(angle);
            [x + cos * 0.3 + sin * 0.2, y + sin * 0.3 - cos * 0.2]
        };
        let h = 1e-5;
        let [now, before, after] = [place(0.0), place(-h), place(h)];
        let velocity = [0, 1].map(|k| (after[k] - before[k]) / (2.0 * h));
        let force = [0, 1].map(|k| 50.0 * (pull.target[k] - now[k]) - 3.0 * velocity[k]);
        let power = force[0] * velocity[0] + force[1] * velocity[1];
        let found = pull.wrench(pose, rate);
        let own: f64 = (0..3).map(|k| found[k] * rate[k]).sum();
        // The difference quotient of the second order is off by about 1e-10.
        assert!((power - own).abs() < 1e-8 * power.abs(), "{power} {own}");
    }
}

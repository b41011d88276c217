//! A scissor lift of three stages, raised by a cylinder.
//!
//! Source: the principle of virtual work, as in J. L. Meriam, L. G. Kraige, Engineering Mechanics: Statics, 2012, chapter 7. The lengths are
//! our own. With bars of length L at an angle w, the platform stands at `3 L sin w`, and the cylinder from the fixed pin to the middle
//! of the second stage has the length `s = L/2 sqrt(cos^2 w + 9 sin^2 w)`. Its force is `dU/dw / (ds/dw)`.
//!
//! | bars L | mass of a bar | platform and load |
//! |---|---|---|
//! | 1.6 m | 15 kg | 60 + 240 kg |

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// A cylinder whose length is prescribed.
    joint ram(a: frame, b: frame) {
        param piston_diameter: m = 0;
        param rod_diameter: m = 0;
        param free_length: m = 0;
        picture free_length, piston_diameter, rod_diameter;
        input length: m;
        constraint distance: norm(b.position - a.position) = length;
        output force = -reaction(distance);
    }

    /// Three stages of scissors under a platform.
    pub Scissor {
        param load: kg = 240 kg;
        gravity: 9.81 m/s^2;
        ground { port pin: (0, 0) m; port rail: (1.4, 0) m; }
        let extended = 0.95 m + smooth_table(t, (0 s, 0 m), (3 s, 0.9 m)) - smooth_table(t, (4 s, 0 m), (7 s, 0.9 m));
        repeat i in 0..3 {
            body left[i] {
                mass: 15 kg; inertia: rod(15 kg, 1.6 m); port low: (-0.8, 0) m; port middle: (0, 0) m; port high: (0.8, 0) m;
                start x: 0.75 m; start y: 0.28 m*(2*i + 1); start angle: 20 deg;
            }
            body right[i] {
                mass: 15 kg; inertia: rod(15 kg, 1.6 m); port low: (-0.8, 0) m; port middle: (0, 0) m; port high: (0.8, 0) m;
                start x: 0.75 m; start y: 0.28 m*(2*i + 1); start angle: 160 deg;
            }
            revolute middle[i](left[i].middle, right[i].middle);
        }
        body platform {
            mass: 60 kg + load; inertia: plate(60 kg + load, 2 m, 0.3 m); port pin: (0, 0) m; port rail: (1.4, 0) m; centre: (0.75, 0.1) m;
            contour: (-0.15, -0.05), (1.75, -0.05), (1.75, 0.9), (1.7, 0.9), (1.7, 0.06), (-0.1, 0.06), (-0.1, 0.9), (-0.15, 0.9) m;
            start y: 1.65 m;
        }
        revolute foot(ground.pin, left[0].low);
        pin_slot roller(ground.rail, right[0].low);
        repeat i in 0..2 {
            revolute far[i](left[i].high, right[i + 1].low);
            revolute near[i](right[i].high, left[i + 1].low);
        }
        revolute top(right[2].high, platform.pin);
        pin_slot glide(platform.rail, left[2].high);
        ram cylinder(ground.pin, left[1].middle) { length: extended; free_length: 0.9 m; piston_diameter: 0.12 m; rod_diameter: 0.07 m; }
        output platform.pin.y in m, cylinder.force in kN;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Scissor::new()).until(7.0).every(0.02).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Scissor::new()).until(7.0).every(0.02).with(options)
}

//! Joints of bars, recomputed from exported poses and velocities: nothing that keeps them closed takes part.

use plm_runtime::BodyState;

/// One end of a pin.
#[derive(Clone, Copy)]
pub enum End {
    /// A place on the ground, m.
    Ground(f64, f64),
    /// So far along the axis of the bar with this number, from its centre, m.
    Bar(usize, f64),
}

use End::{Bar, Ground};

/// The pins of the four-bar linkage S2.
pub const FOUR_BAR: [(End, End); 4] = [
    (Ground(0.0, 0.0), Bar(0, -0.15)),
    (Bar(0, 0.15), Bar(1, -0.45)),
    (Bar(1, 0.45), Bar(2, 0.35)),
    (Ground(1.0, 0.0), Bar(2, -0.35)),
];

/// The pins of the Quadrorhomb.
pub const QUADRORHOMB: [(End, End); 19] = [
    (Ground(0.15, 0.0), Bar(0, -0.075)),
    (Ground(0.0, 0.0), Bar(1, -0.25)),
    (Ground(0.0, 0.0), Bar(2, -0.25)),
    (Bar(0, 0.075), Bar(3, -0.125)),
    (Bar(0, 0.075), Bar(4, -0.125)),
    (Bar(1, 0.25), Bar(3, 0.125)),
    (Bar(1, 0.25), Bar(5, -0.25)),
    (Bar(2, 0.25), Bar(4, 0.125)),
    (Bar(2, 0.25), Bar(6, -0.25)),
    (Bar(5, 0.0), Bar(6, 0.0)),
    (Bar(6, 0.25), Bar(7, -0.25)),
    (Bar(5, 0.25), Bar(8, -0.25)),
    (Bar(7, 0.0), Bar(8, 0.0)),
    (Bar(8, 0.25), Bar(9, -0.25)),
    (Bar(7, 0.25), Bar(10, -0.25)),
    (Bar(9, 0.0), Bar(10, 0.0)),
    (Bar(10, 0.25), Bar(11, -0.125)),
    (Bar(9, 0.25), Bar(12, -0.125)),
    (Bar(11, 0.125), Bar(12, 0.125)),
];

/// The largest components of phi (m) and of phi_dot (m/s).
pub fn open(bars: &[BodyState<f64>], pins: &[(End, End)]) -> [f64; 2] {
    let (mut phi, mut phi_dot) = (0.0_f64, 0.0_f64);
    for (a, b) in pins {
        let ([x, y, vx, vy], [u, v, vu, vv]) = (a.motion(bars), b.motion(bars));
        phi = phi.max((x - u).abs()).max((y - v).abs());
        phi_dot = phi_dot.max((vx - vu).abs()).max((vy - vv).abs());
    }
    [phi, phi_dot]
}

impl End {
    /// Place and velocity.
    fn motion(self, bars: &[BodyState<f64>]) -> [f64; 4] {
        match self {
            Ground(x, y) => [x, y, 0.0, 0.0],
            Bar(index, along) => {
                let bar = &bars[index];
                let (sin, cos) = bar.angle.sin_cos();
                let turning = along * bar.omega;
                [bar.x + along * cos, bar.y + along * sin, bar.vx - turning * sin, bar.vy + turning * cos]
            }
        }
    }
}

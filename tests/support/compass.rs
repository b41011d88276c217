//! A compass-like biped on a slope, by the equations of A. Goswami, B. Thuilot, B. Espiau, A study of the passive gait of a compass-like
//! biped robot, Int. J. Robotics Research 17, 1998.

/// Slope of the ground in the paper, rad.
pub(crate) const SLOPE: f64 = 3.0 * std::f64::consts::PI / 180.0;

/// Angles of the leg that stands and of the one that swings from the vertical, and their rates.
pub(crate) type State = [f64; 4];

/// Two legs of 1 m on a hip.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Compass {
    /// Mass at the hip, and of each leg, kg.
    pub(crate) hip: f64,
    pub(crate) leg: f64,
    /// The mass of a leg is so far from its foot, m.
    pub(crate) from_foot: f64,
    /// m/s^2.
    pub(crate) gravity: f64,
    /// rad.
    pub(crate) slope: f64,
}

/// That of the paper.
pub(crate) const PAPER: Compass =
    Compass { hip: 10.0, leg: 5.0, from_foot: 0.5, gravity: 9.81, slope: SLOPE };

impl Compass {
    /// The equations of the paper.
    fn rate(self, [s, n, w, u]: State) -> State {
        let Self { hip, leg: m, from_foot: a, gravity: g, .. } = self;
        let (b, (sin, cos)) = (1.0 - a, (s - n).sin_cos());
        let [stand, cross, swing] = [hip + m + m * a * a, -m * b * cos, m * b * b];
        let f = m * b * sin * u * u + g * (hip + m * a + m) * s.sin();
        let h = -m * b * sin * w * w - m * g * b * n.sin();
        let determinant = stand * swing - cross * cross;
        [w, u, (swing * f - cross * h) / determinant, (stand * h - cross * f) / determinant]
    }

    /// The method of W. Kutta.
    pub(crate) fn step(self, x: State, h: f64) -> State {
        let at = |k: State, h: f64| -> State { core::array::from_fn(|i| x[i] + h * k[i]) };
        let a = self.rate(x);
        let b = self.rate(at(a, 0.5 * h));
        let c = self.rate(at(b, 0.5 * h));
        let d = self.rate(at(c, h));
        core::array::from_fn(|i| x[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
    }

    /// Heel strike: the angular momentum of all about the foot that strikes stays, and that of the leg behind about the hip. The legs
    /// change their parts.
    fn strike(self, [s, n, w, u]: State) -> State {
        let Self { hip, leg: m, from_foot: a, .. } = self;
        let (b, cos) = (1.0 - a, (s - n).cos());
        let all = (hip + 2.0 * m * a) * cos * w - m * a * b * (w + u);
        let behind = -m * a * b * w;
        let [p, q] = [m * b * (b - cos), m * (1.0 - b * cos) + m * a * a + hip];
        let [r, t] = [m * b * b, -m * b * cos];
        let determinant = p * t - q * r;
        [n, s, (p * behind - r * all) / determinant, (t * all - q * behind) / determinant]
    }

    /// The time of a step from one heel strike to the next, and the state behind it.
    pub(crate) fn walked(self, mut x: State) -> (f64, State) {
        let (h, mut time) = (1.25e-3, 0.0);
        let gap = |x: State| x[0] + x[1] + 2.0 * self.slope;
        loop {
            let next = self.step(x, h);
            let is_ahead = next[1] > next[0] + 0.2;
            if !(is_ahead && gap(next) <= 0.0) {
                (x, time) = (next, time + h);
                continue;
            }
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let half = 0.5 * (low + high);
                *(if gap(self.step(x, half)) > 0.0 { &mut low } else { &mut high }) = half;
            }
            return (time + high, self.strike(self.step(x, high)));
        }
    }
}

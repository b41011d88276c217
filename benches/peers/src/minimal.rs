//! Equations of motion in minimal coordinates, by hand: S1, S2, S5 and S6. `benches/peers/by_heyoka.py` has the same ones.

const GRAVITY: f64 = 9.81;

/// A scene as an ordinary differential equation.
pub(crate) trait Scene: Copy + 'static {
    /// Angles and angular velocities.
    const SIZE: usize;
    /// End of the run, s.
    const UNTIL: f64 = 1.0;

    /// The state at the start.
    fn start(self) -> Vec<f64>;
    /// The rate `dx` of the state.
    fn rate(self, x: &[f64], dx: &mut [f64]);
    /// What errors are measured by: x and y of the centre of gravity of each body, m; of S5 angles, rad.
    fn measured(self, x: &[f64]) -> Vec<f64>;
}

/// S1: Lagrange's equations in the absolute angles of the two bars.
#[derive(Clone, Copy)]
pub(crate) struct DoublePendulum;

impl Scene for DoublePendulum {
    const SIZE: usize = 4;

    fn start(self) -> Vec<f64> {
        vec![45_f64.to_radians(), 0.0, 0.0, 0.0]
    }

    fn rate(self, x: &[f64], dx: &mut [f64]) {
        let &[first, second, omega, second_omega] = x else { return };
        // m = 10 kg, J = 0.01 kg m^2; G at 0.5 m on the first bar of 1 m, at 1 m on the second.
        let (a, b) = (0.01 + 10.0 * 0.25 + 10.0, 0.01 + 10.0);
        let (sin, cos) = (first - second).sin_cos();
        let coupling = 10.0 * cos;
        let right = -10.0 * sin * second_omega * second_omega - GRAVITY * 15.0 * first.cos();
        let second_right = 10.0 * sin * omega * omega - GRAVITY * 10.0 * second.cos();
        let determinant = a * b - coupling * coupling;
        dx.copy_from_slice(&[
            omega,
            second_omega,
            (b * right - coupling * second_right) / determinant,
            (a * second_right - coupling * right) / determinant,
        ]);
    }

    fn measured(self, x: &[f64]) -> Vec<f64> {
        let ((sin, cos), (second_sin, second_cos)) = (x[0].sin_cos(), x[1].sin_cos());
        vec![0.5 * cos, 0.5 * sin, cos + second_cos, sin + second_sin]
    }
}

/// A point that moves with one angle: its place, and its first and second derivative by that angle, m.
#[derive(Clone, Copy, Default)]
struct Point {
    place: [f64; 2],
    lever: [f64; 2],
    lever_rate: [f64; 2],
}

/// The direction of a bar: sine, cosine, and how far it turns for a radian of the angle, with the rate of change of that.
#[derive(Clone, Copy)]
struct Turn {
    sin: f64,
    cos: f64,
    ratio: f64,
    ratio_rate: f64,
}

impl Turn {
    /// That of the crank, which has the angle.
    fn crank(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { sin, cos, ratio: 1.0, ratio_rate: 0.0 }
    }

    /// The angle of a body whose bar is inclined by `bar` at its angle 0, rad.
    fn angle(self, bar: f64) -> f64 {
        let (sin, cos) = bar.sin_cos();
        (self.sin * cos - self.cos * sin).atan2(self.cos * cos + self.sin * sin)
    }

    /// The point of a bar so far along it and across it, to its left, from where it begins, m.
    fn point(self, begin: Point, [along, across]: [f64; 2]) -> Point {
        let [x, y] = [self.cos * along - self.sin * across, self.sin * along + self.cos * across];
        let square = self.ratio * self.ratio;
        Point {
            place: [begin.place[0] + x, begin.place[1] + y],
            lever: [begin.lever[0] - self.ratio * y, begin.lever[1] + self.ratio * x],
            lever_rate: [
                begin.lever_rate[0] - self.ratio_rate * y - square * x,
                begin.lever_rate[1] + self.ratio_rate * x - square * y,
            ],
        }
    }
}

/// Two bars of these lengths from a point that moves and from a pivot to a common joint, on the left of the line from the point to
/// the pivot if `side` is 1, on its right if -1.
fn dyad(begin: Point, pivot: [f64; 2], lengths: [f64; 2], side: f64) -> [Turn; 2] {
    let d = [pivot[0] - begin.place[0], pivot[1] - begin.place[1]];
    let [ee, ff] = [lengths[0] * lengths[0], lengths[1] * lengths[1]];
    let square = dot(d, d);
    let along = 0.5 * (square + ee - ff);
    let across = side * (ee * square - along * along).max(0.0).sqrt();
    let e = [(along * d[0] - across * d[1]) / square, (along * d[1] + across * d[0]) / square];
    let f = [e[0] - d[0], e[1] - d[1]];
    // begin' + u k x e = w k x f, and its derivative.
    let cross = e[0] * f[1] - e[1] * f[0];
    let solve = |g: [f64; 2]| (-dot(g, f) / cross, -dot(g, e) / cross);
    let (u, w) = solve(begin.lever);
    let g = |i: usize| begin.lever_rate[i] - u * u * e[i] + w * w * f[i];
    let (u_rate, w_rate) = solve([g(0), g(1)]);
    let turn = |[x, y]: [f64; 2], length: f64, ratio, ratio_rate| Turn {
        sin: y / length,
        cos: x / length,
        ratio,
        ratio_rate,
    };
    [turn(e, lengths[0], u, u_rate), turn(f, lengths[1], w, w_rate)]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// A body: its centre of gravity and its turn, mass and inertia.
type Body = (Point, Turn, f64, f64);

/// A uniform bar from a point, whose mass in kg is its length in m.
fn bar(begin: Point, turn: Turn, length: f64) -> Body {
    (turn.point(begin, [0.5 * length, 0.0]), turn, length, length * length * length / 12.0)
}

/// The angular acceleration of a mechanism of one degree of freedom (Eksergian's equation): with
/// J = sum m |lever|^2 + inertia ratio^2 it is J angle'' + J' angle'^2 / 2 = moment of the forces.
fn eksergian<const N: usize>(bodies: &[Body; N], omega: f64, moment: f64) -> f64 {
    let (mut inertia, mut half_rate) = (0.0, 0.0);
    for (point, turn, mass, own) in bodies {
        inertia += mass * dot(point.lever, point.lever) + own * turn.ratio * turn.ratio;
        half_rate += mass * dot(point.lever, point.lever_rate) + own * turn.ratio * turn.ratio_rate;
    }
    (moment - half_rate * omega * omega) / inertia
}

/// The moment of the weights.
fn weights<const N: usize>(bodies: &[Body; N]) -> f64 {
    bodies.iter().map(|(point, _, mass, _)| -mass * GRAVITY * point.lever[1]).sum()
}

fn places<const N: usize>(bodies: &[Body; N]) -> Vec<f64> {
    bodies.iter().flat_map(|(point, ..)| point.place).collect()
}

/// S2: the loop is closed by a dyad.
#[derive(Clone, Copy)]
pub(crate) struct FourBar;

impl FourBar {
    fn bodies(angle: f64) -> [Body; 3] {
        let (ground, crank) = (Point::default(), Turn::crank(angle));
        let pivot = Point { place: [1.0, 0.0], ..ground };
        let tip = crank.point(ground, [0.3, 0.0]);
        let [coupler, rocker] = dyad(tip, pivot.place, [0.9, 0.7], 1.0);
        [bar(ground, crank, 0.3), bar(tip, coupler, 0.9), bar(pivot, rocker, 0.7)]
    }
}

impl Scene for FourBar {
    const SIZE: usize = 2;

    fn start(self) -> Vec<f64> {
        vec![60_f64.to_radians(), 0.0]
    }

    fn rate(self, x: &[f64], dx: &mut [f64]) {
        let bodies = Self::bodies(x[0]);
        dx.copy_from_slice(&[x[1], eksergian(&bodies, x[1], weights(&bodies))]);
    }

    fn measured(self, x: &[f64]) -> Vec<f64> {
        places(&Self::bodies(x[0]))
    }
}

/// S6: the rod's angle from the height of the crank pin.
#[derive(Clone, Copy)]
pub(crate) struct SliderCrank;

impl SliderCrank {
    fn bodies(angle: f64) -> [Body; 3] {
        let (length, rod_length) = (0.2, 0.6);
        let (ground, crank) = (Point::default(), Turn::crank(angle));
        let pin = crank.point(ground, [length, 0.0]);
        let sin = -length * crank.sin / rod_length;
        let cos = (1.0 - sin * sin).sqrt();
        let ratio = -length * crank.cos / (rod_length * cos);
        let ratio_rate = (length * crank.sin / rod_length + sin * ratio * ratio) / cos;
        let rod = Turn { sin, cos, ratio, ratio_rate };
        let wrist = rod.point(pin, [rod_length, 0.0]);
        [bar(ground, crank, length), bar(pin, rod, rod_length), (wrist, rod, 0.5, 0.0)]
    }
}

impl Scene for SliderCrank {
    const SIZE: usize = 2;

    fn start(self) -> Vec<f64> {
        vec![60_f64.to_radians(), 0.0]
    }

    fn rate(self, x: &[f64], dx: &mut [f64]) {
        let bodies = Self::bodies(x[0]);
        dx.copy_from_slice(&[x[1], eksergian(&bodies, x[1], 1.0 + weights(&bodies))]);
    }

    fn measured(self, x: &[f64]) -> Vec<f64> {
        places(&Self::bodies(x[0]))
    }
}

/// S5: three dyads; the last two hang on the pin of K3. Data: `tests/support/scenes.rs`.
#[derive(Clone, Copy)]
pub(crate) struct Andrews;

impl Andrews {
    const B: [f64; 2] = [-0.03635, 0.03273];
    const C: [f64; 2] = [-0.06934, -0.00227];
    const D: [f64; 2] = [0.014, 0.072];

    /// The bodies, and where the spring pulls at K3.
    fn bodies(angle: f64) -> ([Body; 7], Point) {
        let (ground, k1) = (Point::default(), Turn::crank(angle));
        let [b, c] = [Self::B, Self::C].map(|place| Point { place, ..ground });
        let tip = k1.point(ground, [0.007, 0.0]);
        let [k2, k3] = dyad(tip, Self::B, [0.028, 0.035], 1.0);
        let pin = k3.point(b, [0.035, 0.0]);
        let [k4, k5] = dyad(pin, Self::C, [0.02, 0.04], -1.0);
        let [k6, k7] = dyad(pin, Self::C, [0.02, 0.04], 1.0);
        let bodies = [
            (k1.point(ground, [0.00092, 0.0]), k1, 0.04325, 2.194e-6),
            (k2.point(tip, [0.0115, 0.0]), k2, 0.00365, 4.41e-7),
            (k3.point(b, [0.01874, 0.01043]), k3, 0.02373, 5.255e-6),
            (k4.point(pin, [0.01421, 0.0]), k4, 0.00706, 5.667e-7),
            (k5.point(c, [0.02308, 0.00916]), k5, 0.0705, 1.169e-5),
            (k6.point(pin, [0.01421, 0.0]), k6, 0.00706, 5.667e-7),
            (k7.point(c, [0.00449, 0.01228]), k7, 0.05498, 1.912e-5),
        ];
        (bodies, k3.point(b, [0.018, 0.02]))
    }
}

impl Scene for Andrews {
    const SIZE: usize = 2;
    const UNTIL: f64 = 0.03;

    fn start(self) -> Vec<f64> {
        vec![-0.061_713_890_014_276_45, 0.0]
    }

    fn rate(self, x: &[f64], dx: &mut [f64]) {
        let (bodies, hook) = Self::bodies(x[0]);
        let spring = [hook.place[0] - Self::D[0], hook.place[1] - Self::D[1]];
        let pull = 4530.0 * (0.07785 / dot(spring, spring).sqrt() - 1.0);
        dx.copy_from_slice(&[x[1], eksergian(&bodies, x[1], 0.033 + pull * dot(spring, hook.lever))]);
    }

    /// The seven angles of the IVP test set.
    fn measured(self, x: &[f64]) -> Vec<f64> {
        let quarter = 90_f64.to_radians();
        let ([_, k2, k3, k4, k5, k6, k7], _) = Self::bodies(x[0]);
        let angle = |body: Body, quarters: f64| body.1.angle(quarters * quarter);
        let [k2, k3, k4] = [angle(k2, 2.0), angle(k3, -1.0), angle(k4, 1.0)];
        let [k5, k6, k7] = [angle(k5, 0.0), angle(k6, 2.0), angle(k7, -1.0)];
        vec![x[0], k2 - x[0], k3, k4 - k5, k5, k6 - k7, k7]
    }
}

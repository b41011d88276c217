//! Equations of motion in minimal coordinates, by hand: S1, S2 and S6.

const GRAVITY: f64 = 9.81;

/// A scene as an ordinary differential equation.
pub(crate) trait Scene: Copy + 'static {
    /// Angles and angular velocities.
    const SIZE: usize;

    /// The state at the start.
    fn start(self) -> Vec<f64>;
    /// The rate `dx` of the state.
    fn rate(self, x: &[f64], dx: &mut [f64]);
    /// x and y of the centre of gravity of each body, m.
    fn places(self, x: &[f64]) -> Vec<f64>;
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

    fn places(self, x: &[f64]) -> Vec<f64> {
        let ((sin, cos), (second_sin, second_cos)) = (x[0].sin_cos(), x[1].sin_cos());
        vec![0.5 * cos, 0.5 * sin, cos + second_cos, sin + second_sin]
    }
}

/// A body that moves with one angle: its place and how far it and its angle move for a radian of that angle, with the rates of change of
/// both by the angle.
#[derive(Clone, Copy, Default)]
struct Led {
    mass: f64,
    inertia: f64,
    place: [f64; 2],
    lever: [f64; 2],
    lever_rate: [f64; 2],
    ratio: f64,
    ratio_rate: f64,
}

/// The angular acceleration of a mechanism of one degree of freedom (Eksergian's equation): with
/// J = sum m |lever|^2 + inertia ratio^2 it is J angle'' + J' angle'^2 / 2 = torque + weights on their levers.
fn eksergian<const N: usize>(bodies: &[Led; N], omega: f64, torque: f64) -> f64 {
    let (mut inertia, mut half_rate, mut moment) = (0.0, 0.0, torque);
    for body in bodies {
        let ([x, y], [x_rate, y_rate]) = (body.lever, body.lever_rate);
        inertia += body.mass * (x * x + y * y) + body.inertia * body.ratio * body.ratio;
        half_rate += body.mass * (x * x_rate + y * y_rate) + body.inertia * body.ratio * body.ratio_rate;
        moment -= body.mass * GRAVITY * y;
    }
    (moment - half_rate * omega * omega) / inertia
}

/// A bar whose beginning is led, and which turns by `ratio` for a radian; `along` is where G is, as a fraction of the length.
fn bar(mass: f64, length: f64, along: f64, (sin, cos): (f64, f64), begin: Led, ratio: [f64; 2]) -> Led {
    let reach = length * along;
    let [ratio, ratio_rate] = ratio;
    let square = ratio * ratio;
    Led {
        mass,
        inertia: mass * length * length / 12.0,
        place: [begin.place[0] + reach * cos, begin.place[1] + reach * sin],
        lever: [begin.lever[0] - reach * sin * ratio, begin.lever[1] + reach * cos * ratio],
        lever_rate: [
            begin.lever_rate[0] - reach * (cos * square + sin * ratio_rate),
            begin.lever_rate[1] + reach * (cos * ratio_rate - sin * square),
        ],
        ratio,
        ratio_rate,
    }
}

/// S2: the loop is closed by the intersection of two circles.
#[derive(Clone, Copy)]
pub(crate) struct FourBar;

impl FourBar {
    fn bodies(angle: f64) -> [Led; 3] {
        let (crank, coupler, rocker) = (0.3, 0.9, 0.7);
        let direction = angle.sin_cos();
        let tip = bar(crank, crank, 1.0, direction, Led::default(), [1.0, 0.0]);
        // C from B and D, on the left of the line from B to D.
        let [x, y] = [1.0 - tip.place[0], -tip.place[1]];
        let square = x * x + y * y;
        let along = 0.5 * (square + coupler * coupler - rocker * rocker);
        let across = (coupler * coupler * square - along * along).max(0.0).sqrt();
        let (cos, sin) =
            ((along * x - across * y) / (square * coupler), (along * y + across * x) / (square * coupler));
        let arm = [(coupler * cos - x) / rocker, (coupler * sin - y) / rocker];
        // tip + coupler turned = rocker turned: two equations for the ratios, and again for their rates.
        let determinant = coupler * rocker * (cos * arm[1] - sin * arm[0]);
        let solve = |[x, y]: [f64; 2]| {
            [-rocker * (x * arm[0] + y * arm[1]) / determinant, -coupler * (x * cos + y * sin) / determinant]
        };
        let [ratio, rocker_ratio] = solve(tip.lever);
        let (square, rocker_square) = (ratio * ratio, rocker_ratio * rocker_ratio);
        let [ratio_rate, rocker_ratio_rate] = solve([
            tip.lever_rate[0] - coupler * cos * square + rocker * arm[0] * rocker_square,
            tip.lever_rate[1] - coupler * sin * square + rocker * arm[1] * rocker_square,
        ]);
        let pivot = Led { place: [1.0, 0.0], ..Led::default() };
        [
            bar(crank, crank, 0.5, direction, Led::default(), [1.0, 0.0]),
            bar(coupler, coupler, 0.5, (sin, cos), tip, [ratio, ratio_rate]),
            bar(rocker, rocker, 0.5, (arm[1], arm[0]), pivot, [rocker_ratio, rocker_ratio_rate]),
        ]
    }
}

impl Scene for FourBar {
    const SIZE: usize = 2;

    fn start(self) -> Vec<f64> {
        vec![60_f64.to_radians(), 0.0]
    }

    fn rate(self, x: &[f64], dx: &mut [f64]) {
        dx.copy_from_slice(&[x[1], eksergian(&Self::bodies(x[0]), x[1], 0.0)]);
    }

    fn places(self, x: &[f64]) -> Vec<f64> {
        Self::bodies(x[0]).iter().flat_map(|body| body.place).collect()
    }
}

/// S6: the rod's angle from the height of the crank pin.
#[derive(Clone, Copy)]
pub(crate) struct SliderCrank;

impl SliderCrank {
    fn bodies(angle: f64) -> [Led; 3] {
        let (crank, rod) = (0.2, 0.6);
        let (sin, cos) = angle.sin_cos();
        let pin = bar(crank, crank, 1.0, (sin, cos), Led::default(), [1.0, 0.0]);
        let rod_sin = -crank * sin / rod;
        let rod_cos = (1.0 - rod_sin * rod_sin).sqrt();
        let ratio = -crank * cos / (rod * rod_cos);
        let ratio_rate = (crank * sin / rod + rod_sin * ratio * ratio) / rod_cos;
        let wrist = bar(0.0, rod, 1.0, (rod_sin, rod_cos), pin, [ratio, ratio_rate]);
        [
            bar(crank, crank, 0.5, (sin, cos), Led::default(), [1.0, 0.0]),
            bar(rod, rod, 0.5, (rod_sin, rod_cos), pin, [ratio, ratio_rate]),
            Led { mass: 0.5, inertia: 0.0, ratio: 0.0, ratio_rate: 0.0, ..wrist },
        ]
    }
}

impl Scene for SliderCrank {
    const SIZE: usize = 2;

    fn start(self) -> Vec<f64> {
        vec![60_f64.to_radians(), 0.0]
    }

    fn rate(self, x: &[f64], dx: &mut [f64]) {
        dx.copy_from_slice(&[x[1], eksergian(&Self::bodies(x[0]), x[1], 1.0)]);
    }

    fn places(self, x: &[f64]) -> Vec<f64> {
        Self::bodies(x[0]).iter().flat_map(|body| body.place).collect()
    }
}

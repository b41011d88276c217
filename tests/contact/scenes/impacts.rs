//! Laws of impact: three balls in a row and a double pendulum that strikes the floor.

use plm::{Cause, Dop853, Mechanism as _};

use crate::declared::{Newton, Sequential};
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

by_law!(Poisson, poisson);

/// Velocities of the balls after an impact with the coefficient e; `$apart` is how far the third one is at first.
fn row_of_balls(balls: Scene, e: f64, apart: f64) -> [f64; 3] {
    // The pendulum does not slip: this is about the balls.
    let balls =
        balls.with("e", e).with("lower_angle", 0.4).with("friction", 0.0).with_start("third.x", apart);
    let mut sim = balls.start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(1.5 * apart).unwrap();
    [sim.state_of("first").vx, sim.state_of("second").vx, sim.state_of("third").vx]
}

/// Case C15: touching balls by each law, and with a gap.
#[test]
fn c15_a_cradle_by_each_law() {
    let third = 1.0 / 3.0;
    for (found, known) in [
        (row_of_balls(Poisson::new(), 1.0, 0.0), [-third, 2.0 * third, 2.0 * third]),
        (row_of_balls(Newton::new(), 1.0, 0.0), [-third, 2.0 * third, 2.0 * third]),
        (row_of_balls(Sequential::new(), 1.0, 0.0), [0.0, 0.0, 1.0]),
        (row_of_balls(Poisson::new(), 0.0, 0.0), [third; 3]),
        (row_of_balls(Poisson::new(), 1.0, 0.01), [0.0, 0.0, 1.0]),
        (row_of_balls(Sequential::new(), 0.9, 0.01), [0.05, 0.0475, 0.9025]),
    ] {
        found.iter().zip(known).for_each(|(found, known)| near(*found, known, 1e-12));
    }
}

/// The double pendulum at its impact: inverse mass matrix, directions of the floor and along it.
#[derive(Clone, Copy)]
struct Impact {
    mass: [[f64; 2]; 2],
    responses: [[f64; 2]; 2],
    delassus: [[f64; 2]; 2],
    rates: [f64; 2],
}

impl Impact {
    const BEFORE: [f64; 2] = [-0.1, -0.2];

    fn of(upper: f64, lower: f64) -> Self {
        let cos = (upper - lower).cos();
        let mass = [[4.0 / 3.0, 0.5 * cos], [0.5 * cos, 1.0 / 3.0]];
        let determinant = mass[0][0] * mass[1][1] - mass[0][1] * mass[1][0];
        let directions = [[upper.sin(), lower.sin()], [upper.cos(), lower.cos()]];
        let responses = directions.map(|[a, b]| {
            [(mass[1][1] * a - mass[0][1] * b) / determinant, (mass[0][0] * b - mass[1][0] * a) / determinant]
        });
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let delassus = directions.map(|direction| responses.map(|response| dot(direction, response)));
        Self { mass, responses, delassus, rates: directions.map(|direction| dot(direction, Self::BEFORE)) }
    }

    /// Impulses that take the rate of approach to zero, the friction by Coulomb's law.
    fn compressed(&self, friction: f64) -> [f64; 2] {
        let ([[nn, nt], [tn, tt]], [approach, slip]) = (self.delassus, self.rates);
        let determinant = nn * tt - nt * tn;
        let sticks = [(nt * slip - tt * approach) / determinant, (tn * approach - nn * slip) / determinant];
        if sticks[1].abs() <= friction * sticks[0] {
            return sticks;
        }
        for side in [1.0, -1.0] {
            let normal = -approach / (nn - side * friction * nt);
            let slides = [normal, -side * friction * normal];
            if normal >= 0.0 && side * (slip + tn * slides[0] + tt * slides[1]) >= 0.0 {
                return slides;
            }
        }
        panic!("no impulse");
    }

    /// Impulses of both phases by Poisson's law: the friction of each is bounded by the normal impulse of each.
    fn poisson(&self, e: f64, friction: f64) -> [f64; 2] {
        let [normal, along] = self.compressed(friction);
        let ([_, [tn, tt]], slip) = (self.delassus, self.rates[1]);
        let back = e * normal;
        let rate = slip + tn * (normal + back) + tt * along;
        let held = (-rate / tt).clamp(-friction * back, friction * back);
        [normal + back, along + held]
    }

    fn energy(&self, [a, b]: [f64; 2]) -> f64 {
        0.5 * (self.mass[0][0] * a * a + self.mass[1][1] * b * b) + self.mass[0][1] * a * b
    }

    fn after(&self, [normal, along]: [f64; 2]) -> [f64; 2] {
        core::array::from_fn(|i| {
            Self::BEFORE[i] + self.responses[0][i] * normal + self.responses[1][i] * along
        })
    }
}

/// T. R. Kane, D. A. Levinson, Dynamics: Theory and Applications, 1985: by Newton's law this impact gains energy. Poisson's loses some,
/// as does treating the one contact by itself.
#[test]
fn kanes_double_pendulum_loses_energy_by_poissons_law() {
    let (upper, lower) = (20_f64.to_radians(), 30_f64.to_radians());
    let impact = Impact::of(upper, lower);
    let before = impact.energy(Impact::BEFORE);
    for (e, friction) in [(0.5, 0.5), (0.5, 0.3), (0.7, 0.5), (1.0, 0.6), (0.5, 0.0)] {
        let known = impact.after(impact.poisson(e, friction));
        for pendulum in [Poisson::new(), Sequential::new()] {
            let sim =
                pendulum.with("e", e).with("friction", friction).start_with(Dop853::new(1e-10)).unwrap();
            near(sim.state_of("upper").omega, known[0], 1e-13);
            near(sim.state_of("lower").omega, known[1], 1e-13);
            let balls = 0.5
                * (sim.state_of("first").vx.powi(2)
                    + sim.state_of("second").vx.powi(2)
                    + sim.state_of("third").vx.powi(2));
            near(sim.kinetic_energy() - balls, impact.energy(known), 1e-12 * before);
            assert!(impact.energy(known) <= before * (1.0 + 1e-12), "{e} {friction}");
        }
    }
}

/// By Newton's law the floor gives back e times the speed of approach: impulses are those that compress (1 + e) times as much. For
/// e = mu = 0.5 the energy would grow to 1.587 of it, which is a fault.
#[test]
fn kanes_double_pendulum_by_newtons_law() {
    let impact = Impact::of(20_f64.to_radians(), 30_f64.to_radians());
    let known = |e: f64, friction: f64| {
        let [approach, slip] = impact.rates;
        impact.after(Impact { rates: [(1.0 + e) * approach, slip], ..impact }.compressed(friction))
    };
    let before = impact.energy(Impact::BEFORE);
    let gains = impact.energy(known(0.5, 0.5)) - before;
    near(gains / before, 0.587, 5e-4);
    // The balls rest: they would lose more than that.
    let pendulum = Newton::new().with_start("first.vx", 0.0);
    match pendulum.start_with(Dop853::new(1e-10)).map(|_| ()).unwrap_err().cause {
        Cause::ImpactGains { by, .. } => near(by, gains, 1e-12 * gains),
        cause => panic!("{cause:?}"),
    }
    for (e, friction) in [(0.5, 0.0), (0.8, 0.0), (0.0, 0.5)] {
        let sim =
            Newton::new().with("e", e).with("friction", friction).start_with(Dop853::new(1e-10)).unwrap();
        near(sim.state_of("upper").omega, known(e, friction)[0], 1e-13);
        near(sim.state_of("lower").omega, known(e, friction)[1], 1e-13);
    }
}

//! Equilibria of chains and loops.

use plm::{Equilibrium, Mechanism as _, Stabilise, What};

use super::stabilise::{assert_close, assert_needs, value};
use crate::scene::Given as _;

#[test]
fn a_loop_with_a_spring_rests_in_every_formulation() {
    macro_rules! four_bar {
        ($module:ident, { $($formulation:tt)* }) => {
            mod $module {
                scene! {
                    pub FourBar {
                        $($formulation)*
                        gravity: 9.81 m/s^2;
                        ground { port a: (0, 0) m; port d: (1, 0) m; }
                        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.2, 0) m; port b: (0.2, 0) m; start angle: 70 deg, locked; }
                        body coupler { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-0.5, 0) m; port c: (0.5, 0) m; start angle: 15 deg; }
                        body follower { mass: 1 kg; inertia: 0.05 kg*m^2; port c: (0.4, 0) m; port d: (-0.4, 0) m; start angle: 70 deg; }
                        revolute a(ground.a, crank.a) { stiffness: 30 N*m/rad; rest: 50 deg; }
                        revolute b(crank.b, coupler.b);
                        revolute c(coupler.c, follower.c);
                        revolute d(ground.d, follower.d);
                        output a.angle;
                    }
                }
            }
        };
    }
    four_bar!(least, {});
    four_bar!(absolute, { formulation: absolute; });
    let one = least::FourBar::new().released("crank.angle");
    let other = absolute::FourBar::new().released("crank.angle");
    let (one, other) =
        (one.stabilise().unwrap().balanced().unwrap(), other.stabilise().unwrap().balanced().unwrap());
    assert_close(value(&one, "crank.angle"), value(&other, "crank.angle"), 1e-12);
    // Neither gravity nor the spring gains anything there: their energy is stationary along the loop.
    let energy = |crank: f64| {
        let at = least::FourBar::new()
            .with_start("crank.angle", crank)
            .with_start("coupler.angle", value(&one, "coupler.angle"))
            .with_start("follower.angle", value(&one, "follower.angle"));
        let sim = at.start().unwrap();
        sim.gravity_energy() + 15.0 * (crank - 50_f64.to_radians()).powi(2)
    };
    let (crank, h) = (value(&one, "crank.angle"), 1e-4);
    assert!((energy(crank + h) - energy(crank - h)).abs() / (2.0 * h) < 1e-6);
    // Locked, it needs the torque that the energy asks for.
    let found = least::FourBar::new().stabilise().unwrap();
    let locked = 70_f64.to_radians();
    assert_needs_near(&found, "crank.angle", (energy(locked + h) - energy(locked - h)) / (2.0 * h));
}

/// As a difference quotient tells it.
#[track_caller]
fn assert_needs_near<M: Stabilise>(found: &Equilibrium<M>, name: &str, force: f64) {
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), (name, What::Lock));
    assert_close(residual.value, force, 1e-6);
}

scene! {
    /// Three parallel cranks: one constraint says what others say. A weight hangs on the bar.
    pub Parallelogram {
        allow(W0001);
        gravity: 9.81 m/s^2;
        ground { port a: (0, 0) m; port b: (1, 0) m; port c: (2, 0) m; }
        body first { mass: 1 kg; inertia: 0.1 kg*m^2; port foot: (0, 0) m; port head: (0, 0.5) m; start angle: 20 deg; }
        body second { mass: 1 kg; inertia: 0.1 kg*m^2; port foot: (0, 0) m; port head: (0, 0.5) m; start x: 1 m; start angle: 20 deg; }
        body third { mass: 1 kg; inertia: 0.1 kg*m^2; port foot: (0, 0) m; port head: (0, 0.5) m; start x: 2 m; start angle: 20 deg; }
        body bar { mass: 4 kg; inertia: 1 kg*m^2; port a: (-1, 0) m; port b: (0, 0) m; port c: (1, 0) m; start x: 1 m; start y: 0.5 m; }
        revolute a(ground.a, first.foot) { stiffness: 50 N*m/rad; }
        revolute b(ground.b, second.foot);
        revolute c(ground.c, third.foot);
        revolute d(first.head, bar.a);
        revolute e(second.head, bar.b);
        revolute f(third.head, bar.c);
    }
}

#[test]
fn redundant_joints_rest_too() {
    let found = Parallelogram::new().stabilise().unwrap().balanced().unwrap();
    // The spring is stronger than the weight upright: 50 > m g l.
    assert!(value(&found, "first.angle").abs() < 1e-10, "{found}");
    assert!(found.free.is_empty());
    // Weaker, it gives way until k a = m g l sin a.
    let heavy = Parallelogram::new().with_lock("first.angle", 20_f64.to_radians());
    let found = heavy.stabilise().unwrap();
    let angle = 20_f64.to_radians();
    assert_needs(&found, "first.angle", 50.0 * angle - 4.0 * 9.81 * 0.5 * angle.sin());
}

scene! {
    pub Chain {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        repeat i in 0..3 {
            body bar[i] { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0.5) m; port b: (0, -0.5) m; }
        }
        revolute first(ground.o, bar[0].a);
        revolute second(bar[0].b, bar[1].a);
        revolute third(bar[1].b, bar[2].a);
    }
}

#[test]
fn a_chain_rests_in_line_from_wherever_it_starts() {
    for start in [[0.5, -0.4, 0.3], [1.5, 1.4, 1.6], [2.0, -1.0, 0.5], [-3.0, 2.0, 1.0]] {
        let mut chain = Chain::new();
        let mut hinge = [0.0, 0.0];
        for (bar, angle) in start.into_iter().enumerate() {
            // From the hinge to the middle of the bar.
            let (sin, cos) = f64::sin_cos(angle);
            chain = chain
                .with_start(&format!("bar[{bar}].angle"), angle)
                .with_start(&format!("bar[{bar}].x"), hinge[0] + 0.5 * sin)
                .with_start(&format!("bar[{bar}].y"), hinge[1] - 0.5 * cos);
            hinge = [hinge[0] + sin, hinge[1] - cos];
        }
        let found = chain.stabilise().unwrap().balanced().unwrap();
        for angle in ["bar[0].angle", "bar[1].angle", "bar[2].angle"] {
            assert!(value(&found, angle).sin().abs() < 1e-10, "{start:?} {found}");
        }
    }
}

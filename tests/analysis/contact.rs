//! Friction and unilateral contact: the linear system of the modes held.

use plm::runtime::linalg::Dense;
use plm::runtime::{Described, Linear, Rate, Vector};
use plm::{Dop853, Linearisation, Moment, Sim, linearise};

/// Declares the same mechanism in the formulation that the compiler takes, and in absolute coordinates.
macro_rules! in_both_formulations {
    ($module:ident { $($item:tt)* }) => {
        mod $module {
            pub(super) mod least {
                plm::mechanism! { pub Scene { $($item)* } }
            }
            pub(super) mod absolute {
                plm::mechanism! { pub Scene { formulation: absolute; $($item)* } }
            }
        }
    };
}

in_both_formulations!(wheel {
    gravity: 9.81 m/s^2;
    param mu: 1 = 0.5;
    input pull: N = 0 N;
    ground { port o: (0, 0) m; }
    body wheel { mass: 2 kg; inertia: 0.3 kg*m^2; port hub: (0, 0) m; start x: 0.1 m; start y: 0.5 m; }
    force spring(wheel.hub) { x: pull - (40 N/m)*wheel.x; }
    unilateral floor: wheel.y >= 0.5 m;
    friction grip: rate(wheel.x + (0.5 m)*wheel.angle) within mu*reaction(floor);
    output wheel.x, drag = reaction(grip);
});

/// The eigenvalues that are not zero.
fn frequencies(system: &Linearisation) -> Vec<f64> {
    let modes = system.modes();
    assert!(modes.iter().all(|mode| mode.eigenvalue.re.abs() < 1e-9), "{system}");
    modes.iter().map(|mode| mode.frequency).filter(|frequency| *frequency > 1e-6).collect()
}

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}");
}

/// Where it grips it rolls, with m + I/r^2; where it slips its friction is known, and it swings with m alone.
#[test]
fn a_wheel_rolls_or_slips() {
    macro_rules! in_formulation {
        ($module:ident) => {{
            let mut scene = wheel::$module::Scene::new();
            let rolls = linearise(&scene.start().unwrap()).unwrap();
            let inertia = 2.0 + 0.3 / 0.25;
            assert_eq!(rolls.a.shape(), (2, 2));
            for frequency in frequencies(&rolls) {
                near(frequency, f64::sqrt(40.0 / inertia), 1e-9);
            }
            // Of a pull the grip takes I/r^2 of m + I/r^2.
            near(rolls.d[(1, 0)], -0.3 / 0.25 / inertia, 1e-12);

            scene.mu = 0.05;
            let mut sim = scene.start().unwrap();
            sim.step_to(0.1).unwrap();
            let slips = linearise(&sim).unwrap();
            assert_eq!(slips.a.shape(), (4, 4));
            let found = frequencies(&slips);
            assert_eq!(found.len(), 2);
            found.into_iter().for_each(|frequency| near(frequency, f64::sqrt(40.0 / 2.0), 1e-9));
            assert_eq!(slips.d[(1, 0)], 0.0);

            scene.start.wheel.y.value = 0.6;
            assert_eq!(linearise(&scene.start().unwrap()).unwrap().a.nrows(), 6);
        }};
    }
    in_formulation!(least);
    in_formulation!(absolute);
}

in_both_formulations!(ladder {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body ladder {
        mass: 3 kg;
        inertia: 1 kg*m^2;
        port top: (0, 1) m;
        port foot: (0, -1) m;
        start angle: 25 deg, locked;
        start x: sin(25 deg)*(1 m), locked;
        start y: cos(25 deg)*(1 m), locked;
    }
    body bob { mass: 1 kg; inertia: 0.1 kg*m^2; port pin: (0, 0.4) m; start angle: -10 deg; start x: 0.4 m; start y: 1.4 m; }
    revolute hinge(ladder.top, bob.pin);
    unilateral wall: ladder.top.x >= 0 m;
    unilateral floor: ladder.foot.y >= 0 m;
    friction slide: rate(ladder.foot.x) within 0.2*reaction(floor);
    friction climb: rate(ladder.top.y) within 0.3*reaction(wall);
    friction rub: rate(bob.angle - ladder.angle) within 0.2*(0.05 m)*norm(hinge.force);
});

/// Derivatives of the rates beside differences, in the modes held; with pushes, slips and a bound by the load of a pin.
#[test]
fn derivatives_are_those_of_the_rates() {
    fn differs<M>(sim: &Sim<M, Dop853<M>>) -> f64
    where
        M: Linear<S = f64> + Described + plm::Mechanism<S = f64>,
    {
        let (mechanism, held, time, x) =
            (sim.state().mechanism(), sim.state().held(), sim.state().time(), *sim.state().x());
        let mut matrix = <M::X as Dense<f64>>::zeros();
        assert!(mechanism.jacobian(time, &held, &x, &mut matrix, None).is_good());
        let mut worst = 0.0_f64;
        for column in 0..M::X::LEN {
            let h = 1e-6;
            let [low, high] = [-h, h].map(|h| {
                let (mut moved, mut rate) = (x, x);
                moved.set(column, x.at(column) + h);
                Rate::rate(mechanism, time, &held, &moved, &mut rate);
                rate
            });
            for row in 0..M::X::LEN {
                let slope = (high.at(row) - low.at(row)) / (2.0 * h);
                let exact = M::X::entry(&matrix, row, column);
                worst = worst.max((slope - exact).abs() / (1.0 + exact.abs()));
            }
        }
        worst
    }
    let mut least = ladder::least::Scene::new().start().unwrap();
    let mut absolute = ladder::absolute::Scene::new().start().unwrap();
    for until in [0.05, 0.2, 0.4, 0.6] {
        least.step_to(until).unwrap();
        absolute.step_to(until).unwrap();
        println!("{:?}", least.contacts().collect::<Vec<_>>());
        // Differences of that length leave 1e-8 of the largest terms.
        assert!(
            differs(&least) < 1e-6 && differs(&absolute) < 1e-6,
            "{until}: {} {}",
            differs(&least),
            differs(&absolute)
        );
    }
}

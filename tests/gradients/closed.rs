//! Derivatives of smooth motions.

use plm::{By, Dop853, mechanism, with_derivatives};

mechanism! {
    pub Pendulum {
        param length: m = 1 m;
        param g: m/s^2 = 9.81 m/s^2;
        gravity: g;
        ground { port pivot: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 1e-14 kg*m^2; port pivot: (0 m, length); start angle: 60 deg, locked; }
        revolute hinge(ground.pivot, bob.pivot);
    }
}

/// The angle is a function of t sqrt(g/l) alone: by its rate, d/dl = -t w/(2 l) and d/dg = t w/(2 g).
#[test]
fn of_a_pendulum_after_three_seconds() {
    let by = [By::Parameter("length"), By::Parameter("g")];
    let mut sim =
        with_derivatives(&Pendulum::new(), by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    let t = 3.0;
    sim.step_to(t.into()).unwrap();
    let ([by_length, by_g], omega) = (sim.bob().angle.tangents, sim.bob().omega.value);
    assert!((by_length + t * omega / 2.0).abs() < 1e-9, "{by_length}");
    assert!((by_g - t * omega / (2.0 * 9.81)).abs() < 1e-10, "{by_g}");
}

//! The benchmark scenes in absolute coordinates, the formulation that holds every mechanism: where they end, how well the joints stay
//! closed, what a right-hand side costs, and how Baumgarte's stabilisation closes what is open.

use plm::runtime::{Absolute as _, Rate as _};
use plm::{Dop853, Dopri5, Mechanism as _, Moment as _, Sim};
use plm_compiler::compile;
use plm_compiler::token::Sources;

use crate::references::{S1_1, S2_1, S2_10, S5_003, S6_1, difference, run};
use crate::scene::{Given as _, Named as _, Scene, State, numbers};
use crate::scenes::{andrews, double_pendulum, four_bar, slider_crank};

double_pendulum!([scene] s1: formulation: absolute; output shoulder.force, elbow.force;);
four_bar!([scene] s2: formulation: absolute; output drive.force;);
slider_crank!([scene] s6: formulation: absolute; output drive.force;);
andrews!([scene] s5: formulation: absolute; output r1.force, r2.force, r4.force;);

#[test]
fn scenes_meet_their_references() {
    let (poses, drift) = run(s1::DoublePendulum::new(), Dopri5::new(1e-12), 1.0);
    assert!(difference(&poses, &S1_1) < 1e-9, "S1: {:e}", difference(&poses, &S1_1));
    assert!(drift.phi < 1e-13 && drift.phi_dot < 1e-13, "S1: {drift:?}");
    for (until, expected) in [(1.0, &S2_1), (10.0, &S2_10)] {
        let (poses, drift) = run(s2::FourBar::new(), Dopri5::new(1e-12), until);
        assert!(difference(&poses, expected) < 1e-9, "S2: {:e}", difference(&poses, expected));
        assert!(drift.phi < 1e-13 && drift.phi_dot < 1e-13, "S2 after {until} s: {drift:?}");
    }
    let (poses, drift) = run(s6::SliderCrank::new(), Dopri5::new(1e-12), 1.0);
    assert!(difference(&poses, &S6_1) < 1e-9, "S6: {:e}", difference(&poses, &S6_1));
    // The scene moves at some 27 rad/s and 5.5 m/s: phi_dot is judged against that.
    assert!(drift.phi < 1e-13 && drift.phi_dot < 27.0 * 1e-13, "S6: {drift:?}");
    let (poses, drift) = run(s5::Andrews::new(), Dopri5::new(1e-12), 0.03);
    assert!(difference(&poses, &S5_003) < 1e-9, "S5: {:e}", difference(&poses, &S5_003));
    // Its shortest bars turn at up to 1300 rad/s.
    assert!(drift.phi < 1e-13 && drift.phi_dot < 1300.0 * 1e-13, "S5: {drift:?}");
}

/// Operations of a right-hand side, which compiled code has as `OPERATIONS`.
fn operations(declaration: &str) -> usize {
    let mut sources = Sources::new();
    sources.add_text("declaration", declaration);
    compile(&mut sources).report.unwrap().rate.total()
}

#[test]
fn right_hand_sides_cost_no_more_than_committed() {
    // (scene, operations now, committed); a sine and cosine of one angle count as one.
    let table = [
        ("S1", operations(s1::DoublePendulum::TEXT), 124),
        ("S2", operations(s2::FourBar::TEXT), 305),
        ("S6", operations(s6::SliderCrank::TEXT), 207),
        ("S5", operations(s5::Andrews::TEXT), 987),
    ];
    for (scene, now, committed) in table {
        assert!(now <= committed, "{scene}: {now} operations, {committed} committed");
        assert!(now + now / 20 >= committed, "{scene}: {now} operations: commit the new count");
    }
}

scene! {
    /// An arm whose hinge is pulled apart, stabilised within tau.
    pub Arm {
        param tau: s = 0.1 s;
        gravity: 9.81 m/s^2;
        stabilisation: baumgarte(tau);
        ground { port o: (0, 0) m; }
        body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; start angle: 20 deg, locked; }
        revolute hinge(ground.o, arm.o);
    }
}

/// phi'' = -2 phi'/tau - phi/tau^2 is solved by (phi + (phi' + phi/tau) t) e^(-t/tau), whatever the rest of the motion is.
#[test]
fn baumgartes_stabilisation_closes_a_gap_as_it_says() {
    for tau in [0.02, 0.1, 0.5] {
        let mechanism = Arm::new().with("tau", tau);
        let start = mechanism.start().unwrap();
        let mut x = *start.state().x();
        let (gap, speed) = ([0.01, -0.02], [0.3, 0.1]);
        for axis in 0..2 {
            x[axis] += gap[axis];
            x[Scene::NQ + axis] += speed[axis];
        }
        let state = State::new(mechanism, start.state().held(), 0.0, x);
        let mut sim: Sim<Scene> = Sim::new(state, Dop853::new(1e-12));
        for _ in 0..40 {
            sim.step(tau / 4.0).unwrap();
            let (t, state) = (sim.time(), sim.state());
            let pose = [sim.state_of("arm").x, sim.state_of("arm").y, sim.state_of("arm").angle];
            let q = *numbers(&pose, &[]).first_chunk().unwrap();
            for (axis, found) in mechanism.phi(state.time(), &q).into_iter().take(2).enumerate() {
                let known = (gap[axis] + (speed[axis] + gap[axis] / tau) * t) * (-t / tau).exp();
                assert!((found - known).abs() < 1e-11, "tau {tau}, {t} s: {found:e} instead of {known:e}");
            }
        }
    }
}

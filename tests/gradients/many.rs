//! More directions than a step has arguments with derivatives, against closed forms.

use std::f64::consts::FRAC_PI_2;

use plm::runtime::Seen;
use plm::runtime::gradient::set_input;
use plm::{By, Dop853, Dual, Rk4, Sim, Term, Trace, mechanism, with_derivatives, with_trace};

use super::adjoint::{Cart, gradient};

mechanism! {
    part spring_to_origin(on: body) {
        param stiffness: N/m = 9 N/m;
        force on on: (-stiffness*on.x, 0 N);
    }
    /// A mass on a spring that strikes a wall. A step has four arguments that move: place, speed and both parameters.
    pub Ball {
        param stiffness: N/m = 9 N/m;
        param wall: m = 0.3 m;
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start x: 1 m, locked; }
        constraint level: ball.angle = 0;
        constraint height: ball.y = 0;
        spring_to_origin spring(ball) { stiffness: stiffness; }
        unilateral stop: ball.x + wall >= 0 m { restitution: 0.6; }
    }
}

const AT: [f64; 2] = [9.0, 0.3];

/// Stiffness and wall change by so much in eight directions.
const ALONG: [[f64; 8]; 2] =
    [[1.0, 0.0, 2.0, -1.0, 0.0, 0.5, 3.0, 0.0], [0.0, 1.0, 1.0, 2.0, 0.0, -0.5, 0.0, -1.0]];

fn lifted() -> Ball<Dual<f64, 8>> {
    let [stiffness, wall] = [0, 1].map(|k| Dual { value: AT[k], tangents: ALONG[k] });
    Ball { stiffness, wall, ..Ball::of() }
}

/// When it strikes the wall.
fn struck([stiffness, wall]: [f64; 2]) -> f64 {
    (FRAC_PI_2 + wall.asin()) / stiffness.sqrt()
}

/// Its place: a cosine to the wall, from there with 0.6 of the speed.
fn place(at: [f64; 2], time: f64) -> f64 {
    let ([stiffness, wall], omega) = (at, at[0].sqrt());
    let phase = omega * (time - struck([stiffness, wall]));
    if phase < 0.0 {
        return (omega * time).cos();
    }
    -wall * phase.cos() + 0.6 * (1.0 - wall * wall).sqrt() * phase.sin()
}

/// Asserts that its derivatives are those of the closed form.
fn are_known(found: Dual<f64, 8>, time: f64, within: f64) {
    assert!((found.value - place(AT, time)).abs() < within, "{time}: {}", found.value);
    let by_stiffness = super::slope(|stiffness| place([stiffness, AT[1]], time), AT[0]);
    let by_wall = super::slope(|wall| place([AT[0], wall], time), AT[1]);
    for (k, found) in found.tangents.into_iter().enumerate() {
        let known = ALONG[0][k] * by_stiffness + ALONG[1][k] * by_wall;
        assert!((found - known).abs() < within, "{time}, direction {k}: {found} is not {known}");
    }
}

#[test]
fn across_an_impact_and_between_steps() {
    let mut sim = lifted().start_with(Dop853::new(1e-12.into())).unwrap();
    let (end, mut samples) = (1.1, 0);
    Sim::watch(&mut sim, end.into(), 0.07.into(), |seen| {
        // At the impact itself the closed form has a corner within reach of its differences.
        if let Seen::Sample(state) = seen
            && (state.time().value - struck(AT)).abs() > 0.01
        {
            are_known(state.ball().x, state.time().value, 3e-9);
            samples += 1;
        }
    })
    .unwrap();
    assert!(samples > 10);
    are_known(sim.ball().x, end, 3e-10);

    let mut alone = Ball::new().start_with(Dop853::new(1e-12)).unwrap();
    alone.step_to(end).unwrap();
    assert_eq!(sim.ball().x.value, alone.ball().x);
}

#[test]
fn by_steps_of_one_length() {
    let mut sim = lifted().start_with(Rk4::new(1e-3.into())).unwrap();
    sim.step_to(0.5.into()).unwrap();
    are_known(sim.ball().x, 0.5, 1e-10);
}

/// Nothing has derivatives before the input has them.
#[test]
fn by_an_input_that_begins_later() {
    let lifted = with_derivatives(&Cart::new(), [By::Input("push"); 8]).unwrap();
    let mut sim = lifted.start_with(Dop853::new(1e-12.into())).unwrap();
    sim.step(0.5.into()).unwrap();
    assert_eq!(sim.cart().x.tangents, [0.0; 8]);
    let tangents = core::array::from_fn(|k| k as f64);
    set_input(&mut sim, "push", Dual { value: 3.0, tangents }).unwrap();
    sim.step(0.7.into()).unwrap();
    // m v' = u - c v with m = 2 kg, c = 0.5 N s/m.
    let (c, m, t) = (0.5, 2.0, 0.7_f64);
    let by_push = (t - m / c * (1.0 - (-c * t / m).exp())) / c;
    for (k, found) in sim.cart().x.tangents.into_iter().enumerate() {
        assert!((found - k as f64 * by_push).abs() < 1e-10, "{k}: {found}");
    }
}

/// What is named twice has its derivatives in both directions, forward and backward.
#[test]
fn of_names_that_stand_twice() {
    let by =
        [By::Parameter("stiffness"), By::Start("ball.x"), By::Parameter("stiffness"), By::Start("ball.x")];
    let mut sim = with_derivatives(&Ball::new(), by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    sim.step_to(0.4.into()).unwrap();
    let [by_stiffness, by_start, again, start_again] = sim.ball().x.tangents;
    // x = cos(sqrt(c) t) before the wall.
    assert!(
        (by_stiffness + 0.4 / 6.0 * f64::sin(1.2)).abs() < 1e-10 && (by_start - f64::cos(1.2)).abs() < 1e-10
    );
    assert_eq!([again, start_again], [by_stiffness, by_start]);

    let mut terms = vec![Term::EMPTY; 100_000];
    let trace = Trace::new(&mut terms, 4);
    let start = with_trace(&Ball::new(), &by, &trace).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    let advance = |sim: &mut _| Sim::step_towards(sim, 0.4.into());
    let (_, [backward]) = gradient(&trace, 1, start, advance, |sim| [sim.ball().x]).unwrap();
    let forward = [by_stiffness, by_start, again, start_again];
    assert!(backward.iter().zip(forward).all(|(a, b)| (a - b).abs() < 1e-12), "{backward:?} {forward:?}");
}

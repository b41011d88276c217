//! Derivatives are those of the steps that were made, also where these are so long that they are rough.

use plm::{By, Dop853, Dopri5, Dual, Mechanism as _, Sim, Term, Trace, with_derivatives, with_trace};

use super::adjoint::gradient;
use super::body;
use crate::scene::Given as _;

scene! {
    part spring_to_origin(on: body) {
        param stiffness: N/m = 9 N/m;
        force on on: (-stiffness*on.x, 0 N);
    }
    /// A mass that strikes a wall, and a mass that an event sends back.
    pub Rough {
        param stiffness: N/m = 9 N/m;
        param wall: m = 0.3 m;
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start x: 1 m, locked; }
        constraint level: ball.angle = 0;
        constraint height: ball.y = 0;
        spring_to_origin spring(ball) { stiffness: stiffness; }
        unilateral stop: ball.x + wall >= 0 m { restitution: 0.6; }
        body block { mass: 1 kg; inertia: 1 kg*m^2; start x: 1 m, locked; }
        constraint upright: block.angle = 0;
        constraint line: block.y = 0;
        spring_to_origin other(block) { stiffness: 1.1*stiffness; }
        when block.x < 0.1 m - wall { block.vx = -0.7*block.vx; }
    }
}

scene! {
    /// A slider-crank against a buffer, whose force jumps.
    pub Buffered {
        param radius: m = 0.119 m;
        param rod: m = 0.392 m;
        ground { port o: (0, 0) m; }
        body crank {
            mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0, 0) m; port b: (radius, 0 m);
            start angle: 1.2 rad, locked; start omega: 6 rad/s, locked;
        }
        body link { mass: 0.5 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (rod, 0 m); start angle: -0.3 rad; }
        body slide { mass: 0.5 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; start x: 0.35 m; }
        revolute main(ground.o, crank.a);
        revolute pin(crank.b, link.a);
        revolute end(link.b, slide.b);
        prismatic guide(ground.o, slide.b);
        let depth = slide.x - 0.338 m;
        force buffer(slide.b) { x: if depth > 0 m then -365 N/m*depth - 2 N else 0 N; }
    }
}

/// All steps are of this length, s, but for those that an event or the end cuts off.
const STEP: f64 = 0.2;
/// Relative tolerance, which such steps keep.
const TOLERANCE: f64 = 300.0;
const END: f64 = 1.1;

fn ends([stiffness, wall]: [f64; 2]) -> [f64; 2] {
    let method = Dopri5::new(TOLERANCE).with_longest_step(STEP);
    let mut sim = Rough::new().with("stiffness", stiffness).with("wall", wall).start_with(method).unwrap();
    sim.step_to(END).unwrap();
    [body(sim.state(), "ball").x, body(sim.state(), "block").x]
}

/// By central differences of two widths, whose errors of the second order cancel.
fn slopes(at: [f64; 2], by: usize) -> [f64; 2] {
    let central = |width: f64| {
        let [above, below] = [width, -width].map(|width| {
            let mut at = at;
            at[by] += width;
            ends(at)
        });
        [0, 1].map(|k| (above[k] - below[k]) / (2.0 * width))
    };
    let (wide, narrow) = (central(2e-3), central(1e-3));
    [0, 1].map(|k| (4.0 * narrow[k] - wide[k]) / 3.0)
}

/// Ends with their derivatives by dual numbers.
fn forward(by: [By; 2]) -> [Dual<f64, 2>; 2] {
    let method = Dopri5::new(TOLERANCE.into()).with_longest_step(STEP.into());
    let mut sim = with_derivatives(&Rough::new(), by).unwrap().start_with(method).unwrap();
    sim.step_to(END.into()).unwrap();
    ["ball", "block"].map(|name| body(sim.state(), name).x)
}

/// Derivatives of the ends by the reverse of a trace.
fn backward(by: [By; 2]) -> [Vec<f64>; 2] {
    let mut terms = vec![Term::EMPTY; 200_000];
    let trace = Trace::new(&mut terms, 2);
    let method = Dopri5::new(TOLERANCE.into()).with_longest_step(STEP.into());
    let sim = with_trace(&Rough::new(), &by, &trace).unwrap().start_with(method).unwrap();
    let advance = |sim: &mut _| Sim::step_towards(sim, END.into());
    gradient(&trace, 20, sim, advance, |sim| ["ball", "block"].map(|name| body(sim.state(), name).x))
        .unwrap()
        .1
}

/// In a build that is not optimised, dual numbers of a mechanism from text need more stack than the thread of a test has.
#[test]
fn rough_steps_have_their_own_derivatives() {
    let thread = std::thread::Builder::new().stack_size(16 << 20).spawn(compare);
    thread.unwrap().join().unwrap();
}

fn compare() {
    let by = [By::Parameter("stiffness"), By::Parameter("wall")];
    let at = [9.0, 0.3];
    // Closed form: a quarter of a turn to the middle, from there to the wall, and back at 0.6 of the speed.
    let (omega, wall) = (3.0_f64, 0.3_f64);
    let struck = (std::f64::consts::FRAC_PI_2 + wall.asin()) / omega;
    let phase = omega * (END - struck);
    let exact = -wall * phase.cos() + 0.6 * (1.0 - wall * wall).sqrt() * phase.sin();
    let rough = (ends(at)[0] - exact).abs();
    assert!(
        rough > 1e-6,
        "{rough:e}: the steps are too good to tell their derivatives from those of the motion"
    );

    let (forward, backward) = (forward(by), backward(by));
    assert_eq!(forward.map(|x| x.value), ends(at));

    // Measured 8e-8 and 3e-10; states that move along their rate at the event differ by 4e-7 and 5e-6. An event is found on the dense output,
    // whose error has a derivative by the stiffness, and none by the place of the wall.
    for (parameter, most) in [2e-7, 1e-9].into_iter().enumerate() {
        let expected = slopes(at, parameter);
        for output in 0..2 {
            let (forward, backward) = (forward[output].tangents[parameter], backward[output][parameter]);
            let differs = (forward - expected[output]).abs();
            assert!(differs < most, "{parameter} {output}: {forward} for {}", expected[output]);
            assert!((forward - backward).abs() < 1e-12, "{parameter} {output}: {forward} {backward}");
        }
    }
}

/// The lengths of the steps after an event are values. One that moved with the event would pass it on, enlarged from step to step: then the
/// derivative of 78 is wrong by 1.6e-5 at the looser tolerance.
#[test]
fn lengths_of_steps_do_not_move_with_events() {
    let [loose, tight] = [1e-9, 1e-12].map(|tolerance| {
        let by = [By::Parameter("radius"), By::Parameter("rod")];
        let buffered = with_derivatives(&Buffered::new(), by).unwrap();
        let mut sim = buffered.start_with(Dop853::new(tolerance.into())).unwrap();
        sim.step_to(1.0.into()).unwrap();
        assert!(sim.stats().switches > 3);
        body(sim.state(), "crank").angle.tangents
    });
    for (loose, tight) in loose.into_iter().zip(tight) {
        assert!((loose - tight).abs() < 1e-6, "{loose} {tight}");
    }
}

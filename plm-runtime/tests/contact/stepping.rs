//! The time stepping of Moreau and Jean: order, rest without creep, energy of impacts, and its small problem against enumeration.

use plm_runtime::contact::{self, Change, Held, ImpactLaw, Law, Limit, Modal, Mode, Rows, Stride};
use plm_runtime::{Dop853, Mechanism, MoreauJean, Scalar, Sim};

use crate::block::Block;
use crate::bodies::rocking;
use crate::energy::{Numbers, Random, begin, energy, random};
use crate::friction::Roller;
use crate::impacts::{Ball, Cradle};
use crate::oscillator::Oscillator;
use crate::slider_crank::{inertia, slider};
use crate::support::{Row, Scene, dot, system};

const GRAVITY: f64 = 9.81;

fn at<M: Mechanism<S = f64> + Copy>(scene: M, method: MoreauJean<f64>, t: f64) -> Sim<M, MoreauJean<f64>> {
    let mut sim = scene.start_with(method).unwrap();
    sim.step(t).unwrap();
    sim
}

/// Errors at steps of 8 ms and of an eighth, and of an eighth of that: within `most` times the step.
fn errors(most: f64, error: impl Fn(f64) -> f64) -> [f64; 3] {
    [8e-3, 1e-3, 1.25e-4].map(|h| {
        let found = error(h).abs();
        assert!(found <= most * h, "{h}: {found:e}");
        found
    })
}

/// Order 1 over impacts, changes of stick and slip and a corner that strikes, for each theta; an event-driven run agrees to 1e-9.
#[test]
fn errors_fall_with_the_step() {
    for theta in [0.5, 0.75, 1.0] {
        let by = |h: f64| MoreauJean::new(h).with_theta(theta);
        // The second flight of a ball, at its top: a quarter of the first height.
        let top = 1.5 * (2.0 / GRAVITY).sqrt();
        let ball = Ball { height: 1.0, angle: 0.0, restitution: 0.5 };
        errors(4.0, |h| at(ball, by(h), top).x[1] - 0.25);
        // A belt: stuck again after the first slip.
        let caught = 0.3924 + 0.433_536_962_770_418_6;
        errors(0.5, |h| at(Oscillator::ON_BELT, by(h), caught + 0.1).x[0] - 0.01981);
        // A rocking block after its first impact, at the turn.
        let turn = 0.5 * (0.347_093_586_788_881_3 + 0.950_920_536_477_668_3);
        let block = rocking(0.5 * 0.2_f64.atan());
        errors(4.0, |h| at(block, by(h), turn).x[2].abs() - 0.083_339_113_164_354_69);
        // A disc that is thrown sliding rolls.
        let disc = Roller { inertia: 0.5, friction: 0.2, incline: 0.0, start: [5.0, 0.0] };
        let rolls = 0.849_473_326_537_546_7;
        let [_, _, finest] =
            errors(1.0, |h| at(disc, by(h), rolls + 1.0).x[0] - 3.539_472_193_906_444_6 - 10.0 / 3.0);
        assert!(theta > 0.5 || finest < 1e-6, "{finest:e}");
    }
}

/// The slider-crank, driven by 8 N m against 50 N s/m at its slider and 0.5 N m at its crank, until the crank strikes a stop.
#[derive(Clone, Copy, Debug)]
struct Driven;

impl Scene<1, 2> for Driven {
    fn laws(&self) -> [Law<f64>; 2] {
        [Law::Unilateral { restitution: 0.5 }, Law::Friction]
    }
    fn free<T: Scalar>(&self, _t: T, q: [T; 1], v: [T; 1]) -> [T; 1] {
        let ([mass, rate], [way, _]) = (inertia(q[0]), slider(q[0]));
        [(T::lit(8.0) - T::lit(50.0) * way * way * v[0] - rate * v[0] * v[0]) / mass]
    }
    fn inverse_mass<T: Scalar>(&self, q: [T; 1]) -> [[T; 1]; 1] {
        [[T::lit(1.0) / inertia(q[0])[0]]]
    }
    fn contact<T: Scalar>(&self, _t: T, q: [T; 1], _v: [T; 1]) -> [Row<T, 1>; 2] {
        [Row::fixed(T::lit(25.0) - q[0], [T::lit(-1.0)]), Row::fixed(q[0], [T::lit(1.0)])]
    }
    fn friction<T: Scalar>(&self, _t: T, _q: [T; 1], _v: [T; 1], rows: &mut Rows<T, 2>) {
        rows.set_friction(1, Limit::own(T::lit(0.5)));
    }
    fn start(&self) -> ([f64; 1], [f64; 1]) {
        ([1.0], [20.0])
    }
}

system!(Driven, 1, 2);

/// Two evaluations are of order 2 where forces depend on velocities, and through an impact of the crank. Angles at
/// 0.5 s and 0.82 s, rad, by the classical Runge-Kutta method with steps of 25 us in Python, from the kinetic energy and its derivative
/// by a complex step; the impact by bisection.
#[test]
fn two_evaluations_are_of_order_2() {
    let (before, behind) = (15.357_881_417_462, 24.701_471_262_149);
    let two = |h: f64, t: f64| {
        let mut sim = Driven.start_with(MoreauJean::new(h).with_evaluations::<2>()).unwrap();
        sim.step(t).unwrap();
        let stats = sim.stats();
        // An impact takes an evaluation, and those of the step without it and of its rest.
        assert_eq!(stats.evaluations, 2 * stats.steps + 5 * u64::from(t > 0.6));
        assert!(sim.method().largest_residual() < 1e-12, "{:e}", sim.method().largest_residual());
        sim.x[0]
    };
    let found = [2e-3, 1e-3, 5e-4, 2.5e-4].map(|h| (two(h, 0.5) - before).abs());
    for pair in found.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.05, "{found:?}");
    }
    let found = [2e-3, 1e-3, 5e-4, 2.5e-4].map(|h| (two(h, 0.82) - behind).abs());
    for pair in found.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.2, "{found:?}");
    }
    let one = at(Driven, MoreauJean::new(2.5e-4), 0.5).x[0] - before;
    assert!(one.abs() > 300.0 * found[3], "{one:e} {found:?}");
}

/// A block at 99 percent of its bound, and a block on two corners that rock to rest, stay where they are, to rounding.
#[test]
fn what_sticks_does_not_creep() {
    for theta in [0.5, 1.0] {
        let method = MoreauJean::new(1e-3).with_theta(theta);
        let block = Block { incline: 0.3, mu: 0.3_f64.tan() / 0.99, e: 0.0, until: 1.0, start: [0.0; 4] };
        let mut sim = at(block, method, 0.1);
        let place = sim.x;
        sim.step(10.0).unwrap();
        assert_eq!(sim.held.contact.modes.of, [Mode::Closed, Mode::Sticks]);
        for i in 0..4 {
            assert!((sim.x[i] - place[i]).abs() < 1e-16, "{theta}: {:?}", sim.x);
        }
        // Beyond it slides with the difference.
        let slides = Block { mu: 0.3_f64.tan() * 0.9, ..block };
        let sim = at(slides, method, 1.0);
        let way = 0.5 * GRAVITY * 0.1 * 0.3_f64.sin();
        assert!((sim.x[0] - way).abs() < 1e-3 * way + 1e-12, "{:?}", sim.x);

        let mut sim = at(rocking(0.5 * 0.2_f64.atan()), method, 9.0);
        let place = sim.x;
        assert!(sim.held.is_sticking(1) && sim.held.is_sticking(3), "{:?}", sim.held);
        assert!(sim.held.are_undetermined() && sim.x[2].abs() < 1e-12, "{:?}", sim.x);
        sim.step(10.0).unwrap();
        for i in 0..6 {
            assert!((sim.x[i] - place[i]).abs() < 1e-14, "{theta}: {:?} {place:?}", sim.x);
        }
        // As it lands its feet have rates along the floor that differ by its turn.
        assert!(sim.method().largest_residual() < 1e-6, "{:e}", sim.method().largest_residual());
    }
}

/// A ball with e = 1 keeps its energy; with less it comes to rest in the time of the closed form, and neither is ever below the ground.
#[test]
fn a_ball_bounces_and_comes_to_rest() {
    let of = |x: &[f64; 4]| GRAVITY * x[1] + 0.5 * x[3] * x[3];
    let ball = Ball { height: 1.0, angle: 0.0, restitution: 1.0 };
    let mut sim = ball.start_with(MoreauJean::new(1e-3)).unwrap();
    for _ in 0..10_000 {
        sim.step(1e-3).unwrap();
        assert!(sim.x[1] >= 0.0 && (of(&sim.x) - GRAVITY).abs() < 1e-11, "{:?}", sim.x);
    }
    assert!(sim.x[1] <= 1.0 && sim.stats().steps == 10_000);
    let rest = 3.0 * (2.0 / GRAVITY).sqrt();
    let ball = Ball { restitution: 0.5, ..ball };
    let mut sim = ball.start_with(MoreauJean::new(1e-3)).unwrap();
    let mut last = of(&sim.x);
    for _ in 0..2_000 {
        sim.step(1e-3).unwrap();
        assert!(sim.x[1] >= -1e-16 && of(&sim.x) <= last + 1e-14, "{:?}", sim.x);
        last = of(&sim.x);
        assert!(sim.time > rest - 0.02 || last > 1e-6, "{:?}", sim.x);
    }
    assert!(
        sim.x[1].abs() < 1e-16 && sim.x[3].abs() < 1e-16 && sim.held.of[0] == Mode::Closed,
        "{:?}",
        sim.x
    );
}

/// Three balls that touch: (-1/3, 2/3, 2/3) by Poisson's law, (0, 0, 1) pair by pair.
#[test]
fn a_cradle_follows_its_law() {
    for (law, known) in
        [(ImpactLaw::Poisson, [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0]), (ImpactLaw::Sequential, [0.0, 0.0, 1.0])]
    {
        let mut sim = Cradle { gap: 0.0, restitution: 1.0, law }.start_with(MoreauJean::new(1e-3)).unwrap();
        sim.step(0.1).unwrap();
        for i in 0..3 {
            assert!((sim.x[3 + i] - known[i]).abs() < 1e-12, "{law:?}: {:?}", sim.x);
        }
    }
}

/// One step of 1 us from the beginning of a random system whose contacts are closed: velocities, and by how much laws are not met.
fn one_step(scene: &Random) -> ([f64; 3], f64) {
    let v = scene.speed;
    let (mut u, mut x) = (Held::<f64, 4>::open(), [0.0, 0.0, 0.0, v[0], v[1], v[2]]);
    u.modes_mut().change = Change::InSteps;
    let stride = Stride { t: 0.0, h: 1e-6, theta: 1.0 };
    let solution = contact::step::<_, 4, 1>(scene, &stride, &mut u, &mut x, |_, _, _| Ok(())).unwrap();
    assert!(solution.rounds <= 60, "{}", solution.rounds);
    ([x[3], x[4], x[5]], solution.residual)
}

/// Without friction no step gains energy, by either law; with friction the small problem has the velocities of the enumeration, where
/// that finds one solution.
#[test]
fn steps_of_random_systems() {
    let mut numbers = Numbers(34);
    let (mut compared, mut unsolved) = (0, 0);
    for case in 0..3000 {
        for law in [ImpactLaw::Poisson, ImpactLaw::Newton] {
            let (scene, mass) = random(&mut numbers, law);
            let smooth = Random { friction: 0.0, ..scene };
            // By Newton's law a gap that leaves, and is not to sink in, may gain.
            let leaves = |row: usize| dot(&scene.directions[row], &scene.speed) > 0.0;
            if law == ImpactLaw::Newton && (leaves(0) || leaves(2)) {
                continue;
            }
            let (after, residual) = one_step(&smooth);
            let (had, has) = (energy(&mass, &scene.speed), energy(&mass, &after));
            assert!(has <= had * (1.0 + 1e-12), "{case} {law:?}: {had} {has} {residual:e}");
            assert!(residual < 1e-12, "{case} {law:?}: {residual:e}");
        }
        let (scene, _) = random(&mut numbers, ImpactLaw::Poisson);
        let scene = Random { restitution: 0.0, ..scene };
        let (u, known, found) = begin(&scene);
        let (after, residual) = one_step(&scene);
        unsolved += usize::from(residual > 1e-12);
        let counts = u.status().counts();
        if found.is_err() || counts.impacts != 1 || counts.ambiguous + counts.ambiguous_impacts > 0 {
            continue;
        }
        if residual < 1e-12 {
            compared += 1;
            for i in 0..3 {
                assert!((after[i] - known[i]).abs() < 1e-10, "{case}: {after:?} {known:?} {residual:e}");
            }
        }
    }
    println!("compared {compared}, with a residual {unsolved} of 3000");
    assert!(compared > 1000 && unsolved < 30, "{compared} {unsolved}");
}

/// A run by events goes on from a state that steps have led to, and steps go on from one of events.
#[test]
fn a_run_changes_its_method() {
    let ball = Ball { height: 1.0, angle: 0.0, restitution: 0.5 };
    let stepped = at(ball, MoreauJean::new(1e-4), 0.5);
    let mut by_events = Sim::<Ball, _>::new(*stepped.state(), Dop853::new(1e-10));
    by_events.step(1.5).unwrap();
    assert_eq!((by_events.held.of[0], by_events.held.change), (Mode::Closed, Change::AtEvents));
    assert!(by_events.x[1].abs() < 1e-12);
    let mut stepped = Sim::<Ball, _>::new(*by_events.state(), MoreauJean::new(1e-3));
    stepped.step(1.0).unwrap();
    assert_eq!((stepped.held.of[0], stepped.held.change), (Mode::Closed, Change::InSteps));
    assert!(stepped.x[1].abs() < 1e-12);
}

//! Identification: the truth by readings without noise, covariance by closed forms, what readings do not tell, mistakes.

use plm::optimise::{ByDop853, Error, Experiment, Identification, Unknown};
use plm::runtime::described::by_number;
use plm::{Described, Dop853, Mechanism};

use super::{Few, mechanism, set_start};

/// Readings of observables at times of a run with a finer tolerance, SI.
pub fn readings(of: &Few, names: &[&str], times: &[f64]) -> Vec<Vec<f64>> {
    let mut sim = of.start_with(Dop853::new(1e-13)).unwrap();
    let all = of.observables();
    let places: Vec<usize> =
        names.iter().map(|name| all.iter().position(|own| own.0 == *name).unwrap()).collect();
    let mut columns = vec![Vec::new(); names.len()];
    for time in times {
        sim.step_to(*time).unwrap();
        for (column, place) in columns.iter_mut().zip(&places) {
            column.push(Few::observed(sim.state(), *place).unwrap());
        }
    }
    columns
}

pub fn set(of: &mut Few, name: &str, value: f64) {
    let index = of.tables().parameters.iter().position(|own| own.name == name).unwrap();
    by_number::set_parameter(of, index, value);
}

/// Times from 0 on.
pub fn times(count: usize, every: f64) -> Vec<f64> {
    (0..count).map(|k| k as f64 * every).collect()
}

pub const PENDULUM: &str = "pub Pendulum {
    param length: m = 1 m;
    param damping: N*m*s/rad = 0.2 N*m*s/rad;
    param g: m/s^2 = 9.81 m/s^2;
    gravity: g;
    ground { port o: (0, 0) m; }
    body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0 m, length); start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
    revolute hinge(ground.o, bob.pivot) { damping: damping; }
    output bob.angle in deg;
}";

#[test]
fn pendulum_by_readings_without_noise() {
    let truth = mechanism(PENDULUM);
    let times = times(60, 0.05);
    let angles = &readings(&truth, &["bob.angle"], &times)[0];
    let mut guess = truth;
    set(&mut guess, "length", 0.7);
    set(&mut guess, "damping", 0.0);
    let experiment = Experiment::new(times).measured("bob.angle", "rad", angles.clone());
    let fit = Identification::new(guess)
        .find(Unknown::parameter("length").within(0.1, 3.0))
        .find(Unknown::parameter("damping"))
        .find(Unknown::start("bob.angle").from(0.9))
        .experiment(experiment)
        .run_by(ByDop853(1e-11))
        .unwrap();
    println!("{fit} {} {}", fit.iterations, fit.runs);
    assert!((fit.value("length").unwrap() - 1.0).abs() < 1e-8);
    assert!((fit.value("damping").unwrap() - 0.2).abs() < 1e-8);
    assert!((fit.value("bob.angle").unwrap() - 60_f64.to_radians()).abs() < 1e-8);
}

/// A ball that bounces, a mass on a spring, and a cart: side by side.
pub const YARD: &str = "pub Yard {
    param e: 1 = 0.8;
    param g: m/s^2 = 9.81 m/s^2;
    param mass: kg = 2 kg;
    param stiffness: N/m = 50 N/m;
    param damping: N*s/m = 0.7 N*s/m;
    input push: N = 0 N;
    gravity: g;
    body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m, locked; start vy: 0 m/s, locked; }
    unilateral floor: ball.y >= 0 m { restitution: e; }
    ground { port rail: (0, 0) m; }
    body cart { mass: mass; inertia: 1 kg*m^2; port shoe: (0, 0) m; start x: 0.1 m, locked; start vx: 0 m/s, locked; }
    prismatic rail(ground.rail, cart.shoe) { stiffness: stiffness; damping: damping; drive: push; }
    output ball.y in mm, rail.displacement;
}";

#[test]
fn restitution_and_gravity_of_a_ball_by_readings_without_noise() {
    let truth = mechanism(YARD);
    let times = times(25, 0.08);
    let heights = &readings(&truth, &["ball.y"], &times)[0];
    let mut guess = truth;
    set(&mut guess, "e", 0.7);
    set(&mut guess, "g", 9.6);
    let millimetres: Vec<f64> = heights.iter().map(|height| height * 1e3).collect();
    let fit = Identification::new(guess)
        .find(Unknown::parameter("e").within(0.0, 1.0))
        .find(Unknown::parameter("g"))
        .experiment(Experiment::new(times).measured("ball.y", "mm", millimetres))
        .run_by(ByDop853(1e-11))
        .unwrap();
    assert!((fit.value("e").unwrap() - 0.8).abs() < 1e-8, "{fit}");
    assert!((fit.value("g").unwrap() - 9.81).abs() < 1e-8, "{fit}");
}

/// A free oscillation tells the ratio of stiffness and mass alone, a known push tells both.
#[test]
fn what_readings_do_not_tell() {
    let truth = mechanism(YARD);
    let times = times(20, 0.1);
    let places = &readings(&truth, &["rail.displacement"], &times)[0];
    let mut guess = truth;
    set(&mut guess, "mass", 2.6);
    set(&mut guess, "stiffness", 60.0);
    let free = Experiment::new(times.clone()).measured("rail.displacement", "m", places.clone());
    let problem = Identification::new(guess)
        .find(Unknown::parameter("mass").within(0.1, 100.0))
        .find(Unknown::parameter("stiffness"))
        .find(Unknown::parameter("damping"));
    let fit = problem.clone().experiment(free.clone()).run().unwrap();
    let [mass, stiffness, damping] = ["mass", "stiffness", "damping"].map(|name| fit.value(name).unwrap());
    assert!((stiffness / mass - 25.0).abs() < 1e-7 && (damping / mass - 0.35).abs() < 1e-7, "{fit}");
    let [untold] = &fit.undetermined[..] else { panic!("{fit}") };
    let change = |name: &str| untold.changes.iter().find(|own| own.0 == name).unwrap().1;
    assert!((change("stiffness") / change("mass") - stiffness / mass).abs() < 1e-5, "{fit}");
    assert!((change("damping") / change("mass") - damping / mass).abs() < 1e-5, "{fit}");
    assert!(fit.standard_error("mass").unwrap().is_infinite());

    // From another start, with pushes that change.
    let (began, pushes) = ([0.0, 0.5, 1.0], [3.0, -2.0, 0.0]);
    let mut pushed = truth;
    set_start(&mut pushed, "cart.x", 0.02);
    let mut sim = pushed.start_with(Dop853::new(1e-13)).unwrap();
    let mut seen = Vec::new();
    for time in &times {
        sim.step_to(*time).unwrap();
        seen.push(Few::observed(sim.state(), 1).unwrap());
        if let Some(k) = began.iter().position(|own| own == time) {
            by_number::set_input(&mut sim, 0, pushes[k]);
        }
    }
    let pushed = Experiment::new(times)
        .measured("rail.displacement", "m", seen)
        .input("push", "N", began, pushes)
        .start("cart.x", 0.02);
    let fit = problem.experiment(free).experiment(pushed).run_by(ByDop853(1e-11)).unwrap();
    assert!(fit.undetermined.is_empty(), "{fit}");
    for (name, value) in [("mass", 2.0), ("stiffness", 50.0), ("damping", 0.7)] {
        assert!((fit.value(name).unwrap() - value).abs() < 1e-8 * value, "{fit}");
    }
}

/// Of a throw y = h + v t - g t^2/2 the covariance is sigma^2 (X^T X)^-1 with the rows (1, t, -t^2/2).
#[test]
fn covariance_of_a_throw() {
    let truth = mechanism(YARD);
    let (sigma, noise) = (0.02, [1.0, -0.6, 0.3, 0.9, -1.4, 0.2, 0.5, -0.8]);
    let times: Vec<f64> = (0..8).map(|k| 0.05 * f64::from(k)).collect();
    let heights: Vec<f64> =
        times.iter().zip(noise).map(|(t, noise)| 1.0 - 4.905 * t * t + sigma * noise).collect();
    let of = |experiment: Experiment| {
        Identification::new(truth)
            .find(Unknown::start("ball.y"))
            .find(Unknown::start("ball.vy"))
            .find(Unknown::parameter("g"))
            .experiment(experiment)
            .run()
            .unwrap()
    };
    let readings = Experiment::new(times.clone()).measured("ball.y", "m", heights.clone());
    let known = of(readings.clone().deviation("ball.y", sigma));
    let rows = rows_of(&times);
    let inverse = inverse(normal(&rows));
    for i in 0..3 {
        for k in 0..3 {
            let closed = sigma * sigma * inverse[i][k];
            assert!(
                (known.covariance[(i, k)] / closed - 1.0).abs() < 1e-7,
                "{} {closed}",
                known.covariance[(i, k)]
            );
        }
    }
    // Without a deviation it comes from the residuals, with as many freedoms as there are readings more than unknowns.
    let unknown = of(readings);
    let values = unknown.estimates.iter().map(|estimate| estimate.value).collect::<Vec<_>>();
    let squares: f64 = rows
        .iter()
        .zip(&heights)
        .map(|(row, height)| row.iter().zip(&values).map(|(x, value)| x * value).sum::<f64>() - height)
        .map(|residual| residual * residual)
        .sum();
    let closed = (squares / 5.0 * inverse[2][2]).sqrt();
    assert!((unknown.standard_error("g").unwrap() / closed - 1.0).abs() < 1e-7, "{unknown}");
    assert_eq!(unknown.freedoms, 5);
}

fn rows_of(times: &[f64]) -> Vec<[f64; 3]> {
    times.iter().map(|t| [1.0, *t, -0.5 * t * t]).collect()
}

fn normal(rows: &[[f64; 3]]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|k| rows.iter().map(|row| row[i] * row[k]).sum()))
}

/// By cofactors.
fn inverse(a: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let minor = |i: usize, k: usize| {
        let ([p, q], [r, s]) = ([(i + 1) % 3, (i + 2) % 3], [(k + 1) % 3, (k + 2) % 3]);
        a[p][r] * a[q][s] - a[p][s] * a[q][r]
    };
    let determinant: f64 = (0..3).map(|k| a[0][k] * minor(0, k)).sum();
    std::array::from_fn(|i| std::array::from_fn(|k| minor(k, i) / determinant))
}

/// A bound holds an unknown as if it were known; what is expected draws it.
#[test]
fn bounds_and_expected_values() {
    let truth = mechanism(YARD);
    let times = times(20, 0.1);
    let places = &readings(&truth, &["rail.displacement"], &times)[0];
    let experiment = Experiment::new(times)
        .measured("rail.displacement", "m", places.clone())
        .deviation("rail.displacement", 1e-3);
    let problem = Identification::new(truth).find(Unknown::parameter("damping")).experiment(experiment);
    let bounded =
        problem.clone().find(Unknown::parameter("stiffness").from(45.0).within(40.0, 49.0)).run().unwrap();
    assert_eq!(bounded.value("stiffness"), Some(49.0));
    assert_eq!(bounded.estimates[1].bound, Some(49.0));
    let mut other = truth;
    set(&mut other, "stiffness", 49.0);
    let experiment = Experiment::new(times_of(&bounded)).measured("rail.displacement", "m", places.clone());
    let known =
        Identification::new(other).find(Unknown::parameter("damping")).experiment(experiment).run().unwrap();
    assert!(
        (known.value("damping").unwrap() - bounded.value("damping").unwrap()).abs() < 1e-8,
        "{known} {bounded}"
    );

    // An expected value counts as one more reading: with one that is far more certain than all readings, it stays.
    let expected = problem.find(Unknown::parameter("stiffness").expected(49.0, 1e-6)).run().unwrap();
    assert!((expected.value("stiffness").unwrap() - 49.0).abs() < 1e-6, "{expected}");
    assert!((expected.standard_error("stiffness").unwrap() / 1e-6 - 1.0).abs() < 1e-3, "{expected}");
}

fn times_of(fit: &plm::optimise::Fit<Few>) -> Vec<f64> {
    fit.residuals[0].times.clone()
}

pub const FOUR_BAR: &str = "pub FourBar {
    param drag: N*m = 0.4 N*m;
    param load: kg = 2 kg;
    gravity: 9.81 m/s^2;
    ground { port left: (0, 0) m; port right: (0.4, 0) m; }
    body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 0) m; port pin: (0.1, 0) m; start angle: 0.7 rad, locked; start omega: 0 rad/s, locked; }
    body coupler { mass: load; inertia: 0.01 kg*m^2; port pin: (0, 0) m; port end: (0.35, 0) m; start x: 0.08 m; start y: 0.06 m; start angle: 0.5 rad; }
    body rocker { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 0) m; port end: (0.25, 0) m; start x: 0.4 m; start angle: 1.9 rad; }
    revolute main(ground.left, crank.pivot);
    revolute pin(crank.pin, coupler.pin);
    revolute end(coupler.end, rocker.end);
    revolute side(ground.right, rocker.pivot);
    friction rub: rate(crank.angle) within drag;
    output rocker.angle in deg, crank.angle in deg;
}";

#[test]
fn friction_and_load_of_a_four_bar_by_readings_without_noise() {
    let truth = mechanism(FOUR_BAR);
    let times = times(12, 0.1);
    let angles = readings(&truth, &["rocker.angle", "crank.angle"], &times);
    let mut guess = truth;
    set(&mut guess, "drag", 0.3);
    set(&mut guess, "load", 2.3);
    let experiment = Experiment::new(times).measured("rocker.angle", "rad", angles[0].clone()).measured(
        "crank.angle",
        "rad",
        angles[1].clone(),
    );
    let fit = Identification::new(guess)
        .find(Unknown::parameter("drag").within(0.0, 5.0))
        .find(Unknown::parameter("load").within(0.1, 10.0))
        .experiment(experiment)
        .run_by(ByDop853(1e-11))
        .unwrap();
    assert!((fit.value("drag").unwrap() - 0.4).abs() < 1e-8, "{fit}");
    assert!((fit.value("load").unwrap() - 2.0).abs() < 1e-8, "{fit}");
}

/// x'' = mu^2 x - (mu^2 + p^2) sin(p t) has the solution sin(p t), beside which motions grow by exp(mu t) (H. G. Bock, Recent advances in
/// parameter identification techniques for O.D.E., 1983; there mu is 60, which takes 20 segments).
#[test]
fn unstable_motion_by_segments() {
    let text = "pub Bock {
        param mu: 1 = 20;
        param p: 1 = 1;
        ground { port rail: (0, 0) m; }
        body mass { mass: 1 kg; inertia: 1 kg*m^2; port shoe: (0, 0) m; start x: 0 m, locked; start vx: 1 m/s, locked; }
        prismatic rail(ground.rail, mass.shoe) {
            drive: 1 N/m*(mu^2*mass.x - 1 m*(mu^2 + p^2)*sin(p*t/(1 s)));
        }
        output mass.x;
    }";
    let times: Vec<f64> = (1..=16).map(|k| 0.0625 * f64::from(k)).collect();
    let places: Vec<f64> = times.iter().map(|t| (core::f64::consts::PI * t).sin()).collect();
    let experiment = Experiment::new(times).measured("mass.x", "m", places).segments(8);
    let problem = |experiment| {
        Identification::new(mechanism(text))
            .find(Unknown::parameter("p"))
            .find(Unknown::start("mass.x"))
            .find(Unknown::start("mass.vx"))
            .experiment(experiment)
    };
    let fit = problem(experiment.clone()).run_by(ByDop853(1e-11)).unwrap();
    println!("{fit} {} {}", fit.iterations, fit.runs);
    assert!((fit.value("p").unwrap() - core::f64::consts::PI).abs() < 1e-8, "{fit}");
    assert!((fit.value("mass.vx").unwrap() - core::f64::consts::PI).abs() < 1e-6, "{fit}");
}

#[test]
fn mistakes_are_told() {
    let truth = mechanism(YARD);
    let of = |unknown: Unknown, experiment: Experiment| {
        Identification::new(truth).find(unknown).experiment(experiment).run().unwrap_err().to_string()
    };
    let read = || Experiment::new([0.0, 0.1]).measured("ball.y", "m", [1.0, 0.9]);
    assert_eq!(
        of(Unknown::parameter("masss"), read()),
        "there is no parameter `masss`; there are e, g, mass, stiffness, damping"
    );
    let unit = of(Unknown::parameter("e"), Experiment::new([0.0]).measured("ball.y", "cm", [1.0]));
    assert_eq!(unit, "`ball.y` is in `mm` or `m`, not in `cm`");
    let times = of(Unknown::parameter("e"), Experiment::new([0.1, 0.1]).measured("ball.y", "m", [1.0, 1.0]));
    assert_eq!(times, "experiment 0: the times do not ascend from 0 s on");
    let count = of(Unknown::parameter("e"), Experiment::new([0.1]).measured("ball.y", "m", [1.0, 1.0]));
    assert_eq!(count, "experiment 0: `ball.y` has 2 readings at 1 times");
    let fault = of(Unknown::parameter("mass").from(-1.0), read());
    assert!(
        fault.starts_with("experiment 0 does not run with the guesses: ") && fault.contains("mass"),
        "{fault}"
    );
    let few = Identification::new(truth)
        .find(Unknown::parameter("e"))
        .find(Unknown::parameter("g"))
        .experiment(Experiment::new([0.1]).measured("ball.y", "m", [1.0]))
        .run();
    assert!(matches!(few, Err(Error::TooFew { readings: 1, unknowns: 2 })));
}

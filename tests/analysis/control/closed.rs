//! Closed forms: integrators, a scalar, a pendulum, an oscillator, an elastic drive.

use std::f64::consts::PI;

use nalgebra::{Complex, DMatrix};
use plm::control::{NoGain, NoResponse, frequencies, root_locus};
use plm::dynamic::{Compiled, Small};
use plm::{Linearisation, Mechanism, Moment, linearise};

use super::{near, same_set, system};

fn linear(declaration: &str) -> Linearisation {
    let compiled =
        Compiled::new("mechanism.plm", declaration).unwrap_or_else(|refused| panic!("{refused:?}"));
    let mechanism: Small = compiled.mechanism().unwrap();
    linearise(&mechanism.start().unwrap()).unwrap()
}

/// A carriage that nothing holds, and a block on a spring that nothing drives; in a formulation, with the block's damping.
fn carriage(formulation: &str, damping: f64) -> Linearisation {
    linear(&format!(
        "pub Carriage {{
            {formulation}
            input push: N = 0 N;
            input gust: N = 0 N;
            ground {{ port rail: (0, 0) m; port other: (0, 1) m; }}
            body cart {{ mass: 2 kg; inertia: 1 kg*m^2; port rail: (0, 0) m; start x: 3 m, locked; }}
            body block {{ mass: 1 kg; inertia: 1 kg*m^2; port other: (0, 0) m; start y: 1 m; }}
            prismatic rail(ground.rail, cart.rail) {{ drive: push; }}
            prismatic other(ground.other, block.other) {{ stiffness: 9 N/m; damping: {damping} N*s/m; drive: gust; }}
            output cart.x, cart.vx, block.x in mm;
        }}"
    ))
}

/// m x'' = u with the least integral of q x^2 + r u^2: m x'' + k2 x' + k1 x = 0 with k1 = sqrt(q/r) and a damping ratio of 1/sqrt(2).
#[test]
fn a_double_integrator_has_a_known_regulator_and_filter() {
    for formulation in ["", "formulation: absolute;"] {
        let carriage = carriage(formulation, 0.6);
        let regulator = carriage.regulator(&[("cart.x", 5.0)], &[("push", 0.2)]).unwrap();
        let (k1, m) = (5.0_f64, 2.0);
        let natural = (k1 / m).sqrt();
        let (half, own) = (natural * 0.5_f64.sqrt(), Complex::new(-0.3, (9.0 - 0.09_f64).sqrt()));
        let poles = [Complex::new(-half, half), Complex::new(-half, -half), own, own.conj()];
        same_set(&regulator.poles, &poles, 1e-9);
        assert_eq!(regulator.inputs, ["push"]);
        // The gains by what they do: to a place of 1 m, and to a speed of 1 m/s.
        let gains = &regulator.gains * carriage.basis.transpose();
        let names =
            if formulation.is_empty() { ["rail.displacement", "rail.speed"] } else { ["cart.x", "cart.vx"] };
        let place = |name: &str| carriage.states.iter().position(|own| *own == name);
        let [x, v] = names.map(|name| place(name).unwrap_or_else(|| panic!("{:?}", carriage.states)));
        near(gains[(0, x)], k1, 1e-9);
        near(gains[(0, v)], (2.0 * m * k1).sqrt(), 1e-9);
        // At 3 m, where it was linearised, there is nothing to correct; 0.1 m beyond there is.
        near(regulator.point[x], 3.0, 1e-12);
        let mut state = regulator.point.clone();
        near(regulator.inputs_at(&state)[0], 0.0, 1e-12);
        state[x] += 0.1;
        near(regulator.inputs_at(&state)[0], -0.1 * k1, 1e-9);

        // White noise of the force, intensity w, and of the place, v: L = (sqrt(2 s), s), s = sqrt(w/v)/m.
        let filter = carriage.estimator(&[("push", 0.8)], &[("cart.x", 1e-3)]).unwrap();
        let corrections = &carriage.basis * &filter.gains;
        let s = (0.8_f64 / 1e-3).sqrt() / m;
        near(corrections[(x, 0)], (2.0 * s).sqrt(), 1e-9);
        near(corrections[(v, 0)], s, 1e-9);
    }
}

fn one(number: f64) -> DMatrix<f64> {
    DMatrix::from_element(1, 1, number)
}

#[test]
fn a_scalar_has_the_roots_of_a_quadratic() {
    let (a, b, c, q, r) = (0.7, 2.0, 3.0, 1.5, 0.4);
    let scalar = system(one(a), one(b), one(c));
    let regulator = scalar.regulator(&[("y0", q)], &[("u0", r)]).unwrap();
    let (q, g) = (c * c * q, b * b / r);
    near(regulator.cost[(0, 0)], (a + f64::sqrt(a * a + g * q)) / g, 1e-13);
    near(regulator.poles[0].re, -f64::sqrt(a * a + g * q), 1e-13);

    let sampled = scalar.sampled(0.3);
    let (a, b) = (f64::exp(0.7 * 0.3), 2.0 * (f64::exp(0.7 * 0.3) - 1.0) / 0.7);
    near(sampled.a[(0, 0)], a, 1e-14);
    near(sampled.b[(0, 0)], b, 1e-14);
    // b^2 p^2 + (r - a^2 r - b^2 q) p - q r = 0.
    let middle = r - a * a * r - b * b * q;
    let p = (-middle + f64::sqrt(middle * middle + 4.0 * b * b * q * r)) / (2.0 * b * b);
    let regulator = sampled.regulator(&[("y0", 1.5)], &[("u0", r)]).unwrap();
    near(regulator.cost[(0, 0)], p, 1e-13);
    near(regulator.gains[(0, 0)], a * b * p / (r + b * b * p), 1e-13);
    // p = a^2 p v / (c^2 p + v) + b^2 w, corrected by p c / (c^2 p + v).
    let (w, v) = (0.2, 0.05);
    let filter = sampled.estimator(&[("u0", w)], &[("y0", v)]).unwrap();
    let p = filter.covariance[(0, 0)];
    near(a * a * p * v / (c * c * p + v) + b * b * w, p, 1e-13);
    near(filter.gains[(0, 0)], p * c / (c * c * p + v), 1e-13);
    near(filter.poles[0].re, a * v / (c * c * p + v), 1e-13);
}

/// theta / torque = 1 / (m g l - J w^2 + i d w), in deg.
#[test]
fn a_pendulum_answers_a_torque() {
    let pendulum = linear(
        "pub Pendulum {
            gravity: 9.81 m/s^2;
            input torque: N*m = 0;
            ground { port o: (0, 0) m; }
            body bob { mass: 1.5 kg; inertia: 0.02 kg*m^2; port pivot: (0, 0.8) m; start angle: 0 deg; }
            revolute hinge(ground.o, bob.pivot) { drive: torque; damping: 0.3 N*m*s/rad; }
            output bob.angle in deg;
        }",
    );
    let (mgl, inertia) = (1.5 * 9.81 * 0.8, 0.02 + 1.5 * 0.64);
    let bode = pendulum.bode("torque", "bob.angle", &frequencies(0.1, 1e3, 40)).unwrap();
    assert_eq!(
        (bode.input, bode.output, bode.frequencies.len()),
        (("torque", "N*m"), ("bob.angle", "deg"), 161)
    );
    for ((w, magnitude), phase) in bode.frequencies.iter().zip(&bode.magnitude).zip(&bode.phase) {
        let known = 180.0 / PI / Complex::new(mgl - inertia * w * w, 0.3 * w);
        near(magnitude / known.norm(), 1.0, 1e-10);
        near(*phase, known.arg(), 1e-10);
    }
    // Held from sample to sample: the transfer of the samples at a frequency far below.
    let sampled = pendulum.sampled(1e-3);
    let (slow, fast) = (
        sampled.response("torque", "bob.angle", 0.5).unwrap(),
        pendulum.response("torque", "bob.angle", 0.5),
    );
    let delay = Complex::new(0.0, -0.5 * 0.5e-3).exp();
    near((slow - fast.unwrap() * delay).norm() / slow.norm(), 0.0, 1e-6);
    let modes = sampled.modes();
    near(modes[0].frequency, pendulum.modes()[0].frequency, 1e-9);
    near(modes[0].damping, 0.3 / (2.0 * (mgl * inertia).sqrt()), 1e-9);
}

/// Two inertias on a spring: what the motor does not turn is a zero, the place of both a pole and a zero at 0; phases go on below -pi.
#[test]
fn an_elastic_drive_has_zeros_and_a_phase_beyond_half_a_turn() {
    let drive = linear(
        "pub Drive {
            input torque: N*m = 0;
            rotor motor() { inertia: 0.02 kg*m^2; drive: torque; }
            rotor load() { inertia: 0.1 kg*m^2; }
            shaft_spring coupling(motor.shaft, load.shaft) { stiffness: 500 N*m/rad; damping: 0.2 N*m*s; }
            output motor.speed, load.angle;
        }",
    );
    let (k, d, load) = (500.0, 0.2, 0.1);
    let im = f64::sqrt(k / load - (d / (2.0 * load)) * (d / (2.0 * load)));
    let zero = Complex::new(-d / (2.0 * load), im);
    let zeros = drive.zeros("torque", "motor.speed").unwrap();
    same_set(&zeros, &[Complex::new(0.0, 0.0), zero, zero.conj()], 1e-7);
    // load / torque = (d s + k) / (J1 J2 s^4 + (J1 + J2) s^2 (d s + k)): a zero at -k/d.
    same_set(&drive.zeros("torque", "load.angle").unwrap(), &[Complex::new(-k / d, 0.0)], 1e-7);
    let bode = drive.bode("torque", "load.angle", &frequencies(1.0, 1e6, 50)).unwrap();
    near(bode.phase[0], -PI, 1e-2);
    near(*bode.phase.last().unwrap(), -1.5 * PI, 1e-2);
    for (w, magnitude) in bode.frequencies.iter().zip(&bode.magnitude) {
        let s = Complex::new(0.0, *w);
        let known = (s * d + k) / (s.powi(4) * 0.002 + s * s * 0.12 * (s * d + k));
        assert!(
            (magnitude / known.norm() - 1.0).abs() < 1e-9,
            "{w} rad/s: {:e}",
            magnitude / known.norm() - 1.0
        );
    }
}

#[test]
fn poles_move_with_a_parameter() {
    // Of x'' + k x they are +- i sqrt(k); those of another oscillator pass them.
    let values: Vec<f64> = (1..=60).map(|k| 0.5 * f64::from(k)).collect();
    let locus = root_locus(values.iter().copied(), |k| {
        let last = [-8.0, 0.2 * k - 3.0];
        let a =
            [[0.0, 1.0, 0.0, 0.0], [-k, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0], [0.0, 0.0, last[0], last[1]]];
        let matrix = |rows: usize, all: &[f64]| DMatrix::from_row_slice(rows, all.len() / rows, all);
        let [b, c] = [matrix(4, &[0.0, 1.0, 0.0, 1.0]), matrix(1, &[1.0, 0.0, 0.0, 0.0])];
        Ok::<_, plm::Fault>(system(matrix(4, a.as_flattened()), b, c))
    })
    .unwrap();
    assert_eq!((locus.branches.len(), locus.values), (4, values.clone()));
    // Each branch is one of +- i sqrt(k), wherever the others pass it.
    for sign in [-1.0, 1.0] {
        let follows = |branch: &Vec<Complex<f64>>| {
            branch
                .iter()
                .zip(&values)
                .all(|(pole, k)| (pole - Complex::new(0.0, sign * k.sqrt())).norm() < 1e-9)
        };
        assert_eq!(locus.branches.iter().filter(|branch| follows(branch)).count(), 1, "{:?}", locus.branches);
    }
}

/// What cannot be had names its mode.
#[test]
fn no_gain_without_reach_and_sight() {
    let carriage = carriage("", 0.0);
    let refused = carriage.regulator(&[("cart.x", 1.0), ("block.x", 1.0)], &[("push", 1.0)]).unwrap_err();
    let NoGain::NotReached(lacking) = &refused else { panic!("{refused}") };
    near(lacking.mode.frequency, 3.0, 1e-9);
    assert!(lacking.state.starts_with("other."), "{refused}");
    let refused = carriage.regulator(&[("cart.vx", 1.0)], &[("push", 1.0), ("gust", 1.0)]).unwrap_err();
    let NoGain::NotShown(lacking) = refused else { panic!("{refused}") };
    near(lacking.mode.frequency, 0.0, 1e-9);
    let refused =
        carriage.sampled(0.01).estimator(&[("push", 1.0), ("gust", 1.0)], &[("cart.x", 1.0)]).unwrap_err();
    let NoGain::NotShown(lacking) = refused else { panic!("{refused}") };
    near(lacking.mode.frequency, 3.0, 1e-9);
    assert!(carriage.not_reached().is_empty() && carriage.not_shown().is_empty());

    let one = [("push", 1.0)];
    assert_eq!(carriage.regulator(&[("cart.y", 1.0)], &one).unwrap_err(), NoGain::Output("cart.y".into()));
    assert_eq!(carriage.regulator(&[], &[("pull", 1.0)]).unwrap_err(), NoGain::Input("pull".into()));
    let refused = carriage.regulator(&[("cart.x", 1.0)], &[("push", 0.0)]).unwrap_err();
    assert_eq!(refused.to_string(), "the weight of `push` must be positive, found 0");
    let refused = carriage.bode("gust", "block.x", &[1.0, 3.0]).unwrap_err();
    assert!(matches!(refused, NoResponse::Undamped(w) if w == 3.0), "{refused}");
}

/// A v = lambda v for each shape, also for both of two equal pendulums, and a state along a shape is that far from where it was.
#[test]
fn shapes_are_eigenvectors() {
    for formulation in ["", "formulation: absolute;"] {
        let text = format!(
            "pub Two {{
                {formulation}
                gravity: 9.81 m/s^2;
                ground {{ port a: (0, 0) m; port b: (1, 0) m; }}
                body a {{ mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 1) m; }}
                body b {{ mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 1) m; start x: 1 m; }}
                revolute hinge_a(ground.a, a.o);
                revolute hinge_b(ground.b, b.o) {{ damping: 1e-12 N*m*s; }}
            }}"
        );
        let mechanism: Small = Compiled::new("two.plm", &text).unwrap().mechanism().unwrap();
        let sim = mechanism.start().unwrap();
        let system = linearise(&sim).unwrap();
        let shapes = system.shapes();
        assert_eq!(shapes.len(), 2);
        let vectors: Vec<_> = shapes
            .iter()
            .map(|shape| {
                let whole = nalgebra::DVector::from_column_slice(&shape.vector);
                let own = system.basis.map(|entry| Complex::new(entry, 0.0)).tr_mul(&whole);
                let miss =
                    system.a.map(|entry| Complex::new(entry, 0.0)) * &own - &own * shape.mode.eigenvalue;
                assert!(miss.norm() < 1e-7 * own.norm() * shape.mode.frequency, "{formulation} {shape:?}");
                near(shape.mode.frequency, (9.81_f64 / 1.1).sqrt(), 1e-6);
                own.normalize()
            })
            .collect();
        assert!(vectors[0].dotc(&vectors[1]).norm() < 0.99, "{vectors:?}");
        let moved = shapes[0].moved(sim.state(), (1e-3, 0.0));
        let change = shapes[0].change(1e-3, 0.0);
        near(
            change.iter().take(system.coordinates).fold(0.0, |most: f64, own| most.max(own.abs())),
            1e-3,
            1e-9,
        );
        let most =
            moved.x().iter().zip(sim.state().x()).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!((1e-3..1e-2).contains(&most), "{most}");
    }
}

//! The method that eigenvalues ask for.

use plm::{Adams, Choice, Described, Dop853, Mechanism as _, Mode, Pace, RadauIia5, StartAuto, Vern9};

use crate::scene::{Given as _, Named as _};

/// Eigenvalues, complex ones once.
fn modes(eigenvalues: &[(f64, f64)]) -> Vec<Mode> {
    let pair = |&(re, im): &(f64, f64)| {
        let frequency = f64::hypot(re, im);
        let damping = if frequency > 0.0 { -re / frequency } else { 1.0 };
        let mode = |im| Mode { eigenvalue: nalgebra::Complex::new(re, im), frequency, damping };
        if im == 0.0 { vec![mode(0.0)] } else { vec![mode(-im), mode(im)] }
    };
    eigenvalues.iter().flat_map(pair).collect()
}

#[test]
fn what_swings_fast_is_followed_and_what_dies_out_fast_is_not() {
    let choice = |of: &[(f64, f64)]| Choice::by(&modes(of), 1e-8);
    // The manual's arm on its jack, at the stop: fast, and hardly damped.
    let arm = choice(&[(-1.5, 2002.0), (-1.5, 4668.0), (-3.0, 0.0)]);
    assert!(!arm.stiff);
    assert_eq!(arm.pace.map(|pace| pace.rate().round()), Some(4668.0));
    // A ratio of eigenvalues alone does not make it stiff: 4668 to 0.01.
    assert!(!choice(&[(-1.5, 4668.0), (-0.01, 0.0)]).stiff);
    // The same arm with a valve that is a thousand times faster.
    let valve = choice(&[(-1.5, 2002.0), (-1.5, 4668.0), (-5e6, 0.0), (-4e6, 3e6)]);
    assert_eq!((valve.stiff, valve.fast), (true, 3));
    // Creep beside fast decay.
    let creep = choice(&[(-0.5, 0.0), (-2e5, 0.0), (-3e5, 0.0), (-1e5, 1e4)]);
    assert_eq!((creep.stiff, creep.fast, creep.pace), (true, 4, Some(Pace::DiesOut(0.5))));
    assert_eq!(
        creep.to_string(),
        "Radau IIA: 4 eigenvalues die out by up to 3.00e5 1/s, while the slowest takes 2.00e0 s"
    );
    // A wheel with a fast bearing, which then stands or turns.
    assert!(choice(&[(0.0, 0.0), (-1e5, 0.0)]).stiff);
    // What grows has to be followed.
    assert!(!choice(&[(3e4, 0.0), (-1e5, 0.0)]).stiff);
    assert_eq!(
        choice(&[(-0.5, 0.0)]).to_string(),
        "DOP853: the slowest takes 2.00e0 s, and nothing dies out 100 times faster (at most 5.00e-1 1/s)"
    );
    assert_eq!(choice(&[(0.0, 0.0)]).to_string(), "DOP853: no eigenvalue tells of motion at the start");
    // What only swings, to a tight tolerance, is followed with order 9.
    let swings = modes(&[(-0.1, 5.0)]);
    assert!(
        !Choice::by(&swings, 1e-8).ninth_order
            && !Choice::by(&modes(&[(-0.1, 5.0), (-6.0, 0.0)]), 1e-9).ninth_order
    );
    assert_eq!(
        Choice::by(&swings, 1e-9).to_string(),
        "Verner 9(8): what has to be followed swings or grows with 5.00e0 1/s, and nothing dies out"
    );
    // The tighter the tolerance, the later it pays.
    let edge = modes(&[(-1.0, 0.0), (-200.0, 0.0)]);
    assert!(Choice::by(&edge, 1e-8).stiff && !Choice::by(&edge, 1e-12).stiff);
}

scene! {
    pub Damped {
        param damping: N*s/m = 1e5 N*s/m;
        ground { port rail: (0, 0) m; }
        body mass { mass: 1 kg; inertia: 1 kg*m^2; port slide: (0, 0) m; start x: 0.1 m, locked; }
        prismatic rail(ground.rail, mass.slide) { stiffness: 1e6 N/m; damping: damping; }
    }
}

#[test]
fn a_tight_tolerance_takes_order_9() {
    let mass = Damped::new().with("damping", 10.0);
    let mut auto = mass.start_auto_with(1e-11).unwrap();
    let mut known = mass.start_with(Vern9::new(1e-11)).unwrap();
    assert!(auto.method().choice().ninth_order);
    auto.step(0.1).unwrap();
    known.step(0.1).unwrap();
    assert_eq!((auto.stats(), auto.state_of("mass").x), (known.stats(), known.state_of("mass").x));
}

// Of more than 8 bodies: compiled.
mod hanging {
    plm::mechanism! {
        /// A chain of 64 bars that hangs aslant; with loops it is compiled in less time.
        pub Chain {
            code: rolled;
            gravity: 9.81 m/s^2;
            ground { port o: (0, 0) m; }
            repeat i in 0..64 {
                body bar[i] {
                    mass: 1 kg / 64;
                    inertia: 1 kg*m^2 / (12 * 64^3);
                    port a: (-0.5 / 64, 0) m;
                    port b: (0.5 / 64, 0) m;
                    start angle: -80 deg;
                }
            }
            revolute pin[0](ground.o, bar[0].a);
            repeat i in 1..64 {
                revolute pin[i](bar[i-1].b, bar[i].a);
            }
        }
    }
}

#[test]
fn a_long_chain_takes_adams() {
    let chain = hanging::Chain::new();
    let mut auto = chain.start_auto().unwrap();
    let choice = *auto.method().choice();
    assert!(choice.multistep && !choice.ninth_order && choice.to_string().starts_with("Adams: "), "{choice}");
    let mut known = chain.start_with(Adams::new(1e-8)).unwrap();
    let mut other = chain.start_with(Dop853::new(1e-8)).unwrap();
    for step in [auto.step(0.3), known.step(0.3), other.step(0.3)] {
        step.unwrap();
    }
    assert_eq!((auto.stats(), auto.bar_63().x), (known.stats(), known.bar_63().x));
    assert!((known.bar_63().x - other.bar_63().x).abs() < 1e-6);
    // The chain from text has the bits of compiled code, whose functions are loops.
    let text = plm::dynamic::Mechanism::from_text(hanging::Chain::<f64>::DECLARATION).unwrap();
    let mut run = text.start_with(plm::dynamic::Integrator::Dop853(1e-8)).unwrap();
    run.step_to(0.3).unwrap();
    assert_eq!(run.body("bar[63]").unwrap(), other.bar_63());
    assert_eq!(run.stats().evaluations, other.stats().evaluations);
    assert!(3 * known.stats().evaluations < 2 * other.stats().evaluations, "{:?}", known.stats());
}

/// Three simulations of a mechanism from text stand on the stack at once: without optimisation more than a thread of tests has.
#[test]
fn the_chosen_method_runs_and_is_the_cheaper_one() {
    let stack = std::thread::Builder::new().stack_size(8 << 20);
    stack.spawn(runs_by_the_cheaper_method).unwrap().join().unwrap();
}

fn runs_by_the_cheaper_method() {
    for (damping, stiff) in [(1e5, true), (10.0, false)] {
        let mass = Damped::new().with("damping", damping);
        let mut auto = mass.start_auto().unwrap();
        assert_eq!(auto.method().choice().stiff, stiff);
        let (mut explicit, mut implicit) =
            (mass.start_with(Dop853::new(1e-8)).unwrap(), mass.start_with(RadauIia5::new(1e-8)).unwrap());
        let mut samples = 0;
        auto.run(0.1, 0.01, |_| samples += 1).unwrap();
        explicit.run(0.1, 0.01, |_| ()).unwrap();
        implicit.run(0.1, 0.01, |_| ()).unwrap();
        assert_eq!(samples, 11);
        assert_eq!(auto.stats(), if stiff { implicit.stats() } else { explicit.stats() });
        let evaluations = (explicit.stats().evaluations, implicit.stats().evaluations);
        assert!(if stiff { evaluations.0 > 10 * evaluations.1 } else { evaluations.0 < 3 * evaluations.1 });
        // The roots of s^2 + c s + k, from x = 0.1 at rest.
        let (a, b) = (-0.5 * damping, 0.25 * damping * damping - 1e6);
        let exact = if b > 0.0 {
            let (slow, fast) = (1e6 / (a - b.sqrt()), a - b.sqrt());
            0.1 * (fast * f64::exp(slow * 0.1) - slow * f64::exp(fast * 0.1)) / (fast - slow)
        } else {
            let w = (-b).sqrt();
            0.1 * f64::exp(a * 0.1) * (f64::cos(w * 0.1) - a / w * f64::sin(w * 0.1))
        };
        assert!((auto.state_of("mass").x - exact).abs() < 1e-6, "{} {exact}", auto.state_of("mass").x);
    }
}

//! Implicit methods on trees and in absolute coordinates: the linearised equations against the full matrix of derivatives, by dual numbers.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

use plm::runtime::held::Loops as _;
use plm::runtime::linalg::{Both, Complex, Dense, Derivatives};
use plm::runtime::{Linear, Rate, Vector};
use plm::{Dop853, Mechanism, Moment, RadauIia5, Ros34Pw2};

#[path = "support/linearised.rs"]
mod linearised;

use linearised::{chain, loom, mill, zoo};

chain!(chain4, 4);
chain!(chain16, 16);
chain!(chain32, 32);

/// An arm on a hydraulic jack with a servo-valve: first-order states, stops, roots.
#[allow(
    unused_qualifications,
    reason = "emitted code qualifies where a name of the user's could stand in the way"
)]
#[path = "snapshots/arm_on_jack.rs"]
mod arm_on_jack;

/// Are a real and a complex system solved side by side as each by itself, to the bit?
fn both<X: Dense<f64>, D: Derivatives<f64, X>>(
    derivatives: &D,
    (r, lambda): (impl Fn(usize) -> Complex<f64>, Complex<f64>),
    nq: usize,
) -> bool {
    let [real, complex] = [25.0, 1.0].map(|factor| Complex { re: factor * lambda.re, im: lambda.im });
    let (real, complex) =
        (derivatives.resolvent(real.re, nq).unwrap(), derivatives.resolvent(complex, nq).unwrap());
    let (mut alone, mut beside) = ([vec![], vec![]], [vec![], vec![]]);
    derivatives.resolve(&real, nq, |i| r(i).im, |_, k| alone[0].push(Complex { re: k, im: 0.0 }));
    derivatives.resolve(&complex, nq, &r, |_, k| alone[1].push(k));
    let of_both = |i| Both { real: r(i).im, complex: r(i) };
    derivatives.resolve_both((&real, &complex), nq, of_both, |_, k| {
        beside[0].push(Complex { re: k.real, im: 0.0 });
        beside[1].push(k.complex);
    });
    alone == beside && alone.iter().all(|found| found.len() == X::LEN)
}

/// The largest difference of (lambda I - J)^-1 r between the full matrix and the augmented system, over the largest k. On a
/// tree there is no full matrix beside the system.
fn difference<M>(mechanism: M, time: f64, lambda: Complex<f64>, is_tree: bool) -> f64
where
    M: Mechanism<S = f64, X: Dense<f64, Matrix: Derivatives<f64, <M as Rate>::X>>> + Linear,
{
    let mut sim = mechanism.start().unwrap();
    sim.step(time).unwrap();
    let state = sim.state();
    let (t, held, x) = (state.time(), state.held(), *state.x());
    let (mut full, mut sparse) = (M::X::zeros(), M::Derivatives::zeros());
    assert_eq!(sparse.full().is_none(), is_tree, "the linearised equations of a tree are sparse");
    assert!(mechanism.jacobian(t, &held, &x, &mut full, None).is_good());
    assert!(mechanism.differentiate(t, &held, &x, &mut sparse, None).is_good());
    let holds_matrix = size_of_val(&sparse) > size_of_val(&full);
    assert_ne!(
        holds_matrix, is_tree,
        "the equations of absolute coordinates are linearised beside the matrix"
    );
    let r = |i: usize| Complex { re: f64::from(i as u32 % 7) - 2.5, im: f64::from(i as u32 % 5) - 1.5 };
    let mut found = [vec![], vec![]];
    let resolvent = full.resolvent(lambda, M::NQ).unwrap();
    full.resolve(&resolvent, M::NQ, r, |i, k| found[0].push((i, k)));
    let resolvent = sparse.resolvent(lambda, M::NQ).unwrap();
    sparse.resolve(&resolvent, M::NQ, r, |i, k| found[1].push((i, k)));
    assert_eq!(found[0].len(), M::X::LEN);
    for side_by_side in [both(&full, (r, lambda), M::NQ), both(&sparse, (r, lambda), M::NQ)] {
        assert!(side_by_side, "two systems solved side by side are as each by itself");
    }
    let size = found[0].iter().fold(0.0_f64, |size, (_, k)| size.max(k.re.hypot(k.im)));
    let gaps = found[0].iter().zip(&found[1]).map(|((i, a), (j, b))| {
        assert_eq!(i, j);
        (a.re - b.re).hypot(a.im - b.im)
    });
    gaps.fold(0.0, f64::max) / size
}

#[test]
fn the_linearised_equations_solve_what_the_full_matrix_does() {
    for lambda in [
        Complex { re: 1e4, im: 0.0 },
        Complex { re: 300.0, im: 350.0 },
        Complex { re: 30.0, im: -20.0 },
        Complex { re: 4.0, im: 3.0 },
    ] {
        let found = [
            difference(zoo::Zoo::new(), 0.1, lambda, true),
            difference(mill::Mill::new(), 0.1, lambda, false),
            difference(arm_on_jack::ArmOnJack::new(), 0.01, lambda, true),
            difference(chain4::Chain::new(), 0.3, lambda, true),
            difference(chain16::Chain::new(), 0.3, lambda, true),
            difference(chain32::Chain::new(), 0.3, lambda, true),
        ];
        assert!(found.iter().all(|gap| *gap < 1e-10), "{lambda:?}: {found:?}");
    }
}

/// Entry by entry as by dual numbers, in every chart.
#[test]
fn the_matrix_of_a_loop_is_that_of_dual_numbers() {
    let mut sim = loom::Loom::new().start().unwrap();
    let mut charts = [false; 3];
    for _ in 0..200 {
        sim.step(0.02).unwrap();
        let (mechanism, held, t, x) = (sim.mechanism, sim.state().held(), sim.time(), *sim.state().x());
        charts[held.of_loops.chart().unwrap()] = true;
        let mut by_x = [[0.0; 5]; 5];
        let mut by_t = [0.0; 5];
        assert!(mechanism.jacobian(t, &held, &x, &mut by_x, Some(&mut by_t)).is_good());
        for j in 0..=5 {
            let along: [f64; 5] = std::array::from_fn(|k| f64::from(u8::from(k == j)));
            let (mut column, by) = ([0.0; 5], f64::from(u8::from(j == 5)));
            assert!(mechanism.jvp(t, &held, &x, (by, &along), &mut column).is_good());
            for i in 0..5 {
                let entry = if j == 5 { by_t[i] } else { by_x[i][j] };
                let gap = (entry - column[i]).abs() / column[i].abs().max(1.0);
                assert!(gap < 1e-11, "t = {t}, {i} by {j}: {entry} and {}", column[i]);
            }
        }
    }
    assert!(charts.iter().filter(|seen| **seen).count() > 1, "{charts:?}");
}

#[test]
fn implicit_methods_carry_loops_in_absolute_coordinates() {
    let run = |mut known: plm::Sim<mill::Mill, RadauIia5<mill::Mill>>| {
        known.step(1.0).unwrap();
        (known.stats(), *known.state().x())
    };
    let mut known = mill::Mill::new().start_with(Dop853::new(1e-12)).unwrap();
    known.step(1.0).unwrap();
    let (stats, x) = run(mill::Mill::new().start_with(RadauIia5::new(1e-9)).unwrap());
    let off = known.state().x().iter().zip(&x).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    assert!(off < 1e-6, "{off:e}");
    assert!(stats.rejected < 20 && stats.evaluations < 9 * stats.steps, "{stats:?}");
}

#[test]
fn implicit_methods_carry_a_large_tree() {
    // With everything in it: the time too.
    let mut known = zoo::Zoo::new().start_with(Dop853::new(1e-12)).unwrap();
    known.step(0.5).unwrap();
    let mut radau = zoo::Zoo::new().start_with(RadauIia5::new(1e-9)).unwrap();
    radau.step(0.5).unwrap();
    let off = |x: &[f64]| known.state().x().iter().zip(x).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    assert!(off(radau.state().x()) < 1e-6, "{:e}", off(radau.state().x()));
    // Derivatives that were wrong would cost iterations: a step of two takes 7 rates.
    let stats = radau.stats();
    assert!(stats.rejected < 10 && stats.evaluations < 9 * stats.steps, "{stats:?}");
    // Order 3, whatever the derivatives are: a W-method does not hang on them.
    let [coarse, fine] = [400, 800].map(|steps| {
        let mut sim = zoo::Zoo::new().start_with(Ros34Pw2::new(0.5 / f64::from(steps))).unwrap();
        sim.step(0.5).unwrap();
        off(sim.state().x())
    });
    assert!((6.5..10.0).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
}

//! What implicit methods solve, and what they cost.
//!
//! ```text
//! cargo bench --bench implicit
//! cargo bench --bench implicit -- arm          a part alone: chain, arm, radau
//! ```
//!
//! * `chain`: along a chain the augmented system that is generated beside the full matrix. Microseconds of the derivatives, of
//!   one real and one complex decomposition, and of a solution with each.
//! * `arm`: nanoseconds of a linearly implicit step of 1 ms, of the arm on a hydraulic jack that runs in real time.
//! * `radau`: a run of 4 s of the manual's arms, beside one of `Dop853`, and what the parts cost at its end.

#[path = "../tests/oracle/speed/src/work_precision/arms.rs"]
#[allow(dead_code, unreachable_pub)] // The example uses more of it.
mod arms;
#[path = "scenes/chain.rs"]
mod chain;
#[path = "../examples/real_time/plants.rs"]
#[allow(dead_code, unreachable_pub)] // The example uses more of it.
mod plants;

use std::hint::black_box;
use std::time::Instant;

use plm::runtime::linalg::{Complex, Dense, Derivatives};
use plm::runtime::{Linear, Rate, System};
use plm::{Dop853, Mechanism, Method, Moment, RadauIia5};

chain::chain!(Chain16, 16);
chain::chain!(Chain32, 32);

fn main() {
    let parts: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let asked = |part: &str| parts.is_empty() || parts.iter().any(|other| other == part);
    if asked("chain") {
        println!(
            "{:>5} {:>24} {:>24} {:>24}",
            "bars", "derivatives: full, aug.", "decompositions", "solutions"
        );
        row(16, Chain16::new());
        row(32, Chain32::new());
    }
    if asked("arm") {
        println!("arm, a linearly implicit step: {:.0} ns", arm());
    }
    if asked("radau") {
        radau("arm", arms::arms_tree::Arm::new());
        radau("arms", arms::arms_tree::Arms::new());
    }
}

/// The least time of a step, ns, while the valve swings.
fn arm() -> f64 {
    let run = || {
        let mut step = plants::arm(1e-3).expect("the arm can be assembled");
        let begin = Instant::now();
        for k in 0..1000 {
            let lever = 0.2 * (std::f64::consts::TAU * f64::from(k) / 1000.0).sin();
            black_box(step(lever).0);
        }
        begin.elapsed().as_secs_f64() * 1e9 / 1000.0
    };
    (0..100).map(|_| run()).fold(f64::INFINITY, f64::min)
}

/// Times of runs, and of the parts of Radau's method.
fn radau<M>(name: &str, mechanism: M)
where
    M: Mechanism<S = f64, X: Dense<f64>> + Linear,
{
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let [implicit, explicit] =
            [run(mechanism, &RadauIia5::new(tolerance)), run(mechanism, &Dop853::new(tolerance))];
        println!("{name:>5} {tolerance:.0e}: Radau {implicit}; Dop853 {explicit}");
    }
    let mut sim = mechanism.start().expect("the arms can be assembled");
    sim.step(1.2).expect("the arms can be moved");
    let (state, mut by_x) = (sim.state(), M::Derivatives::zeros());
    let (held, x, t) = (state.held(), *state.x(), state.time());
    let mut dx = x;
    let rate = best(|| {
        mechanism.rate(t, &held, black_box(&x), &mut dx);
        black_box(&dx);
    });
    let derivatives =
        best(|| _ = black_box(mechanism.differentiate(t, &held, black_box(&x), &mut by_x, None)));
    let [factors, solutions] = solving::<M, _>(&by_x);
    println!(
        "{name:>5}: rate {rate:.3} us, derivatives {derivatives:.3}, decompositions {factors:.3}, solutions {solutions:.3}"
    );
}

/// The least time of a run, with what it did.
fn run<M: Mechanism<S = f64>, I: Method<M>>(mechanism: M, method: &I) -> String {
    let (mut least, mut told) = (f64::INFINITY, String::new());
    for _ in 0..5 {
        let mut sim = mechanism.start_with(method.clone()).expect("the arms can be assembled");
        let begin = Instant::now();
        sim.step(4.0).expect("the arms can be moved");
        least = least.min(begin.elapsed().as_secs_f64() * 1e6);
        let stats = sim.stats();
        told = format!(
            "{} rates, {} derivatives, {} decompositions",
            stats.evaluations, stats.jacobians, stats.factorisations
        );
    }
    format!("{least:.0} us, {told}")
}

fn row<M>(bars: usize, mechanism: M)
where
    M: Mechanism<S = f64, X: Dense<f64, Matrix: Derivatives<f64, <M as Rate>::X>>> + Linear,
{
    let mut sim = mechanism.start().expect("the chain can be assembled");
    sim.step(0.1).expect("the chain can be moved");
    let state = sim.state();
    let (held, x) = (state.held(), *state.x());
    let (mut full, mut augmented) = (M::X::zeros(), M::Derivatives::zeros());
    let derivatives = [
        best(|| _ = black_box(mechanism.jacobian(0.1, &held, &x, &mut full, None))),
        best(|| _ = black_box(mechanism.differentiate(0.1, &held, &x, &mut augmented, None))),
    ];
    let [full, augmented] = [solving::<M, _>(&full), solving::<M, _>(&augmented)];
    println!(
        "{bars:>5} {:>12.2} {:>11.2} {:>12.2} {:>11.2} {:>12.2} {:>11.2}",
        derivatives[0], derivatives[1], full[0], augmented[0], full[1], augmented[1]
    );
}

/// Times of decompositions and of solutions.
fn solving<M: System<S = f64, X: Dense<f64>>, D: Derivatives<f64, M::X>>(derivatives: &D) -> [f64; 2] {
    let pair = Complex { re: 268.0, im: 305.0 };
    let factor = || (derivatives.resolvent(364.0, M::NQ), derivatives.resolvent(pair, M::NQ));
    let (Some(real), Some(complex)) = factor() else { return [f64::NAN; 2] };
    let solve = || {
        let mut sum = 0.0;
        derivatives.resolve(&real, M::NQ, |i| i as f64, |_, k| sum += k);
        let r = |i: usize| Complex { re: i as f64, im: 1.0 };
        derivatives.resolve(&complex, M::NQ, r, |_, k| sum += k.re);
        black_box(sum);
    };
    [best(|| _ = black_box(factor())), best(solve)]
}

/// The least of many times, us.
fn best(mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..60 {
        let begin = Instant::now();
        for _ in 0..8 {
            work();
        }
        least = least.min(begin.elapsed().as_secs_f64() * 1e6 / 8.0);
    }
    least
}

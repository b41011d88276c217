//! What implicit methods solve, along a chain: the augmented system that is generated beside the full matrix.
//!
//! ```text
//! cargo bench --bench implicit
//! ```
//!
//! Microseconds of the derivatives, of one real and one complex decomposition, and of a solution with each.

#[path = "scenes/chain.rs"]
mod chain;

use std::hint::black_box;
use std::time::Instant;

use plm::runtime::linalg::{Complex, Dense, Derivatives};
use plm::runtime::{Linear, System};
use plm::{Mechanism, Moment};

chain::chain!(Chain16, 16);
chain::chain!(Chain32, 32);

fn main() {
    println!("{:>5} {:>24} {:>24} {:>24}", "bars", "derivatives: full, aug.", "decompositions", "solutions");
    row(16, Chain16::new());
    row(32, Chain32::new());
}

fn row<M>(bars: usize, mechanism: M)
where
    M: Mechanism<S = f64, X: Dense<f64, Matrix: Derivatives<f64, <M as System>::X>>> + Linear,
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

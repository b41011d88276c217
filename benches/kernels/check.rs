//! Whether the kernels are right: a wrong one is no measure.
//!
//! End states against references in quadruple precision, which two formulations agreed on to 1e-14 or better. The chain
//! has none: its accelerations are put into Lagrange's equations, and its energy must stay.

use super::chain::{self, accelerations_at};
use super::lanes::Lanes;
use super::{ANDREWS, Andrews, DOUBLE_PENDULUM, FOUR_BAR, FourBar, SLIDER_CRANK, SliderCrank};
use super::{Crank, crank, double_pendulum};

/// Prints the error of every kernel; whether all are below 1e-8, as a fraction of the largest component.
pub(crate) fn all_right() -> bool {
    let errors = [
        ("S1", double_pendulum_error()),
        ("S2", crank_error::<FourBar>(FOUR_BAR, 1.0, 10_000, S2)),
        ("S6", crank_error::<SliderCrank>(SLIDER_CRANK, 1.0, 10_000, S6)),
        ("S5", crank_error::<Andrews>(ANDREWS, 0.03, 10_000, S5)),
        ("chain 4", chain_error::<4>()),
        ("chain 16", chain_error::<16>()),
        ("chain 64", chain_error::<64>()),
    ];
    for (name, error) in errors {
        println!("{name:<10} error {error:.1e}{}", if error < 1e-8 { "" } else { "  WRONG" });
    }
    errors.iter().all(|(_, error)| *error < 1e-8)
}

/// q and v at the end.
const S1: double_pendulum::State =
    [[-1.982_300_809_959_603_3, -2.289_294_911_020_306_7], [-8.270_425_432_169_654, 1.627_894_834_494_063_1]];
const S2: [f64; 2] = [-4.561_584_698_981_446, -0.945_584_321_054_772_6];
const S6: [f64; 2] = [17.329_530_409_860_606, 27.269_387_406_127_06];
const S5: [f64; 2] = [15.810_771_195_153_707, 1_139.920_302_259_106_2];

fn double_pendulum_error() -> f64 {
    let alone = |x: double_pendulum::State, h| {
        double_pendulum::plain_step(x.map(|x| x.map(Lanes::<1>::from)), h).map(|x| x.map(|Lanes([x])| x))
    };
    let ends = [alone, double_pendulum::paired_step].map(|step| {
        let [q, v] = run(DOUBLE_PENDULUM, 1.0, 10_000, step);
        [q[0], q[1], v[0], v[1]]
    });
    let [q, v] = S1;
    relative(&ends, [q[0], q[1], v[0], v[1]])
}

fn crank_error<K: Crank>(start: [f64; 2], until: f64, steps: u32, end: [f64; 2]) -> f64 {
    let alone = |x: [f64; 2], h| crank::plain_step::<K, 1>(x.map(Lanes::from), h).map(|Lanes([x])| x);
    let ends = [alone, crank::paired_step::<K>].map(|step| run(start, until, steps, step));
    relative(&ends, end)
}

fn run<X>(start: X, until: f64, steps: u32, step: impl Fn(X, f64) -> X) -> X {
    (0..steps).fold(start, |x, _| step(x, until / f64::from(steps)))
}

/// Largest error of a component over the largest magnitude expected of it or 1.
fn relative<const N: usize>(found: &[[f64; N]], expected: [f64; N]) -> f64 {
    let of = |x: &[f64; N]| {
        (0..N).map(|i| (x[i] - expected[i]).abs() / expected[i].abs().max(1.0)).fold(0.0, f64::max)
    };
    found.iter().map(of).fold(0.0, f64::max)
}

/// The larger of the residual of Lagrange's equations at the end of a fall, and of the energy won in it.
fn chain_error<const BARS: usize>() -> f64 {
    let steps = [chain::plain_step::<BARS>, chain::paired_step::<BARS>];
    let of = |step: fn(&mut chain::State<BARS>, f64)| {
        let mut x = chain::State::START;
        for _ in 0..3000 {
            step(&mut x, 1e-4);
        }
        lagrange_residual(&x).max(energy(&x).abs())
    };
    steps.map(of).into_iter().fold(0.0, f64::max)
}

/// Bars beyond the angles i and j, over which both move: `w = 1/2 + bars after the outer one`, in bars.
fn shared<const BARS: usize>(i: usize, j: usize) -> f64 {
    0.5 + (BARS - 1 - i.max(j)) as f64
}

/// Entry of the mass matrix over m l^2 without its cosine.
fn inertia<const BARS: usize>(i: usize, j: usize) -> f64 {
    if i == j { shared::<BARS>(i, j) - 0.5 + 1.0 / 3.0 } else { shared::<BARS>(i, j) }
}

/// `sum_j w_ij (cos(q_i - q_j) a_j + sin(q_i - q_j) v_j^2) = -g/l w_ii cos q_i`, residual over the largest weight.
fn lagrange_residual<const BARS: usize>(x: &chain::State<BARS>) -> f64 {
    let gravity = 9.81 * BARS as f64;
    let a = accelerations_at(x);
    let residual = |i: usize| {
        let of = |j: usize| {
            let (s, c) = (x.q[i] - x.q[j]).sin_cos();
            inertia::<BARS>(i, j) * (c * a[j] + s * x.v[j] * x.v[j])
        };
        (0..BARS).map(of).sum::<f64>() + gravity * shared::<BARS>(i, i) * x.q[i].cos()
    };
    (0..BARS).map(|i| residual(i).abs()).fold(0.0, f64::max) / (gravity * BARS as f64)
}

/// Kinetic and potential energy over that of the weight on a string as long, m g L; zero at the start.
fn energy<const BARS: usize>(x: &chain::State<BARS>) -> f64 {
    let of = |i: usize| {
        let of = |j: usize| 0.5 * inertia::<BARS>(i, j) * (x.q[i] - x.q[j]).cos() * x.v[i] * x.v[j];
        (0..BARS).map(of).sum::<f64>() + 9.81 * BARS as f64 * shared::<BARS>(i, i) * x.q[i].sin()
    };
    (0..BARS).map(of).sum::<f64>() / (9.81 * (BARS * BARS * BARS) as f64)
}

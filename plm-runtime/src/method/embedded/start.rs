//! First step.

use crate::fault::Fault;
use crate::method::Context;
use crate::method::adaptive::shortest;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// A first step from the sizes of the state, of its rate and of an estimate of the second derivative
/// (Hairer, Nørsett, Wanner I, II.4, "starting step size", a to f). It takes one evaluation.
pub(in crate::method) fn first_step<M: System<S: Real>>(
    context: &mut Context<'_, M>,
    rate: &M::X,
    rtol: M::S,
    order: u32,
) -> Result<M::S, Fault> {
    let lit = M::S::lit;
    let (typical, count) = (context.system.typical(), context.system.states());
    let x = context.x;
    let size = |v: &M::X| {
        let mut sum = lit(0.0);
        for i in 0..M::X::LEN {
            let ratio = v.at(i) / (rtol * (typical.at(i) + x.at(i).abs()));
            sum = ratio.mul_add(ratio, sum);
        }
        (sum / lit(count.max(1) as f64)).sqrt()
    };
    let (least, span) = (lit(1e-10), context.end - context.time);
    let (state, slope) = (size(&x), size(rate));
    let first = if state < least || slope < least { lit(1e-6) } else { lit(0.01) * (state / slope) };
    let first = positive(first, lit(1e-6) * span).min(span);

    let (mut ahead, mut rate_after) = (x, *rate);
    ahead.add([(first, rate)]);
    context.rate(context.time + first, &ahead, &mut rate_after)?;
    let bend = size(&rate_after.map2(rate, |after, before| after - before)) / first;
    let steepest = bend.max(slope);
    let second = if steepest < lit(1e-15) {
        (lit(1e-3) * first).max(lit(1e-6))
    } else {
        ((lit(0.01) / steepest).ln() / lit(f64::from(order))).exp()
    };
    // A guess at a state of rest may be too short to move the time. The length has no derivatives, since it
    // only decides.
    let step = positive((lit(100.0) * first).min(second), first).max(lit(2.0) * shortest(context));
    Ok(M::S::of_plain(step.plain()))
}

/// The first length, or the second if the first is not positive or NaN.
fn positive<S: Real>(step: S, otherwise: S) -> S {
    if step > S::lit(0.0) { step } else { otherwise }
}

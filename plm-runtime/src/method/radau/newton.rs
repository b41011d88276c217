//! Stages of a step by simplified Newton iteration.

use super::tableau::{ALPHA, BETA, C, GAMMA, T, T_INVERSE};
use crate::linalg::{Both, Complex, Derivatives as _};
use crate::linear::Linear;
use crate::method::Context;
use crate::method::jacobian::Resolvent;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Most iterations before a shorter step is tried.
pub(super) const MOST_ITERATIONS: usize = 7;

/// Ratio of two corrections above which a shorter step is preferred.
const SLOWEST: f64 = 0.4;

/// Bound of the remaining corrections if there are events, as a part of the motion in a step, ...
const OF_THE_STEP: f64 = 1e-6;
/// ... or in units in the last place, ...
const ULPS: f64 = 64.0;
/// ... or the least ratio of two corrections that no longer shrink.
const SHRINKS: f64 = 0.5;

/// Decomposed matrices gamma/h I - J and (alpha + i beta)/h I - J.
#[derive(Clone)]
pub(super) struct Factors<M: Linear> {
    /// Length of the steps for which they are.
    pub(super) h: M::S,
    /// True if they are known for the present derivatives.
    pub(super) known: bool,
    real: Resolvent<M, M::S>,
    complex: Resolvent<M, Complex<M::S>>,
}

impl<M: Linear> Factors<M> {
    /// Room for both matrices.
    pub(super) fn room(by_x: &M::Derivatives) -> Self {
        Self { h: M::S::ZERO, known: false, real: by_x.room(), complex: by_x.room() }
    }

    /// True if they are those of steps of `h`.
    pub(super) fn are_of(&self, h: M::S) -> bool {
        self.known && self.h == h
    }

    /// Forgets them, since the derivatives have changed.
    pub(super) fn forget(&mut self) {
        self.known = false;
    }

    /// Decomposes the matrices for steps of `h`; false if one of them is singular.
    pub(super) fn decompose(&mut self, context: &mut Context<'_, M>, by_x: &M::Derivatives, h: M::S) -> bool {
        context.stats.factorisations += 1;
        self.h = h;
        self.found(by_x)
    }

    fn found(&mut self, by_x: &M::Derivatives) -> bool {
        let h = self.h;
        let over_h = |value: f64| M::S::lit(value) / h;
        let pair = Complex { re: over_h(ALPHA), im: over_h(BETA) };
        self.known = by_x.decompose(over_h(GAMMA), M::NQ, &mut self.real)
            && by_x.decompose(pair, M::NQ, &mut self.complex);
        self.known
    }

    /// Repeats the decompositions for the length of their steps, if they were known.
    pub(super) fn again(&mut self, by_x: &M::Derivatives) {
        if self.known {
            self.found(by_x);
        }
    }

    /// (gamma/h I - J)^-1 r.
    pub(super) fn solve(&self, by_x: &M::Derivatives, r: &M::X) -> M::X {
        let mut k = *r;
        by_x.resolve(&self.real, M::NQ, |i| r.at(i), |i, s| k.set(i, s));
        k
    }

    /// Newton correction of the transformed stages `w`, whose rates are `g`.
    fn correction(&self, by_x: &M::Derivatives, w: &[M::X; 3], g: &[M::X; 3]) -> [M::X; 3] {
        let [gamma, alpha, beta] = [GAMMA, ALPHA, BETA].map(|value| M::S::lit(value) / self.h);
        let [w1, w2, w3] = w;
        let [g1, g2, g3] = g;
        let r = |i: usize| Both {
            real: g1.at(i) - gamma * w1.at(i),
            complex: Complex {
                re: g2.at(i) - (alpha * w2.at(i) - beta * w3.at(i)),
                im: g3.at(i) - (alpha * w3.at(i) + beta * w2.at(i)),
            },
        };
        let mut dw = *w;
        let [real, re, im] = &mut dw;
        by_x.resolve_both((&self.real, &self.complex), M::NQ, r, |i, k| {
            real.set(i, k.real);
            re.set(i, k.complex.re);
            im.set(i, k.complex.im);
        });
        dw
    }
}

/// Convergence of the iteration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Convergence<S> {
    /// theta / (1 - theta), stored from step to step: the remaining corrections relative to the last one.
    pub(super) rest: S,
    /// Last ratio of two corrections.
    pub(super) theta: S,
}

impl<S: Real> Convergence<S> {
    pub(super) fn new() -> Self {
        Self { rest: S::lit(1.0), theta: S::ZERO }
    }
}

impl<S: Real> Convergence<S> {
    /// Factor by which a step may grow so that the iteration still converges fast enough: the ratio of two corrections grows with h, and
    /// with h^4 where stiff springs turn (K. Gustafsson, G. Söderlind, Control strategies for the iterative solution of nonlinear equations
    /// in ODE solvers, SIAM J. Sci. Comput. 18, 1997). A single iteration gives no ratio.
    pub(super) fn growth(&self, iterations: usize) -> S {
        if iterations < 2 {
            return S::INFINITY;
        }
        (S::lit(SLOWEST) / self.theta.max(S::EPSILON)).sqrt().sqrt()
    }
}

/// Outcome of an iteration.
pub(super) enum Outcome<X> {
    /// Stages less the state at the beginning, after so many iterations.
    Found([X; 3], usize),
    /// Factor of a shorter step that has to be tried.
    Failed(f64),
}

/// Iterates the stages of a step from the guess `z` (Hairer and Wanner II, IV.8, eqs. (8.10) to (8.13)). The corrections count by `weight`;
/// the remaining ones are then below `tolerance`.
pub(super) fn iterate<M: Linear>(
    context: &mut Context<'_, M>,
    by_x: &M::Derivatives,
    factors: &Factors<M>,
    mut z: [M::X; 3],
    (weight, tolerance): (&M::X, M::S),
    convergence: &mut Convergence<M::S>,
) -> Outcome<M::X> {
    let (t, x, h) = (context.time, context.x, factors.h);
    let mut w = transform(&T_INVERSE, &z);
    let (mut last, mut last_ratio, mut met) = (M::S::ZERO, M::S::ZERO, None);
    convergence.rest = (convergence.rest.max(M::S::EPSILON).ln() * M::S::lit(0.8)).exp();
    for iteration in 1..=MOST_ITERATIONS {
        let mut rates = z;
        for i in 0..3 {
            let stage = x.map2(&z[i], |x, z| x + z);
            if context.rate(t + M::S::lit(C[i]) * h, &stage, &mut rates[i]).is_err() {
                return Outcome::Failed(0.5);
            }
        }
        let dw = factors.correction(by_x, &w, &transform(&T_INVERSE, &rates));
        let size = mean_square(&dw, weight, context.system.states()).sqrt();
        if !size.is_finite() {
            return Outcome::Failed(0.5);
        }
        if iteration > 1 {
            let ratio = size / last;
            // The tolerance stays met once it is; corrections that do not shrink are rounding.
            if let Some(iterations) = met.filter(|_| ratio >= M::S::lit(SHRINKS)) {
                return Outcome::Found(z, iterations);
            }
            convergence.theta = if iteration == 2 { ratio } else { (ratio * last_ratio).sqrt() };
            last_ratio = ratio;
            match convergence.verdict(size / tolerance, iteration) {
                Some(factor) if met.is_none() => return Outcome::Failed(factor),
                _ => {}
            }
        }
        last = size.max(M::S::EPSILON);
        for (w, dw) in w.iter_mut().zip(&dw) {
            w.add([(M::S::lit(1.0), dw)]);
        }
        z = transform(&T, &w);
        let left = convergence.rest * size;
        if left <= tolerance {
            let iterations = *met.get_or_insert(iteration);
            if context.system.guard_count() == 0 || left <= exact(&w, (weight, &x), context.system) {
                return Outcome::Found(z, iterations);
            }
        }
    }
    met.map_or(Outcome::Failed(0.5), |iterations| Outcome::Found(z, iterations))
}

/// Bound of the remaining corrections if there are events, by `weight`: a small part of the motion in the step, since flights between two
/// impacts are lower than any tolerance, or rounding.
fn exact<M: System<S: Real>>(w: &[M::X; 3], (weight, x): (&M::X, &M::X), system: &M) -> M::S {
    let moved = mean_square(w, weight, system.states()).sqrt();
    let typical = system.typical();
    let size = |i: usize| weight.at(i) * (x.at(i).abs() + typical.at(i));
    let rounding = (0..system.states()).fold(M::S::ZERO, |most, i| most.max(size(i)));
    (M::S::lit(OF_THE_STEP) * moved).max(M::S::lit(ULPS) * M::S::EPSILON * rounding)
}

impl<S: Real> Convergence<S> {
    /// Factor of a shorter step, if the remaining iterations do not suffice.
    fn verdict(&mut self, size: S, iteration: usize) -> Option<f64> {
        let (theta, one) = (self.theta, S::lit(1.0));
        if theta >= S::lit(0.99) || !theta.is_finite() {
            return Some(0.5);
        }
        self.rest = theta / (one - theta);
        let left = MOST_ITERATIONS - iteration;
        let excess = (self.rest * size * theta.powi(left as i32)).to_f64();
        if excess < 1.0 {
            return None;
        }
        let root = S::lit(excess.clamp(1e-4, 20.0)).ln() * S::lit(-1.0 / (4.0 + left as f64));
        Some(0.8 * root.exp().to_f64())
    }
}

/// Mean of the squares of three times so many components, each by its weight.
fn mean_square<S: Real, X: Vector<S>>(v: &[X; 3], weight: &X, count: usize) -> S {
    let mut sum = S::ZERO;
    for v in v {
        for i in 0..X::LEN {
            let part = v.at(i) * weight.at(i);
            sum = part.mul_add(part, sum);
        }
    }
    sum / S::lit((3 * count).max(1) as f64)
}

/// A matrix of the tableau times the stages.
fn transform<S: Scalar, X: Vector<S>>(matrix: &[[f64; 3]; 3], v: &[X; 3]) -> [X; 3] {
    let ([v1, v2, v3], matrix, mut out) = (v, matrix.map(|row| row.map(S::lit)), *v);
    for i in 0..X::LEN {
        let at = [v1.at(i), v2.at(i), v3.at(i)];
        for (out, [a, b, c]) in out.iter_mut().zip(matrix) {
            out.set(i, a * at[0] + b * at[1] + c * at[2]);
        }
    }
    out
}

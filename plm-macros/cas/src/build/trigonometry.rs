//! Sine and cosine: exact values, one sign, one pair for each angle.

use crate::graph::Graph;
use crate::math;
use crate::node::{Expr, Function, Node};
use crate::number::Number;

impl Graph {
    /// `sin(x)`, x in radians.
    pub fn sin(&mut self, x: Expr) -> Expr {
        if let Some(value) = self.as_number(x).and_then(sin_of) {
            return self.number(value);
        }
        let (coefficient, _) = self.split_scale(x);
        if coefficient.is_negative() {
            let positive = self.neg(x);
            let sine = self.sin(positive);
            return self.neg(sine);
        }
        if let Some((rest, angle)) = self.split_angle(x)
            && let (Some(s), Some(c)) = (sin_of(angle), cos_of(angle))
        {
            let (sine, cosine) = (self.sin(rest), self.cos(rest));
            return self.linear(Number::ZERO, &[(c, sine), (s, cosine)]);
        }
        match self.node(x) {
            Node::Call(Function::Asin, arguments) => arguments[0],
            _ => self.intern(Node::Call(Function::Sin, [x].into())),
        }
    }

    /// `cos(x)`, x in radians.
    pub fn cos(&mut self, x: Expr) -> Expr {
        if let Some(value) = self.as_number(x).and_then(cos_of) {
            return self.number(value);
        }
        let (coefficient, _) = self.split_scale(x);
        if coefficient.is_negative() {
            let positive = self.neg(x);
            return self.cos(positive);
        }
        if let Some((rest, angle)) = self.split_angle(x)
            && let (Some(s), Some(c)) = (sin_of(angle), cos_of(angle))
        {
            let (sine, cosine) = (self.sin(rest), self.cos(rest));
            return self.linear(Number::ZERO, &[(c, cosine), (-s, sine)]);
        }
        match self.node(x) {
            Node::Call(Function::Acos, arguments) => arguments[0],
            _ => self.intern(Node::Call(Function::Cos, [x].into())),
        }
    }

    /// `tan(x)` as `sin(x) / cos(x)`, which shares the pair.
    pub fn tan(&mut self, x: Expr) -> Expr {
        let (sine, cosine) = (self.sin(x), self.cos(x));
        self.div(sine, cosine)
    }

    /// Splits a constant angle off, where this leaves one term or the angle is a multiple of a quarter turn.
    fn split_angle(&mut self, x: Expr) -> Option<(Expr, Number)> {
        let (scale, inner) = self.split_scale(x);
        let Node::Sum { constant, terms } = self.node(inner) else { return None };
        let angle = scale * *constant;
        if angle.is_zero() || !(terms.len() == 1 || quarter_turns(angle)) {
            return None;
        }
        let terms: Vec<_> = terms.iter().map(|&(c, term)| (scale * c, term)).collect();
        Some((self.linear(Number::ZERO, &terms), angle))
    }

    /// Takes a pair of terms `c*r*sin(u)^2 + c*r*cos(u)^2`, the first of them not before `from`, out of a sorted list of terms
    /// and returns `(c, r)` and where it stood.
    pub(super) fn take_pythagoras(
        &mut self,
        terms: &mut Vec<(Number, Expr)>,
        from: usize,
    ) -> Option<(Number, Expr, usize)> {
        for i in from..terms.len() {
            let (coefficient, term) = terms[i];
            let Node::Product(factors) = self.node(term) else { continue };
            for k in 0..factors.len() {
                if factors[k].1 < 2 {
                    continue;
                }
                let Some(partner) = self.cosine_partner(factors, k) else { continue };
                let found = terms.binary_search_by_key(&partner, |known| known.1);
                let Some(j) = found.ok().filter(|&j| terms[j].0 == coefficient) else { continue };
                let mut rest = factors.to_vec();
                rest[k].1 -= 2;
                terms.remove(i.max(j));
                terms.remove(i.min(j));
                let rest = self.monomial(Number::ONE, &rest);
                return Some((coefficient, rest, i - usize::from(j < i)));
            }
        }
        None
    }

    /// The product in which `cos(u)^2` takes the place of `sin(u)^2`, the factor at `k`; if there is one.
    fn cosine_partner(&self, factors: &[(Expr, i32)], k: usize) -> Option<Expr> {
        let Node::Call(Function::Sin, arguments) = self.node(factors[k].0) else { return None };
        let cosine = self.find(&Node::Call(Function::Cos, arguments.clone()))?;
        let mut partner = factors.to_vec();
        partner[k].1 -= 2;
        match partner.iter_mut().find(|f| f.0 == cosine) {
            Some(factor) => factor.1 = factor.1.checked_add(2)?,
            None => partner.push((cosine, 2)),
        }
        partner.retain(|f| f.1 != 0);
        super::product::sort_factors(&mut partner);
        self.find_product(&partner)
    }
}

fn quarter_turns(angle: Number) -> bool {
    matches!(angle, Number::Exact { den: 1 | 2, pi: 1, .. })
}

/// The sine of a constant; `None` if it is not finite.
pub(super) fn sin_of(angle: Number) -> Option<Number> {
    match angle {
        Number::Exact { num: 0, .. } => Some(Number::ZERO),
        Number::Exact { num, den, pi: 1 } if num.abs() < i128::MAX / 4 && den < i128::MAX / 4 => {
            Some(sin_of_half_turns(num, den))
        }
        _ => finite(math::sin(angle.to_f64())),
    }
}

/// The cosine of a constant; `None` if it is not finite.
pub(super) fn cos_of(angle: Number) -> Option<Number> {
    match angle {
        Number::Exact { num: 0, .. } => Some(Number::ONE),
        Number::Exact { num, den, pi: 1 } if num.abs() < i128::MAX / 8 && den < i128::MAX / 8 => {
            Some(sin_of_half_turns(2 * num + den, 2 * den)) // cos(x) = sin(x + pi/2)
        }
        _ => finite(math::cos(angle.to_f64())),
    }
}

/// `sin(pi * num / den)`, reduced exactly to the first half quadrant before anything is rounded.
fn sin_of_half_turns(num: i128, den: i128) -> Number {
    let turn = num.rem_euclid(2 * den);
    let (sign, half) = if turn >= den { (Number::MINUS_ONE, turn - den) } else { (Number::ONE, turn) };
    let acute = half.min(den - half);
    let angle = |num: i128, den: i128| {
        Number::rational(num, den).map_or(f64::NAN, |turns| (turns * Number::pi()).to_f64())
    };
    let magnitude = if acute == 0 {
        Number::ZERO
    } else if 6 * acute == den {
        Number::Exact { num: 1, den: 2, pi: 0 }
    } else if 2 * acute == den {
        Number::ONE
    } else if 4 * acute <= den {
        Number::from_f64(math::sin(angle(acute, den)))
    } else {
        Number::from_f64(math::cos(angle(den - 2 * acute, 2 * den)))
    };
    sign * magnitude
}

pub(super) fn finite(value: f64) -> Option<Number> {
    value.is_finite().then(|| Number::from_f64(value))
}

//! Products: flat, powers of one base merged, the number in front.

use super::sum::LONG;
use crate::graph::Graph;
use crate::node::{Expr, Function, Node};
use crate::number::Number;

type Factor = (Expr, i32);

impl Graph {
    /// `coefficient * product of factor^exponent` in canonical form.
    pub fn monomial(&mut self, coefficient: Number, factors: &[(Expr, i32)]) -> Expr {
        let mut coefficient = coefficient;
        let mut flat = Vec::with_capacity(2 * factors.len() + 2);
        for &(factor, exponent) in factors {
            self.flatten_product(factor, exponent, &mut coefficient, &mut flat);
        }
        if !merge_powers(&mut flat) {
            return self.whole_product(factors);
        }
        while let Some((base, exponent)) = self.take_even_power(&mut flat) {
            self.flatten_product(base, exponent, &mut coefficient, &mut flat);
            merge_powers(&mut flat);
        }
        if coefficient.is_zero() {
            return self.zero();
        }
        let product = match *flat {
            [] => return self.number(coefficient),
            [(factor, 1)] => factor,
            _ => self.intern_product(&flat),
        };
        self.scale(coefficient, product)
    }

    /// A product whose factors stay whole, because exponents of what is in them would be too large.
    fn whole_product(&mut self, factors: &[Factor]) -> Expr {
        let (mut coefficient, mut whole) = (Number::ONE, Vec::with_capacity(factors.len()));
        for &(factor, exponent) in factors {
            let number = self.as_number(factor);
            let (scale, base) = number.map_or(self.split_scale(factor), |number| (number, factor));
            let power = scale.powi(exponent);
            coefficient = coefficient * power.unwrap_or(Number::ONE);
            if number.is_none() || power.is_none() {
                whole.push((base, exponent));
            }
        }
        merge_powers(&mut whole);
        let product = match *whole {
            [] => return self.number(coefficient),
            [(factor, 1)] => factor,
            _ => self.intern_product(&whole),
        };
        self.scale(coefficient, product)
    }

    /// A product in shared form: products among its factors stay whole.
    pub(crate) fn nested_product(&mut self, mut factors: Vec<Factor>) -> Expr {
        let plain = |&(factor, _): &Factor| {
            !matches!(self.node(factor), Node::Number(_)) && self.split_scale(factor).1 == factor
        };
        if !factors.iter().all(plain) {
            return self.monomial(Number::ONE, &factors);
        }
        merge_powers(&mut factors);
        match *factors {
            [] => self.one(),
            [(factor, 1)] => factor,
            _ => self.intern_product(&factors),
        }
    }

    /// Appends the factors of `e^exponent`, none of them a product that is not long, a scaled expression or an invertible number.
    fn flatten_product(&self, e: Expr, exponent: i32, coefficient: &mut Number, flat: &mut Vec<Factor>) {
        let mut open = vec![(e, exponent)];
        while let Some((e, exponent)) = open.pop() {
            if exponent == 0 {
                continue;
            }
            match self.node(e) {
                Node::Number(number) => match number.powi(exponent) {
                    Some(power) => *coefficient = *coefficient * power,
                    None => flat.push((e, exponent)),
                },
                Node::Sum { constant, terms } if terms.len() == 1 && constant.is_zero() => {
                    // A canonical coefficient is not zero, so that any power of it exists.
                    *coefficient = *coefficient * terms[0].0.powi(exponent).unwrap_or(Number::ZERO);
                    open.push((terms[0].1, exponent));
                }
                Node::Product(inner)
                    if inner.len() <= LONG && inner.iter().all(|f| f.1.checked_mul(exponent).is_some()) =>
                {
                    open.extend(inner.iter().map(|&(factor, inner)| (factor, inner * exponent)));
                }
                _ => flat.push((e, exponent)),
            }
        }
    }

    /// Takes out of the list what an even power of a root or a magnitude is: `sqrt(x)^(2k)` is x^k and
    /// `abs(x)^(2k)` is x^(2k).
    fn take_even_power(&self, flat: &mut Vec<Factor>) -> Option<Factor> {
        for i in 0..flat.len() {
            let (factor, exponent) = flat[i];
            if exponent.abs() < 2 {
                continue;
            }
            let Node::Call(function, arguments) = self.node(factor) else { continue };
            let even = exponent - exponent % 2;
            let power = match function {
                Function::Sqrt => (arguments[0], even / 2),
                Function::Abs => (arguments[0], even),
                _ => continue,
            };
            if even == exponent {
                flat.remove(i);
            } else {
                flat[i].1 = exponent - even;
            }
            return Some(power);
        }
        None
    }
}

/// Sorts factors and adds the exponents of equal ones; those that cancel go. Whether no sum of exponents was too large.
fn merge_powers(factors: &mut Vec<Factor>) -> bool {
    sort_factors(factors);
    let (mut kept, mut fits) = (0, true);
    for i in 0..factors.len() {
        let (factor, exponent) = factors[i];
        let same = kept > 0 && factors[kept - 1].0 == factor;
        let sum = if same { factors[kept - 1].1.checked_add(exponent) } else { None };
        if let Some(sum) = sum {
            factors[kept - 1].1 = sum;
        } else {
            fits &= !same;
            if kept > 0 && factors[kept - 1].1 == 0 {
                kept -= 1;
            }
            factors[kept] = (factor, exponent);
            kept += 1;
        }
    }
    if kept > 0 && factors[kept - 1].1 == 0 {
        kept -= 1;
    }
    factors.truncate(kept);
    fits
}

pub(crate) fn sort_factors(factors: &mut [Factor]) {
    for i in 1..factors.len() {
        let factor = factors[i];
        let mut at = i;
        while at > 0 && factors[at - 1].0 > factor.0 {
            factors[at] = factors[at - 1];
            at -= 1;
        }
        factors[at] = factor;
    }
}

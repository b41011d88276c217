//! Sums: flat, like terms collected, one sign and one scale.

use crate::graph::Graph;
use crate::node::{Expr, Node};
use crate::number::Number;

type Term = (Number, Expr);

/// A sum of more terms stays whole within another. A name for each partial sum of n terms, `s2 = s1 + x2`, would otherwise take
/// n^2/2 terms; so it takes n times this at most.
pub(super) const LONG: usize = 512;

impl Graph {
    /// `constant + sum of coefficient * term` in canonical form.
    pub fn linear(&mut self, constant: Number, terms: &[(Number, Expr)]) -> Expr {
        let mut constant = constant;
        let mut flat = Vec::with_capacity(2 * terms.len() + 2);
        for &(coefficient, term) in terms {
            self.flatten(coefficient, term, &mut constant, &mut flat);
        }
        collect_like(&mut flat);
        let (mut from, mut more) = (0, Vec::new());
        loop {
            let Some((coefficient, rest, at)) = self.take_pythagoras(&mut flat, from) else {
                if from == 0 {
                    break;
                }
                from = 0;
                continue;
            };
            self.flatten(coefficient, rest, &mut constant, &mut more);
            more.drain(..).for_each(|term| collect(&mut flat, term));
            // What is left may make a pair with an earlier term. In a long sum that waits until the others are through.
            from = if flat.len() > LONG { at } else { 0 };
        }
        self.finish_sum(constant, &mut flat)
    }

    /// `coefficient * e`. A sum keeps its node: the coefficient stands before it.
    pub fn scale(&mut self, coefficient: Number, e: Expr) -> Expr {
        if coefficient.is_zero() {
            return self.zero();
        }
        if let Some(number) = self.as_number(e) {
            return self.number(coefficient * number);
        }
        let (inner, base) = self.split_scale(e);
        let coefficient = coefficient * inner;
        if coefficient.is_one() { base } else { self.intern_sum(Number::ZERO, &[(coefficient, base)]) }
    }

    /// Appends the terms of `coefficient * e`, none of them a number, or a sum that is not long.
    fn flatten(&self, coefficient: Number, e: Expr, constant: &mut Number, flat: &mut Vec<Term>) {
        let mut open = vec![(coefficient, e)];
        while let Some((coefficient, e)) = open.pop() {
            match self.node(e) {
                Node::Number(number) => *constant = *constant + coefficient * *number,
                Node::Sum { constant: inner, terms } if terms.len() <= LONG => {
                    *constant = *constant + coefficient * *inner;
                    for &(inner, term) in terms {
                        let scaled = (coefficient * inner, term);
                        if matches!(self.node(term), Node::Sum { .. }) {
                            open.push(scaled);
                        } else {
                            flat.push(scaled);
                        }
                    }
                }
                _ => flat.push((coefficient, e)),
            }
        }
    }

    /// A sum in shared form: sums among its terms stay whole, signs and scale stay where they are.
    pub(crate) fn nested_sum(&mut self, constant: Number, mut terms: Vec<Term>) -> Expr {
        for term in &mut terms {
            let (inner, base) = self.split_scale(term.1);
            *term = (term.0 * inner, base);
        }
        collect_like(&mut terms);
        match *terms {
            [] => self.number(constant),
            [(coefficient, term)] if constant.is_zero() => self.scale(coefficient, term),
            _ => self.intern_sum(constant, &terms),
        }
    }

    /// Pulls sign and common magnitude out. The terms ascend and differ, coefficients are not zero.
    fn finish_sum(&mut self, constant: Number, terms: &mut [Term]) -> Expr {
        match *terms {
            [] => return self.number(constant),
            [(coefficient, term)] if constant.is_zero() => return self.scale(coefficient, term),
            _ => {}
        }
        let scale = common_scale(constant, terms);
        if scale.is_one() {
            return self.intern_sum(constant, terms);
        }
        for term in terms.iter_mut() {
            term.0 = without_scale(term.0, scale);
        }
        let unit = self.intern_sum(without_scale(constant, scale), terms);
        self.intern_sum(Number::ZERO, &[(scale, unit)])
    }
}

/// Factor before the canonical sum: the sign of the first term, and the magnitude that all coefficients (and
/// the constant, unless it is 0) have in common.
fn common_scale(constant: Number, terms: &[Term]) -> Number {
    let first = terms[0].0;
    let magnitude = first.abs();
    let mut common = constant.is_zero() || constant.abs() == magnitude;
    for &(coefficient, _) in terms {
        common = common && coefficient.abs() == magnitude;
    }
    match (common, first.is_negative()) {
        (true, _) => first,
        (false, true) => Number::MINUS_ONE,
        (false, false) => Number::ONE,
    }
}

/// `value / scale`, where `scale` is -1 or the magnitudes are equal or `value` is 0: exact for floats too.
fn without_scale(value: Number, scale: Number) -> Number {
    if scale.is_minus_one() || value.is_zero() {
        -value
    } else if value.is_negative() == scale.is_negative() {
        Number::ONE
    } else {
        Number::MINUS_ONE
    }
}

/// Sorts terms and adds the coefficients of equal ones; what cancels goes.
fn collect_like(terms: &mut Vec<Term>) {
    sort_terms(terms);
    let mut kept = 0;
    for i in 0..terms.len() {
        let (coefficient, term) = terms[i];
        if kept > 0 && terms[kept - 1].1 == term {
            terms[kept - 1].0 = terms[kept - 1].0 + coefficient;
        } else {
            if kept > 0 && terms[kept - 1].0.is_zero() {
                kept -= 1;
            }
            terms[kept] = (coefficient, term);
            kept += 1;
        }
    }
    if kept > 0 && terms[kept - 1].0.is_zero() {
        kept -= 1;
    }
    terms.truncate(kept);
}

/// Adds a term to collected ones, as [`collect_like`] would.
fn collect(terms: &mut Vec<Term>, (coefficient, term): Term) {
    match terms.binary_search_by_key(&term, |known| known.1) {
        Ok(at) => {
            terms[at].0 = terms[at].0 + coefficient;
            if terms[at].0.is_zero() {
                terms.remove(at);
            }
        }
        Err(_) if coefficient.is_zero() => {}
        Err(at) => terms.insert(at, (coefficient, term)),
    }
}

/// Insertion sort for the short lists that sums are, mostly ascending already.
pub(crate) fn sort_terms(terms: &mut [Term]) {
    const SHORT: usize = 16;
    if terms.len() > SHORT {
        terms.sort_by_key(|term| term.1);
        return;
    }
    for i in 1..terms.len() {
        let term = terms[i];
        let mut at = i;
        while at > 0 && terms[at - 1].1 > term.1 {
            terms[at] = terms[at - 1];
            at -= 1;
        }
        terms[at] = term;
    }
}

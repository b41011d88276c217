//! The other functions, comparison and choice.

use crate::graph::Graph;
use crate::math;
use crate::node::{Expr, Function, Node};
use crate::number::Number;

use super::trigonometry::finite;

impl Graph {
    /// A function by its name. The arguments must be as many as [`Function::arity`] says; else the result is NaN.
    pub fn call(&mut self, function: Function, arguments: &[Expr]) -> Expr {
        match (function, arguments) {
            (Function::Sin, &[x]) => self.sin(x),
            (Function::Cos, &[x]) => self.cos(x),
            (Function::Asin, &[x]) => self.asin(x),
            (Function::Acos, &[x]) => self.acos(x),
            (Function::Atan2, &[y, x]) => self.atan2(y, x),
            (Function::Sqrt, &[x]) => self.sqrt(x),
            (Function::Exp, &[x]) => self.exp(x),
            (Function::Ln, &[x]) => self.ln(x),
            (Function::Abs, &[x]) => self.abs(x),
            (Function::Sign, &[x]) => self.sign(x),
            (Function::Floor, &[x]) => self.floor(x),
            (Function::Min, &[a, b]) => self.min(a, b),
            (Function::Max, &[a, b]) => self.max(a, b),
            _ => self.number(Number::Float(f64::NAN)),
        }
    }

    fn intern_call(&mut self, function: Function, arguments: &[Expr]) -> Expr {
        self.intern(Node::Call(function, arguments.into()))
    }

    /// Arc sine, in [-pi/2, pi/2].
    pub fn asin(&mut self, x: Expr) -> Expr {
        if let Some(value) = self.as_number(x).and_then(asin_of) {
            return self.number(value);
        }
        let (coefficient, _) = self.split_scale(x);
        if coefficient.is_negative() {
            let positive = self.neg(x);
            let angle = self.asin(positive);
            return self.neg(angle);
        }
        self.intern_call(Function::Asin, &[x])
    }

    /// Arc cosine, in [0, pi].
    pub fn acos(&mut self, x: Expr) -> Expr {
        if let Some(value) = self.as_number(x).and_then(acos_of) {
            return self.number(value);
        }
        self.intern_call(Function::Acos, &[x])
    }

    /// The angle of the point (x, y), in [-pi, pi].
    pub fn atan2(&mut self, y: Expr, x: Expr) -> Expr {
        if let (Some(y), Some(x)) = (self.as_number(y), self.as_number(x))
            && let Some(value) = atan2_of(y, x)
        {
            return self.number(value);
        }
        self.intern_call(Function::Atan2, &[y, x])
    }

    /// Square root.
    pub fn sqrt(&mut self, x: Expr) -> Expr {
        if let Some(number) = self.as_number(x) {
            let root = number.exact_sqrt().or_else(|| finite(math::sqrt(number.to_f64())));
            return match root {
                Some(root) => self.number(root),
                None => self.intern_call(Function::Sqrt, &[x]),
            };
        }
        let (coefficient, base) = self.split_scale(x);
        let outer = coefficient.exact_sqrt().filter(|_| !coefficient.is_one());
        let root = match self.root_of_even_powers(base) {
            Some(power) if outer.is_some() || coefficient.is_one() => self.abs(power),
            _ if outer.is_some() => self.intern_call(Function::Sqrt, &[base]),
            _ => self.intern_call(Function::Sqrt, &[x]),
        };
        self.scale(outer.unwrap_or(Number::ONE), root)
    }

    /// The product whose square `e` is, if all exponents are even.
    fn root_of_even_powers(&mut self, e: Expr) -> Option<Expr> {
        let Node::Product(factors) = self.node(e) else { return None };
        let halves: Option<Vec<_>> =
            factors.iter().map(|&(factor, n)| (n % 2 == 0).then_some((factor, n / 2))).collect();
        halves.map(|halves| self.monomial(Number::ONE, &halves))
    }

    /// e to the power x.
    pub fn exp(&mut self, x: Expr) -> Expr {
        if self.is_zero(x) {
            return self.one();
        }
        if let Some(value) = self.as_number(x).and_then(|n| finite(math::exp(n.to_f64()))) {
            return self.number(value);
        }
        match self.node(x) {
            Node::Call(Function::Ln, arguments) => arguments[0],
            _ => self.intern_call(Function::Exp, &[x]),
        }
    }

    /// Natural logarithm.
    pub fn ln(&mut self, x: Expr) -> Expr {
        if self.is_one(x) {
            return self.zero();
        }
        if let Some(value) = self.as_number(x).and_then(|n| finite(math::ln(n.to_f64()))) {
            return self.number(value);
        }
        match self.node(x) {
            Node::Call(Function::Exp, arguments) => arguments[0],
            _ => self.intern_call(Function::Ln, &[x]),
        }
    }

    /// Absolute value.
    pub fn abs(&mut self, x: Expr) -> Expr {
        if let Some(number) = self.as_number(x) {
            return self.number(number.abs());
        }
        let (coefficient, base) = self.split_scale(x);
        let (mut outside, mut inside) = (Vec::new(), Vec::new());
        match self.node(base) {
            Node::Product(factors) => {
                for &factor in &**factors {
                    let side = if self.is_never_negative(factor) { &mut outside } else { &mut inside };
                    side.push(factor);
                }
            }
            _ if self.is_never_negative((base, 1)) => outside.push((base, 1)),
            _ => inside.push((base, 1)),
        }
        if !inside.is_empty() {
            let inner = self.monomial(Number::ONE, &inside);
            outside.push((self.intern_call(Function::Abs, &[inner]), 1));
        }
        self.monomial(coefficient.abs(), &outside)
    }

    /// Is the power zero, positive or NaN by its form alone?
    fn is_never_negative(&self, (base, exponent): (Expr, i32)) -> bool {
        let by_itself = matches!(
            self.node(base),
            Node::Call(Function::Abs | Function::Sqrt | Function::Exp | Function::Acos, _)
        );
        by_itself || exponent % 2 == 0
    }

    /// The sign as [`Function::Sign`] defines it.
    pub fn sign(&mut self, x: Expr) -> Expr {
        if let Some(number) = self.as_number(x) {
            return match number {
                zero if zero.is_zero() => x,
                Number::Float(value) if value.is_nan() => x,
                negative if negative.is_negative() => self.int(-1),
                _ => self.one(),
            };
        }
        let (coefficient, base) = self.split_scale(x);
        let sign = match self.node(base) {
            Node::Call(Function::Sign, _) => base,
            _ => self.intern_call(Function::Sign, &[base]),
        };
        if coefficient.is_negative() { self.neg(sign) } else { sign }
    }

    /// The largest integer that is not above x.
    pub fn floor(&mut self, x: Expr) -> Expr {
        match self.as_number(x).and_then(floor_of) {
            Some(number) => self.number(number),
            None => self.intern_call(Function::Floor, &[x]),
        }
    }

    /// The smaller one, as [`Function::Min`] defines it; the order of the arguments is normalised.
    pub fn min(&mut self, a: Expr, b: Expr) -> Expr {
        self.extremum(Function::Min, a, b)
    }

    /// The larger one, as [`Function::Max`] defines it; the order of the arguments is normalised.
    pub fn max(&mut self, a: Expr, b: Expr) -> Expr {
        self.extremum(Function::Max, a, b)
    }

    /// `x` held between `low` and `high`: `max(low, min(x, high))`.
    pub fn clamp(&mut self, x: Expr, low: Expr, high: Expr) -> Expr {
        let below = self.min(x, high);
        self.max(low, below)
    }

    fn extremum(&mut self, function: Function, a: Expr, b: Expr) -> Expr {
        if a == b {
            return a;
        }
        if let Some(a_is_less) = self.compare(a, b) {
            return if a_is_less == (function == Function::Min) { a } else { b };
        }
        let (first, second) = if a <= b { (a, b) } else { (b, a) };
        self.intern_call(function, &[first, second])
    }

    /// `a < b` for two constants.
    fn compare(&self, a: Expr, b: Expr) -> Option<bool> {
        let (a, b) = (self.as_number(a)?, self.as_number(b)?);
        Some(a.to_f64() < b.to_f64())
    }

    /// The condition `a < b` for [`select`](Self::select); 1 or 0 where it is known.
    pub fn less(&mut self, a: Expr, b: Expr) -> Expr {
        if a == b {
            return self.zero();
        }
        match self.compare(a, b) {
            Some(true) => self.one(),
            Some(false) => self.zero(),
            None => match self.less_than_extremum(a, b) {
                Some(known) => known,
                None => self.intern(Node::Less(a, b)),
            },
        }
    }

    /// A comparison of a constant with the extremum of another and `x` asks for `x` alone, or for nothing: `0 < max(x, 0)` is
    /// `0 < x`. What is left passes the boundary with a slope, where the extremum rests on it.
    fn less_than_extremum(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        let constant_first = self.as_number(a).is_some();
        let (constant, other) = if constant_first { (a, b) } else { (b, a) };
        self.as_number(constant)?;
        let Node::Call(function @ (Function::Min | Function::Max), arguments) = self.node(other) else {
            return None;
        };
        let (is_max, [p, q]) = (*function == Function::Max, <[Expr; 2]>::try_from(&arguments[..]).ok()?);
        let (bound, x) = if self.as_number(p).is_some() { (p, q) } else { (q, p) };
        // Does the bound itself fulfil the condition?
        let holds =
            if constant_first { self.compare(constant, bound)? } else { self.compare(bound, constant)? };
        // Of a maximum above the constant, and of a minimum below it, one is enough.
        let one_is_enough = is_max == constant_first;
        Some(match (holds, one_is_enough) {
            (true, true) => self.one(),
            (false, false) => self.zero(),
            _ if constant_first => self.less(constant, x),
            _ => self.less(x, constant),
        })
    }

    /// `a` where the condition holds, else `b`. A condition that is not a comparison means "greater than 0".
    pub fn select(&mut self, condition: Expr, a: Expr, b: Expr) -> Expr {
        let zero = self.zero();
        let condition = match self.node(condition) {
            Node::Less(..) => condition,
            _ => self.less(zero, condition),
        };
        if a == b || self.is_one(condition) {
            a
        } else if self.is_zero(condition) {
            b
        } else {
            self.intern(Node::Select(condition, a, b))
        }
    }
}

const HALF: Number = Number::Exact { num: 1, den: 2, pi: 0 };

/// `pi * num / den`.
const fn part_of_pi(num: i128, den: i128) -> Number {
    Number::Exact { num, den, pi: 1 }
}

/// Of a rational number exactly.
fn floor_of(x: Number) -> Option<Number> {
    match x {
        Number::Exact { num, den, pi: 0 } => Some(Number::Exact { num: num.div_euclid(den), den: 1, pi: 0 }),
        _ => finite(math::floor(x.to_f64())),
    }
}

fn asin_of(x: Number) -> Option<Number> {
    let angle = match x.abs() {
        zero if zero.is_zero() => Number::ZERO,
        half if half == HALF => part_of_pi(1, 6),
        one if one.is_one() => part_of_pi(1, 2),
        other => finite(math::asin(other.to_f64()))?,
    };
    Some(if x.is_negative() { -angle } else { angle })
}

fn acos_of(x: Number) -> Option<Number> {
    let exact = x.is_zero() || x.abs() == HALF || x.abs().is_one();
    if exact { Some(part_of_pi(1, 2) - asin_of(x)?) } else { finite(math::acos(x.to_f64())) }
}

fn atan2_of(y: Number, x: Number) -> Option<Number> {
    let upper = match (y.is_zero(), x.is_zero(), x.is_negative()) {
        (true, _, false) => Number::ZERO, // IEEE 754 too gives 0 at the origin
        (true, _, true) => part_of_pi(1, 1),
        (false, true, _) => part_of_pi(1, 2),
        (false, false, false) if y.abs() == x => part_of_pi(1, 4),
        (false, false, true) if y.abs() == -x => part_of_pi(3, 4),
        _ => finite(math::atan2(y.abs().to_f64(), x.to_f64()))?,
    };
    Some(if y.is_negative() { -upper } else { upper })
}

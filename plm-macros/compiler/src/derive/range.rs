//! Range of an expression for all values of its symbols, by interval arithmetic (R. E. Moore, R. B. Kearfott, M. J. Cloud,
//! Introduction to Interval Analysis, SIAM 2009, chapter 2). It tells that `2 - cos(angle)` never vanishes.

use plm_cas::{Expr, Function, Node, algebra};

/// From the least to the greatest value.
pub(crate) type Range = [f64; 2];

const ALL: Range = [f64::NEG_INFINITY, f64::INFINITY];

/// The range of an expression.
pub(crate) fn range(expr: Expr) -> Range {
    let nodes = algebra::reachable(&[expr]);
    let mut ranges: Vec<Range> = Vec::with_capacity(nodes.len());
    for node in &nodes {
        let of = |operand: Expr| nodes.binary_search(&operand).ok().and_then(|k| ranges.get(k)).copied();
        let found = of_node(&node.node(), &|operand| of(operand).unwrap_or(ALL));
        let is_number = found.iter().all(|bound| !bound.is_nan());
        ranges.push(if is_number { found } else { ALL });
    }
    ranges.last().copied().unwrap_or(ALL)
}

/// By the ranges of its operands.
fn of_node(node: &Node, of: &dyn Fn(Expr) -> Range) -> Range {
    match node {
        Node::Number(number) => [number.to_f64(); 2],
        Node::Symbol => ALL,
        Node::Defined(value) => of(*value),
        Node::Sum { constant, terms } => {
            let mut sum = [constant.to_f64(); 2];
            for &(coefficient, term) in terms {
                let [low, high] = product([coefficient.to_f64(); 2], of(term));
                sum = [sum[0] + low, sum[1] + high];
            }
            sum
        }
        Node::Product(factors) => factors
            .iter()
            .fold([1.0; 2], |all, &(factor, exponent)| product(all, power(of(factor), exponent))),
        Node::Call(function, arguments) => of_call(*function, arguments, of),
        Node::Less(..) => [0.0, 1.0],
        Node::Select(_, yes, no) => {
            let ([a, b], [c, d]) = (of(*yes), of(*no));
            [a.min(c), b.max(d)]
        }
    }
}

fn of_call(function: Function, arguments: &[Expr], of: &dyn Fn(Expr) -> Range) -> Range {
    use std::f64::consts::{FRAC_PI_2, PI};
    let [low, high] = arguments.first().map_or(ALL, |first| of(*first));
    let [other_low, other_high] = arguments.get(1).map_or(ALL, |second| of(*second));
    match function {
        Function::Sin | Function::Cos | Function::Sign => [-1.0, 1.0],
        Function::Asin => [-FRAC_PI_2, FRAC_PI_2],
        Function::Acos => [0.0, PI],
        Function::Atan2 => [-PI, PI],
        Function::Sqrt => [low.max(0.0).sqrt(), high.max(0.0).sqrt()],
        Function::Exp => [low.exp(), high.exp()],
        Function::Ln => ALL,
        Function::Floor => [low.floor(), high.floor()],
        Function::Abs if low >= 0.0 => [low, high],
        Function::Abs if high <= 0.0 => [-high, -low],
        Function::Abs => [0.0, high.max(-low)],
        Function::Min => [low.min(other_low), high.min(other_high)],
        Function::Max => [low.max(other_low), high.max(other_high)],
    }
}

fn product([a, b]: Range, [c, d]: Range) -> Range {
    let times = |x: f64, y: f64| if x == 0.0 || y == 0.0 { 0.0 } else { x * y };
    let all = [times(a, c), times(a, d), times(b, c), times(b, d)];
    [all.into_iter().fold(f64::INFINITY, f64::min), all.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}

fn power([low, high]: Range, exponent: i32) -> Range {
    if exponent < 0 {
        let [low, high] = power([low, high], exponent.saturating_neg());
        return match () {
            () if low > 0.0 || high < 0.0 => [1.0 / high, 1.0 / low],
            () if low >= 0.0 => [0.0, f64::INFINITY],
            () if high <= 0.0 => [f64::NEG_INFINITY, 0.0],
            () => ALL,
        };
    }
    let [at_low, at_high] = [low.powi(exponent), high.powi(exponent)];
    if exponent % 2 == 1 {
        return [at_low, at_high];
    }
    let least = if low <= 0.0 && high >= 0.0 { 0.0 } else { at_low.min(at_high) };
    [least, at_low.max(at_high)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use plm_cas::Graph;

    #[test]
    fn what_cannot_change_its_sign_is_seen() {
        Graph::new().enter(|| {
            let (x, y) = (Expr::symbol("x"), Expr::symbol("y"));
            let two = Expr::from(2);
            let length = (x * x + y * y).sqrt();
            for (expr, least, most) in [
                (two - x.cos(), 1.0, 3.0),
                (length, 0.0, f64::INFINITY),
                (Expr::ONE / length, 0.0, f64::INFINITY),
                (x.abs().max(two), 2.0, f64::INFINITY),
                (x.exp() + Expr::ONE, 1.0, f64::INFINITY),
                (x.less(y).select(two, Expr::from(3)), 2.0, 3.0),
                (x * x * x, f64::NEG_INFINITY, f64::INFINITY),
                (Expr::ONE / (two - x.sin()), 1.0 / 3.0, 1.0),
                (-(x * x), f64::NEG_INFINITY, 0.0),
            ] {
                assert_eq!(range(expr), [least, most], "{expr}");
            }
        });
    }
}

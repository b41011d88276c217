//! Random numbers and expressions from a seed.

#[path = "../../../../tests/support/random.rs"]
mod stream;

use plm_cas::{Expr, Function, Graph, Number};

pub(crate) use stream::Random;

/// A small exact number, never 0.
pub(crate) fn number(random: &mut Random) -> Number {
    let num = *random.one_of(&[1, 1, 2, 3, -1, -2, 5, -7]);
    Number::rational(num, *random.one_of(&[1, 1, 2, 3, 10])).unwrap()
}

/// Grows a pool of `count` expressions over some symbols by random constructors. Every kind of node occurs; the
/// arguments of partial functions are kept inside their domains, and quotients away from zero.
pub(crate) fn grow(g: &mut Graph, random: &mut Random, symbols: &[Expr], count: usize) -> Vec<Expr> {
    let mut pool = symbols.to_vec();
    while pool.len() < symbols.len() + count {
        let (a, b, c) = (*random.one_of(&pool), *random.one_of(&pool), *random.one_of(&pool));
        let e = operation(g, random, a, b, c);
        // Keep values near 1, where rounding errors can be bounded.
        let e = if random.below(3) == 0 { g.sin(e) } else { e };
        pool.push(e);
    }
    pool
}

fn operation(g: &mut Graph, random: &mut Random, a: Expr, b: Expr, c: Expr) -> Expr {
    let k = number(random);
    match random.below(20) {
        0..3 => g.sum(&[a, b, c]),
        3 => g.sub(a, b),
        4 => g.linear(k, &[(number(random), a), (number(random), b), (number(random), c)]),
        5 => g.linear(Number::ZERO, &[(k, a), (k, b), (-k, c)]),
        6..8 => g.mul(a, b),
        8 => g.product(&[a, b, c]),
        9 => {
            let above_one = at_least_one(g, b);
            g.div(a, above_one)
        }
        10 => {
            let small = g.sin(a);
            let n = *random.one_of(&[2, 2, 3, 4, 7]);
            let power = g.powi(small, n);
            g.mul(power, b)
        }
        11 => g.scale(k, a),
        12 => g.cos(a),
        13 => {
            let above_one = at_least_one(g, a);
            if random.below(2) == 0 { g.sqrt(above_one) } else { g.ln(above_one) }
        }
        14 => {
            let half = g.sin(b);
            let half = g.scale(Number::rational(1, 2).unwrap(), half);
            let f = *random.one_of(&[Function::Asin, Function::Acos, Function::Exp]);
            g.call(f, &[half])
        }
        15 => {
            let above_one = at_least_one(g, a);
            g.atan2(b, above_one)
        }
        16 => g.call(*random.one_of(&[Function::Abs, Function::Sign, Function::Floor]), &[a]),
        17 => g.call(*random.one_of(&[Function::Min, Function::Max]), &[a, b]),
        18 => {
            let less = g.less(a, b);
            g.select(less, c, a)
        }
        _ => g.define("d", a),
    }
}

fn at_least_one(g: &mut Graph, e: Expr) -> Expr {
    let square = g.powi(e, 2);
    g.linear(Number::ONE, &[(Number::ONE, square)])
}

//! How long the algebra takes on a chain of bars in absolute coordinates, in the build that proc macros run in:
//! `cargo run -p plm-cas --example chain -- 64` (and `list` to see the operations).
//!
//! For each joint two closure rows, their gradients and accelerations; then G = J M^-1 J^T in banded form, its
//! factorisation L D L^T in defined atoms, the multipliers, and the accelerations of all bodies.

use std::time::Instant;

use plm_cas::{Expr, Graph, Number, Tape, share};

struct Body {
    q: [Expr; 3],
    v: [Expr; 3],
    inverse_mass: [Expr; 3],
}

/// A point at (along, 0) on a body.
fn point(g: &mut Graph, body: &Body, along: &str) -> [Expr; 2] {
    let along = Number::parse_decimal(along).unwrap_or(Number::ONE);
    let (s, c) = (g.sin(body.q[2]), g.cos(body.q[2]));
    let x = g.linear(Number::ZERO, &[(Number::ONE, body.q[0]), (along, c)]);
    let y = g.linear(Number::ZERO, &[(Number::ONE, body.q[1]), (along, s)]);
    [x, y]
}

fn chain(g: &mut Graph, count: usize) -> (Vec<Body>, Vec<Expr>) {
    let mut bodies = Vec::new();
    for i in 0..count {
        let mut symbol = |name: &str| g.symbol(&format!("{name}{i}"));
        let (q, v) = ([symbol("x"), symbol("y"), symbol("theta")], [symbol("vx"), symbol("vy"), symbol("w")]);
        let (m, j) = (symbol("m"), symbol("j"));
        let (m, j) = (g.recip(m), g.recip(j));
        bodies.push(Body { q, v, inverse_mass: [m, m, j] });
    }
    let mut phi = Vec::new();
    for i in 0..count {
        let near = point(g, &bodies[i], "-0.25");
        let far = if i == 0 { [g.zero(), g.zero()] } else { point(g, &bodies[i - 1], "0.25") };
        phi.push(g.sub(near[0], far[0]));
        phi.push(g.sub(near[1], far[1]));
    }
    (bodies, phi)
}

fn gamma(g: &mut Graph, bodies: &[Body], phi: &[Expr]) -> Vec<Expr> {
    let along: Vec<_> = bodies.iter().flat_map(|b| b.q.into_iter().zip(b.v)).collect();
    let rate = g.directionals(phi, &along);
    let second = g.directionals(&rate, &along);
    second.into_iter().map(|row| g.neg(row)).collect()
}

/// `G[i][i - k]` for k up to the bandwidth of 3, by the rows' common columns.
fn gram(g: &mut Graph, rows: &[Vec<(usize, Expr)>], bodies: &[Body], i: usize, j: usize) -> Expr {
    let mut terms = Vec::new();
    for &(column, a) in &rows[i] {
        if let Some(&(_, b)) = rows[j].iter().find(|entry| entry.0 == column) {
            let inverse = bodies[column / 3].inverse_mass[column % 3];
            terms.push(g.product(&[a, b, inverse]));
        }
    }
    g.sum(&terms)
}

const BAND: usize = 3;

/// L and the inverse pivots: `l[i][k]` is L(i, i - k) for k in 1..=BAND.
struct Factors {
    l: Vec<[Expr; BAND + 1]>,
    inverse: Vec<Expr>,
}

/// Factorises the symmetric matrix whose lower entries `entry(i, j)` gives.
fn factorise(g: &mut Graph, entry: impl Fn(&mut Graph, usize, usize) -> Expr, n: usize) -> Factors {
    let mut f = Factors { l: Vec::new(), inverse: Vec::new() };
    for i in 0..n {
        let mut row = [g.zero(); BAND + 1];
        let mut scaled = [g.zero(); BAND + 1];
        for k in (1..=BAND.min(i)).rev() {
            let j = i - k;
            let mut value = entry(g, i, j);
            for m in k + 1..=BAND.min(i) {
                let product = g.mul(scaled[m], f.l[j][m - k]);
                value = g.sub(value, product);
            }
            scaled[k] = g.define(&format!("u{i}_{j}"), value);
            let quotient = g.mul(scaled[k], f.inverse[j]);
            row[k] = g.define(&format!("l{i}_{j}"), quotient);
        }
        let mut pivot = entry(g, i, i);
        for k in 1..=BAND.min(i) {
            let product = g.mul(scaled[k], row[k]);
            pivot = g.sub(pivot, product);
        }
        let pivot = g.define(&format!("d{i}"), pivot);
        let reciprocal = g.recip(pivot);
        f.inverse.push(g.define(&format!("inv_d{i}"), reciprocal));
        f.l.push(row);
    }
    f
}

/// Solves for the right-hand side b, forwards and backwards.
fn solve(g: &mut Graph, f: &Factors, b: &[Expr]) -> Vec<Expr> {
    let n = b.len();
    let mut x = b.to_vec();
    for i in 0..n {
        for k in 1..=BAND.min(i) {
            let product = g.mul(f.l[i][k], x[i - k]);
            x[i] = g.sub(x[i], product);
        }
        x[i] = g.define(&format!("z{i}"), x[i]);
    }
    for i in (0..n).rev() {
        x[i] = g.mul(x[i], f.inverse[i]);
        for k in 1..=BAND.min(n - 1 - i) {
            let product = g.mul(f.l[i + k][k], x[i + k]);
            x[i] = g.sub(x[i], product);
        }
        x[i] = g.define(&format!("lambda{i}"), x[i]);
    }
    x
}

/// Accelerations of all coordinates. Weight is the only force: a = g + M^-1 J^T lambda, G lambda = gamma - J g.
fn accelerations(g: &mut Graph, bodies: &[Body], phi: &[Expr]) -> Vec<Expr> {
    let q: Vec<Expr> = bodies.iter().flat_map(|body| body.q).collect();
    let rows: Vec<_> = phi.iter().map(|&row| g.gradient(row, &q)).collect();
    let mut right = gamma(g, bodies, phi);
    let fall = g.number(Number::parse_decimal("-9.81").unwrap_or(Number::ONE));
    let weight = |column: usize| (column % 3 == 1).then_some(fall);
    for (i, row) in rows.iter().enumerate() {
        for &(column, entry) in row {
            if let Some(fall) = weight(column) {
                let product = g.mul(entry, fall);
                right[i] = g.sub(right[i], product);
            }
        }
    }
    let factors = factorise(g, |g, i, j| gram(g, &rows, bodies, i, j), phi.len());
    let lambda = solve(g, &factors, &right);
    let mut terms: Vec<Vec<Expr>> = (0..q.len()).map(|column| weight(column).into_iter().collect()).collect();
    for (i, row) in rows.iter().enumerate() {
        for &(column, entry) in row {
            let inverse = bodies[column / 3].inverse_mass[column % 3];
            terms[column].push(g.product(&[entry, lambda[i], inverse]));
        }
    }
    terms.iter().map(|terms| g.sum(terms)).collect()
}

fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}

fn main() -> Result<(), String> {
    let (mut count, mut listed) = (64, false);
    for word in std::env::args().skip(1) {
        match word.parse() {
            Ok(number) => count = number,
            Err(_) if word == "list" => listed = true,
            Err(_) => return Err(format!("{word} is neither a number of bodies nor `list`")),
        }
    }
    let mut g = Graph::new();

    let start = Instant::now();
    let (bodies, phi) = chain(&mut g, count);
    let a = accelerations(&mut g, &bodies, &phi);
    let derived = milliseconds(start);
    let nodes = g.len();

    let start = Instant::now();
    let roots = share(&mut g, &a);
    let shared = milliseconds(start);

    let start = Instant::now();
    let tape = Tape::new(&g, &roots);
    let lowered = milliseconds(start);

    println!("{count} bodies, {nodes} nodes, {} after sharing", g.len());
    println!(
        "derivation {derived:.1} ms, sharing {shared:.1} ms, tape {lowered:.1} ms, all {:.1} ms",
        derived + shared + lowered
    );
    for (name, count) in [("before", Tape::new(&g, &a).count()), ("after", tape.count())] {
        println!("{name} sharing: {count} ({})", count.total());
    }
    if listed {
        println!("{}", tape.listing(&g));
    }
    Ok(())
}

//! Assembly from rough starts: what a closed form reaches is found, what it does not says how much it lacks.
#![allow(
    clippy::large_types_passed_by_value,
    clippy::unwrap_used,
    clippy::panic,
    missing_docs,
    reason = "tests"
)]

#[macro_use]
#[path = "support/scene.rs"]
mod scene;
#[path = "support/random.rs"]
mod random;

use plm::runtime::absolute;
use plm::{Cause, Fault, Found};
use random::Random;
use scene::{Given as _, Scene};

scene! {
    pub FiveBar {
        param span: m = 0.2 m; param a: m = 0.2 m; param b: m = 0.2 m; param c: m = 0.25 m; param d: m = 0.25 m;
        param q1: rad = 24 deg; param q2: rad = 252 deg;
        ground { port a: (0, 0) m; port b: (span, 0); }
        body left { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port c: (a, 0); start angle: q1; }
        body right { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port d: (b, 0); start x: span; start angle: q2; }
        body l2 { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; port p: (c, 0); }
        body r2 { mass: 1 kg; inertia: 1 kg*m^2; port d: (0, 0) m; port p: (d, 0); }
        revolute ja(ground.a, left.a);
        revolute jb(ground.b, right.b);
        revolute jc(left.c, l2.c);
        revolute jd(right.d, r2.d);
        revolute tip(l2.p, r2.p);
        constraint m1: left.angle = q1;
        constraint m2: right.angle = q2;
    }
}

scene! {
    pub FourBar {
        formulation: absolute;
        param span: m = 0.4 m; param a: m = 0.1 m; param b: m = 0.4 m; param c: m = 0.3 m; param q: rad = 1 rad;
        ground { port o: (0, 0) m; port p: (span, 0); }
        body crank { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (a, 0); start angle: q, locked; }
        body coupler { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (b, 0); }
        body rocker { mass: 1 kg; inertia: 1 kg*m^2; port c: (c, 0); port p: (0, 0) m; start x: span; }
        revolute po(ground.o, crank.a);
        revolute pb(crank.b, coupler.b);
        revolute pp(ground.p, rocker.p);
        revolute pc(coupler.c, rocker.c);
    }
}

scene! {
    pub SliderCrank {
        param offset: m = 0 m; param a: m = 0.1 m; param b: m = 0.3 m; param q: rad = 1 rad;
        ground { port o: (0, 0) m; port rail: (0 m, offset); }
        body crank { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (a, 0); start angle: q; }
        body rod { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (b, 0); }
        body piston { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start y: offset; }
        revolute main(ground.o, crank.a);
        revolute big_end(crank.b, rod.b);
        prismatic guide(ground.rail, piston.c);
        revolute small_end(rod.c, piston.c);
        constraint drive: crank.angle = q;
    }
}

scene! {
    /// A four-bar whose coupler carries a second dyad.
    pub SixBar {
        param span: m = 0.4 m; param a: m = 0.1 m; param b: m = 0.4 m; param c: m = 0.3 m; param q: rad = 1 rad;
        param u: m = 0.2 m; param v: m = 0.1 m; param gx: m = 0.3 m; param gy: m = -0.2 m; param d: m = 0.4 m; param e: m = 0.4 m;
        ground { port o: (0, 0) m; port p: (span, 0); port g: (gx, gy); }
        body crank { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (a, 0); start angle: q; }
        body coupler { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (b, 0); port s: (u, v); }
        body rocker { mass: 1 kg; inertia: 1 kg*m^2; port c: (c, 0); port p: (0, 0) m; }
        body link { mass: 1 kg; inertia: 1 kg*m^2; port s: (0, 0) m; port t: (d, 0); }
        body arm { mass: 1 kg; inertia: 1 kg*m^2; port t: (e, 0); port g: (0, 0) m; }
        revolute po(ground.o, crank.a);
        revolute pb(crank.b, coupler.b);
        revolute pc(coupler.c, rocker.c);
        revolute pp(ground.p, rocker.p);
        revolute ps(coupler.s, link.s);
        revolute pt(link.t, arm.t);
        revolute pg(ground.g, arm.g);
        constraint drive: crank.angle = q;
    }
}

/// What a case has come to.
#[derive(Default, Debug)]
struct Tally {
    reachable: usize,
    missed: usize,
    /// Poses that a search found, and of those which are not the nearer one of the two.
    searched: usize,
    farther: usize,
    beyond: usize,
    /// Of those beyond reach what came out as something else than the true lack.
    untrue: usize,
}

/// A mechanism with parameters and start values of its own.
fn given(mechanism: Scene, parameters: &[(&str, f64)], starts: &[(&str, f64)]) -> Scene {
    let mechanism = parameters.iter().fold(mechanism, |own, (name, value)| own.with(name, *value));
    starts.iter().fold(mechanism, |own, (name, value)| own.with_start(name, *value))
}

/// Coordinates and how they were found.
fn assembled(mechanism: &Scene, count: usize) -> Result<(Vec<f64>, Found), Fault> {
    absolute::assemble(mechanism, 0.0).map(|found| (found.q[..count].to_vec(), found.found))
}

/// Solutions of a closed form, as all coordinates; or by how much it lacks one, m.
type Closed = Result<Vec<Vec<f64>>, f64>;

fn judge(
    tally: &mut Tally,
    closed: &Closed,
    found: &Result<(Vec<f64>, Found), Fault>,
    (start, case): (&[f64], &str),
) {
    let distance = |q: &[f64]| -> f64 { q.iter().zip(start).map(|(a, b)| (a - b) * (a - b)).sum() };
    match (closed, found) {
        (Ok(poses), Ok((found, how))) => {
            tally.reachable += 1;
            let best = poses.iter().map(|pose| {
                let nearest = |(k, q): (usize, &f64)| {
                    let turns =
                        if k % 3 == 2 { ((start[k] - q) / std::f64::consts::TAU).round() } else { 0.0 };
                    q + turns * std::f64::consts::TAU
                };
                pose.iter().enumerate().map(nearest).collect::<Vec<f64>>()
            });
            let best: Vec<Vec<f64>> = best.collect();
            // It is one of them, to rounding near the boundary of the workspace.
            let off = |pose: &Vec<f64>| {
                found.iter().zip(pose).enumerate().fold(0.0_f64, |off, (k, (a, b))| {
                    let by = if k % 3 == 2 { 2.0 * ((a - b) / 2.0).sin() } else { a - b };
                    off.max(by.abs())
                })
            };
            let near = best.iter().map(off).fold(f64::INFINITY, f64::min);
            assert!(near < 1e-5, "{case}: off every pose by {near:e}");
            if matches!(how, Found::Searched { .. }) {
                tally.searched += 1;
                let least = best.iter().map(|pose| distance(pose)).fold(f64::INFINITY, f64::min);
                if distance(found) > least * (1.0 + 1e-6) {
                    tally.farther += 1;
                    println!("{case}: {} where {least} is", distance(found));
                }
            }
        }
        (Ok(_), Err(fault)) => {
            tally.reachable += 1;
            tally.missed += 1;
            println!("{case}: {fault}");
        }
        (Err(_), Ok(_)) => panic!("{case}: found where nothing is"),
        (Err(lack), Err(fault)) => {
            tally.beyond += 1;
            let is_true = matches!(fault.cause, Cause::Open { gap } if lack.is_nan() || (gap - lack).abs() < 1e-5 * (1.0 + lack));
            if !is_true {
                tally.untrue += 1;
                println!("{case}: lacks {lack}: {fault}");
            }
        }
    }
}

/// Both ways from `a` by `p` to what is `q` from `b`: the angles of the two bars; or by how much they are too short or too long.
fn dyad(a: [f64; 2], b: [f64; 2], p: f64, q: f64) -> Result<[[f64; 2]; 2], f64> {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let far = dx.hypot(dy);
    let lack = (far - p - q).max((p - q).abs() - far);
    if lack > 0.0 {
        return Err(lack);
    }
    let (line, half) =
        (dy.atan2(dx), ((p * p + far * far - q * q) / (2.0 * p * far)).clamp(-1.0, 1.0).acos());
    Ok([half, -half].map(|half| {
        let angle = line + half;
        let tip = [a[0] + p * angle.cos(), a[1] + p * angle.sin()];
        [angle, (tip[1] - b[1]).atan2(tip[0] - b[0])]
    }))
}

/// A length of one to four digits, m.
fn length(random: &mut Random) -> f64 {
    let digits = 10_f64.powi(random.between(1.0, 5.0).floor() as i32);
    (random.between(0.05, 1.0) * digits).ceil() / digits
}

fn angle(random: &mut Random) -> f64 {
    3.1 * random.unit()
}

/// Where a case is not nearer to the boundary of the workspace than numbers are told.
fn is_clear(closed: &Result<[[f64; 2]; 2], f64>, a: [f64; 2], b: [f64; 2], p: f64, q: f64) -> bool {
    let far = (b[0] - a[0]).hypot(b[1] - a[1]);
    closed.as_ref().map_or_else(|lack| *lack > 1e-6, |_| (p + q - far).min(far - (p - q).abs()) > 1e-6)
}

fn polar(r: f64, angle: f64) -> [f64; 2] {
    [r * angle.cos(), r * angle.sin()]
}

fn end(tally: &Tally, what: &str) {
    println!("{what}: {tally:?}");
    assert!(tally.reachable > 10 && tally.beyond > 10 && tally.searched > 0, "{what}: {tally:?}");
    assert_eq!((tally.missed, tally.farther, tally.untrue), (0, 0, 0), "{what}: {tally:?}");
}

fn cases() -> u64 {
    std::env::var("PLM_REACH").map_or(60, |cases| cases.parse().unwrap())
}

#[test]
fn no_pose_of_a_five_bar_is_missed() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let mut r = Random(seed);
        let [span, a, b, c, d] = std::array::from_fn(|_| length(&mut r));
        let [q1, q2, s1, s2] = std::array::from_fn(|_| angle(&mut r));
        let (left, mut right) = (polar(a, q1), polar(b, q2));
        right[0] += span;
        let closed = dyad(left, right, c, d);
        if !is_clear(&closed, left, right, c, d) {
            continue;
        }
        let lengths = [("span", span), ("a", a), ("b", b), ("c", c), ("d", d), ("q1", q1), ("q2", q2)];
        let starts = [("left.angle", q1), ("right.angle", q2), ("l2.angle", s1), ("r2.angle", s2)];
        let m = given(FiveBar::new(), &lengths, &starts).with_start("right.x", span);
        let start = [0.0, 0.0, q1, span, 0.0, q2, 0.0, 0.0, s1, 0.0, 0.0, s2];
        let poses = closed.map(|both| {
            both.map(|[c, d]| vec![0.0, 0.0, q1, span, 0.0, q2, left[0], left[1], c, right[0], right[1], d])
                .to_vec()
        });
        judge(&mut tally, &poses, &assembled(&m, start.len()), (&start, &format!("five-bar {seed}")));
    }
    end(&tally, "five-bar");
}

#[test]
fn no_pose_of_a_four_bar_is_missed() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let mut r = Random(seed);
        let [span, a, b, c] = std::array::from_fn(|_| length(&mut r));
        let [q, s1, s2] = std::array::from_fn(|_| angle(&mut r));
        let (pin, foot) = (polar(a, q), [span, 0.0]);
        let closed = dyad(pin, foot, b, c);
        if !is_clear(&closed, pin, foot, b, c) {
            continue;
        }
        let lengths = [("span", span), ("a", a), ("b", b), ("c", c), ("q", q)];
        let starts = [("crank.angle", q), ("coupler.angle", s1), ("rocker.angle", s2), ("rocker.x", span)];
        let m = given(FourBar::new(), &lengths, &starts);
        let start = [0.0, 0.0, q, 0.0, 0.0, s1, span, 0.0, s2];
        let poses =
            closed.map(|both| both.map(|[b, c]| vec![0.0, 0.0, q, pin[0], pin[1], b, span, 0.0, c]).to_vec());
        judge(&mut tally, &poses, &assembled(&m, start.len()), (&start, &format!("four-bar {seed}")));
    }
    end(&tally, "four-bar");
}

#[test]
fn no_pose_of_a_slider_crank_is_missed() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let mut r = Random(seed);
        let [a, b] = std::array::from_fn(|_| length(&mut r));
        let offset = length(&mut r) * r.unit().signum();
        let [q, s1] = std::array::from_fn(|_| angle(&mut r));
        let x = r.unit();
        let lengths = [("offset", offset), ("a", a), ("b", b), ("q", q)];
        let starts = [("crank.angle", q), ("rod.angle", s1), ("piston.x", x), ("piston.y", offset)];
        let m = given(SliderCrank::new(), &lengths, &starts);
        let pin = polar(a, q);
        let (height, start) = (offset - pin[1], [0.0, 0.0, q, 0.0, 0.0, s1, x, offset, 0.0]);
        if (height.abs() - b).abs() < 1e-6 {
            continue;
        }
        let poses = if height.abs() > b {
            Err(height.abs() - b)
        } else {
            let tilt = (height / b).asin();
            let pose = |rod: f64| vec![0.0, 0.0, q, pin[0], pin[1], rod, pin[0] + b * rod.cos(), offset, 0.0];
            Ok([tilt, std::f64::consts::PI - tilt].map(pose).to_vec())
        };
        judge(&mut tally, &poses, &assembled(&m, start.len()), (&start, &format!("slider-crank {seed}")));
    }
    // Newton's steps close a single slider from everywhere.
    println!("{tally:?}");
    assert!(tally.reachable > 10 && tally.beyond > 10, "{tally:?}");
    assert_eq!((tally.missed, tally.farther, tally.untrue), (0, 0, 0), "{tally:?}");
}

#[test]
fn no_pose_of_a_six_bar_is_missed() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let mut r = Random(seed);
        let [span, a, b, c, u, v, gx, gy, d, e] = std::array::from_fn(|_| length(&mut r));
        let [q, s1, s2, s3, s4] = std::array::from_fn(|_| angle(&mut r));
        let (v, gy) = (v - 0.5, -gy);
        let (pin, foot) = (polar(a, q), [span, 0.0]);
        let first = dyad(pin, foot, b, c);
        if !is_clear(&first, pin, foot, b, c) {
            continue;
        }
        let (mut poses, mut clear) = (Vec::new(), true);
        for [coupler, rocker] in first.into_iter().flatten() {
            let (sin, cos) = coupler.sin_cos();
            let at = [pin[0] + cos * u - sin * v, pin[1] + sin * u + cos * v];
            let second = dyad(at, [gx, gy], d, e);
            clear &= is_clear(&second, at, [gx, gy], d, e);
            for [link, arm] in second.into_iter().flatten() {
                let crank = [0.0, 0.0, q, pin[0], pin[1], coupler, span, 0.0, rocker];
                poses.push([&crank[..], &[at[0], at[1], link, gx, gy, arm]].concat());
            }
        }
        if !clear {
            continue;
        }
        let bars = [("span", span), ("a", a), ("b", b), ("c", c), ("q", q)];
        let dyad = [("u", u), ("v", v), ("gx", gx), ("gy", gy), ("d", d), ("e", e)];
        let m =
            given(SixBar::new(), &bars, &[("crank.angle", q), ("coupler.angle", s1), ("rocker.angle", s2)]);
        let m = given(m, &dyad, &[("link.angle", s3), ("arm.angle", s4)]);
        let start = [0.0, 0.0, q, 0.0, 0.0, s1, 0.0, 0.0, s2, 0.0, 0.0, s3, 0.0, 0.0, s4];
        let poses = if poses.is_empty() { Err(f64::NAN) } else { Ok(poses) };
        judge(&mut tally, &poses, &assembled(&m, start.len()), (&start, &format!("six-bar {seed}")));
    }
    end(&tally, "six-bar");
}

//! Implicit methods on trees and in absolute coordinates: the linearised equations against the full matrix of derivatives, by dual numbers.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

use plm::runtime::held::Loops as _;
use plm::runtime::linalg::{Both, Complex, Dense, Derivatives};
use plm::runtime::{Linear, Rate, Vector};
use plm::{Dop853, Mechanism, Moment, RadauIia5, Ros34Pw2};

/// A chain that holds a bit of everything: revolutes with springs, a slide, a slot, welds, a body that hangs on nothing, a
/// spring from end to end, a drag by the place and velocity of a body, a pivot that moves, first-order states.
mod zoo {
    plm::mechanism! {
        pub Zoo {
            gravity: 9.81 m/s^2;
            param stiffness: N/m = 40 N/m;
            input push: N = 2 N;
            ground { port o: (0.1 m*sin(3 rad/s*t), 0.05 m*cos(2 rad/s*t)); port rail: (0.3, 1) m, angle: 20 deg; }
            repeat i in 0..9 {
                body bar[i] {
                    mass: 0.3 kg + i*0.1 kg; inertia: 0.01 kg*m^2;
                    port a: (-0.2, 0.01) m; port b: (0.15, 0.02) m;
                    start angle: 20 deg + i*25 deg, locked; start omega: 1 rad/s - i*0.7 rad/s, locked;
                }
            }
            body shoe { mass: 0.5 kg; inertia: 0.02 kg*m^2; port in: (0.05, 0) m, angle: 30 deg; port out: (0, 0.1) m, angle: -35 deg; }
            body tip { mass: 0.2 kg; inertia: 0.01 kg*m^2; port in: (0.1, 0) m; port seam: (0, 0.1) m, angle: 40 deg; start angle: 1 rad, locked; start omega: 2 rad/s, locked; }
            body cap { mass: 0.1 kg; inertia: 0.001 kg*m^2; port seam: (0.02, 0.03) m, angle: 10 deg; }
            body block { mass: 1 kg; inertia: 0.01 kg*m^2; port rail: (0, 0) m; port pin: (0, -0.05) m; }
            body load { mass: 0.4 kg; inertia: 0.01 kg*m^2; port pin: (0.1, 0.1) m; start angle: 2 rad, locked; }
            body bird { mass: 0.3 kg; inertia: 0.01 kg*m^2; port hook: (0.05, 0.02) m; start x: 2 m, locked; start vy: 1 m/s, locked; start omega: 3 rad/s, locked; }
            revolute pin[0](ground.o, bar[0].a) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; }
            repeat i in 1..9 { revolute pin[i](bar[i].a, bar[i-1].b) { stiffness: 2 N*m/rad; damping: 0.05 N*m*s/rad; } }
            prismatic sleeve(bar[4].b, shoe.in) { stiffness: 200 N/m; damping: 3 N*s/m; }
            pin_slot slot(shoe.out, tip.in) { stiffness: 150 N/m; }
            weld seam(tip.seam, cap.seam);
            prismatic rail(block.rail, ground.rail) { stiffness: stiffness; drive: filtered; }
            revolute bell(load.pin, block.pin);
            spring leash(bar[8].b, bird.hook) { stiffness: 50 N/m; damping: 0.4 N*s/m; free_length: 0.4 m; }
            force drag(cap.seam) { x: -0.3 N*s/m*cap.vx - 2 N/m*cap.y; y: -0.1 N*s^2/m^2*cap.vy*abs(cap.vy); }
            state filtered: N = 3 N;
            rate filtered = (push - filtered + 1 N/m*tip.x)/0.2 s;
        }
    }
}

/// Loops with a slide, a spring across, a drive by the time and a first-order state, in absolute coordinates.
mod mill {
    plm::mechanism! {
        pub Mill {
            gravity: 9.81 m/s^2;
            formulation: absolute;
            ground { port o: (0, 0) m; port p: (1.5 m, 0.02 m*sin(5 rad/s*t)); port rail: (2, 0.4) m, angle: 10 deg; }
            body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.2, 0) m; port b: (0.2, 0) m; start angle: 60 deg, locked; start omega: 4 rad/s, locked; }
            body rod { mass: 2 kg; inertia: 0.2 kg*m^2; port a: (-0.6, 0) m; port b: (0.6, 0) m; port c: (0.1, 0.3) m; }
            body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port a: (-0.4, 0) m; port b: (0.4, 0) m; start angle: 95 deg; }
            body link { mass: 0.5 kg; inertia: 0.03 kg*m^2; port a: (-0.4, 0) m; port b: (0.4, 0) m; }
            body slide { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; }
            revolute r1(ground.o, crank.a) { drive: filtered; }
            revolute r2(crank.b, rod.a);
            revolute r3(rod.b, rocker.b) { damping: 0.2 N*m*s/rad; }
            revolute r4(ground.p, rocker.a) { stiffness: 3 N*m/rad; }
            revolute r5(rod.c, link.a);
            revolute r6(link.b, slide.a);
            prismatic rail(slide.a, ground.rail) { stiffness: 200 N/m; damping: 5 N*s/m; }
            spring across(crank.b, rocker.b) { stiffness: 80 N/m; damping: 1 N*s/m; free_length: 0.5 m; }
            state filtered: N*m = 1 N*m;
            rate filtered = (2 N*m - filtered - 0.1 N*m*s*crank.omega)/0.3 s;
        }
    }
}

/// A loop with a chain of lags, whose matrix of derivatives is emitted entry by entry.
mod loom {
    plm::mechanism! {
        pub Loom {
                gravity: 9.81 m/s^2;
                ground { port o: (0, 0) m; port p: (0.8, 0) m; }
                body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 40 deg, locked; start omega: 5 rad/s, locked; }
                body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (-0.2, 0) m; port c: (0.2, 0) m; }
                body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.45, 0) m; port p: (-0.45, 0) m; start angle: 120 deg; }
                revolute o(ground.o, crank.a) { drive: s3; }
                revolute b(crank.b, coupler.b);
                revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
                revolute p(ground.p, rocker.p) { stiffness: 2 N*m/rad; }
                state s1: N*m = 0.5 N*m; rate s1 = (1 N*m*cos(3 rad/s*t) - s1)/0.01 s;
                state s2: N*m = 0.5 N*m; rate s2 = (s1 - s2)/0.01 s;
                state s3: N*m = 0.5 N*m; rate s3 = (s2 - s3 - 0.1 N*m*s/rad*rocker.omega)/0.01 s;
        }
    }
}

/// A chain of so many bars, with springs and dampers in its hinges.
macro_rules! chain {
    ($module:ident, $bars:tt) => {
        mod $module {
            plm::mechanism! {
                pub Chain {
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    repeat i in 0..$bars {
                        body bar[i] {
                            mass: 1 kg / $bars; inertia: 1 kg*m^2 / (12 * $bars^3);
                            port a: (-0.5 / $bars, 0) m; port b: (0.5 / $bars, 0) m;
                            start x: (i + 0.5) / $bars * 1 m;
                        }
                    }
                    revolute pin[0](ground.o, bar[0].a) { damping: 1e-3 N*m*s/rad; }
                    repeat i in 1..$bars {
                        revolute pin[i](bar[i-1].b, bar[i].a) { stiffness: 0.1 N*m/rad; damping: 1e-3 N*m*s/rad; }
                    }
                }
            }
        }
    };
}
chain!(chain4, 4);
chain!(chain16, 16);
chain!(chain32, 32);

/// An arm on a hydraulic jack with a servo-valve: first-order states, stops, roots.
#[allow(
    unused_qualifications,
    reason = "emitted code qualifies where a name of the user's could stand in the way"
)]
#[path = "snapshots/arm_on_jack.rs"]
mod arm_on_jack;

/// Are a real and a complex system solved side by side as each by itself, to the bit?
fn both<X: Dense<f64>, D: Derivatives<f64, X>>(
    derivatives: &D,
    (r, lambda): (impl Fn(usize) -> Complex<f64>, Complex<f64>),
    nq: usize,
) -> bool {
    let [real, complex] = [25.0, 1.0].map(|factor| Complex { re: factor * lambda.re, im: lambda.im });
    let (real, complex) =
        (derivatives.resolvent(real.re, nq).unwrap(), derivatives.resolvent(complex, nq).unwrap());
    let (mut alone, mut beside) = ([vec![], vec![]], [vec![], vec![]]);
    derivatives.resolve(&real, nq, |i| r(i).im, |_, k| alone[0].push(Complex { re: k, im: 0.0 }));
    derivatives.resolve(&complex, nq, &r, |_, k| alone[1].push(k));
    let of_both = |i| Both { real: r(i).im, complex: r(i) };
    derivatives.resolve_both((&real, &complex), nq, of_both, |_, k| {
        beside[0].push(Complex { re: k.real, im: 0.0 });
        beside[1].push(k.complex);
    });
    alone == beside && alone.iter().all(|found| found.len() == X::LEN)
}

/// The largest difference of (lambda I - J)^-1 r between the full matrix and the augmented system, over the largest k. On a
/// tree there is no full matrix beside the system.
fn difference<M>(mechanism: M, time: f64, lambda: Complex<f64>, is_tree: bool) -> f64
where
    M: Mechanism<S = f64, X: Dense<f64, Matrix: Derivatives<f64, <M as Rate>::X>>> + Linear,
{
    let mut sim = mechanism.start().unwrap();
    sim.step(time).unwrap();
    let state = sim.state();
    let (t, held, x) = (state.time(), state.held(), *state.x());
    let (mut full, mut sparse) = (M::X::zeros(), M::Derivatives::zeros());
    assert_eq!(sparse.full().is_none(), is_tree, "the linearised equations of a tree are sparse");
    assert!(mechanism.jacobian(t, &held, &x, &mut full, None).is_good());
    assert!(mechanism.differentiate(t, &held, &x, &mut sparse, None).is_good());
    let holds_matrix = size_of_val(&sparse) > size_of_val(&full);
    assert_ne!(
        holds_matrix, is_tree,
        "the equations of absolute coordinates are linearised beside the matrix"
    );
    let r = |i: usize| Complex { re: f64::from(i as u32 % 7) - 2.5, im: f64::from(i as u32 % 5) - 1.5 };
    let mut found = [vec![], vec![]];
    let resolvent = full.resolvent(lambda, M::NQ).unwrap();
    full.resolve(&resolvent, M::NQ, r, |i, k| found[0].push((i, k)));
    let resolvent = sparse.resolvent(lambda, M::NQ).unwrap();
    sparse.resolve(&resolvent, M::NQ, r, |i, k| found[1].push((i, k)));
    assert_eq!(found[0].len(), M::X::LEN);
    for side_by_side in [both(&full, (r, lambda), M::NQ), both(&sparse, (r, lambda), M::NQ)] {
        assert!(side_by_side, "two systems solved side by side are as each by itself");
    }
    let size = found[0].iter().fold(0.0_f64, |size, (_, k)| size.max(k.re.hypot(k.im)));
    let gaps = found[0].iter().zip(&found[1]).map(|((i, a), (j, b))| {
        assert_eq!(i, j);
        (a.re - b.re).hypot(a.im - b.im)
    });
    gaps.fold(0.0, f64::max) / size
}

#[test]
fn the_linearised_equations_solve_what_the_full_matrix_does() {
    for lambda in [
        Complex { re: 1e4, im: 0.0 },
        Complex { re: 300.0, im: 350.0 },
        Complex { re: 30.0, im: -20.0 },
        Complex { re: 4.0, im: 3.0 },
    ] {
        let found = [
            difference(zoo::Zoo::new(), 0.1, lambda, true),
            difference(mill::Mill::new(), 0.1, lambda, false),
            difference(arm_on_jack::ArmOnJack::new(), 0.01, lambda, true),
            difference(chain4::Chain::new(), 0.3, lambda, true),
            difference(chain16::Chain::new(), 0.3, lambda, true),
            difference(chain32::Chain::new(), 0.3, lambda, true),
        ];
        assert!(found.iter().all(|gap| *gap < 1e-10), "{lambda:?}: {found:?}");
    }
}

/// Entry by entry as by dual numbers, in every chart.
#[test]
fn the_matrix_of_a_loop_is_that_of_dual_numbers() {
    let mut sim = loom::Loom::new().start().unwrap();
    let mut charts = [false; 3];
    for _ in 0..200 {
        sim.step(0.02).unwrap();
        let (mechanism, held, t, x) = (sim.mechanism, sim.state().held(), sim.time(), *sim.state().x());
        charts[held.of_loops.chart().unwrap()] = true;
        let mut by_x = [[0.0; 5]; 5];
        let mut by_t = [0.0; 5];
        assert!(mechanism.jacobian(t, &held, &x, &mut by_x, Some(&mut by_t)).is_good());
        for j in 0..=5 {
            let along: [f64; 5] = std::array::from_fn(|k| f64::from(u8::from(k == j)));
            let (mut column, by) = ([0.0; 5], f64::from(u8::from(j == 5)));
            assert!(mechanism.jvp(t, &held, &x, (by, &along), &mut column).is_good());
            for i in 0..5 {
                let entry = if j == 5 { by_t[i] } else { by_x[i][j] };
                let gap = (entry - column[i]).abs() / column[i].abs().max(1.0);
                assert!(gap < 1e-11, "t = {t}, {i} by {j}: {entry} and {}", column[i]);
            }
        }
    }
    assert!(charts.iter().filter(|seen| **seen).count() > 1, "{charts:?}");
}

#[test]
fn implicit_methods_carry_loops_in_absolute_coordinates() {
    let run = |mut known: plm::Sim<mill::Mill, RadauIia5<mill::Mill>>| {
        known.step(1.0).unwrap();
        (known.stats(), *known.state().x())
    };
    let mut known = mill::Mill::new().start_with(Dop853::new(1e-12)).unwrap();
    known.step(1.0).unwrap();
    let (stats, x) = run(mill::Mill::new().start_with(RadauIia5::new(1e-9)).unwrap());
    let off = known.state().x().iter().zip(&x).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    assert!(off < 1e-6, "{off:e}");
    assert!(stats.rejected < 20 && stats.evaluations < 9 * stats.steps, "{stats:?}");
}

#[test]
fn implicit_methods_carry_a_large_tree() {
    // With everything in it: the time too.
    let mut known = zoo::Zoo::new().start_with(Dop853::new(1e-12)).unwrap();
    known.step(0.5).unwrap();
    let mut radau = zoo::Zoo::new().start_with(RadauIia5::new(1e-9)).unwrap();
    radau.step(0.5).unwrap();
    let off = |x: &[f64]| known.state().x().iter().zip(x).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
    assert!(off(radau.state().x()) < 1e-6, "{:e}", off(radau.state().x()));
    // Derivatives that were wrong would cost iterations: a step of two takes 7 rates.
    let stats = radau.stats();
    assert!(stats.rejected < 10 && stats.evaluations < 9 * stats.steps, "{stats:?}");
    // Order 3, whatever the derivatives are: a W-method does not hang on them.
    let [coarse, fine] = [400, 800].map(|steps| {
        let mut sim = zoo::Zoo::new().start_with(Ros34Pw2::new(0.5 / f64::from(steps))).unwrap();
        sim.step(0.5).unwrap();
        off(sim.state().x())
    });
    assert!((6.5..10.0).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
}

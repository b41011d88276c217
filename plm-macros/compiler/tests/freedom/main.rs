//! What is chosen at compile time holds. Every formulation has as many freedoms as the mechanism: its coordinates less the rank of its constraints, which is
//! worked out here once more, from the residuals' rates alone. And it
//! accelerates as the absolute coordinates do.
//!
//! Random mechanisms with redundant rows of all kinds. `PLM_SWEEP=10000 PLM_SEED=7 cargo test -p plm-compiler --test freedom`
//! tries more of them, or others.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod charts;
mod free_bodies;
mod massless;
mod motion;
mod poses;
mod reasons;
mod scene;

use plm_compiler::token::Sources;
use plm_compiler::{Oracle, compile};
use scene::{Random, Scene};

/// Rows below this size, after elimination, depend on those before.
const DEPENDENT: f64 = 1e-10;
/// Rows between these are neither: the pose is next to a singular one.
const INDEPENDENT: f64 = 1e-5;

/// The rank of a matrix and a vector that its rows let pass, or nothing if the rank cannot be told.
fn rank(mut rows: Vec<Vec<f64>>, mut through: Vec<f64>) -> Option<(usize, Vec<f64>)> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut rank = 0;
    loop {
        let sizes = rows.iter().map(|row| dot(row, row).sqrt()).enumerate();
        let Some((at, size)) = sizes.max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
        if size <= DEPENDENT {
            break;
        }
        if size < INDEPENDENT {
            return None;
        }
        rank += 1;
        let pivot: Vec<f64> = rows.swap_remove(at).iter().map(|entry| entry / size).collect();
        // Twice is enough (W. Kahan, in B. N. Parlett, The Symmetric Eigenvalue Problem, section 6.9).
        for row in rows.iter_mut().chain([&mut through]) {
            for _ in 0..2 {
                let along = dot(row, &pivot);
                row.iter_mut().zip(&pivot).for_each(|(entry, p)| *entry -= along * p);
            }
        }
    }
    Some((rank, through))
}

/// Jacobian of the constraints at a pose: the rates of the residuals are affine in the velocities.
fn jacobian(oracle: &Oracle, q: &[f64]) -> Vec<Vec<f64>> {
    let rates = |moving: Option<usize>| {
        let mut x = [q, &vec![0.0; q.len()]].concat();
        if let Some(k) = moving {
            x[q.len() + k] = 1.0;
        }
        oracle.phi_dot(0.0, &x)
    };
    let still = rates(None);
    let columns: Vec<Vec<f64>> = (0..q.len()).map(|k| rates(Some(k))).collect();
    (0..still.len()).map(|row| columns.iter().map(|column| column[row] - still[row]).collect()).collect()
}

/// What the sweep saw.
#[derive(Debug, Default)]
struct Seen {
    /// Joint coordinates, with as many rows as rank.
    plain: usize,
    /// Joint coordinates although rows are redundant.
    redundant: usize,
    /// Absolute coordinates because rows are redundant.
    absolute: usize,
    /// Other reasons for absolute coordinates.
    other: usize,
    /// Next to a singular pose.
    undecided: usize,
}

fn judge(scene: &Scene, random: &mut Random, seen: &mut Seen) -> Result<(), String> {
    let mut sources = Sources::new();
    sources.add_text("declaration", &scene.text());
    let expansion = compile(&mut sources);
    let Some(oracle) = &expansion.oracle else {
        let messages = expansion.diagnostics.sorted().iter().map(|d| d.render(&sources)).collect::<String>();
        return Err(format!("does not compile: {messages}"));
    };
    let q = scene.poses();
    let jacobian = jacobian(oracle, &q);
    let rows = jacobian.len();
    let gap = oracle.phi(0.0, &[&q[..], &vec![0.0; q.len()]].concat());
    assert!(gap.iter().all(|gap| gap.abs() < 1e-12), "the scene is open by {gap:?}");
    let anywhere = q.iter().map(|_| random.unit()).collect();
    let Some((rank, v)) = rank(jacobian, anywhere) else {
        seen.undecided += 1;
        return Ok(());
    };
    let expected = q.len() - rank;
    let Some(states) = oracle.reduced_states() else {
        *(if rank < rows { &mut seen.absolute } else { &mut seen.other }) += 1;
        return Ok(());
    };
    *(if rank < rows { &mut seen.redundant } else { &mut seen.plain }) += 1;
    if states != 2 * expected {
        return Err(format!("{} coordinates, but {expected} degrees of freedom", states / 2));
    }
    let x = [q, v].concat();
    let charts = oracle.charts(0.0, &x);
    // One that is flat here has others.
    let best = charts.into_iter().max_by(|a, b| a.measure.total_cmp(&b.measure)).unwrap();
    let apart = best.pose.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let finite = best.acceleration.iter().chain(&best.pose).all(|value| value.is_finite());
    if best.measure < 1e-6 {
        return Err(format!("no chart determines it: the best measures {}", best.measure));
    }
    if !finite || apart > 1e-9 / best.measure {
        return Err(format!("at measure {} the pose comes back {apart} away: {best:?}", best.measure));
    }
    Ok(())
}

#[test]
fn every_formulation_has_the_freedoms_of_the_mechanism() {
    let number = |name: &str, default: u64| {
        std::env::var(name).map_or(default, |text| text.parse().unwrap_or_else(|_| panic!("{name}={text}")))
    };
    let (count, seed) = (number("PLM_SWEEP", 100), number("PLM_SEED", 1));
    println!("{count} mechanisms from seed {seed}");
    let mut seen = Seen::default();
    let mut complaints = Vec::new();
    for k in 0..count {
        let mut random = Random(seed.wrapping_mul(1 << 32).wrapping_add(k));
        let scene = Scene::new(&mut random);
        if let Err(complaint) = judge(&scene, &mut random, &mut seen) {
            complaints.push(format!("mechanism {k} of seed {seed}: {complaint}\n{}", scene.text()));
        }
    }
    println!("{seen:?}");
    let shown: Vec<String> = complaints.iter().take(3).cloned().collect();
    assert!(complaints.is_empty(), "{} of {count}:\n{}", complaints.len(), shown.join("\n"));
    // The sweep means something only if it meets all kinds.
    let each = [seen.plain, seen.redundant, seen.absolute];
    assert!(count < 100 || each.iter().all(|&of| of > 0), "{seen:?}");
    assert!(10 * seen.undecided <= count as usize, "{seen:?}");
}

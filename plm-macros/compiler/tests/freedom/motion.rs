//! Joint coordinates of trees, loops in closed form and loops by iteration: the accelerations that absolute coordinates have.

use plm_compiler::token::Sources;
use plm_compiler::{InChart, Oracle, compile};

use crate::scene::{Random, Scene};
use crate::{jacobian, rank};

/// Charts below this are left for better ones.
const POOR: f64 = 0.05;
/// Half the distance of the states that a difference quotient is taken from, s. What it leaves out is `h^2/6` of a third derivative,
/// of some 100 rad/s^4 here; rounding is divided by it.
const H: f64 = 1e-5;

/// Does a chart accelerate as the absolute coordinates do? By the change of its rates along the parabola of these.
fn accelerates(oracle: &Oracle, x: &[f64], at: usize, chart: &InChart) -> Result<(), String> {
    let (q, v) = x.split_at(x.len() / 2);
    let dynamics = oracle.dynamics(0.0, x);
    let a = &dynamics[q.len()..x.len()];
    let rates = |h: f64| {
        let place = (0..q.len()).map(|k| q[k] + h * (v[k] + 0.5 * h * a[k]));
        let moved: Vec<f64> = place.chain((0..q.len()).map(|k| v[k] + h * a[k])).collect();
        oracle.charts(0.0, &moved).swap_remove(at).state.split_off(chart.acceleration.len())
    };
    let (after, before) = (rates(H), rates(-H));
    for (k, found) in chart.acceleration.iter().enumerate() {
        let wanted = (after[k] - before[k]) / (2.0 * H);
        // False for what is not a number.
        let agrees = (found - wanted).abs() < 1e-8 * (1.0 + wanted.abs());
        if !agrees {
            return Err(format!("coordinate {k} has {found}, not {wanted}; {chart:?}"));
        }
    }
    Ok(())
}

/// Down, along an axis, and anywhere.
const GRAVITY: [&str; 3] = ["9.81 m/s^2", "(-7, 0) m/s^2", "(3, -5) m/s^2"];

/// What was compared.
#[derive(Debug, Default)]
struct Compared {
    trees: usize,
    loops: usize,
    /// Mechanisms whose equations are set up body by body.
    body_by_body: usize,
    /// Rows are redundant, or nearly so: absolute coordinates have no solution by elimination.
    none: usize,
}

#[test]
fn every_chart_accelerates_as_the_absolute_coordinates() {
    let seed = 3;
    println!("seed {seed}");
    let mut compared = Compared::default();
    for k in 0..60 {
        let mut random = Random((seed << 32) + k);
        let scene = Scene::sprung(&mut random);
        let text = scene.text().replace(GRAVITY[0], GRAVITY[k as usize % GRAVITY.len()]);
        let mut sources = Sources::new();
        sources.add_text("declaration", &text);
        let expansion = compile(&mut sources);
        let report = expansion.report.map(|report| report.to_string()).unwrap_or_default();
        compared.body_by_body += usize::from(report.contains("partial velocities"));
        let oracle = expansion.oracle.unwrap_or_else(|| panic!("mechanism {k}:\n{text}"));
        let q = scene.poses();
        let jacobian = jacobian(&oracle, &q);
        let rows = jacobian.len();
        let anywhere = q.iter().map(|_| random.unit()).collect();
        let Some((_, v)) = rank(jacobian, anywhere).filter(|(rank, _)| *rank == rows) else {
            compared.none += 1;
            continue;
        };
        let x = [q, v].concat();
        for (at, chart) in oracle.charts(0.0, &x).iter().enumerate().filter(|(_, chart)| chart.measure > POOR)
        {
            *(if oracle.accelerations(0.0, &x).is_some() {
                &mut compared.trees
            } else {
                &mut compared.loops
            }) += 1;
            if let Err(complaint) = accelerates(&oracle, &x, at, chart) {
                panic!("mechanism {k} of seed {seed}, chart {at}: {complaint}\n{text}");
            }
        }
    }
    assert!(compared.trees >= 20 && compared.loops >= 50 && compared.body_by_body >= 5, "{compared:?}");
}

//! Fits of unknowns within bounds that hold at the first step, on the way and at the end.
//!
//! A motion that is linear in its unknowns has one least sum of squares within bounds, which is the least of those of all sets of bounds that
//! hold (2 or 3 choices for each unknown). Of closed forms that are not linear the sum around what was found says whether it is least there.

use plm_dynamic::Mechanism;
use plm_studies::optimise::{ByDop853, Experiment, Identification, Unknown};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// An unknown: its name, its kind, its guess and its bounds.
struct Sought {
    name: &'static str,
    is_start: bool,
    guess: f64,
    bounds: [f64; 2],
}

/// A machine, of which a closed form says the reading at a time.
struct Machine {
    family: &'static str,
    text: String,
    output: &'static str,
    sought: Vec<Sought>,
    /// The unknowns of the readings.
    truth: Vec<f64>,
    closed_form: fn(&[f64], f64) -> f64,
}

pub(crate) fn case(draw: &mut Draw) -> Case {
    let machine = match draw.below(4) {
        0 | 1 => throw(draw),
        2 => damped(draw),
        _ => bounce(draw),
    };
    let count = 3 + draw.below(6);
    let noise = draw.number(0.0, 0.1, &[0.0]);
    let times: Vec<f64> = (1..=count).map(|k| 0.25 * k as f64).collect();
    let readings: Vec<f64> = times
        .iter()
        .map(|t| (machine.closed_form)(&machine.truth, *t) + noise * draw.rounded(-1.0, 1.0))
        .collect();
    let verdict = match found(&machine, &times, &readings) {
        Ok(z) if machine.family == "linear" => linear(&machine, (&times, &readings), &z),
        Ok(z) => least_around(&machine, (&times, &readings), &z),
        Err(why) if machine.family == "linear" => Verdict::Wrong(why),
        Err(why) => Verdict::Stopped(why),
    };
    let sought =
        machine.sought.iter().map(|own| format!("{} from {} in {:?}", own.name, own.guess, own.bounds));
    let sought: Vec<String> = sought.collect();
    let text = format!("{}\n{}\n{times:?}\n{readings:?}", machine.text, sought.join("\n"));
    Case { family: machine.family.to_owned(), text, verdict }
}

/// Bounds and a guess beside a true value: half of them special.
fn sought(
    draw: &mut Draw,
    (name, is_start): (&'static str, bool),
    truth: f64,
    [low, high]: [f64; 2],
) -> Sought {
    let side = |draw: &mut Draw| {
        draw.number(low, high, &[truth, 0.0_f64.max(low).min(high), low, high, f64::INFINITY])
    };
    let (one, other) = (side(draw), side(draw));
    let least = if one.is_finite() { one.min(other) } else { f64::NEG_INFINITY };
    let most = if other.is_finite() { other.max(one) } else { f64::INFINITY };
    // What a machine cannot have is no guess: a bound that is open ends where its numbers end.
    let bounds = [least.max(low), if most.is_finite() { most.min(high) } else { f64::INFINITY }];
    let bounds = if bounds[0] <= bounds[1] { bounds } else { [bounds[1], bounds[0]] };
    let guess = draw.number(low, high, &[truth, bounds[0].max(low), bounds[1].min(high), 0.0_f64.max(low)]);
    Sought { name, is_start, guess, bounds }
}

/// A mass that a force pushes: place, speed and force are linear in the readings.
fn throw(draw: &mut Draw) -> Machine {
    let truth: Vec<f64> = (0..3).map(|_| draw.number(-2.0, 2.0, &[0.0, 1.0])).collect();
    let of = [("b.x", true), ("b.vx", true), ("push", false)];
    let mut all: Vec<Sought> =
        of.iter().zip(&truth).map(|(of, truth)| sought(draw, *of, *truth, [-3.0, 3.0])).collect();
    // A bound that is open is open on both sides of a linear motion.
    for own in &mut all {
        if draw.chance(0.3) {
            own.bounds[0] = f64::NEG_INFINITY;
        }
    }
    Machine {
        family: "linear",
        text: "pub Throw {
    param push: N = 0 N;
    ground { port o: (0, 0) m; }
    body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: 0 m/s, locked; }
    prismatic r(ground.o, b.o) { drive: push; }
    output b.x;
}"
        .to_owned(),
        output: "b.x",
        sought: all,
        truth,
        closed_form: |z, t| z[0] + z[1] * t + 0.5 * z[2] * t * t,
    }
}

/// A mass that a damper stops: `x = (1 - exp(-c t)) v / c`.
fn damped(draw: &mut Draw) -> Machine {
    let truth = vec![draw.number(0.0, 3.0, &[0.0, 1e-3]), draw.number(0.5, 2.0, &[1.0])];
    let own = [
        sought(draw, ("c", false), truth[0], [0.0, 5.0]),
        sought(draw, ("b.vx", true), truth[1], [0.1, 3.0]),
    ];
    Machine {
        family: "damper",
        text: "pub Damped {
    param c: N*s/m = 1 N*s/m;
    ground { port o: (0, 0) m; }
    body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: 1 m/s, locked; }
    prismatic r(ground.o, b.o) { damping: c; }
    output b.x;
}"
        .to_owned(),
        output: "b.x",
        sought: own.into(),
        truth,
        closed_form: |z, t| {
            let [c, v] = [z[0], z[1]];
            if (c * t).abs() < 1e-5 { v * t * (1.0 - 0.5 * c * t) } else { -v / c * (-c * t).exp_m1() }
        },
    }
}

/// A ball without gravity between two hits of a wall: `x = v t`, then `-e v` from the wall on.
fn bounce(draw: &mut Draw) -> Machine {
    let truth = vec![draw.number(0.0, 1.0, &[0.0, 0.5, 1.0])];
    let own = [sought(draw, ("e", false), truth[0], [0.0, 1.0])];
    Machine {
        family: "restitution",
        text: "pub Bounce {
    param e: 1 = 0.5;
    ground { port o: (0, 0) m; }
    body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: -2 m/s, locked; }
    prismatic r(ground.o, b.o);
    unilateral wall: b.x >= -1.1 m { restitution: e; }
    output b.x;
}"
        .to_owned(),
        output: "b.x",
        sought: own.into(),
        truth,
        closed_form: |z, t| if t <= 0.55 { -2.0 * t } else { -1.1 + 2.0 * z[0] * (t - 0.55) },
    }
}

fn found(machine: &Machine, times: &[f64], readings: &[f64]) -> Result<Vec<f64>, String> {
    let text = Mechanism::from_text(&machine.text).map_err(|error| error.to_string())?;
    let small = text.small().map_err(|error| error.to_string())?;
    let experiment = Experiment::new(times).measured(machine.output, "m", readings);
    let mut problem = Identification::new(small).experiment(experiment);
    for own in &machine.sought {
        let unknown = if own.is_start { Unknown::start(own.name) } else { Unknown::parameter(own.name) };
        problem = problem.find(unknown.from(own.guess).within(own.bounds[0], own.bounds[1]));
    }
    let fit = problem.run_by(ByDop853(1e-11)).map_err(|error| error.to_string())?;
    let _ = fit.to_string();
    Ok(fit.estimates.iter().map(|estimate| estimate.value).collect())
}

fn sum(machine: &Machine, (times, readings): (&[f64], &[f64]), z: &[f64]) -> f64 {
    times.iter().zip(readings).map(|(t, own)| ((machine.closed_form)(z, *t) - own).powi(2)).sum()
}

/// The least sum within the bounds is that of a set of unknowns at bounds with the others free.
fn linear(machine: &Machine, of: (&[f64], &[f64]), z: &[f64]) -> Verdict {
    let count = machine.sought.len();
    let mut best: Option<(f64, Vec<f64>)> = None;
    for set in 0..3_usize.pow(count as u32) {
        let side = |k: usize| set / 3_usize.pow(k as u32) % 3;
        let held: Vec<Option<f64>> = (0..count)
            .map(|k| [None, Some(0), Some(1)][side(k)].map(|end: usize| machine.sought[k].bounds[end]))
            .collect();
        if held.iter().flatten().any(|bound| bound.is_infinite()) {
            continue;
        }
        let Some(own) = free(of, &held) else { continue };
        let slack = 1e-9;
        let is_inside = own
            .iter()
            .zip(&machine.sought)
            .all(|(z, own)| *z >= own.bounds[0] - slack && *z <= own.bounds[1] + slack);
        let size = sum(machine, of, &own);
        if is_inside && best.as_ref().is_none_or(|(least, _)| size < *least) {
            best = Some((size, own));
        }
    }
    let Some((_, best)) = best else { return Verdict::Undecided("no set of bounds".to_owned()) };
    let error = z.iter().zip(&best).map(|(z, best)| (z - best).abs()).fold(0.0, f64::max) / 1e-6;
    if error <= 1.0 { Verdict::Right(error) } else { Verdict::Wrong(format!("{z:?}, expected {best:?}")) }
}

/// The free unknowns of a linear motion by normal equations; by elimination.
fn free((times, readings): (&[f64], &[f64]), held: &[Option<f64>]) -> Option<Vec<f64>> {
    let row = |t: f64| [1.0, t, 0.5 * t * t];
    let open: Vec<usize> = (0..held.len()).filter(|k| held[*k].is_none()).collect();
    let n = open.len();
    let mut matrix = vec![vec![0.0; n + 1]; n];
    for (t, own) in times.iter().zip(readings) {
        let row = row(*t);
        let rest = own
            - held.iter().enumerate().map(|(k, held)| held.map_or(0.0, |held| held * row[k])).sum::<f64>();
        for (i, a) in open.iter().enumerate() {
            for (k, b) in open.iter().enumerate() {
                matrix[i][k] += row[*a] * row[*b];
            }
            matrix[i][n] += row[*a] * rest;
        }
    }
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| matrix[*a][k].abs().total_cmp(&matrix[*b][k].abs()))?;
        matrix.swap(k, pivot);
        for i in (0..n).filter(|i| *i != k) {
            let factor = matrix[i][k] / matrix[k][k];
            for c in k..=n {
                matrix[i][c] -= factor * matrix[k][c];
            }
        }
    }
    let mut all: Vec<f64> = held.iter().map(|held| held.unwrap_or(0.0)).collect();
    for (k, a) in open.iter().enumerate() {
        all[*a] = matrix[k][n] / matrix[k][k];
    }
    Some(all)
}

/// Nothing near what was found, within the bounds, has a smaller sum.
fn least_around(machine: &Machine, of: (&[f64], &[f64]), z: &[f64]) -> Verdict {
    let own = sum(machine, of, z);
    let inside = |z: &[f64]| {
        z.iter()
            .zip(&machine.sought)
            .map(|(z, own)| z.max(own.bounds[0]).min(own.bounds[1]))
            .collect::<Vec<_>>()
    };
    if inside(z) != z {
        return Verdict::Wrong(format!("{z:?} is outside its bounds"));
    }
    let (mut worst, mut at) = (0.0_f64, z.to_vec());
    for step in [1e-1, 1e-2, 1e-3, 1e-4] {
        for set in 0..3_usize.pow(z.len() as u32) {
            let side = |k: usize| [0.0, step, -step][set / 3_usize.pow(k as u32) % 3];
            let near = inside(&z.iter().enumerate().map(|(k, z)| z + side(k)).collect::<Vec<_>>());
            let gain = own - sum(machine, of, &near);
            // Sums are known to rounding, and to what runs of a tolerance of 1e-11 add to them.
            let share = gain / (1e-9 * own + 1e-10 * own.sqrt() + 1e-18);
            if share > worst {
                (worst, at) = (share, near);
            }
        }
    }
    if worst <= 1.0 {
        Verdict::Right(worst)
    } else {
        Verdict::Wrong(format!("{z:?} has {own:e}, {at:?} less by {worst:.1} bounds"))
    }
}

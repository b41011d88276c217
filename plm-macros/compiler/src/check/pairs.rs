//! A joint says twice how it moves: by its rows, and by the pair that it states. Rung 5 follows the rows, the rungs above
//! walk through the pair, so both must say the same.
//!
//! The motion of the pair is put into the rows at poses without a pattern: all rows must vanish there, and their rank must
//! be what the pair takes away. Poses and parameters are in general position, so that a row which vanishes at all of them
//! vanishes identically (J. T. Schwartz, Fast probabilistic algorithms for verification of polynomial identities, J. ACM
//! 27, 1980).

use plm_cas::{Expr, Tape, algebra};

use super::random::Random;
use super::rank::{Row, rank};
use super::{defaults, run, value};
use crate::derive::Equations;
use crate::diag::{Code, Diagnostics};
use crate::model::{FrameRef, Model, Pair, Part, Port};

/// Poses that are tried; at the first the parameters have their defaults.
const POSES: usize = 4;
/// A residual of so many parts of what it is made from is rounding.
const ROUNDING: f64 = 1e-11;

/// Reports the joints whose rows are not those of their pair.
pub(crate) fn check_pairs(model: &Model, equations: &Equations, length: f64, diagnostics: &mut Diagnostics) {
    let defaults = defaults(model);
    for (index, part) in model.parts.iter().enumerate() {
        let (Some(pair), &[a, b]) = (part.pair, part.frames.as_slice()) else { continue };
        if a.body == b.body {
            continue;
        }
        let joint = Joint::new(model, equations, (index, pair, [a, b]), length);
        joint.check(part, &defaults, diagnostics);
    }
}

/// A joint that states its pair.
struct Joint<'a> {
    model: &'a Model,
    equations: &'a Equations,
    pair: Pair,
    frames: [FrameRef; 2],
    /// Its rows, by their places in the model.
    rows: Vec<usize>,
    /// Their residuals, then the entries of their gradients.
    tape: Tape,
    /// Size of the scene, m.
    length: f64,
}

/// The rows at a pose of the pair.
struct Found {
    residuals: Vec<f64>,
    /// What a residual may be by rounding.
    limits: Vec<f64>,
    rank: usize,
}

impl<'a> Joint<'a> {
    fn new(
        model: &'a Model,
        equations: &'a Equations,
        (part, pair, frames): (usize, Pair, [FrameRef; 2]),
        length: f64,
    ) -> Joint<'a> {
        let rows: Vec<usize> = (0..model.rows.len()).filter(|&row| model.rows[row].part == part).collect();
        let residuals = rows.iter().map(|&row| equations.phi[row]);
        let entries = rows.iter().flat_map(|&row| equations.phi_q[row].iter().map(|&(_, entry)| entry));
        let roots: Vec<Expr> = residuals.chain(entries).collect();
        Joint { model, equations, pair, frames, rows, tape: algebra::tape(&roots), length }
    }

    fn check(&self, part: &Part, defaults: &[(Expr, f64)], diagnostics: &mut Diagnostics) {
        let mut random = Random(0);
        let mut ranks = Vec::new();
        for pose in 0..POSES {
            let fixed = scattered(self.model, defaults, pose > 0, &mut random);
            let found = self.at(&fixed, &mut random);
            let wrong = (0..self.rows.len()).find(|&k| found.residuals[k].abs() > found.limits[k]);
            if let Some(row) = wrong {
                return self.report_row(part, self.rows[row], found.residuals[row], diagnostics);
            }
            // Where a row is not a number nothing can be said; the start is looked at by itself.
            if found.residuals.iter().all(|residual| residual.is_finite()) {
                ranks.push(found.rank);
            }
        }
        let expected = taken(self.pair);
        if ranks.iter().max().is_some_and(|&rank| rank < expected) {
            self.report_rank(part, ranks.into_iter().max().unwrap_or(0), diagnostics);
        }
    }

    /// The rows where the pair stands somewhere.
    fn at(&self, fixed: &[(Expr, f64)], random: &mut Random) -> Found {
        let mut values = fixed.to_vec();
        let q = self.pose(fixed, random);
        values.extend(q.iter().map(|&(column, value)| (self.equations.q[column], value)));
        let mut results = run(&self.tape, &values);
        let mut entries = results.split_off(self.rows.len()).into_iter();
        let gradients = self.rows.iter().map(|&row| {
            let columns = self.equations.phi_q[row].iter().map(|&(column, _)| column);
            columns.zip(entries.by_ref()).collect()
        });
        let gradients: Vec<Row> = gradients.collect();
        let size = |column: usize| {
            let own = q.iter().find(|(of, _)| *of == column).map_or(0.0, |found| found.1.abs());
            own.max(if column % 3 == 2 { 1.0 } else { self.length })
        };
        let limit = |row: &Row| ROUNDING * row.iter().map(|&(k, entry)| entry.abs() * size(k)).sum::<f64>();
        Found {
            limits: gradients.iter().map(limit).collect(),
            rank: rank(&gradients).value(),
            residuals: results,
        }
    }

    /// Poses of the bodies that the joint joins: one of them anywhere, the other where the pair lets it be.
    fn pose(&self, fixed: &[(Expr, f64)], random: &mut Random) -> Vec<(usize, f64)> {
        let [a, b] = self.frames;
        let turn = if matches!(self.pair, Pair::Revolute | Pair::PinSlot) { random.unit() } else { 0.0 };
        let slides = matches!(self.pair, Pair::Prismatic | Pair::PinSlot);
        let slide = if slides { self.length * random.unit() } else { 0.0 };
        // The ground stays where it is.
        let forward = b.body.is_some();
        let (held, free) = if forward { (a, b) } else { (b, a) };
        let mut q = Vec::new();
        let mut pose = [0.0; 3];
        if let Some(body) = held.body {
            pose = [self.length * random.unit(), self.length * random.unit(), 3.0 * random.unit()];
            q.extend(pose.into_iter().enumerate().map(|(k, value)| (3 * body + k, value)));
        }
        let (at, angle) = self.port(held, fixed);
        let [x, y] = carried(pose, at, 1.0);
        let heading = pose[2] + angle;
        let sign = if forward { 1.0 } else { -1.0 };
        let (sin, cos) = plm_math::f64::sin_cos(if forward { heading } else { heading - turn });
        let (x, y) = (x + sign * slide * cos, y + sign * slide * sin);
        let (back, own) = self.port(free, fixed);
        let theta = heading + sign * turn - own;
        let [x, y] = carried([x, y, theta], back, -1.0);
        if let Some(body) = free.body {
            q.extend([x, y, theta].into_iter().enumerate().map(|(k, value)| (3 * body + k, value)));
        }
        q
    }

    fn port(&self, frame: FrameRef, fixed: &[(Expr, f64)]) -> ([f64; 2], f64) {
        let Port { at, angle, .. } = match frame.body {
            Some(body) => &self.model.bodies[body].ports[frame.port],
            None => &self.model.ground[frame.port],
        };
        (at.components().map(|component| value(component, fixed)), value(*angle, fixed))
    }

    fn report_row(&self, part: &Part, row: usize, by: f64, diagnostics: &mut Diagnostics) {
        let row = &self.model.rows[row];
        let (pair, name) = (named(self.pair), row.name.rsplit('.').next().unwrap_or(&row.name));
        let message = format!("the constraint `{name}` does not hold where `pair: {pair}` moves the joint");
        let diagnostic = diagnostics.error(Code::PairDisagrees, row.declared.span, message);
        diagnostic.uses.clone_from(&row.declared.uses);
        let (size, unit) = (super::verdict::rounded(by.abs()), &row.unit.text);
        diagnostic.note(format!("at some pose of the pair it is {size} {unit} off: {}", says(self.pair)));
        if let Some(declared) = &part.declared {
            diagnostic.note_at(declared.span, "the pair is stated");
        }
        diagnostic.help(
            "leave `pair` out, so that the constraints alone say how it moves, or move the ports instead of the joint",
        );
    }

    fn report_rank(&self, part: &Part, rank: usize, diagnostics: &mut Diagnostics) {
        let Some(declared) = &part.declared else { return };
        let (pair, expected) = (named(self.pair), taken(self.pair));
        let message =
            format!("`pair: {pair}` takes away {expected} freedoms, the constraints of the joint {rank}");
        let diagnostic = diagnostics.error(Code::PairDisagrees, declared.span, message);
        diagnostic.uses.clone_from(&declared.uses);
        diagnostic.note(format!("the pair says: {}", says(self.pair)));
        diagnostic.help("leave `pair` out, or write the constraints that are missing");
    }
}

/// Values of all symbols that stand still while the joint moves: as they are by default, or anywhere.
fn scattered(
    model: &Model,
    defaults: &[(Expr, f64)],
    anywhere: bool,
    random: &mut Random,
) -> Vec<(Expr, f64)> {
    let is_input = |symbol: Expr| model.inputs.iter().any(|input| input.symbol == symbol);
    let moved = |&(symbol, value): &(Expr, f64)| {
        let by = random.unit();
        let size = if value == 0.0 { 0.1 } else { 0.1 * value };
        (symbol, if anywhere && !is_input(symbol) { value + size * by } else { value })
    };
    defaults.iter().map(moved).collect()
}

/// A port at a pose of its body; with -1 the place of the body whose port is at a place.
fn carried([x, y, theta]: [f64; 3], [px, py]: [f64; 2], sign: f64) -> [f64; 2] {
    let (sin, cos) = plm_math::f64::sin_cos(theta);
    [x + sign * (cos * px - sin * py), y + sign * (sin * px + cos * py)]
}

/// How many freedoms it takes away.
fn taken(pair: Pair) -> usize {
    match pair {
        Pair::PinSlot => 1,
        Pair::Revolute | Pair::Prismatic => 2,
        Pair::Weld => 3,
    }
}

fn named(pair: Pair) -> &'static str {
    match pair {
        Pair::Revolute => "revolute",
        Pair::Prismatic => "prismatic",
        Pair::PinSlot => "pin_slot",
        Pair::Weld => "weld",
    }
}

fn says(pair: Pair) -> &'static str {
    match pair {
        Pair::Revolute => "the points of both frames coincide, and they turn freely",
        Pair::Prismatic => "the second frame slides along the x axis of the first, without turning",
        Pair::PinSlot => "the point of the second frame is on the x axis of the first, and it turns freely",
        Pair::Weld => "both frames are the same",
    }
}

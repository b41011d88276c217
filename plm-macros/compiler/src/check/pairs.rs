//! A joint says twice how it moves: by its rows, and by the pair that it states. Absolute coordinates follow the rows, joint
//! coordinates walk through the pair, so both must say the same.
//!
//! The motion of the pair is put into the rows at poses without a pattern: all rows must vanish there, and their rank must
//! be what the pair takes away. Poses and parameters are in general position, so that a row which vanishes at all of them
//! vanishes identically (J. T. Schwartz, Fast probabilistic algorithms for verification of polynomial identities, J. ACM
//! 27, 1980).

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::{Expr, Tape, algebra};

use crate::diag::{Code, Diagnostics};
use crate::model::{FrameRef, Pair, Part, Port};
use crate::numeric::{Random, Row, Scene, rank, run, value};

/// Poses that are tried; at the first the parameters have their defaults.
const POSES: usize = 4;
/// So many parts of what a row is made from are rounding.
const ROUNDING: f64 = 1e-11;

/// Reports the joints whose rows are not those of their pair.
pub(crate) fn check_pairs(scene: &Scene, diagnostics: &mut Diagnostics) {
    for index in 0..scene.model.parts.len() {
        if let Some(joint) = Joint::new(scene, index) {
            joint.check(diagnostics);
        }
    }
}

/// A joint that states its pair.
struct Joint<'a> {
    scene: &'a Scene<'a>,
    part: &'a Part,
    pair: Pair,
    frames: [FrameRef; 2],
    /// Its rows, by their places in the model.
    rows: Vec<usize>,
    /// Their `phi`, then the entries of their `phi_q`.
    tape: Tape,
}

/// The rows at a pose of the pair.
struct Found {
    phi: Vec<f64>,
    /// Bounds of the rounding error of each entry of `phi`.
    limits: Vec<f64>,
    rank: usize,
}

impl<'a> Joint<'a> {
    /// The joint that a part is, if it states its pair and joins two bodies.
    fn new(scene: &'a Scene<'a>, index: usize) -> Option<Joint<'a>> {
        let Scene { model, equations, .. } = scene;
        let part = &model.parts[index];
        let (Some(pair), &[a, b]) = (part.pair, part.frames.as_slice()) else { return None };
        if a.body == b.body {
            return None;
        }
        let rows: Vec<usize> =
            (0..model.rows.len()).filter(|&row| model.rows[row].part == index).collect_vec();
        let phi = rows.iter().map(|&row| equations.phi[row]);
        let entries = rows.iter().flat_map(|&row| equations.phi_q[row].iter().map(|&(_, entry)| entry));
        let tape = algebra::tape(&phi.chain(entries).collect_vec());
        Some(Joint { scene, part, pair, frames: [a, b], rows, tape })
    }

    fn check(&self, diagnostics: &mut Diagnostics) {
        let mut random = Random(0);
        let mut ranks = Vec::new();
        for pose in 0..POSES {
            let fixed = scattered(self.scene, pose > 0, &mut random);
            let found = self.at(&fixed, &mut random);
            let wrong = (0..self.rows.len()).find(|&k| found.phi[k].abs() > found.limits[k]);
            if let Some(row) = wrong {
                return self.report_row(self.rows[row], found.phi[row], diagnostics);
            }
            // Where a row is not a number nothing can be said; the start is looked at by itself.
            if found.phi.iter().all(|phi| phi.is_finite()) {
                ranks.push(found.rank);
            }
        }
        let expected = self.pair.rows();
        if ranks.iter().max().is_some_and(|&rank| rank < expected) {
            self.report_rank(ranks.into_iter().max().unwrap_or(0), diagnostics);
        }
    }

    /// The rows where the pair stands somewhere.
    fn at(&self, fixed: &[(Expr, f64)], random: &mut Random) -> Found {
        let mut values = fixed.to_vec();
        let q = self.pose(fixed, random);
        values.push_all(q.iter().map(|&(column, value)| (self.scene.equations.q[column], value)));
        let mut results = run(&self.tape, &values);
        let mut entries = results.split_off(self.rows.len()).into_iter();
        let phi_q = self.rows.iter().map(|&row| {
            let columns = self.scene.equations.phi_q[row].iter().map(|&(column, _)| column);
            columns.zip(entries.by_ref()).collect_vec()
        });
        let phi_q: Vec<Row> = phi_q.collect_vec();
        let size = |column: usize| {
            let own = q.iter().find(|(of, _)| *of == column).map_or(0.0, |found| found.1.abs());
            own.max(if column % 3 == 2 { 1.0 } else { self.scene.length })
        };
        let limit = |row: &Row| ROUNDING * row.iter().map(|&(k, entry)| entry.abs() * size(k)).sum::<f64>();
        Found { limits: phi_q.iter().map(limit).collect_vec(), rank: rank(&phi_q).value(), phi: results }
    }

    /// Poses of the bodies that the joint joins: one of them anywhere, the other where the pair lets it be.
    fn pose(&self, fixed: &[(Expr, f64)], random: &mut Random) -> Vec<(usize, f64)> {
        let [a, b] = self.frames;
        let turn = if self.pair.turns() { random.unit() } else { 0.0 };
        let length = self.scene.length;
        let displacement = if self.pair.slides() { length * random.unit() } else { 0.0 };
        // The ground stays where it is.
        let forward = b.body.is_some();
        let (held, free) = if forward { (a, b) } else { (b, a) };
        let mut q = Vec::new();
        let mut pose = [0.0; 3];
        if let Some(body) = held.body {
            pose = [length * random.unit(), length * random.unit(), 3.0 * random.unit()];
            q.push_all(pose.into_iter().enumerate().map(|(k, value)| (3 * body + k, value)));
        }
        let (at, angle) = self.port(held, fixed);
        let [x, y] = carried(pose, at, 1.0);
        let absolute = pose[2] + angle;
        let sign = if forward { 1.0 } else { -1.0 };
        let (sin, cos) = plm_math::f64::sin_cos(if forward { absolute } else { absolute - turn });
        let (x, y) = (x + sign * displacement * cos, y + sign * displacement * sin);
        let (back, own) = self.port(free, fixed);
        let theta = absolute + sign * turn - own;
        let [x, y] = carried([x, y, theta], back, -1.0);
        if let Some(body) = free.body {
            q.push_all([x, y, theta].into_iter().enumerate().map(|(k, value)| (3 * body + k, value)));
        }
        q
    }

    fn port(&self, frame: FrameRef, fixed: &[(Expr, f64)]) -> ([f64; 2], f64) {
        let Port { at, angle, .. } = match frame.body {
            Some(body) => &self.scene.model.bodies[body].ports[frame.port],
            None => &self.scene.model.ground[frame.port],
        };
        (at.components().map_each(|component| value(component, fixed)), value(*angle, fixed))
    }

    fn report_row(&self, row: usize, by: f64, diagnostics: &mut Diagnostics) {
        let row = &self.scene.model.rows[row];
        let (pair, says) = (self.pair.name(), self.pair.says());
        let name = row.name.rsplit('.').next().unwrap_or(&row.name);
        let message = format!("the constraint `{name}` does not hold where `pair: {pair}` moves the joint");
        let diagnostic = diagnostics.error(Code::PairDisagrees, row.declared.span, message);
        diagnostic.uses.clone_from(&row.declared.uses);
        let (size, unit) = (super::verdict::rounded(by.abs()), &row.unit.text);
        diagnostic.note(format!("at some pose of the pair it is {size} {unit} off: {says}"));
        if let Some(declared) = &self.part.declared {
            diagnostic.note_at(declared.span, "the pair is stated");
        }
        diagnostic.help(
            "leave `pair` out, so that the constraints alone say how it moves, or move the ports instead of the joint",
        );
    }

    fn report_rank(&self, rank: usize, diagnostics: &mut Diagnostics) {
        let Some(declared) = &self.part.declared else { return };
        let (pair, expected, says) = (self.pair.name(), self.pair.rows(), self.pair.says());
        let message =
            format!("`pair: {pair}` takes away {expected} freedoms, the constraints of the joint {rank}");
        let diagnostic = diagnostics.error(Code::PairDisagrees, declared.span, message);
        diagnostic.uses.clone_from(&declared.uses);
        diagnostic.note(format!("the pair says: {says}"));
        diagnostic.help("leave `pair` out, or write the constraints that are missing");
    }
}

/// Values of all symbols that stand still while the joint moves: as they are by default, or anywhere.
fn scattered(scene: &Scene, anywhere: bool, random: &mut Random) -> Vec<(Expr, f64)> {
    let is_input = |symbol: Expr| scene.model.inputs.iter().any(|input| input.symbol == symbol);
    let moved = |&(symbol, value): &(Expr, f64)| {
        let by = random.unit();
        let size = if value == 0.0 { 0.1 } else { 0.1 * value };
        (symbol, if anywhere && !is_input(symbol) { value + size * by } else { value })
    };
    scene.values.iter().map(moved).collect_vec()
}

/// A port at a pose of its body; with -1 the place of the body whose port is at a place.
fn carried([x, y, theta]: [f64; 3], [px, py]: [f64; 2], sign: f64) -> [f64; 2] {
    let (sin, cos) = plm_math::f64::sin_cos(theta);
    [x + sign * (cos * px - sin * py), y + sign * (sin * px + cos * py)]
}

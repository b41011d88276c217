//! Frictions that all slip: known forces, and sweeps where reactions of joints bound them.
//!
//! A row that slips has the force `f_i = -sigma_i L_i`. Its limit `L_i = own + share |R_i|` reads a reaction that is affine in the
//! accelerations of the coordinates and in the forces, and the accelerations are affine in the forces,
//!
//! ```text
//! (1)  R_i = r_i + sum P_ik a_k + sum G_ij f_j,    a_k = a_k0 + sum K_kj f_j
//! ```
//!
//! All that does not depend on the forces is computed once at a state. Then the forces are swept in the order of the rows, each by Newton's
//! step along itself, and the accelerations follow each,
//!
//! ```text
//! (2)  f_i <- f_i - (f_i + sigma_i L_i)/s_i,    s_i = 1 + sigma_i dL_i/df_i at f = 0
//! ```
//!
//! (J. M. Ortega, W. C. Rheinboldt, Iterative Solution of Nonlinear Equations in Several Variables, 1970, section 7.4). A reaction along a
//! line has a sign that is held; its row is linear, and (2) solves it for `f_i`.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use super::contact::Accelerated;
use super::function::{Function, Place};
use crate::derive::Equations;
use crate::model::{Contact, ContactLaw, Model};

/// Functions of rows that all slip.
pub(crate) struct Sliding {
    /// Symbols of `slip`: by row, -1 or 1, the sign of the slip; 0 for a row without a force.
    pub(crate) slip: Vec<Expr>,
    /// Symbols of `line`: by row, -1 or 1, the sign that is held of a reaction along a line.
    pub(crate) line: Vec<Expr>,
    /// Symbols of `force`: by row, the multipliers of frictions that reactions bound.
    pub(crate) force: Vec<Expr>,
    /// Symbols of `second`, the accelerations of the coordinates.
    pub(crate) second: Vec<Expr>,
    /// Symbols of `known`: what does not depend on those.
    pub(crate) known: Vec<Expr>,
    /// `dx` but for the accelerations, `free`, the accelerations without the forces that are swept, `known`, and `slope`, s of (2). It
    /// returns what the rate returns.
    pub(crate) motion: Function,
    /// `next` and `changed`, forces and accelerations behind a sweep (2).
    pub(crate) sweep: Function,
    /// One sweep finds the forces.
    pub(crate) is_explicit: bool,
    /// `sizes` of the reactions along a line, with the signs that are held.
    pub(crate) sizes: Function,
}

/// The functions of rows that all slip, where the rate is affine in the multipliers; nothing if pushes alone bound the frictions.
pub(super) fn functions(model: &Model, equations: &Equations, motion: &Accelerated) -> Option<Sliding> {
    let mut system = System::new(model, equations, motion);
    let is_bounded = |(contact, own): (&Contact, &Expr)| contact.reaction().is_some() || !own.is_zero();
    if !model.contacts.iter().zip(&system.own).any(is_bounded) {
        return None;
    }
    let mut results = system.rate(motion);
    let rows: Vec<Row> = (0..model.contacts.len()).filter_map(|row| system.row(row)).collect_vec();
    let sweep = system.sweep(&rows);
    let sizes = rows.iter().filter(|row| is_line(row));
    let sizes = sizes.map(|row| (Place::Element("sizes", row.number), system.size(&row.size))).collect_vec();
    results.push_all(rows.iter().map(|row| (Place::Element("slope", row.number), row.slope)));
    let known = system.values.iter().enumerate().map(|(k, &value)| (Place::Element("known", k), value));
    results.push_all(known);
    let is_explicit = matches!(&rows[..], []) || matches!(&rows[..], [one] if is_line(one));
    let System { slip, line, force, second, known, .. } = system;
    let [motion, sweep, sizes] =
        [results, sweep, sizes].map(|results| Function::of_results(results).optimise());
    Some(Sliding { slip, line, force, second, known, motion, sweep, is_explicit, sizes })
}

/// A friction that reactions bound.
struct Row {
    number: usize,
    /// Of (2).
    slope: Expr,
    /// `own`, and the share of the size.
    limit: [Expr; 2],
    size: Size,
}

/// Is it bounded along a line?
fn is_line(row: &Row) -> bool {
    row.size.components.len() == 1
}

/// The size of a reaction.
struct Size {
    /// One along a line, or two in the plane; of numbers that are known.
    components: Vec<Affine>,
    /// The sign along a line.
    sign: Expr,
}

impl Size {
    fn of(&self, components: &[Expr]) -> Expr {
        match *components {
            [along] => self.sign * along,
            _ => components.iter().map(|&component| component * component).sum::<Expr>().sqrt(),
        }
    }
}

/// An affine function (1).
#[derive(Clone)]
struct Affine {
    own: Expr,
    /// By coordinate.
    by_second: Vec<Expr>,
    /// By row.
    by: Vec<Expr>,
}

impl Affine {
    fn at(&self, second: &[Expr], force: &[Expr]) -> Expr {
        let by_second = self.by_second.iter().zip(second).map(|(&by, &second)| by * second);
        let by = self.by.iter().zip(force).map(|(&by, &force)| by * force);
        [self.own].into_iter().chain(by_second).chain(by).sum()
    }
}

/// Symbols and expressions of which the functions are made.
struct System<'a> {
    model: &'a Model,
    /// Values for the symbols of the model.
    substitution: Vec<(Expr, Expr)>,
    /// Multipliers of all rows.
    lambda: Vec<Expr>,
    /// Forces of rows that no reaction bounds.
    own: Vec<Expr>,
    slip: Vec<Expr>,
    line: Vec<Expr>,
    force: Vec<Expr>,
    second: Vec<Expr>,
    known: Vec<Expr>,
    values: Vec<Expr>,
    /// The accelerations of the coordinates, by forces alone; not among what is known.
    accelerations: Vec<Affine>,
}

impl<'a> System<'a> {
    fn new(model: &'a Model, equations: &Equations, motion: &Accelerated) -> System<'a> {
        let symbols = |name: &str| -> Vec<Expr> {
            model
                .contacts
                .iter()
                .map(|contact| Expr::symbol(format!("{name}_{}", contact.name)))
                .collect_vec()
        };
        let joints = equations.lambda.iter().copied().zip(motion.by_second.iter().copied());
        let mut system = System {
            model,
            substitution: joints.chain(motion.substitution.iter().copied()).collect_vec(),
            lambda: model.contacts.iter().map(|contact| contact.lambda).collect_vec(),
            own: vec![Expr::ZERO; model.contacts.len()],
            slip: symbols("slip"),
            line: symbols("line"),
            force: symbols("force"),
            second: motion.second.to_vec(),
            known: Vec::new(),
            values: Vec::new(),
            accelerations: Vec::new(),
        };
        for (row, contact) in model.contacts.iter().enumerate() {
            if contact.reaction().is_none() {
                let [own, _] = system.limit(row, contact);
                system.own[row] = -(system.slip[row] * own);
            }
        }
        system
    }

    /// A number that does not depend on forces.
    fn know(&mut self, value: Expr) -> Expr {
        if value.as_number().is_some() {
            return value;
        }
        if let Some(place) = self.values.iter().position(|&known| known == value) {
            return self.known[place];
        }
        let symbol = Expr::symbol(format!("known_{}", self.known.len()));
        self.values.push(value);
        self.known.push(symbol);
        symbol
    }

    /// The own part of the limit to the side against which a row slips, and its share of the reaction. Gaps do not push.
    fn limit(&self, row: usize, contact: &Contact) -> [Expr; 2] {
        let ContactLaw::Friction { kinetic, reaction, .. } = &contact.law else { return [Expr::ZERO; 2] };
        let kinetic = algebra::substitute(kinetic, &self.substitution);
        let [lower, upper] = self.without_forces(&kinetic)[..] else { return [Expr::ZERO; 2] };
        let limit = if lower == upper { lower } else { Expr::ZERO.less(self.slip[row]).select(lower, upper) };
        let Some(size) = reaction.as_ref().map(|reaction| reaction.size) else { return [limit, Expr::ZERO] };
        [algebra::substitute(&[limit], &[(size, Expr::ZERO)])[0], limit.diff(size)]
    }

    fn without_forces(&self, values: &[Expr]) -> Vec<Expr> {
        let none: Vec<(Expr, Expr)> = self.lambda.iter().map(|&lambda| (lambda, Expr::ZERO)).collect_vec();
        algebra::substitute(values, &none)
    }

    /// The parts of what is affine, with the forces that no reaction bounds in the own part.
    fn parts(&self, value: Expr) -> Affine {
        let by: Vec<Expr> = self.lambda.iter().map(|&lambda| value.diff(lambda)).collect_vec();
        let by_second: Vec<Expr> = self.second.iter().map(|&second| value.diff(second)).collect_vec();
        let still: Vec<(Expr, Expr)> = self.second.iter().map(|&second| (second, Expr::ZERO)).collect_vec();
        let none = algebra::substitute(&self.without_forces(&[value]), &still)[0];
        let own = by.iter().zip(&self.own).map(|(&factor, &own)| factor * own);
        let own = [none].into_iter().chain(own).sum();
        let is_bounded = |contact: &Contact| contact.reaction().is_some();
        let by = by.into_iter().zip(&self.model.contacts);
        let by = by.map(|(factor, row)| if is_bounded(row) { factor } else { Expr::ZERO }).collect_vec();
        Affine { own, by_second, by }
    }

    fn known(&mut self, Affine { own, by_second, by }: Affine) -> Affine {
        let mut each = |values: Vec<Expr>| values.into_iter().map(|value| self.know(value)).collect_vec();
        Affine { by_second: each(by_second), by: each(by), own: self.know(own) }
    }

    /// The rate without accelerations, and these without the forces that reactions bound.
    fn rate(&mut self, motion: &Accelerated) -> Vec<(Place, Expr)> {
        let n = motion.coordinates;
        let mut results = Vec::new();
        for (place, value) in motion.rate {
            match place {
                Place::Element("dx", k) if (n..2 * n).contains(k) => {
                    let parts = self.parts(*value);
                    results.push((Place::Element("free", k - n), parts.own));
                    self.accelerations.push(parts);
                }
                _ => results.push((place.clone(), self.without_forces(&[*value])[0])),
            }
        }
        results
    }

    /// A row that reactions bound.
    fn row(&mut self, row: usize) -> Option<Row> {
        let contact = &self.model.contacts[row];
        let components = algebra::substitute(&contact.reaction()?.components, &self.substitution);
        let parts = components.into_iter().map(|component| self.parts(component)).collect_vec();
        let (limit, sign) = (self.limit(row, contact), self.line[row]);
        // Where the swept forces are zero: the components, and their derivatives by the force of the row.
        let free = self.accelerations.iter().map(|second| second.own).collect_vec();
        let here: Vec<Expr> = parts.iter().map(|part| part.at(&free, &[])).collect_vec();
        let slopes = parts.iter().map(|part| {
            let through = part.by_second.iter().zip(&self.accelerations);
            through.map(|(&by, second)| by * second.by[row]).chain([part.by[row]]).sum::<Expr>()
        });
        let slopes = slopes.collect_vec();
        let components = parts.into_iter().map(|parts| self.known(parts)).collect_vec();
        let size = Size { components, sign };
        let of_size = match slopes[..] {
            [slope] => sign * slope,
            _ => algebra::dot(&here, &slopes) / size.of(&here),
        };
        let slope = Expr::ONE + self.slip[row] * limit[1] * of_size;
        let slope = slope.named(format!("slope_{}", contact.name));
        Some(Row { number: row, slope, limit, size })
    }

    /// The size of a reaction.
    fn size(&self, size: &Size) -> Expr {
        let components = size.components.iter().map(|component| component.at(&self.second, &self.force));
        size.of(&components.collect_vec())
    }

    /// Forces and accelerations behind (2).
    fn sweep(&mut self, rows: &[Row]) -> Vec<(Place, Expr)> {
        let (mut second, mut force) = (self.second.clone(), self.force.clone());
        let mut results = Vec::new();
        for row in rows {
            let (inverse, against) = (row.slope.recip(), self.slip[row.number]);
            let [own, share] = row.limit;
            let sign = if is_line(row) { row.size.sign } else { Expr::ONE };
            let [own, share] = [own, sign * share].map(|limit| self.know(-(against * limit * inverse)));
            let stays = self.know(Expr::ONE - inverse);
            let at =
                |component: &Affine| component.at(&second, &force).named(format!("component_{}", row.number));
            let components = row.size.components.iter().map(at).collect_vec();
            let size = if let [along] = components[..] { along } else { row.size.of(&components) };
            let next = own + stays * force[row.number] + share * size;
            let change = (next - force[row.number]).named(format!("change_{}", row.number));
            for (k, second) in second.iter_mut().enumerate() {
                let by = self.accelerations[k].by[row.number];
                *second += self.know(by) * change;
            }
            force[row.number] = next;
            results.push((Place::Element("next", row.number), next));
        }
        let changed = second.into_iter().enumerate();
        results.push_all(changed.map(|(k, second)| (Place::Element("changed", k), second)));
        results
    }
}

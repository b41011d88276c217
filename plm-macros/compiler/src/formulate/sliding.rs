//! Frictions that all slip: known forces, and sweeps where reactions of joints bound them.
//!
//! A row that slips has the force `f_i = -sigma_i L_i`. Its limit `L_i = own + sum share_il |R_l|` reads reactions that are affine in the
//! accelerations of the coordinates and in the forces, and the accelerations are affine in the forces,
//!
//! ```text
//! (1)  R_l = r_l + sum P_lk a_k + sum G_lj f_j,    a_k = a_k0 + sum K_kj f_j
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
//! line has a sign that is held; a row with such reactions alone is linear, and (2) solves it for `f_i`.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use super::contact::Accelerated;
use super::function::{Function, Place};
use crate::derive::Equations;
use crate::model::{Contact, ContactLaw, Model, Reaction, bounding_reactions};

/// Functions of rows that all slip.
pub(crate) struct Sliding {
    /// Symbols of `slip`: by row, -1 or 1, the sign of the slip; 0 for a row without a force.
    pub(crate) slip: Vec<Expr>,
    /// Symbols of `line`: by reaction, -1 or 1, the sign that is held of one along a line.
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
    /// `next` and `changed`, forces and accelerations after a sweep (2).
    pub(crate) sweep: Function,
    /// One sweep finds the forces.
    pub(crate) is_explicit: bool,
    /// `sizes` of the reactions along a line, with the signs that are held.
    pub(crate) sizes: Function,
}

/// The functions of rows that all slip, where the rate is affine in the multipliers; nothing if pushes alone bound the frictions.
pub(super) fn functions(model: &Model, equations: &Equations, motion: &Accelerated) -> Option<Sliding> {
    let mut system = System::new(model, equations, motion);
    let is_bounded = |(contact, own): (&Contact, &Expr)| !contact.reactions().is_empty() || !own.is_zero();
    if !model.contacts.iter().zip(&system.own).any(is_bounded) {
        return None;
    }
    let mut results = system.rate(motion);
    let loads = system.loads();
    let bounded = (0..model.contacts.len()).filter(|row| !model.contacts[*row].reactions().is_empty());
    let rows: Vec<Row> = bounded.map(|row| system.row(row, &loads)).collect_vec();
    let loads = loads.into_iter().enumerate().map(|load| system.size(load)).collect_vec();
    let sweep = system.sweep(&rows, &loads);
    let sizes = loads.iter().enumerate().filter(|(_, size)| size.is_line());
    let sizes = sizes.map(|(load, size)| (Place::Element("sizes", load), system.value(size))).collect_vec();
    results.push_all(rows.iter().map(|row| (Place::Element("slope", row.number), row.slope)));
    let known = system.values.iter().enumerate().map(|(k, &value)| (Place::Element("known", k), value));
    results.push_all(known);
    let is_explicit = rows.is_empty() || rows.len() == 1 && loads.iter().all(Size::is_line);
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
    limit: Limit,
}

/// The limit to the side against which a row slips.
struct Limit {
    own: Expr,
    /// Shares of the sizes of reactions, with their numbers.
    shares: Vec<(usize, Expr)>,
}

/// The size of a reaction.
struct Size {
    /// One along a line, or two in the plane; of numbers that are known.
    components: Vec<Affine>,
    /// The sign along a line.
    sign: Expr,
}

impl Size {
    fn is_line(&self) -> bool {
        self.components.len() == 1
    }

    fn of(&self, components: &[Expr]) -> Expr {
        if let [along] = *components { self.sign * along } else { size_of(components) }
    }
}

/// The size of a reaction in the plane.
fn size_of(components: &[Expr]) -> Expr {
    components.iter().map(|&component| component * component).sum::<Expr>().sqrt()
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
        let reactions = 0..bounding_reactions(&model.contacts).len();
        let line = reactions.map(|load| Expr::symbol(format!("line_{load}"))).collect_vec();
        let joints = equations.lambda.iter().copied().zip(motion.by_second.iter().copied());
        let mut system = System {
            model,
            substitution: joints.chain(motion.substitution.iter().copied()).collect_vec(),
            lambda: model.contacts.iter().map(|contact| contact.lambda).collect_vec(),
            own: vec![Expr::ZERO; model.contacts.len()],
            slip: symbols("slip"),
            line,
            force: symbols("force"),
            second: motion.second.to_vec(),
            known: Vec::new(),
            values: Vec::new(),
            accelerations: Vec::new(),
        };
        for (row, contact) in model.contacts.iter().enumerate() {
            if contact.reactions().is_empty() {
                system.own[row] = -(system.slip[row] * system.limit(row).own);
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

    /// The limit to the side against which a row slips. Gaps do not push.
    fn limit(&self, row: usize) -> Limit {
        let none = Limit { own: Expr::ZERO, shares: Vec::new() };
        let ContactLaw::Friction { kinetic, reactions, .. } = &self.model.contacts[row].law else {
            return none;
        };
        let kinetic = algebra::substitute(kinetic, &self.substitution);
        let [lower, upper] = self.without_forces(&kinetic)[..] else { return none };
        let limit = if lower == upper { lower } else { Expr::ZERO.less(self.slip[row]).select(lower, upper) };
        if reactions.is_empty() {
            return Limit { own: limit, ..none };
        }
        let is_read = |size: Expr| reactions.iter().any(|reaction| reaction.size == size);
        let all =
            bounding_reactions(&self.model.contacts).into_iter().map(|reaction| reaction.size).enumerate();
        let sizes = all.filter(|(_, size)| is_read(*size)).collect_vec();
        let still = sizes.iter().map(|(_, size)| (*size, Expr::ZERO)).collect_vec();
        let shares = sizes.into_iter().map(|(load, size)| (load, limit.diff(size))).collect_vec();
        Limit { own: algebra::substitute(&[limit], &still)[0], shares }
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
        let is_bounded = |contact: &Contact| !contact.reactions().is_empty();
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

    /// The reactions that bound rows, by their components (1).
    fn loads(&self) -> Vec<Vec<Affine>> {
        let of = |reaction: &Reaction| {
            let components = algebra::substitute(&reaction.components, &self.substitution);
            components.into_iter().map(|component| self.parts(component)).collect_vec()
        };
        bounding_reactions(&self.model.contacts).into_iter().map(of).collect_vec()
    }

    /// A row that reactions bound.
    fn row(&self, row: usize, loads: &[Vec<Affine>]) -> Row {
        let limit = self.limit(row);
        let through =
            limit.shares.iter().map(|(load, share)| *share * self.slope(row, (*load, &loads[*load])));
        let slope = Expr::ONE + self.slip[row] * through.sum::<Expr>();
        let slope = slope.named(format!("slope_{}", self.model.contacts[row].name));
        Row { number: row, slope, limit }
    }

    /// The derivative of the size of a reaction by the force of a row, where the swept forces are zero.
    fn slope(&self, row: usize, (load, parts): (usize, &[Affine])) -> Expr {
        let slopes = parts.iter().map(|part| {
            let through = part.by_second.iter().zip(&self.accelerations);
            through.map(|(&by, second)| by * second.by[row]).chain([part.by[row]]).sum::<Expr>()
        });
        let slopes = slopes.collect_vec();
        if let [slope] = slopes[..] {
            return self.line[load] * slope;
        }
        let free = self.accelerations.iter().map(|second| second.own).collect_vec();
        let here: Vec<Expr> = parts.iter().map(|part| part.at(&free, &[])).collect_vec();
        algebra::dot(&here, &slopes) / size_of(&here)
    }

    /// The size of a reaction, by numbers that are known.
    fn size(&mut self, (load, parts): (usize, Vec<Affine>)) -> Size {
        Size {
            components: parts.into_iter().map(|parts| self.known(parts)).collect_vec(),
            sign: self.line[load],
        }
    }

    /// The value of the size of a reaction.
    fn value(&self, size: &Size) -> Expr {
        let components = size.components.iter().map(|component| component.at(&self.second, &self.force));
        size.of(&components.collect_vec())
    }

    /// Forces and accelerations after (2).
    fn sweep(&mut self, rows: &[Row], loads: &[Size]) -> Vec<(Place, Expr)> {
        let (mut second, mut force) = (self.second.clone(), self.force.clone());
        let mut results = Vec::new();
        for row in rows {
            let (inverse, against) = (row.slope.recip(), self.slip[row.number]);
            let own = self.know(-(against * row.limit.own * inverse));
            let mut next = own + self.know(Expr::ONE - inverse) * force[row.number];
            for (load, share) in &row.limit.shares {
                let size = &loads[*load];
                let sign = if size.is_line() { size.sign } else { Expr::ONE };
                let share = self.know(-(against * sign * *share * inverse));
                let at = |part: &Affine| part.at(&second, &force).named(format!("component_{}", row.number));
                let components = size.components.iter().map(at).collect_vec();
                next += share * if let [along] = components[..] { along } else { size_of(&components) };
            }
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

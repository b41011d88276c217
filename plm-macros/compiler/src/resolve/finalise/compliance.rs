//! Joints that give way: rows that are springs instead of constraints.
//!
//! With `lambda = (phi + relaxation phi_dot)/compliance` a row is the force `-phi_q^T lambda`, which a constraint becomes in
//! the limit of no compliance (J. Garcia de Jalon, E. Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994,
//! chapter 5: penalty formulations). So `reaction(row)` keeps its meaning.

use crate::collect::{CollectVec, MapEach};
use crate::sorted::SortedMap;

use plm_cas::{Expr, algebra};

use crate::diag::Code;
use crate::model::{Contact, Limit, Load, Output, Range, Row, State, When};
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Reads};
use crate::syntax::ast::Field;
use crate::units::Dimension;

const COMPLIANCE: &str = "compliance";
const ROTARY: &str = "rotary_compliance";
const RELAXATION: &str = "relaxation";

/// Words that may be set where a joint is used, besides its own parameters.
pub(crate) const WORDS: [&str; 3] = [COMPLIANCE, ROTARY, RELAXATION];

/// A word that is set where a joint is used.
struct Word<'a> {
    instance: usize,
    name: &'static str,
    /// Scope in which the joint is used, and the value of the word is evaluated.
    scope: ScopeId,
    field: &'a Field,
}

/// The rows of one instance, by their places in the model.
type OfInstance = Vec<usize>;

impl<'a> Resolver<'a> {
    /// Makes forces of the rows of joints with a compliance; what is left are constraints. Gives both.
    pub(crate) fn apply_compliances(
        &mut self,
        mut rows: Vec<Row>,
        loads: &mut Vec<Load>,
        states: &mut [State],
        outputs: &mut [Output],
        (contacts, whens): (&mut [Contact], &mut [When]),
    ) -> Eval<(Vec<Row>, Vec<Row>)> {
        let mut multipliers: SortedMap<usize, Expr> = SortedMap::new();
        let mut all_found = Ok(());
        for instance in 0..self.names.instances.len() {
            if WORDS.iter().all(|word| self.names.word(instance, word).is_none()) {
                continue;
            }
            let within =
                |row: &usize| self.names.instance(self.unresolved.rows[*row].scope) == Some(instance);
            let of_instance: OfInstance = (0..rows.len()).filter(within).collect_vec();
            let found = self.multipliers(instance, &rows, of_instance);
            all_found = all_found.and(found.map(|found| multipliers.extend(found)));
        }
        all_found?;
        let mut stands_for = Vec::new();
        for (&row, &lambda) in &multipliers {
            let Row { part, phi, lambda: symbol, .. } = rows[row];
            // The force `-phi_q^T lambda` on every body that the row holds.
            self.push_force(phi, part, |entry| -(entry * lambda), loads);
            // What gives way is no pair that coordinates could follow.
            self.unresolved.parts[part].pair = None;
            rows[row].lambda = lambda;
            stands_for.push((symbol, lambda));
        }
        for load in loads {
            load.force = load.force.map_each(|force| algebra::substitute(&[force], &stands_for)[0]);
        }
        for state in states {
            state.rate = algebra::substitute(&[state.rate], &stands_for)[0];
        }
        for output in outputs {
            output.components = algebra::substitute(&output.components, &stands_for);
        }
        let of_events = whens.iter_mut().filter_map(|when| when.condition.as_mut());
        for place in contacts.iter_mut().flat_map(Contact::expressions_mut).chain(of_events) {
            *place = algebra::substitute(&[*place], &stands_for)[0];
        }
        let (soft, rigid): (Vec<_>, Vec<_>) =
            rows.into_iter().enumerate().partition(|(row, _)| multipliers.contains_key(row));
        let of = |rows: Vec<(usize, Row)>| rows.into_iter().map(|(_, row)| row).collect_vec();
        Ok((of(rigid), of(soft)))
    }

    /// `lambda` of the rows of an instance that give way.
    fn multipliers(&mut self, instance: usize, rows: &[Row], own: OfInstance) -> Eval<Vec<(usize, Expr)>> {
        let (rotary, straight): (OfInstance, OfInstance) =
            own.into_iter().partition(|&row| rows[row].unit.dimension.same(Dimension::NUMBER));
        let straight = self.compliances(instance, COMPLIANCE, rows, straight);
        let rotary = self.compliances(instance, ROTARY, rows, rotary);
        let relaxation = self.relaxation(instance);
        let (mut given, relaxation) = (straight?, relaxation?);
        given.extend(rotary?);
        if let (Some((field, _)), []) = (relaxation, given.as_slice()) {
            let outer = self.names.instances[instance].outer;
            self.error(outer, Code::MissingValue, field.span(), "a `relaxation` without a `compliance`")
                .help(format!("write `{{ {COMPLIANCE}: 1e-9 m/N; {RELAXATION}: … }}`"));
            return Err(Failed);
        }
        for (row, value) in &mut given {
            let phi = rows[*row].phi;
            let lagging = match relaxation {
                Some((_, relaxation)) => phi + relaxation * self.calculus.total_derivative(phi),
                None => phi,
            };
            *value = lagging / *value;
        }
        Ok(given)
    }

    /// Compliances that a word sets, by row of its kind.
    fn compliances(
        &mut self,
        instance: usize,
        word: &'static str,
        rows: &[Row],
        own: OfInstance,
    ) -> Eval<Vec<(usize, Expr)>> {
        let Some(word) = self.word(instance, word) else { return Ok(Vec::new()) };
        if own.is_empty() {
            let kind = if word.name == ROTARY { "an angle" } else { "a length" };
            let (of, name) = (&self.names.instances[instance].name, word.name);
            let message = format!("`{of}` has no constraint that is {kind}, which could have a `{name}`");
            self.error(word.scope, Code::UnknownField, word.field.span(), message);
            return Err(Failed);
        }
        let mut known: SortedMap<Dimension, Expr> = SortedMap::new();
        for &row in &own {
            let dimension = rows[row].unit.dimension;
            // phi over lambda; phi lambda is an energy.
            let wanted = if word.name == ROTARY {
                Dimension::ANGLE.over(Dimension::TORQUE)
            } else {
                dimension.power(2).over(Dimension::TORQUE)
            };
            if !known.contains_key(&dimension) {
                known.insert(dimension, self.positive(&word, wanted, false)?);
            }
        }
        Ok(own.into_iter().map(|row| (row, known[&rows[row].unit.dimension])).collect_vec())
    }

    /// The time in which a row that gives way settles.
    fn relaxation(&mut self, instance: usize) -> Eval<Option<(&'a Field, Expr)>> {
        let Some(word) = self.word(instance, RELAXATION) else { return Ok(None) };
        let value = self.positive(&word, Dimension::TIME, true)?;
        Ok(Some((word.field, value)))
    }

    fn word(&self, instance: usize, name: &'static str) -> Option<Word<'a>> {
        self.names.word(instance, name).map(|(scope, field)| Word { instance, name, scope, field })
    }

    /// The value of a word, which must be positive, or zero where that has a meaning. What depends on parameters is looked at when
    /// they are known.
    fn positive(&mut self, word: &Word<'a>, dimension: Dimension, or_zero: bool) -> Eval<Expr> {
        let (scope, name, expr) = (word.scope, word.name, &word.field.value);
        let value = self.eval_number(scope, expr, dimension, Reads::FIXED)?;
        let Some(number) = value.as_number() else {
            let (part, unit) = (self.names.instances[word.instance].name.clone(), dimension.si_unit());
            let (what, span) = (name.to_owned(), expr.span);
            self.unresolved.limits.push(Limit {
                part,
                what,
                value,
                unit,
                range: if or_zero { Range::NotNegative } else { Range::Positive },
                code: Code::NotPositive,
                span,
            });
            return Ok(value);
        };
        if !number.is_negative() && (or_zero || !number.is_zero()) {
            return Ok(value);
        }
        let found =
            crate::resolve::values::expect::literal_text(expr).unwrap_or_else(|| number.to_f64().to_string());
        let wanted = if or_zero { "must not be negative" } else { "must be positive" };
        let diagnostic =
            self.error(scope, Code::NotPositive, expr.span, format!("the {name} {wanted}, found {found}"));
        if !or_zero {
            diagnostic.help("leave it out: without a compliance the joint is rigid");
        }
        Err(Failed)
    }
}

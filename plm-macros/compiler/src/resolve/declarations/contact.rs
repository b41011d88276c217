//! Rows of contact: what they are called, their displacements, and what they say.

use plm_cas::Expr;

use crate::diag::Code;
use crate::model::{Declared, Reaction};
use crate::resolve::Resolver;
use crate::resolve::names::{RowId, ScopeId};
use crate::resolve::values::lazy::Lazy;
use crate::resolve::values::{Eval, Failed, Reads, Scalar};
use crate::span::Span;
use crate::syntax::ast;
use crate::units::Dimension;

/// A row of contact as it was written.
#[derive(Clone, Copy)]
pub(crate) enum WrittenContact<'a> {
    Unilateral(&'a ast::Unilateral),
    Friction(&'a ast::Friction),
}

impl<'a> WrittenContact<'a> {
    fn name(self) -> &'a ast::IndexedName {
        match self {
            WrittenContact::Unilateral(row) => &row.name,
            WrittenContact::Friction(row) => &row.name,
        }
    }

    /// Its word in the language.
    pub(crate) fn word(self) -> &'static str {
        match self {
            WrittenContact::Unilateral(_) => "unilateral",
            WrittenContact::Friction(_) => "friction",
        }
    }

    /// It exists while this holds.
    pub(crate) fn when(self) -> Option<&'a ast::Expr> {
        match self {
            WrittenContact::Unilateral(row) => row.when.as_ref(),
            WrittenContact::Friction(row) => row.when.as_ref(),
        }
    }

    /// The place of its displacement.
    fn span(self) -> Span {
        match self {
            WrittenContact::Unilateral(row) => {
                let [greater, lesser] = row.sides.each_ref().map(|side| side.span);
                greater.min(lesser).to(greater.max(lesser))
            }
            WrittenContact::Friction(row) => row.displacement.span,
        }
    }

    /// How its displacement is spoken of.
    fn displacement(self) -> &'static str {
        match self {
            WrittenContact::Unilateral(_) => "a gap",
            WrittenContact::Friction(_) => "a slip",
        }
    }
}

/// A row of contact on its way to the model.
pub(crate) struct UnresolvedContact<'a> {
    pub(crate) scope: ScopeId,
    pub(crate) written: WrittenContact<'a>,
    /// Full name, `shoe.tip`.
    pub(crate) name: String,
    pub(crate) part: usize,
    pub(crate) span: Span,
    pub(crate) lambda: Expr,
    /// Stands for 1 where it is open, or sticks, else for 0.
    pub(crate) mode: Expr,
    /// The reactions of joints that its bound reads.
    pub(crate) reactions: Vec<Reaction>,
    displacement: Lazy<Displacement>,
}

impl UnresolvedContact<'_> {
    /// Is it a friction? Else it is a unilateral row.
    pub(crate) fn is_friction(&self) -> bool {
        matches!(self.written, WrittenContact::Friction(_))
    }
}

/// The gap, or what slips.
#[derive(Clone, Copy)]
pub(crate) struct Displacement {
    pub(crate) value: Expr,
    pub(crate) dimension: Dimension,
    /// It reads sums at nodes whose summands are not known yet: only its dimension is.
    reads_sums: bool,
}

impl Displacement {
    /// The dimension of the multiplier: times the displacement it is an energy.
    pub(crate) fn of_multiplier(self) -> Dimension {
        Dimension::TORQUE.over(self.dimension).plain()
    }
}

impl<'a> Resolver<'a> {
    /// A row in a part; at the top of the mechanism it is a part of its own.
    pub(crate) fn declare_contact(
        &mut self,
        scope: ScopeId,
        written: WrittenContact<'a>,
        part: Option<usize>,
    ) {
        let id = RowId::Contact(self.unresolved.contacts.len());
        let Some(row) = self.name_row(scope, written.name(), id, written.word(), part) else { return };
        self.unresolved.contacts.push(UnresolvedContact {
            scope,
            written,
            name: row.name,
            part: row.part,
            span: row.span,
            lambda: row.lambda,
            mode: Expr::symbol("mode"),
            reactions: Vec::new(),
            displacement: Lazy::Waiting,
        });
    }

    /// The place of a row.
    pub(crate) fn contact_declared(&self, contact: usize) -> Declared {
        let UnresolvedContact { scope, written, .. } = self.unresolved.contacts[contact];
        Declared { span: written.span(), uses: self.names.uses(scope) }
    }

    /// The displacement of a row, worked out at its first use.
    pub(crate) fn displacement(&mut self, contact: usize) -> Eval<Displacement> {
        let UnresolvedContact { scope, written, .. } = self.unresolved.contacts[contact];
        let found = self.lazy(
            |of| &mut of.unresolved.contacts[contact].displacement,
            |_| (),
            |of| of.displacement_of(scope, written),
        )?;
        if found.reads_sums {
            self.unresolved.contacts[contact].displacement = Lazy::Waiting;
        }
        Ok(found)
    }

    fn displacement_of(&mut self, scope: ScopeId, written: WrittenContact<'a>) -> Eval<Displacement> {
        let found = match written {
            WrittenContact::Unilateral(row) => self.gap(scope, row)?,
            WrittenContact::Friction(row) => self.eval_scalar(scope, &row.displacement)?,
        };
        let found = self.with_sums(found);
        let (what, nature) = (written.displacement(), found.nature);
        let reads_sums = nature.reads.has(Reads::SUM) && !self.unresolved.has_all_loads;
        let may_read = match written {
            _ if reads_sums => Reads::ALL,
            // Events alone change a discrete state: over a step the gap reads a number.
            WrittenContact::Unilateral(_) if self.reads_discrete_states_alone(found.value) => {
                Reads::GEOMETRY.and(Reads::STATE)
            }
            _ => Reads::GEOMETRY,
        };
        let beyond = nature.reads.beyond(may_read);
        if beyond != Reads::NOTHING {
            let message = format!("{what} reads {}", beyond.describe());
            let also = if let WrittenContact::Unilateral(_) = written { ", and discrete states" } else { "" };
            let (scope, span) = self.culprit_of(scope, written, beyond);
            let diagnostic = self
                .error(scope, Code::NotConstant, span, message)
                .note(format!("it may read {}{also}", Reads::GEOMETRY.describe()));
            if beyond.has(Reads::VELOCITY) {
                diagnostic.help("what holds a rate is a `friction`, and what damps is a force");
            } else if let Some([why, instead]) = beyond.no_place() {
                diagnostic.note(why).help(instead);
            }
            return Err(Failed);
        }
        let span = written.span();
        if found.value.as_number().is_some() || !nature.reads.has(Reads::POSITION) {
            let message = format!("{what} that holds no position");
            self.error(scope, Code::NotConstant, span, message).help("it must read the positions of bodies");
            return Err(Failed);
        }
        let dimension = nature.dimension;
        if !dimension.same(Dimension::LENGTH) && !dimension.same(Dimension::NUMBER) {
            let message = format!("{what} is a length or an angle, found {}", dimension.describe());
            self.error(scope, Code::WrongDimension, span, message);
            return Err(Failed);
        }
        Ok(Displacement { value: found.value, dimension, reads_sums })
    }

    /// The smallest part of a displacement that reads what it may not.
    fn culprit_of(&mut self, scope: ScopeId, written: WrittenContact<'a>, beyond: Reads) -> (ScopeId, Span) {
        let sides = match written {
            WrittenContact::Unilateral(row) => row.sides.each_ref().to_vec(),
            WrittenContact::Friction(row) => vec![&row.displacement],
        };
        let mut reading = sides.into_iter().filter(|side| self.reads_any(scope, side, beyond));
        match (reading.next(), reading.next()) {
            (Some(side), None) => {
                drop(reading);
                self.culprit(scope, side, beyond)
            }
            _ => (scope, written.span()),
        }
    }

    /// The greater side without the lesser one.
    fn gap(&mut self, scope: ScopeId, row: &'a ast::Unilateral) -> Eval<Scalar> {
        let [greater, lesser] = &row.sides;
        let (a, b) = (self.eval_scalar(scope, greater), self.eval_scalar(scope, lesser));
        let (a, b) = (a?, b?);
        let span = WrittenContact::Unilateral(row).span();
        let nature = self.joined(scope, span, a, b)?;
        Ok(Scalar::new(a.value - b.value, nature))
    }
}

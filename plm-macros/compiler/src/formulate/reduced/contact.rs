//! Rows of contact in joint coordinates.

use crate::collect::CollectVec;
use plm_cas::{Expr, algebra};

use super::charts::Scheme;
use super::layout::Layout;
use super::motion::Motion;
use super::tree::reactions::of_coordinates;
use crate::formulate::Function;
use crate::formulate::contact::{Accelerated, ContactFunctions, functions};
use crate::model::bounding_reactions;

impl Layout<'_> {
    /// The rows of contact, where `rate` gives the accelerations of the coordinates; none if there are no rows.
    pub(super) fn contact(
        &self,
        motion: &Motion,
        scheme: &Scheme,
        rate: &Function,
    ) -> Option<ContactFunctions> {
        if self.model.contacts.is_empty() {
            return None;
        }
        let second = of_coordinates(motion, rate);
        let bodies = self.accelerations_of_bodies(motion, &second);
        let reactions = self.reactions_of_joints(motion, scheme, &bodies);
        let symbols = (0..second.len()).map(|k| Expr::symbol(format!("second_{k}"))).collect_vec();
        let by_second = self.accelerations_of_bodies(motion, &symbols);
        let by_second = self.reactions_of_joints(motion, scheme, &by_second);
        let substitution = &motion.substitution;
        let (coordinates, rate) = (second.len(), &rate.results);
        let motion = Accelerated {
            bodies: &bodies,
            rate,
            coordinates,
            substitution,
            reactions: &reactions,
            second: &symbols,
            by_second: &by_second,
        };
        functions(self.model, self.equations, &motion)
    }

    /// Multipliers of the joints where they bound a friction: those of forces from body to body, others by elimination in absolute
    /// coordinates, at the pose of the chart. `a` are the accelerations of the bodies.
    fn reactions_of_joints(&self, motion: &Motion, scheme: &Scheme, a: &[Expr]) -> Vec<Expr> {
        if self.model.contacts.iter().all(|contact| contact.reactions().is_empty()) {
            return self.equations.lambda.clone();
        }
        let bounding = bounding_reactions(&self.model.contacts).into_iter();
        let read = algebra::symbols(&bounding.flat_map(|reaction| reaction.components.clone()).collect_vec());
        let passed_on = self.forces_of_joints(motion, scheme, a).into_iter();
        let rows = passed_on.zip(&self.equations.lambda).zip(self.lambda);
        let each = rows.map(|((passed, &symbol), &eliminated)| match passed {
            Some(passed) => passed,
            None if read.contains(&symbol) => algebra::substitute(&[eliminated], &motion.substitution)[0],
            None => symbol,
        });
        each.collect_vec()
    }
}

//! Rows of contact in joint coordinates.

use plm_cas::{Expr, algebra};

use super::layout::Layout;
use super::motion::Motion;
use super::tree::reactions::of_coordinates;
use crate::formulate::Function;
use crate::formulate::contact::{Accelerated, ContactFunctions, functions};

impl Layout<'_> {
    /// The rows of contact, where `rate` gives the accelerations of the coordinates; none if there are no rows.
    pub(super) fn contact(&self, motion: &Motion, rate: &Function) -> Option<ContactFunctions> {
        if self.model.contacts.is_empty() {
            return None;
        }
        let second = of_coordinates(motion, rate);
        let bodies = self.accelerations_of_bodies(motion, &second);
        let reactions = self.reactions_of_joints(motion);
        let substitution = &motion.substitution;
        let (coordinates, rate) = (second.len(), &rate.results);
        let motion = Accelerated { bodies: &bodies, rate, coordinates, substitution, reactions: &reactions };
        functions(self.model, self.equations, &motion)
    }

    /// Multipliers of the joints where they bound a friction: by elimination in absolute coordinates, at the pose of the chart.
    fn reactions_of_joints(&self, motion: &Motion) -> Vec<Expr> {
        if self.model.contacts.iter().all(|contact| contact.reactions().is_empty()) {
            return self.equations.lambda.clone();
        }
        algebra::substitute(self.lambda, &motion.substitution)
    }
}

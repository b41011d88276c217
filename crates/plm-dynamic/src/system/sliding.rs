//! Rows of contact that all slip, where reactions bound them: sweeps over the forces.

use plm_compiler::lowered::Form;
use plm_runtime::{Health, Scalar, contact};

use crate::handle::{Beside, Dynamic, Frame, Held};

impl<
    S: Scalar,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Dynamic<S, NQ, NC, N, L, H, R, P>
{
    /// The rate where all rows that have a force slip, and the sizes of reactions along a line; nothing where sweeps do not converge.
    pub(super) fn contact_sliding(
        &self,
        t: S,
        u: &Held<S, NQ, L, H, R>,
        x: &[S; N],
        dx: &mut [S; N],
        sizes: Option<&mut [S; R]>,
    ) -> Option<Health<S>> {
        let functions = self.contact_functions(u)?.sliding.as_ref()?;
        let [slip, line] = &contact::slipping(&u.contact.modes)?;
        let (mut free, mut slope) = ([S::ZERO; NQ], [S::lit(1.0); R]);
        let mut known = vec![S::ZERO; functions.known];
        let signs = Beside { slip, line, ..Beside::NONE };
        let frame = Frame { beside: Some(&signs), ..Frame::of_state(t, u, x) };
        let health = self.run(&functions.motion, &frame, [dx, &mut free, &mut known, &mut slope]);
        let health = if self.model.lowered.form == Form::Tree { S::lit(1.0) } else { health };
        let mut weights = [1.0; NQ];
        for (to, weight) in weights.iter_mut().zip(&functions.weights) {
            *to = *weight;
        }
        let known = &known;
        let at = |force: &[S; R], second: &[S; NQ], run: &mut dyn FnMut(&Frame<S, NQ, L, H, R>)| {
            let numbers = Beside { line, force, second, known, ..Beside::NONE };
            run(&Frame { beside: Some(&numbers), ..Frame::at(t) });
        };
        let sweep = |force: &[S; R], second: &[S; NQ], next: &mut [S; R], changed: &mut [S; NQ]| {
            at(force, second, &mut |frame| {
                self.run(&functions.sweep, frame, [next, changed]);
            });
        };
        let (force, second) = contact::slide((&slope, &weights), functions.is_explicit, free, sweep)?;
        for (to, acceleration) in dx.iter_mut().skip(NQ).zip(second) {
            *to = acceleration;
        }
        if let Some(sizes) = sizes {
            at(&force, &second, &mut |frame| {
                self.run(&functions.sizes, frame, [sizes]);
            });
        }
        Some(Health(health))
    }
}

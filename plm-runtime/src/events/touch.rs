//! Motions that touch the boundary of a condition within a step and turn back: some motions beside them cross it, and derivatives to both
//! sides have nothing in common. Runs with derivatives end there.

use super::guards;
use super::marks::Marks;
use super::relevant::Relevant;
use super::root::{Point, root};
use super::rounding::{ULPS, rounding};
use crate::fault::{Cause, Fault};
use crate::method::{Context, Method, Path};
use crate::scalar::{Real, Scalar};
use crate::system::{Question, System, value};
use crate::vector::Vector;

/// Distance, in roundings there, up to which a motion touches a boundary; the tolerance of its steps, if that is more.
const MANY: f64 = 1e3;
/// Derivatives below this are rounding.
const NONE: f64 = 1e-12;

/// Searches for a condition whose boundary the last step has only touched, of those that are `relevant` and have no `residual`.
///
/// # Errors
/// [`Cause::Grazes`] if the boundary, or the motion beside it, moves with the variable of differentiation. Runs with one-sided derivatives
/// continue if the motion stays away on that side.
pub(super) fn touch<M: System<S: Real>, I: Method<M>>(
    method: &mut I,
    context: &mut Context<'_, M>,
    (relevant, residual): (Relevant, &M::G),
) -> Result<(), Fault> {
    let Some(path) = method.path() else { return Ok(()) };
    let tolerance = method.tolerance().map_or(M::S::ZERO, value);
    let asked = Touched { path: &path, relevant, residual, tolerance };
    let Some((index, theta)) = context.system.ask(&context.held, asked) else { return Ok(()) };
    method.derive(context)?;
    let Some(path) = method.path() else { return Ok(()) };
    let time = path.time(theta);
    let distance = guards(context.system, time, &context.held, &path.at(theta)).at(index);
    let keeps_away = match distance.goes() {
        Some(away) => away >= 0.0,
        None => distance.largest_derivative() <= NONE,
    };
    if keeps_away {
        return Ok(());
    }
    Err(Fault::of_part(time.to_f64(), context.system.guard_name(index), Cause::Grazes))
}

/// Asks for a condition that is only touched over a step, and for the fraction of the step.
struct Touched<'a, S, X, G> {
    path: &'a Path<S, X>,
    relevant: Relevant,
    residual: &'a G,
    tolerance: S,
}

impl<S: Real, X: Vector<S>, G: Vector<S>> Question<S> for Touched<'_, S, X, G> {
    type Answer = Option<(usize, S)>;

    fn of<N: System<S: Real<Plain = S::Plain>>>(self, system: &N, held: &N::U) -> Self::Answer {
        let Self { relevant, residual, tolerance, .. } = self;
        let over = Over { system, held, path: self.path.in_values(), tolerance: value(tolerance) };
        let has_none = |i: usize| relevant.has(i) && residual.at(i) >= S::ZERO;
        let turns = over.slopes(N::S::ZERO, true) & over.slopes(N::S::lit(1.0), false);
        let mut indices = (0..N::G::LEN).filter(|i| turns.has(*i) && has_none(*i));
        indices.find_map(|i| over.touched(i).map(|theta| (i, value(theta))))
    }
}

/// Conditions over a step, in values.
struct Over<'a, N: System> {
    system: &'a N,
    held: &'a N::U,
    path: Path<N::S, N::X>,
    tolerance: N::S,
}

impl<N: System<S: Real>> Over<'_, N> {
    /// Satisfied conditions that approach their boundaries, or move away from them.
    fn slopes(&self, theta: N::S, nearer: bool) -> Marks {
        let mut found = Marks::NONE;
        self.each(theta, |i, [guard, slope]| {
            let is_right = if nearer { slope < N::S::ZERO } else { slope >= N::S::ZERO };
            if guard > N::S::ZERO && is_right {
                found.put(i);
            }
        });
        found
    }

    /// Fraction of the step at which a condition is nearest to its boundary, if it is no farther there than rounding and tolerance, and
    /// farther at both ends of the step.
    fn touched(&self, index: usize) -> Option<N::S> {
        let one = N::S::lit(1.0);
        let at = |theta: N::S| {
            let mut found = [N::S::ZERO; 2];
            self.each(theta, |i, guard| found = if i == index { guard } else { found });
            found
        };
        let ends = [at(N::S::ZERO), at(one)];
        let [left, right] =
            [(N::S::ZERO, ends[0]), (one, ends[1])].map(|(at, [_, slope])| Point { at, value: -slope });
        let theta = root(left, right, N::S::lit(16.0) * N::S::EPSILON, &mut |theta| -at(theta)[1]);
        let (time, x) = (self.path.time(theta), self.path.at(theta));
        let here = guards(self.system, time, self.held, &x);
        let rounded = rounding((self.system, self.held), (time, time), &x, &here).at(index);
        let parts = (self.tolerance / (N::S::lit(ULPS) * N::S::EPSILON)).max(N::S::lit(MANY));
        let within = parts * rounded;
        let nearest = here.at(index) + self.system.band(index);
        let is_touched = nearest.abs() <= within && ends.iter().all(|[guard, _]| *guard > within);
        is_touched.then_some(theta)
    }

    /// Gives every condition, and its change per step.
    fn each(&self, theta: N::S, mut each: impl FnMut(usize, [N::S; 2])) {
        let (time, x) = self.path.around(theta, N::S::ZERO);
        self.system.guards_within(time, self.held, &x, &mut |i, guard| {
            if i < N::G::LEN {
                let slope = N::S::lit(0.5) * (guard.slope.low + guard.slope.high);
                each(i, [guard.middle + self.system.band(i), slope]);
            }
        });
    }
}

//! Assembly on the mirror images of loops that joints ask for.

use super::Absolute;
use super::branch::{Branch, WAYS};
use super::placed::unwind;
use super::pose::{Pose, newton};
use super::search::search;
use crate::fault::{Cause, Fault};
use crate::scalar::Real;
use crate::start::Start;
use crate::vector::Vector;

/// Goes over to the images that are asked for, one joint after the other; what is locked stays.
pub(super) fn find<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    t: S,
    mut pose: Pose<S, NQ, NC>,
    (start, free): (&[Start<S>; NQ], &[S; NQ]),
) -> Result<Pose<S, NQ, NC>, Fault> {
    while let Some(wrong) = all(m).find(|branch| !branch.is_met(&pose.q)) {
        let before = missed(m, &pose.q);
        let found = WAYS.into_iter().find_map(|way| {
            let mut q = wrong.other(&pose.q, way);
            for (i, start) in start.iter().enumerate() {
                if free.at(i) == S::ZERO {
                    q.set(i, start.value);
                }
            }
            let found = Pose { found: pose.found, ..newton(m, t, &q, free) };
            (found.is_closed(m) && missed(m, &found.q) < before).then_some(found)
        });
        let found = found.or_else(|| {
            let found = search(m, t, (start, free), |q| missed(m, q)).ok()?;
            (missed(m, &found.q) < before).then_some(found)
        });
        let [first, second] = wrong.names;
        let cause = Cause::OtherBranch { first, second, left: !wrong.left };
        pose = found.ok_or(Fault::of_part(t.to_f64(), wrong.part, cause))?;
        // Mirrored bodies may have turned further than half a turn.
        unwind(m, t, &mut pose, (start, free));
    }
    Ok(pose)
}

fn all<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
) -> impl Iterator<Item = Branch<S>> {
    (0..).map_while(|index| m.branch(index))
}

/// How many joints are on another image than they ask for.
pub(super) fn missed<S: Real, M: Absolute<S, NQ, NC>, const NQ: usize, const NC: usize>(
    m: &M,
    q: &[S; NQ],
) -> usize {
    all(m).filter(|branch| !branch.is_met(q)).count()
}

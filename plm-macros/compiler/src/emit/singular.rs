//! How a mechanism goes on near singular poses: its equations in absolute coordinates, in numbers of twice the precision.

use super::{Emission, push};
use crate::model::Stabilisation;

/// The type that takes over from the method where no chart is regular.
pub(crate) fn rescue(emission: &Emission) -> String {
    if !may_be_singular(emission) {
        return "rt::singular::Never<Self>".to_owned();
    }
    let (nq, nc, nx) = sizes(emission);
    format!("rt::singular::Near<Self, {nq}, {nc}, {}>", 2 * nq + nx)
}

/// Has it loops, or constraints whose rank may drop? Where Baumgarte's stabilisation lets states drift from them, there are no
/// poses to come back to.
fn may_be_singular(emission: &Emission) -> bool {
    let projects = matches!(emission.model.stabilisation, Stabilisation::Projection);
    let absolute = emission.reduced.is_none() && !emission.equations.phi.is_empty() && projects;
    emission.loops().is_some() || absolute
}

/// `Fine`.
pub(crate) fn emit(text: &mut String, emission: &Emission) {
    if !may_be_singular(emission) {
        return;
    }
    let name = &emission.name;
    let held = emission.inputs("rt::Twofold<S>");
    let (inputs, charted) =
        if emission.loops().is_some() { (".input", charted(emission)) } else { ("", ALONE.to_owned()) };
    let (nq, nc, nx) = sizes(emission);
    let length = 2 * nq + nx;
    push(
        text,
        format_args!(
            "    #[doc(hidden)] // As `Absolute`.
    impl<S: Real> rt::singular::Fine<{nq}, {nc}, {length}> for {name}<S> {{
        type Twofold = {name}<rt::Twofold<S>>;
        type Inputs = {held};

        fn twofold(&self, held: &Self::U) -> (Self::Twofold, Self::Inputs) {{
            use rt::lanes::Pack;
            let exact = |[s]: [S; 1]| rt::Twofold::of(s);
            (self.pack([self], exact), Self::pack_held(held, [held], exact){inputs})
        }}
        #[cold]
        fn accelerate(
            fine: &Self::Twofold,
            t: rt::Twofold<S>,
            u: &Self::Inputs,
            x: &[rt::Twofold<S>; {length}],
            dx: &mut [rt::Twofold<S>; {length}],
        ) {{
            let mut lambda = [rt::Twofold::<S>::lit(0.0); {nc}];
            fine.dynamics(t, u, x, dx, &mut lambda);
        }}
{charted}    }}

"
        ),
    );
}

/// Coordinates, constraint rows and first-order states.
fn sizes(emission: &Emission) -> (usize, usize, usize) {
    (emission.equations.q.len(), emission.equations.phi.len(), emission.equations.x.len())
}

/// What `Fine` asks of a mechanism that is in absolute coordinates anyway.
const ALONE: &str = "        const CHARTED: bool = false;
        fn is_sharp(&self, _t: S, _held: &Self::U, _before: &Self::X, _x: &Self::X) -> bool {
            false
        }
        fn is_near(_held: &Self::U) -> bool {
            false
        }
        fn full(&self, _t: S, _held: &Self::U, x: &Self::X) -> Self::X {
            *x
        }
        fn hold(&self, _held: &mut Self::U, x: &mut Self::X, full: &Self::X) {
            *x = *full;
        }
        fn flat_part(&self, t: S, full: &Self::X) -> &'static str {
            absolute::flat_part::<_, _, NQ, NC>(self, t, &absolute::split(full).0)
        }
";

/// The same of one that has charts.
fn charted(emission: &Emission) -> String {
    let (nq, _, nx) = sizes(emission);
    let length = 2 * nq + nx;
    format!(
        "        const CHARTED: bool = true;
        #[inline]
        fn is_sharp(&self, t: S, held: &Self::U, before: &Self::X, x: &Self::X) -> bool {{
            rt::charts::is_sharp(self, t, held, before, x)
        }}
        fn is_near(held: &Self::U) -> bool {{
            rt::charts::is_free::<Self>(held)
        }}
        fn full(&self, t: S, held: &Self::U, x: &Self::X) -> [S; {length}] {{
            rt::charts::full(self, t, held, x)
        }}
        fn hold(&self, held: &mut Self::U, x: &mut Self::X, full: &[S; {length}]) {{
            rt::charts::hold::<Self, {length}>(held, x, full);
        }}
        fn flat_part(&self, t: S, full: &[S; {length}]) -> &'static str {{
            let (q, v): ([S; {nq}], [S; {nq}]) = absolute::split(full);
            rt::charts::flat_part(self, t, &q, &v)
        }}
"
    )
}

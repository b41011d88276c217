//! How a mechanism goes on near singular poses: its equations in absolute coordinates, in numbers of twice the precision.

use super::{Emission, push};

/// The type that takes over from the method where no chart is regular.
pub(crate) fn rescue(emission: &Emission) -> String {
    if emission.loops().is_none() {
        return "rt::singular::Never<Self>".to_owned();
    }
    let (nq, nc, nx) = sizes(emission);
    format!("rt::singular::Near<Self, {nq}, {nc}, {}>", 2 * nq + nx)
}

/// `Fine`.
pub(crate) fn emit(text: &mut String, emission: &Emission) {
    let name = &emission.name;
    let (nq, nc, nx) = sizes(emission);
    let length = 2 * nq + nx;
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::singular::Fine<{nq}, {nc}, {length}> for {name}<S> {{
        type Twofold = {name}<rt::Twofold<S>>;
        type Inputs = Input<rt::Twofold<S>>;

        fn twofold(&self, held: &Self::U) -> (Self::Twofold, Self::Inputs) {{
            use rt::lanes::Pack;
            let exact = |[s]: [S; 1]| rt::Twofold::of(s);
            (self.pack([self], exact), Self::pack_held(held, [held], exact).input)
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
    }}

"
        ),
    );
}

/// Coordinates, constraint rows and first-order states.
fn sizes(emission: &Emission) -> (usize, usize, usize) {
    (emission.equations.q.len(), emission.equations.phi.len(), emission.equations.x.len())
}

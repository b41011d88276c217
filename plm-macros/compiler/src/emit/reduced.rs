//! A rung above 5: its right-hand side, and the way to absolute coordinates and back.

use super::bodies::{Shape, write};
use super::{Emission, Origin, push};
use crate::formulate::Reduced;

/// The straight-line functions.
pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    let Some(reduced) = emission.reduced else { return text };
    let Emission { name, .. } = emission;
    let ((length, _), nq) = (emission.state_length(), emission.equations.q.len());
    push(&mut text, format_args!("\n    impl<S: Scalar> {name}<S> {{\n"));
    write(
        &mut text,
        emission,
        &reduced.rate,
        Origin::Reduced,
        &Shape {
            docs: &["The right-hand side in joint coordinates."],
            attribute: "#[inline(always)]",
            signature: &format!(
                "fn motion(&self, t: S, u: &Input<S>, x: &[S; {length}], dx: &mut [S; {length}])"
            ),
            arguments: &["t", "u", "x", "dx"],
        },
    );
    write(
        &mut text,
        emission,
        &reduced.pose,
        Origin::Reduced,
        &Shape {
            docs: &["Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s."],
            attribute: "#[inline]",
            signature: &format!(
                "fn place(&self, t: S, u: &Input<S>, x: &[S; {length}], q: &mut [S; {nq}], v: &mut [S; {nq}])"
            ),
            arguments: &["t", "u", "x", "q", "v"],
        },
    );
    write(
        &mut text,
        emission,
        &reduced.project,
        Origin::Pose,
        &Shape {
            docs: &["The joint coordinates and their rates at a pose that closes the joints."],
            attribute: "",
            signature: &format!(
                "fn project(&self, t: S, q: &[S; {nq}], v: &[S; {nq}], x: &mut [S; {length}])"
            ),
            arguments: &["t", "q", "v", "x"],
        },
    );
    text.push_str("    }\n");
    text
}

/// `System` for the joint coordinates, and the pose of a state.
pub(crate) fn system(text: &mut String, emission: &Emission) {
    let Some(reduced) = emission.reduced else { return };
    let Emission { name, equations, .. } = emission;
    let ((length, second_order), n) = (emission.state_length(), reduced.y.len());
    let (nq, nx) = (equations.q.len(), equations.x.len());
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::System for {name}<S> {{
        type S = S;
        type X = [S; {length}];
        type U = Input<S>;
        type G = [S; 0];
        const NQ: usize = {n};

        #[inline]
        fn rate(&self, t: S, u: &Input<S>, x: &[S; {length}], dx: &mut [S; {length}]) -> rt::Health<S> {{
            self.motion(t, u, x, dx);
            rt::Health::perfect()
        }}

        fn typical(&self) -> [S; {length}] {{
            [{}].map(S::lit)
        }}

        fn part_of_state(&self, index: usize) -> &'static str {{
            const PARTS: &[&str] = &[{}];
            match PARTS.get(index) {{
                Some(name) => name,
                None => \"\",
            }}
        }}
    }}

    impl<S: Real> State<S> {{
        /// Pose and velocity of every body.
        #[inline]
        fn pose(&self) -> ([S; {nq}], [S; {nq}]) {{
            let (mut q, mut v) = ([S::lit(0.0); {nq}], [S::lit(0.0); {nq}]);
            self.mechanism.place(self.time, &self.input, &self.x, &mut q, &mut v);
            (q, v)
        }}

        /// The state in absolute coordinates, for reactions.
        fn absolute(&self) -> [S; {absolute}] {{
            let (q, v) = self.pose();
            let mut x = [S::lit(0.0); {absolute}];
            absolute::join(&q, &v, &mut x);
            for k in 0..{nx} {{
                x[{second_absolute} + k] = self.x[{second_order} + k];
            }}
            x
        }}
    }}

",
            sizes(emission, reduced),
            parts(emission, reduced),
            absolute = 2 * nq + nx,
            second_absolute = 2 * nq,
        ),
    );
}

/// Sizes for absolute tolerances: the scene's length for displacements, one radian for angles, both per second for rates.
fn sizes(emission: &Emission, reduced: &Reduced) -> String {
    let length = format!("{:?}", emission.report.length);
    let one = |angle: &bool| if *angle { "1.0".to_owned() } else { length.clone() };
    let mut sizes: Vec<String> = reduced.angles.iter().chain(&reduced.angles).map(one).collect();
    sizes.extend(std::iter::repeat_n("1.0".to_owned(), emission.equations.x.len()));
    sizes.join(", ")
}

/// Names of the parts that the numbers of the state belong to.
fn parts(emission: &Emission, reduced: &Reduced) -> String {
    let quoted = |name: &String| format!("{name:?}");
    let mut names: Vec<String> = reduced.parts.iter().chain(&reduced.parts).map(quoted).collect();
    names.extend(emission.model.states.iter().map(|state| quoted(&state.name.text)));
    names.join(", ")
}

//! A rung above 5: its right-hand side, and the way to absolute coordinates and back.

use super::bodies::{Shape, write};
use super::{Emission, Origin, charts, push, sides, singular, system};
use crate::formulate::{Chart, Function};

/// The straight-line functions.
pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    let Some(reduced) = emission.reduced else { return text };
    push(&mut text, format_args!("\n    impl<S: Scalar> {}<S> {{\n", emission.name));
    match reduced.first() {
        Some(chart) if !reduced.has_loops() => tree(&mut text, emission, chart),
        _ => charts::emit(&mut text, emission, reduced),
    }
    text.push_str("    }\n");
    text
}

fn tree(text: &mut String, emission: &Emission, chart: &Chart) {
    let inputs = emission.inputs("S");
    let ((length, _), nq) = (emission.state_length(), emission.equations.q.len());
    write(
        text,
        emission,
        &chart.rate,
        Origin::Chart(0),
        &Shape {
            docs: &["The right-hand side in joint coordinates."],
            attribute: "#[inline(always)]",
            signature: &format!(
                "fn motion(&self, t: S, u: &{inputs}, x: &[S; {length}], dx: &mut [S; {length}])"
            ),
            arguments: &["t", "u", "x", "dx"],
        },
    );
    write(
        text,
        emission,
        &chart.pose,
        Origin::Chart(0),
        &Shape {
            docs: &["Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s."],
            attribute: "#[inline]",
            signature: &format!(
                "fn place(&self, t: S, u: &{inputs}, x: &[S; {length}], q: &mut [S; {nq}], v: &mut [S; {nq}])"
            ),
            arguments: &["t", "u", "x", "q", "v"],
        },
    );
    if let Some(reactions) = chart.reactions.as_ref().filter(|_| emission.reads_solution()) {
        let nc = emission.equations.phi.len();
        write(
            text,
            emission,
            reactions,
            Origin::Chart(0),
            &Shape {
                docs: &["Accelerations of every body, and the multipliers: `M a + phi_q^T lambda = Q`."],
                attribute: "#[inline]",
                signature: &format!(
                    "fn reactions(&self, t: S, u: &{inputs}, x: &[S; {length}], a: &mut [S; {nq}], lambda: &mut [S; {nc}])"
                ),
                arguments: &["t", "u", "x", "a", "lambda"],
            },
        );
    }
    projection(text, emission, chart, "project");
    let state = format!("t: S, u: &{inputs}, x: &[S; {length}]");
    guards(
        text,
        emission,
        (&chart.guards, Origin::Chart(0)),
        &format!("fn switching(&self, {state}"),
        &["t", "u", "x", "g"],
    );
}

/// How far the conditions are from switching.
pub(crate) fn guards(
    text: &mut String,
    emission: &Emission,
    (function, origin): (&Function, Origin),
    signature: &str,
    arguments: &[&str],
) {
    let count = emission.model.watched();
    if count == 0 {
        return;
    }
    write(
        text,
        emission,
        function,
        origin,
        &Shape {
            docs: &[
                "How far every condition is from switching: positive while the side that is held applies; then what bends where it passes zero.",
            ],
            attribute: "",
            signature: &format!("{signature}, g: &mut [S; {count}])"),
            arguments,
        },
    );
}

/// The coordinates of a chart at a pose.
pub(crate) fn projection(text: &mut String, emission: &Emission, chart: &Chart, name: &str) {
    let ((length, _), nq) = (emission.state_length(), emission.equations.q.len());
    write(
        text,
        emission,
        &chart.project,
        Origin::Pose,
        &Shape {
            docs: &["The joint coordinates and their rates at a pose that closes the joints."],
            attribute: "",
            signature: &format!(
                "fn {name}(&self, t: S, q: &[S; {nq}], v: &[S; {nq}], x: &mut [S; {length}])"
            ),
            arguments: &["t", "q", "v", "x"],
        },
    );
}

/// `System` for the joint coordinates, and the pose of a state.
pub(crate) fn contract(text: &mut String, emission: &Emission) {
    let held = emission.inputs_of_state();
    let Some((reduced, chart)) = emission.reduced.and_then(|reduced| Some((reduced, reduced.first()?)))
    else {
        return;
    };
    let equations = emission.equations;
    let ((length, _), n) = (emission.state_length(), reduced.freedom());
    let nq = equations.q.len();
    let place;
    if reduced.has_loops() {
        charts::charted(text, emission, reduced);
        singular::emit(text, emission);
        system::rate(text, emission, n, &charts::rate(reduced));
        charts::system(text, emission);
        place = "rt::charts::pose(&self.mechanism, self.time, &rt::Moment::held(self), &self.x)".to_owned();
    } else {
        place = format!(
            "let (mut q, mut v) = ([S::lit(0.0); {nq}], [S::lit(0.0); {nq}]);
            self.mechanism.place(self.time, &{held}, &self.x, &mut q, &mut v);
            (q, v)"
        );
        system::rate(text, emission, n, "self.motion(t, u, x, dx);\n            rt::Health::perfect()");
    }
    if reduced.has_loops() {
        let chosen = charts::chosen(reduced, "u.chart", |k| {
            format!("self.switching_{k}(t, &u.input, &u.memory, x, g)")
        });
        let free = "self.switching(t, &u.input, &rt::charts::full(self, t, u, x), g)";
        sides::contract(text, emission, &chosen, Some(free));
    } else {
        sides::contract(text, emission, "self.switching(t, u, x, g)", None);
    }
    system::energy(text, emission);
    push(
        text,
        format_args!(
            "        fn typical(&self) -> [S; {length}] {{
            [{}].map(S::lit)
        }}

        fn part_of_state(&self, index: usize) -> &'static str {{
            const PARTS: &[&str] = &[{}];
            match PARTS.get(index) {{
                Some(name) => name,
                None => \"\",
            }}
        }}
{names}    }}

    impl<S: Real> State<S> {{
        /// Pose and velocity of every body.
        #[inline]
        fn pose_(&self) -> ([S; {nq}], [S; {nq}]) {{
            {place}
        }}
    }}

",
            sizes(emission, chart),
            parts(emission, chart),
            names = system::name_of_state(emission),
        ),
    );
    absolute(text, emission);
}

/// The state in absolute coordinates, which rung 5 gives the reactions of loops at, and equilibria and starts are told in.
fn absolute(text: &mut String, emission: &Emission) {
    let Emission { equations, .. } = emission;
    let (nq, nx) = (equations.q.len(), equations.x.len());
    let (_, second_order) = emission.state_length();
    push(
        text,
        format_args!(
            "    impl<S: Real> State<S> {{
        /// The state in absolute coordinates.
        fn absolute_(&self) -> [S; {absolute}] {{
            let (q, v) = self.pose_();
            let mut x = [S::lit(0.0); {absolute}];
            absolute::join(&q, &v, &mut x);
            for k in 0..{nx} {{
                x[{second_absolute} + k] = self.x[{second_order} + k];
            }}
            x
        }}
    }}

",
            absolute = 2 * nq + nx,
            second_absolute = 2 * nq,
        ),
    );
}

/// Sizes for absolute tolerances: the scene's length for displacements, one radian for angles, both per second for
/// rates, one of its unit for a state.
fn sizes(emission: &Emission, chart: &Chart) -> String {
    let length = format!("{:?}", emission.report.length);
    let one = |angle: &bool| if *angle { "1.0".to_owned() } else { length.clone() };
    let mut sizes: Vec<String> = chart.angles.iter().chain(&chart.angles).map(one).collect();
    sizes.extend(emission.model.states.iter().map(system::unit_of_state));
    sizes.join(", ")
}

/// Names of the parts that the numbers of the state belong to.
fn parts(emission: &Emission, chart: &Chart) -> String {
    let quoted = |name: &String| format!("{name:?}");
    let mut names: Vec<String> = chart.parts.iter().chain(&chart.parts).map(quoted).collect();
    names.extend(emission.model.states.iter().map(|state| quoted(&state.name.text)));
    names.join(", ")
}

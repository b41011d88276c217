//! A mechanism at rest, and a moment as start values.

use super::bodies::{Shape, write};
use super::{Emission, Origin, defaults, docs, push};
use crate::formulate::coordinate_name;

/// Statements of a block; rustc recurses over longer ones.
const MOST_LINES: usize = 200;

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    at_rest(&mut text, emission);
    start_values(&mut text, emission);
    placed(&mut text, emission);
    contract(&mut text, emission);
    text
}

/// Forces and rates where nothing accelerates.
fn at_rest(text: &mut String, emission: &Emission) {
    let inputs = emission.inputs("S");
    let (nq, nc, nx, length) = sizes(emission);
    push(text, format_args!("    impl<S: Scalar> {}<S> {{\n", emission.name));
    write(
        text,
        emission,
        &emission.program.at_rest,
        Origin::Arguments,
        &Shape {
            docs: &[
                "Applied forces `Q` (N, N, N m per body) and rates of the first-order states, without accelerations.",
            ],
            attribute: "#[cold]",
            signature: &format!(
                "fn at_rest(&self, t: S, u: &{inputs}, x: &[S; {length}], lambda: &[S; {nc}], force: &mut [S; {nq}], x_dot: &mut [S; {nx}])"
            ),
            arguments: &["t", "u", "x", "lambda", "force", "x_dot"],
        },
    );
    text.push_str("    }\n\n");
}

/// `StartValues`: names and values one by one, and as text.
fn start_values(text: &mut String, emission: &Emission) {
    let Emission { model, fields, .. } = emission;
    let bodies = model.bodies.iter().zip(&fields.bodies).map(|(body, field)| {
        let names =
            ["x", "y", "angle", "vx", "vy", "omega"].map(|value| format!("{}.{value}", body.name.text));
        format!("            self.{field}.each({names:?}, &mut *each);\n")
    });
    let states = model.states.iter().zip(&fields.states);
    let states =
        states.map(|(state, field)| format!("            each({:?}, &mut self.{field});\n", state.name.text));
    let lines: Vec<String> = bodies.chain(states).collect();
    let blocks: Vec<String> = lines.chunks(MOST_LINES).map(<[String]>::concat).collect();
    let lines = blocks.join("            }\n            {\n");
    push(
        text,
        format_args!(
            "    impl<S: Scalar> rt::StartValues<S> for Starts<S> {{
        fn each(&mut self, each: &mut impl FnMut(&'static str, &mut Start<S>)) {{
            {{
{lines}            }}
        }}
    }}

    impl<S: Scalar> core::fmt::Display for Starts<S> {{
        fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {{
            rt::start::write_starts(*self, f)
        }}
    }}

"
        ),
    );
}

/// Start values of a state in absolute coordinates.
fn placed(text: &mut String, emission: &Emission) {
    let Emission { model, fields, name, .. } = emission;
    let (nq, _, _, length) = sizes(emission);
    let bindings = emission.parameters();
    let mut lines = String::new();
    for (k, (body, field)) in model.bodies.iter().zip(&fields.bodies).enumerate() {
        let [x, y] =
            body.centre.components().map(|component| defaults::inline(emission, component, &bindings));
        let (q, v) = (3 * k, nq + 3 * k);
        let triple = |first: usize| format!("[x[{first}], x[{}], x[{}]]", first + 1, first + 2);
        push(
            &mut lines,
            format_args!(
                "                {field}: self.start.{field}.with_centre_at([{x}, {y}], {}, {}),\n",
                triple(q),
                triple(v)
            ),
        );
    }
    for (k, field) in fields.states.iter().enumerate() {
        let value = 2 * nq + k;
        push(
            &mut lines,
            format_args!("                {field}: Start {{ value: x[{value}], ..self.start.{field} }},\n"),
        );
    }
    let absolute = if emission.reduced.is_some() { "self.absolute_()" } else { "self.x" };
    push(
        text,
        format_args!(
            "    impl<S: Real> {name}<S> {{
        fn placed(&self, x: &[S; {length}]) -> Starts<S> {{
            let lit = S::lit;
            Starts {{
{lines}            }}
        }}
    }}

    impl<S: Real> State<S> {{
        /// Poses, velocities and states of this moment as start values, with the locks that are set: to go on from here
        /// later, `mechanism.start = sim.starts()`.
        pub fn starts(&self) -> Starts<S> {{
            self.mechanism.placed(&{absolute})
        }}
    }}

"
        ),
    );
}

/// `Statics`.
fn contract(text: &mut String, emission: &Emission) {
    let Emission { model, name, .. } = emission;
    let (nq, nc, nx, length) = sizes(emission);
    let coordinates: Vec<String> = (0..nq).map(|k| format!("{:?}", coordinate_name(model, k))).collect();
    let rows: Vec<String> = model.rows.iter().map(|row| format!("{:?}", row.name)).collect();
    let states = model.states.iter();
    let states = states.map(|state| format!("({:?}, {:?})", state.name.text, docs::si(&state.unit)));
    let states: Vec<String> = states.collect();
    let absolute = if emission.reduced.is_some() { "state.absolute_()" } else { "state.x" };
    let given = match (emission.has_sides(), emission.loops().is_some()) {
        (false, false) => "*held",
        (false, true) => "held.input",
        (true, false) => "Held { input: held.input, ..self.declared_input() }",
        (true, true) => "Held { input: held.input.input, ..self.declared_input() }",
    };
    let (held, input) = if emission.loops().is_some() { ("held", "&held.input") } else { ("held", "held") };
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::Statics for {name}<S> {{
        type Full = [S; {length}];
        type Rows = [S; {nc}];
        type Starts = Starts<S>;
        const COORDINATES: &'static [&'static str] = &[{coordinates}];
        const ROWS: &'static [&'static str] = &[{rows}];
        const STATES: &'static [(&'static str, &'static str)] = &[{states}];

        fn full(state: &State<S>) -> [S; {length}] {{
            {absolute}
        }}
        fn equations(&self, t: S, {held}: &Self::U, x: &[S; {length}], lambda: &[S; {nc}], each: &mut impl FnMut(S)) {{
            let (q, v): ([S; {nq}], [S; {nq}]) = absolute::split(x);
            let (mut force, mut x_dot) = ([S::lit(0.0); {nq}], [S::lit(0.0); {nx}]);
            self.at_rest(t, {input}, x, lambda, &mut force, &mut x_dot);
            absolute::balance::<S, Self, NQ, NC>(self, t, &q, lambda, &force).into_iter().for_each(&mut *each);
            absolute::residuals::<S, Self, NQ, NC, {length}>(self, t, x, each);
            x_dot.into_iter().for_each(each);
        }}
        fn start_with_inputs(&self, t: S, held: &Self::U) -> Result<(Self::U, Self::X), Fault> {{
            self.start_holding_(t, {given})
        }}
        fn starts_mut(&mut self) -> &mut Starts<S> {{
            &mut self.start
        }}
        fn starts_at(&self, x: &[S; {length}]) -> Starts<S> {{
            self.placed(x)
        }}
        fn size(&self) -> S {{
            absolute::Absolute::<S, NQ, NC>::length(self)
        }}
    }}

",
            coordinates = coordinates.join(", "),
            rows = rows.join(", "),
            states = states.join(", "),
        ),
    );
}

/// Coordinates, constraint rows, first-order states, and numbers in a state in absolute coordinates.
fn sizes(emission: &Emission) -> (usize, usize, usize, usize) {
    let equations = emission.equations;
    let (nq, nx) = (equations.q.len(), equations.x.len());
    (nq, equations.phi.len(), nx, 2 * nq + nx)
}

//! Conditions whose sides are held over a step: guards, switches, known times.

use super::bodies::{Shape, write};
use super::{Emission, Origin, push};
use crate::model::Model;

/// The straight-line functions that do not depend on the chart.
pub(crate) fn instants(text: &mut String, emission: &Emission) {
    let inputs = emission.inputs("S");
    row_jumps(text, emission);
    let count = emission.model.sides.len() - emission.model.guards();
    if count == 0 {
        return;
    }
    push(text, format_args!("\n    impl<S: Scalar> {}<S> {{\n", emission.name));
    write(
        text,
        emission,
        &emission.program.instants,
        Origin::Arguments,
        &Shape {
            docs: &["Times at which conditions change, s, and the slope of what they compare."],
            attribute: "#[cold]",
            signature: &format!(
                "fn instants(&self, u: &{inputs}, at: &mut [S; {count}], slope: &mut [S; {count}])"
            ),
            arguments: &["u", "at", "slope"],
        },
    );
    text.push_str("    }\n");
}

/// What rows do where conditions in them change.
fn row_jumps(text: &mut String, emission: &Emission) {
    let (count, nq) = (5 * emission.model.jumps.len(), emission.equations.q.len());
    if count == 0 {
        return;
    }
    push(text, format_args!("\n    impl<S: Scalar> {}<S> {{\n", emission.name));
    write(
        text,
        emission,
        &emission.program.jumps,
        Origin::Pose,
        &Shape {
            docs: &[
                "How rows differ on both sides of conditions: residual, rate, its rate; the distance, its rate.",
            ],
            attribute: "#[cold]",
            signature: &format!(
                "fn jumps(&self, t: S, q: &[S; {nq}], v: &[S; {nq}], jump: &mut [S; {count}])"
            ),
            arguments: &["t", "q", "v", "jump"],
        },
    );
    text.push_str("    }\n");
}

/// What `System` says of them; `call` is the call of the guards' function with `g` as its last argument, `free` that of a
/// state that no chart holds, where there may be one.
pub(crate) fn contract(text: &mut String, emission: &Emission, call: &str, free: Option<&str>) {
    let (length, _) = emission.state_length();
    let input = emission.input();
    if emission.model.watched() > 0 {
        watched(text, emission, (call, free), length);
    }
    if emission.model.guards() > 0 {
        switches(text, emission, length);
    }
    known_times(text, emission, input);
    jumps(text, emission);
}

/// What is looked at in every step: guards and kinks, at a time and over an interval.
fn watched(text: &mut String, emission: &Emission, (call, free): (&str, Option<&str>), length: usize) {
    let (guards, kinks, all) =
        (emission.model.guards(), emission.model.kinks.len(), emission.model.watched());
    let within = call.replace("self.", "mechanism.");
    let here = free.map_or_else(
        || call.to_owned(),
        |free| format!("if rt::charts::is_free::<Self>(u) {{ {free} }} else {{ {call} }}"),
    );
    // Without a chart the state stands in what is held, and does not move with `x`.
    let only = free.map_or("", |_| {
        "if rt::charts::is_free::<Self>(u) {
                return false;
            }
            "
    });
    let held = emission.held("rt::Tube<S>");
    push(
        text,
        format_args!(
            "        const KINKS: usize = {kinks};

        fn guards(&self, t: S, u: &Self::U, x: &[S; {length}], g: &mut [S; {guards}]) {{
            let mut all = [S::lit(0.0); {all}];
            let out = g;
            let g = &mut all;
            {here};
            for (guard, value) in out.iter_mut().zip(all) {{
                *guard = value;
            }}
        }}

        fn kinks(&self, t: S, u: &Self::U, x: &[S; {length}], each: &mut impl FnMut(usize, S)) {{
            let mut all = [S::lit(0.0); {all}];
            let g = &mut all;
            {here};
            for (index, value) in all.into_iter().skip({guards}).enumerate() {{
                each(index, value);
            }}
        }}

        fn guards_within(
            &self,
            t: rt::Tube<S>,
            u: &Self::U,
            x: &impl Fn(usize) -> rt::Tube<S>,
            each: &mut impl FnMut(usize, rt::Tube<S>),
        ) -> bool {{
            {only}use rt::lanes::Pack;
            let constant = |[s]: [S; 1]| rt::Tube::constant(s);
            let (mechanism, held) = (self.pack([self], constant), Self::pack_held(u, [u], constant));
            let mut tubes = [rt::Tube::constant(S::lit(0.0)); {all}];
            let within = |u: &{held}, x: &[rt::Tube<S>; {length}], g: &mut [rt::Tube<S>; {all}]| {within};
            within(&held, &core::array::from_fn(x), &mut tubes);
            for (index, tube) in tubes.into_iter().enumerate() {{
                each(index, tube);
            }}
            true
        }}

"
        ),
    );
}

/// What `System` says of the sides that depend on the state.
fn switches(text: &mut String, emission: &Emission, length: usize) {
    let (guards, input) = (emission.model.guards(), emission.input());
    let names = emission.model.sides.iter().take(guards).map(|side| format!("{:?}", side.name));
    let (required, only) = requirements(emission.model);
    push(
        text,
        format_args!(
            "{required}        fn switch(&self, _t: S, u: &mut Self::U, _x: &[S; {length}], index: usize) {{
            {only}if let Some(side) = {input}.sides.get_mut(index) {{
                *side = -*side;
            }}
        }}

        fn guard_name(&self, index: usize) -> &'static str {{
            const NAMES: [&str; {guards}] = [{}];
            NAMES.get(index).copied().unwrap_or_default()
        }}

",
            names.collect::<Vec<_>>().join(", ")
        ),
    );
}

/// `must_hold`, and what keeps `switch` away from such conditions.
fn requirements(model: &Model) -> (String, &'static str) {
    let of_state = model.sides.iter().filter(|side| side.instant.is_none());
    let required = of_state.enumerate().filter(|(_, side)| side.must_hold);
    let indices: Vec<String> = required.map(|(index, _)| index.to_string()).collect();
    if indices.is_empty() {
        return Default::default();
    }
    let method = format!(
        "        fn must_hold(&self, index: usize) -> bool {{
            matches!(index, {})
        }}

",
        indices.join(" | ")
    );
    (method, "if self.must_hold(index) {\n                return;\n            }\n            ")
}

fn known_times(text: &mut String, emission: &Emission, input: &str) {
    let guards = emission.model.guards();
    let count = emission.model.sides.len() - guards;
    if count == 0 {
        return;
    }
    push(
        text,
        format_args!(
            "        fn next_instant(&self, t: S, u: &Self::U) -> Option<S> {{
            let (mut at, mut slope) = ([S::lit(0.0); {count}], [S::lit(0.0); {count}]);
            self.instants(&{input}, &mut at, &mut slope);
            at.into_iter().filter(|at| *at > t).reduce(S::min)
        }}

        fn pass(&self, t: S, u: &mut Self::U) {{
            let (mut at, mut slope) = ([S::lit(0.0); {count}], [S::lit(0.0); {count}]);
            self.instants(&{input}, &mut at, &mut slope);
            for ((side, at), slope) in {input}.sides.iter_mut().skip({guards}).zip(at).zip(slope) {{
                *side = if (at <= t) == (slope > S::lit(0.0)) {{ S::lit(1.0) }} else {{ S::lit(-1.0) }};
            }}
        }}

"
        ),
    );
}

/// Rows that may jump; those that are known to are errors.
fn jumps(text: &mut String, emission: &Emission) {
    let jumps = &emission.model.jumps;
    if jumps.is_empty() {
        return;
    }
    let ((length, _), count, nq) = (emission.state_length(), jumps.len(), emission.equations.q.len());
    let places: Vec<String> = jumps.iter().map(|jump| format!("({}, {})", jump.row, jump.side)).collect();
    let (u, after) = if emission.loops().is_some() { ("u.input", "after.input") } else { ("u", "after") };
    let pose = if emission.reduced.is_some() {
        "<State<S> as rt::Moment>::new(*self, *u, t, *x).pose_()"
    } else {
        "absolute::split(x)"
    };
    push(
        text,
        format_args!(
            "        #[cold]
        fn jump(&self, t: S, u: &Self::U, x: &[S; {length}], after: Option<&Self::U>) -> Option<Fault> {{
            const JUMPS: [(usize, usize); {count}] = [{places}];
            let (q, v): ([S; {nq}], [S; {nq}]) = {pose};
            let mut jump = [S::lit(0.0); {terms}];
            self.jumps(t, &q, &v, &mut jump);
            let (terms, _) = jump.as_chunks::<5>();
            let crossings = JUMPS.iter().zip(terms).filter_map(|(&(row, side), &terms)| {{
                let changes = after.is_some_and(|after| {after}.sides[side] != {u}.sides[side]);
                (changes || after.is_none()).then_some(absolute::Crossing {{ row, terms, changes }})
            }});
            absolute::jump::<S, Self, NQ, NC>(self, t, (&q, &v), crossings)
        }}

",
            places = places.join(", "),
            terms = 5 * count,
        ),
    );
}

/// Holds the sides that apply at the start, in `start_state`.
pub(crate) fn begin(emission: &Emission) -> &'static str {
    match (emission.model.guards(), emission.model.sides.len()) {
        (_, 0) => "",
        (0, _) => "            rt::System::pass(self, t, &mut held);\n",
        _ => {
            "            rt::System::pass(self, t, &mut held);
            rt::events::switch_where_due(self, t, &mut held, &x);\n"
        }
    }
}

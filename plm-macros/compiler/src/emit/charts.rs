//! Rungs 3 and 4: the functions of every chart, and what the runtime asks of them.

use super::bodies::{Shape, write};
use super::{Emission, Origin, push, reduced};
use crate::formulate::{Chart, Reduced};

/// The straight-line functions of all charts, and those that choose among them.
pub(crate) fn emit(text: &mut String, emission: &Emission, reduced: &Reduced) {
    for (index, chart) in reduced.charts.iter().enumerate() {
        functions(text, emission, reduced, index, chart);
    }
}

fn functions(text: &mut String, emission: &Emission, reduced: &Reduced, index: usize, chart: &Chart) {
    let inputs = emission.inputs("S");
    let (length, _) = emission.state_length();
    let (nq, memory) = (emission.equations.q.len(), reduced.memory_length);
    let state = format!("t: S, u: &{inputs}, m: &[S; {memory}], x: &[S; {length}]");
    let named = chart.names.join(", ");
    // The first chart is the one that runs, the others hardly ever do.
    let attribute = if index == 0 { "#[inline(always)]" } else { "#[inline(never)]" };
    write(
        text,
        emission,
        &chart.rate,
        Origin::Chart(index),
        &Shape {
            docs: &[
                &format!("The right-hand side in the coordinates {named}."),
                "Returns the smallest square of a dyad's measure.",
            ],
            attribute,
            signature: &format!("fn motion_{index}(&self, {state}, dx: &mut [S; {length}]) -> S"),
            arguments: &["t", "u", "m", "x", "dx"],
        },
    );
    write(
        text,
        emission,
        &chart.pose,
        Origin::Chart(index),
        &Shape {
            docs: &["Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s."],
            attribute: "",
            signature: &format!(
                "fn place_{index}(&self, {state}, q: &mut [S; {nq}], v: &mut [S; {nq}]) -> S"
            ),
            arguments: &["t", "u", "m", "x", "q", "v"],
        },
    );
    reduced::guards(
        text,
        emission,
        (&chart.guards, Origin::Chart(index)),
        &format!("fn switching_{index}(&self, {state}"),
        &["t", "u", "m", "x", "g"],
    );
    reduced::projection(text, emission, chart, &format!("project_{index}"));
    if let Some(look) = &chart.look {
        write(
            text,
            emission,
            look,
            Origin::Chart(index),
            &Shape {
                docs: &["What is to be remembered of a state, and the smallest square of a dyad's measure."],
                attribute: "",
                signature: &format!("fn look_{index}(&self, {state}, memory: &mut [S; {memory}]) -> S"),
                arguments: &["t", "u", "m", "x", "memory"],
            },
        );
    }
    if let Some(survey) = &chart.survey {
        write(
            text,
            emission,
            survey,
            Origin::Pose,
            &Shape {
                docs: &["The same of a pose and velocity."],
                attribute: "#[cold]",
                signature: &format!(
                    "fn survey_{index}(&self, t: S, q: &[S; {nq}], v: &[S; {nq}], memory: &mut [S; {memory}]) -> S"
                ),
                arguments: &["t", "q", "v", "memory"],
            },
        );
    }
}

/// The rate in the chart that is held.
pub(crate) fn rate(reduced: &Reduced) -> String {
    let rate = chosen(reduced, "u.chart", |k| match k {
        0 => "self.motion_0(t, &u.input, &u.memory, x, dx)".to_owned(),
        // A copy goes through memory, so that the arrays of the first chart stay in registers.
        _ => format!(
            "{{ let (at, mut out) = (*x, *dx); let measure = self.motion_{k}(t, &u.input, &u.memory, &at, &mut out); *dx = out; measure }}"
        ),
    });
    format!("rt::Health({rate})")
}

/// What `System` does besides the rate, `typical` and `part_of_state`.
pub(crate) fn system(text: &mut String, emission: &Emission) {
    let (length, _) = emission.state_length();
    push(
        text,
        format_args!(
            "        #[cold]
        fn rate_by_rank(&self, t: S, u: &Self::U, x: &[S; {length}], dx: &mut [S; {length}]) -> Result<(), Fault> {{
            if rt::System::rate(self, t, u, x, dx).is_good() {{ Ok(()) }} else {{ Err(rt::charts::not_regular(self, t, u, x)) }}
        }}

        fn is_regular(&self, u: &Self::U) -> bool {{
            !rt::charts::is_free::<Self>(u)
        }}

        #[inline]
        fn accept(&self, t: S, u: &mut Self::U, x: &mut [S; {length}]) -> Result<rt::Accepted, Fault> {{
            rt::charts::accept(self, t, u, x)
        }}

"
        ),
    );
}

/// The runtime's view of the charts.
pub(crate) fn charted(text: &mut String, emission: &Emission, reduced: &Reduced) {
    let inputs = emission.inputs("S");
    let (length, _) = emission.state_length();
    let (nq, memory) = (emission.equations.q.len(), reduced.memory_length);
    let turning: Vec<String> = reduced.turning.iter().map(|name| format!("{name:?}")).collect();
    let followed: Vec<String> = reduced.followed.iter().map(|name| format!("{name:?}")).collect();
    let closing = reduced.charts.iter().map(|chart| {
        let names: Vec<String> = chart.closing.iter().map(|part| format!("{part:?}")).collect();
        format!("&[{}]", names.join(", "))
    });
    let closing: Vec<String> = closing.collect();
    let place = chosen(reduced, "held.chart", |k| {
        format!("self.place_{k}(t, &held.input, &held.memory, x, &mut q, &mut v)")
    });
    let look = chosen(reduced, "held.chart", |k| {
        format!("self.look_{k}(t, &held.input, &held.memory, x, &mut memory)")
    });
    let chart = if reduced.charts.len() == 1 { "_chart" } else { "chart" };
    let survey = chosen(reduced, "chart", |k| format!("self.survey_{k}(t, q, v, &mut memory)"));
    let project = chosen(reduced, "chart", |k| format!("self.project_{k}(t, q, v, x)"));
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::charts::Charted for {name}<S> {{
        type Input = {inputs};
        type Memory = [S; {memory}];
        type Q = [S; {nq}];
        const CHARTS: usize = {charts};
        const BEFORE_AREAS: usize = {before};
        const TURNING: &'static [&'static str] = &[{turning}];
        const BEFORE_FOLLOWED: usize = {before_followed};
        const FOLLOWED: &'static [&'static str] = &[{followed}];
        const CLOSING: &'static [&'static [&'static str]] = &[{closing}];

        fn place(&self, t: S, held: &Self::U, x: &[S; {length}]) -> ([S; {nq}], [S; {nq}], S) {{
            let (mut q, mut v) = ([S::lit(0.0); {nq}], [S::lit(0.0); {nq}]);
            let measure = {place};
            (q, v, measure)
        }}
        fn look(&self, t: S, held: &Self::U, x: &[S; {length}]) -> ([S; {memory}], S) {{
            let mut memory = [S::lit(0.0); {memory}];
            let measure = {look};
            (memory, measure)
        }}
        fn survey(&self, {chart}: usize, t: S, q: &[S; {nq}], v: &[S; {nq}]) -> ([S; {memory}], S) {{
            let mut memory = [S::lit(0.0); {memory}];
            let measure = {survey};
            (memory, measure)
        }}
        fn project(&self, {chart}: usize, t: S, q: &[S; {nq}], v: &[S; {nq}], x: &mut [S; {length}]) {{
            {project}
        }}
    }}

",
            name = emission.name,
            charts = reduced.charts.len(),
            before = reduced.before_areas,
            before_followed = reduced.before_followed,
            turning = turning.join(", "),
            followed = followed.join(", "),
            closing = closing.join(", "),
        ),
    );
}

/// A call that depends on the chart; none to choose from costs nothing.
pub(crate) fn chosen(reduced: &Reduced, chart: &str, call: impl Fn(usize) -> String) -> String {
    let count = reduced.charts.len();
    if count == 1 {
        return call(0);
    }
    let arms = (0..count).map(|k| {
        let pattern = if k == count - 1 { "_".to_owned() } else { k.to_string() };
        format!("{pattern} => {}", call(k))
    });
    format!("match {chart} {{ {} }}", arms.collect::<Vec<_>>().join(", "))
}

//! The mechanism that can be started, and its state at a moment.

use super::{Emission, limits, push, sides, singular};

/// `Moment` for the state and `Mechanism` for the mechanism.
pub(crate) fn emit(text: &mut String, emission: &Emission) {
    let name = &emission.name;
    let (length, second_order) = emission.state_length();
    let loops = emission.loops().is_some();
    let inputs = emission.inputs_of_state();
    let held = if loops {
        format!("rt::charts::Held {{ input: {inputs}, chart: self.chart, memory: self.memory }}")
    } else {
        inputs.to_owned()
    };
    // What the state keeps of what is held, field by field.
    let mut kept = match (emission.has_sides(), loops) {
        (false, false) => vec![("input", "held")],
        (false, true) => vec![("input", "held.input")],
        (true, false) => vec![("input", "held.input"), ("sides", "held.sides")],
        (true, true) => vec![("input", "held.input.input"), ("sides", "held.input.sides")],
    };
    if loops {
        kept.extend([("chart", "held.chart"), ("memory", "held.memory")]);
    }
    let named: Vec<String> = kept.iter().map(|(field, value)| format!("{field}: {value}")).collect();
    let set: Vec<String> =
        kept.iter().map(|(field, value)| format!("            self.{field} = {value};\n")).collect();
    let (fields_kept, set) = (named.join(", "), set.concat());
    let held_type = emission.held("S");
    let rescue = singular::rescue(emission);
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::Moment for State<S> {{
        type M = {name}<S>;

        fn new(mechanism: {name}<S>, held: {held_type}, time: S, x: [S; {length}]) -> Self {{
            State {{ mechanism, time, x, {fields_kept} }}
        }}
        fn mechanism(&self) -> &{name}<S> {{
            &self.mechanism
        }}
        fn held(&self) -> {held_type} {{
            {held}
        }}
        fn time(&self) -> S {{
            self.time
        }}
        fn x(&self) -> &[S; {length}] {{
            &self.x
        }}
        fn set(&mut self, time: S, held: &{held_type}, x: &[S; {length}]) {{
            let held = *held;
            self.time = time;
{set}            self.x = *x;
        }}
    }}

    impl<S: Real> rt::Mechanism for {name}<S> {{
        type State = State<S>;
        type Rescue = {rescue};
        const WORKSPACE: usize = rt::workspace::of::<S, NQ, NC>();

        fn start_state(&self, t: S) -> Result<({held_type}, [S; {length}]), Fault> {{
            self.start_holding_(t, self.declared_input())
        }}

",
        ),
    );
    limits::emit(text, emission);
    text.push_str("    }\n\n");
    start(text, emission, (length, second_order));
}

/// The assembled state with inputs.
fn start(text: &mut String, emission: &Emission, (length, second_order): (usize, usize)) {
    push(
        text,
        format_args!(
            "    impl<S: Real> {name}<S> {{
        fn start_holding_(&self, t: S, input: {inputs}) -> Result<({held}, [S; {length}]), Fault> {{
{check}            let assembly = absolute::assemble(self, t)?;
{carried}            let mut x = [S::lit(0.0); {length}];
",
            name = emission.name,
            inputs = emission.inputs("S"),
            held = emission.held("S"),
            check = limits::call(emission),
            carried = limits::carried(emission),
        ),
    );
    for (k, field) in emission.fields.states.iter().enumerate() {
        push(text, format_args!("            x[{}] = self.start.{field}.value;\n", second_order + k));
    }
    text.push_str(&begin(emission));
    text.push_str("        }\n    }\n\n");
}

/// What ends a start at which rows repeat others although the charts count on all of them: they would leave out a freedom.
const REPEATS: &str = "            if assembly.redundant.contains(&true) {
                let joints = rt::Names::marked(&<Self as absolute::Absolute<S, NQ, NC>>::PARTS, &assembly.redundant);
                return Err(Fault::new(rt::Scalar::to_f64(t), rt::Cause::Repeats { joints }));
            }
";

/// From the assembled pose to the state.
fn begin(emission: &Emission) -> String {
    let sides = sides::begin(emission);
    if let Some(reduced) = emission.loops() {
        return format!(
            "            let memory = [S::lit(0.0); {}];
{repeats}            let mut held = rt::charts::Held {{ input, chart: 0, memory }};
            rt::charts::enter(self, t, &mut held, (&assembly.q, &assembly.v), &mut x);
{sides}            Ok((held, x))
",
            reduced.memory_length,
            repeats = if reduced.is_redundant() { "" } else { REPEATS },
        );
    }
    let call = if emission.reduced.is_some() {
        "self.project(t, &assembly.q, &assembly.v, &mut x)"
    } else {
        "absolute::join(&assembly.q, &assembly.v, &mut x)"
    };
    let mutable = if sides.is_empty() { "" } else { "mut " };
    format!("            {call};\n            let {mutable}held = input;\n{sides}            Ok((held, x))\n")
}

//! A mechanism in other numbers, for derivatives and for lanes, and its inputs and outputs by number.
//!
//! All of it is generic: nothing is compiled where nobody asks for it.

use super::{Emission, augmented, docs, push};

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    pack(&mut text, emission);
    lift(&mut text, emission);
    ports(&mut text, emission);
    text
}

/// `Pack`: every number of a mechanism and of what it holds, made of those of several.
fn pack(text: &mut String, emission: &Emission) {
    let Emission { fields, name, .. } = emission;
    let held = emission.held("S");
    let bodies = each(&fields.bodies, |_, field| {
        format!("                {field}: self.start.{field}.map(|s| number([s; N])),\n")
    });
    let states = each(&fields.states, |_, field| {
        format!("                {field}: self.start.{field}.map(|s| number([s; N])),\n")
    });
    let params = each(&fields.params, |_, field| {
        format!("                {field}: number(all.map(|one| one.{field})),\n")
    });
    let from = if emission.loops().is_some() { "held.input" } else { "held" };
    let to_fields = emission.to_fields();
    let inputs = if fields.inputs.is_empty() {
        "                none: core::marker::PhantomData,\n".to_owned()
    } else {
        each(&fields.inputs, |_, field| {
            format!("                {field}: number(all.map(|held| {from}{to_fields}.{field})),\n")
        })
    };
    let sides = if emission.has_sides() {
        format!(
            "            let sides = core::array::from_fn(|k| number(all.map(|held| {from}.sides[k])));
            let input = Held {{ input, sides }};\n"
        )
    } else {
        String::new()
    };
    let (first, wrapped, calm) = if emission.loops().is_some() {
        (
            "first",
            "let memory = core::array::from_fn(|k| number(all.map(|held| held.memory[k])));
            rt::charts::Held { input, chart: first.chart, memory }",
            "rt::charts::is_calm::<Self>(t, held, x)
        }

        fn chart(held: &Self::U) -> usize {
            held.chart",
        )
    } else {
        ("_", "input", "let _ = (t, held, x);\n            true")
    };
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::lanes::Pack for {name}<S> {{
        type Packed<T: Scalar> = {name}<T>;

        #[allow(unused_variables)] // where there are no parameters
        fn pack<T: Scalar, const N: usize>(&self, all: [&Self; N], number: impl Fn([S; N]) -> T) -> {name}<T> {{
            let start = Starts {{
{bodies}{states}            }};
            {name} {{
                start,
{params}            }}
        }}

        #[allow(unused_variables)] // where there are no inputs
        fn pack_held<T: Scalar, const N: usize>({first}: &{held}, all: [&{held}; N], number: impl Fn([S; N]) -> T) -> {packed} {{
            let input = Input {{
{inputs}            }};
{sides}            {wrapped}
        }}

        #[inline]
        fn is_calm(t: S, held: &{held}, x: &Self::X) -> bool {{
            {calm}
        }}
    }}

",
            packed = emission.held("T"),
        ),
    );
}

/// `Linear`: the mechanism and what it holds as constants with derivatives.
fn lift(text: &mut String, emission: &Emission) {
    let name = &emission.name;
    let (length, _) = emission.state_length();
    let (derivatives, differentiate) = augmented::derivatives(emission);
    let (held, lifted) = (emission.held("S"), emission.held("rt::Dual<S, K>"));
    let constraints = if emission.reduced.is_some() {
        String::new()
    } else {
        format!(
            "
        fn constraints(&self, t: S, x: &[S; {length}], row: &mut impl FnMut(S)) {{
            absolute::residuals::<S, Self, NQ, NC, {length}>(self, t, x, row);
        }}
"
        )
    };
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::Linear for {name}<S> {{
        type Lifted<const K: usize> = {name}<rt::Dual<S, K>>;
        type Derivatives = {derivatives};

        fn lift<const K: usize>(&self, held: &{held}) -> ({name}<rt::Dual<S, K>>, {lifted}) {{
            use rt::lanes::Pack;
            let constant = |[s]: [S; 1]| rt::Dual::constant(s);
            (self.pack([self], constant), Self::pack_held(held, [held], constant))
        }}
{constraints}{differentiate}    }}

"
        ),
    );
}

/// `Ports`: inputs and outputs in the order of the declaration.
fn ports(text: &mut String, emission: &Emission) {
    let Emission { model, fields, name, .. } = emission;
    let names =
        model.inputs.iter().map(|input| format!("({:?}, {:?})", input.name.text, docs::si(&input.unit)));
    let names: Vec<String> = names.collect();
    let input = if emission.loops().is_some() { "held.input" } else { "held" };
    let held = emission.held("S");
    let to_fields = emission.to_fields();
    let arms = each(&fields.inputs, |k, field| {
        format!("                {k} => Some(&mut {input}{to_fields}.{field}),\n")
    });
    push(
        text,
        format_args!(
            "    impl<S: Real> rt::Ports for {name}<S> {{
        const INPUTS: &'static [(&'static str, &'static str)] = &[{}];
        const OUTPUTS: &'static [(&'static str, &'static str)] = &State::<S>::OUTPUTS;

        fn input(held: &mut {held}, index: usize) -> Option<&mut S> {{
            match index {{
{arms}                _ => None,
            }}
        }}

        fn outputs(state: &State<S>, each: &mut impl FnMut(S)) {{
            for output in state.outputs() {{
                each(output);
            }}
        }}
    }}

",
            names.join(", ")
        ),
    );
}

/// A line for every field.
fn each(fields: &[String], line: impl Fn(usize, &str) -> String) -> String {
    let lines: Vec<String> = fields.iter().enumerate().map(|(k, field)| line(k, field)).collect();
    lines.concat()
}

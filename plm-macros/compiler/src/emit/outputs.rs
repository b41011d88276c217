//! What can be read from a state: poses, the user's outputs, energies.

use super::lines;
use super::{Emission, Origin, blocks, docs, families, push};
use crate::formulate::Function;
use crate::model;
use crate::units::DisplayUnit;

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::from("    impl<S: Real> State<S> {\n");
    text.push_str(
        "        /// Time, s.\n        pub fn time(&self) -> S {\n            self.time\n        }\n\n",
    );
    poses(&mut text, emission);
    let bindings = emission.bindings(Origin::State);
    for index in 0..emission.model.outputs.len() {
        user_output(&mut text, emission, &bindings, index);
    }
    let outputs = &emission.program.outputs;
    let energies = [
        ("kinetic_energy", "Kinetic energy of all bodies, J.", &outputs.kinetic_energy),
        ("gravity_energy", "Potential energy of gravity above the origin, J.", &outputs.gravity_energy),
        ("load_power", "Power of all forces and torques but gravity and reactions, W.", &outputs.load_power),
    ];
    for (name, doc, function) in energies {
        push(&mut text, format_args!("        /// {doc}\n        pub fn {name}(&self) -> S {{\n"));
        text.push_str(&function_body(emission, &bindings, function));
        text.push_str("        }\n\n");
    }
    families::emit(&mut text, emission);
    branches(&mut text, emission, &bindings);
    table(&mut text, emission);
    if emission.model.outputs.iter().any(|output| !output.declared) {
        observed(&mut text, emission);
    }
    text.push_str("    }\n\n");
    text
}

fn poses(text: &mut String, emission: &Emission) {
    let Emission { model, fields, equations, .. } = emission;
    let nq = equations.q.len();
    for (k, (body, field)) in model.bodies.iter().zip(&fields.bodies).enumerate() {
        let (q, v, i, j) = if emission.reduced.is_some() {
            ("q", "v", 3 * k, 3 * k)
        } else {
            ("self.x", "self.x", 3 * k, nq + 3 * k)
        };
        push(
            text,
            format_args!(
                "        /// Pose and velocity of G of body `{}`: m, m, rad; m/s, m/s, rad/s.
        pub fn {field}(&self) -> BodyState<S> {{
{}            BodyState::of([{q}[{i}], {q}[{}], {q}[{}]], [{v}[{j}], {v}[{}], {v}[{}]])
        }}

",
                body.name.text,
                emission.pose_line(),
                i + 1,
                i + 2,
                j + 1,
                j + 2
            ),
        );
    }
}

fn user_output(text: &mut String, emission: &Emission, bindings: &lines::Bindings, index: usize) {
    let output: &model::Output = &emission.model.outputs[index];
    let laid_out = &emission.program.outputs.user[index];
    let name = &emission.fields.outputs[index];
    let unit = docs::si(&output.unit);
    let count = output.components.len();
    let kind = if count == 1 { "S".to_owned() } else { format!("[S; {count}]") };
    let what = if output.declared { "Output" } else { "Observed:" };
    push(text, format_args!("        /// {what} `{}`, {unit}.\n", output.name.text));
    if !output.docs.is_empty() {
        push(text, format_args!("        ///\n        /// {}\n", output.docs));
    }
    push(text, format_args!("        pub fn {name}(&self) -> {kind} {{\n"));
    if laid_out.solves {
        text.push_str("            let (a, lambda) = self.solved_();\n");
    }
    if count > 1 {
        push(text, format_args!("            let mut value = [S::lit(0.0); {count}];\n"));
    }
    text.push_str(&function_body(emission, bindings, &laid_out.function));
    text.push_str(if count > 1 { "            value\n        }\n\n" } else { "        }\n\n" });
}

fn function_body(emission: &Emission, bindings: &lines::Bindings, function: &Function) -> String {
    let reserved = ["lit", "value", "a", "lambda", "q", "v"];
    let lines = lines::lower(function, bindings, &reserved);
    format!("{}{}", emission.pose_line(), blocks::with_literals(&lines, 12))
}

/// The turns that tell the mirror images of loops apart.
fn branches(text: &mut String, emission: &Emission, bindings: &lines::Bindings) {
    let Emission { model, equations, program, .. } = emission;
    let count = equations.branches.len();
    let joints = equations
        .branches
        .iter()
        .enumerate()
        .map(|(k, branch)| format!("({:?}, value[{k}])", model.parts[branch.part].name.text));
    let joints: Vec<String> = joints.collect();
    push(
        text,
        format_args!(
            "        /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
        /// the second turns from the first, rad, positive to the left.
        pub fn branches(&self) -> [(&'static str, S); {count}] {{
            let mut value = [S::lit(0.0); {count}];
{}            [{}]
        }}

",
            function_body(emission, bindings, &program.outputs.branches),
            joints.join(", ")
        ),
    );
}

/// The outputs as a row of a table, with names and units.
fn table(text: &mut String, emission: &Emission) {
    let columns = columns_of(emission, "self", Columns::Declared);
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    let values: Vec<&str> = columns.iter().map(|(_, value)| value.as_str()).collect();
    push(
        text,
        format_args!(
            "        /// Names and units of the columns of [`State::outputs`].
        pub const OUTPUTS: [(&'static str, &'static str); {count}] = [{}];

        /// The declared outputs, in the units of [`State::OUTPUTS`].
        pub fn outputs(&self) -> [S; {count}] {{
            [{}]
        }}
",
            names.join(", "),
            values.join(", "),
            count = columns.len()
        ),
    );
}

/// All that can be read by name, and the reading of it by number: a match in blocks, as everything that is long.
fn observed(text: &mut String, emission: &Emission) {
    const BLOCK: usize = 200;
    let columns = columns_of(emission, "state", Columns::All);
    push(
        text,
        format_args!(
            "
        /// Names and SI units of the outputs and of all that is observed.
        pub const OBSERVED: [(&'static str, &'static str); {}] = [
",
            columns.len()
        ),
    );
    for (name, _) in &columns {
        push(text, format_args!("            {name},\n"));
    }
    text.push_str(
        "        ];

        /// The quantities of these names; `Err` with the first that is not in [`State::OBSERVED`].
        pub fn find<'n, const K: usize>(names: [&'n str; K]) -> Result<[rt::Observed; K], &'n str> {
            rt::Observed::find(&Self::OBSERVED, names)
        }

        /// The values of these quantities, SI; each is worked out when it is asked for.
        pub fn observed<const K: usize>(&self, quantities: [rt::Observed; K]) -> [S; K] {
",
    );
    let mut blocks = String::new();
    for (block, chunk) in columns.chunks(BLOCK).enumerate() {
        push(
            &mut blocks,
            format_args!("                {block} => block_{block}(self, quantity.column()),\n"),
        );
        push(
            text,
            format_args!(
                "            fn block_{block}<S: Real>(state: &State<S>, column: usize) -> S {{\n                match column {{\n"
            ),
        );
        for (k, (_, value)) in chunk.iter().enumerate() {
            push(text, format_args!("                    {} => {value},\n", block * BLOCK + k));
        }
        text.push_str("                    _ => S::lit(f64::NAN),\n                }\n            }\n");
    }
    push(
        text,
        format_args!(
            "            quantities.map(|quantity| match quantity.column() / {BLOCK} {{
{blocks}                _ => S::lit(f64::NAN),
            }})
        }}
"
        ),
    );
}

/// Which outputs make columns, and in which units.
#[derive(Clone, Copy, PartialEq)]
enum Columns {
    /// Those that are declared, in the units that they ask for.
    Declared,
    /// Those and what is observed, in SI.
    All,
}

/// Name with unit, and how `state` reads it, of each number of the outputs that are asked for.
fn columns_of(emission: &Emission, state: &str, wanted: Columns) -> Vec<(String, String)> {
    let mut columns = Vec::new();
    let outputs = emission.model.outputs.iter().zip(&emission.fields.outputs);
    for (output, accessor) in outputs.filter(|(output, _)| wanted == Columns::All || output.declared) {
        let shown = wanted == Columns::Declared;
        let unit = if shown { output.unit.clone() } else { DisplayUnit::si(output.unit.dimension) };
        let scale = unit.factor.to_f64();
        let read = |value: String| if scale == 1.0 { value } else { format!("{value} / S::lit({scale:?})") };
        if output.components.len() == 1 {
            columns.push((column(&output.name.text, &unit.text), read(format!("{state}.{accessor}()"))));
        } else {
            for (axis, k) in ["x", "y"].into_iter().zip(0..) {
                let name = column(&format!("{}.{axis}", output.name.text), &unit.text);
                columns.push((name, read(format!("{state}.{accessor}()[{k}]"))));
            }
        }
    }
    columns
}

fn column(name: &str, unit: &str) -> String {
    format!("({name:?}, {unit:?})")
}

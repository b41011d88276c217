//! What can be read from a state: poses, the user's outputs, energies.

use super::lines;
use super::{Emission, Origin, blocks, docs, push};
use crate::formulate::Function;
use crate::model;

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::from("    impl<S: Real> State<S> {\n");
    text.push_str(
        "        /// Time, s.\n        pub fn time(&self) -> S {\n            self.time\n        }\n\n",
    );
    poses(&mut text, emission);
    for index in 0..emission.model.outputs.len() {
        user_output(&mut text, emission, index);
    }
    let outputs = &emission.program.outputs;
    let energies = [
        ("kinetic_energy", "Kinetic energy of all bodies, J.", &outputs.kinetic_energy),
        ("gravity_energy", "Potential energy of gravity above y = 0, J.", &outputs.gravity_energy),
        ("load_power", "Power of all forces and torques but gravity and reactions, W.", &outputs.load_power),
    ];
    for (name, doc, function) in energies {
        push(&mut text, format_args!("        /// {doc}\n        pub fn {name}(&self) -> S {{\n"));
        text.push_str(&function_body(emission, function));
        text.push_str("        }\n\n");
    }
    branches(&mut text, emission);
    table(&mut text, emission);
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
{}            BodyState {{ x: {q}[{i}], y: {q}[{}], angle: {q}[{}], vx: {v}[{j}], vy: {v}[{}], omega: {v}[{}] }}
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

fn user_output(text: &mut String, emission: &Emission, index: usize) {
    let output: &model::Output = &emission.model.outputs[index];
    let laid_out = &emission.program.outputs.user[index];
    let name = &emission.fields.outputs[index];
    let unit = docs::si(&output.unit);
    let count = output.components.len();
    let kind = if count == 1 { "S".to_owned() } else { format!("[S; {count}]") };
    push(text, format_args!("        /// Output `{}`, {unit}.\n", output.name.text));
    push(text, format_args!("        pub fn {name}(&self) -> {kind} {{\n"));
    if laid_out.solves {
        text.push_str("            let (a, lambda) = self.solved();\n");
    }
    if count > 1 {
        push(text, format_args!("            let mut value = [S::lit(0.0); {count}];\n"));
    }
    text.push_str(&function_body(emission, &laid_out.function));
    text.push_str(if count > 1 { "            value\n        }\n\n" } else { "        }\n\n" });
}

fn function_body(emission: &Emission, function: &Function) -> String {
    let bindings = emission.bindings(Origin::State);
    let reserved = ["lit", "value", "a", "lambda", "q", "v"];
    let lines = lines::lower(emission.graph, function, &bindings, &reserved);
    format!("{}{}", emission.pose_line(), blocks::with_literals(&lines, 12))
}

/// The turns that tell the mirror images of loops apart.
fn branches(text: &mut String, emission: &Emission) {
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
            function_body(emission, &program.outputs.branches),
            joints.join(", ")
        ),
    );
}

/// The outputs as a row of a table, with names and units.
fn table(text: &mut String, emission: &Emission) {
    let mut names = Vec::new();
    let mut values = Vec::new();
    for (output, accessor) in emission.model.outputs.iter().zip(&emission.fields.outputs) {
        let scale = output.unit.factor.to_f64();
        let read = |value: String| if scale == 1.0 { value } else { format!("{value} / S::lit({scale:?})") };
        if output.components.len() == 1 {
            names.push(column(&output.name.text, output));
            values.push(read(format!("self.{accessor}()")));
        } else {
            for (axis, k) in ["x", "y"].into_iter().zip(0..) {
                names.push(column(&format!("{}.{axis}", output.name.text), output));
                values.push(read(format!("self.{accessor}()[{k}]")));
            }
        }
    }
    let count = names.len();
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
            values.join(", ")
        ),
    );
}

fn column(name: &str, output: &model::Output) -> String {
    format!("({name:?}, {:?})", output.unit.text)
}

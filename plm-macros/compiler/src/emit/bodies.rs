//! The straight-line functions: dynamics and constraints.

use super::lines::{self, Lines};
use super::{Emission, Origin, blocks, push, reduced};
use crate::formulate::Function;

pub(crate) fn emit(emission: &Emission) -> String {
    let mut text = String::new();
    if emission.reactions().is_none() {
        equations_of_motion(&mut text, emission);
    }
    constraints(&mut text, emission);
    text
}

/// `dynamics`, and what the rank-revealing fallback needs.
fn equations_of_motion(text: &mut String, emission: &Emission) {
    let inputs = emission.inputs("S");
    let Emission { name, equations, program, .. } = emission;
    let (nq, nc, nx) = (equations.q.len(), equations.phi.len(), equations.x.len());
    let length = 2 * nq + nx;
    push(text, format_args!("    impl<S: Scalar> {name}<S> {{\n"));
    let state = format!("t: S, u: &{inputs}, x: &[S; {length}]");
    write(
        text,
        emission,
        &program.dynamics,
        Origin::Arguments,
        &Shape {
            docs: &[
                "The right-hand side and the multipliers: `M a + phi_q^T lambda = Q`, `phi_q a = gamma`.",
                "Returns the smallest pivot ratio of the factorisation.",
            ],
            attribute: "#[inline(always)]",
            signature: &format!(
                "fn dynamics(&self, {state}, dx: &mut [S; {length}], lambda: &mut [S; {nc}]) -> S"
            ),
            arguments: &["t", "u", "x", "dx", "lambda"],
        },
    );
    write(
        text,
        emission,
        &program.free,
        Origin::Arguments,
        &Shape {
            docs: &["Applied forces `Q` (N, N, N m per body) and `gamma`, for the rank-revealing solution."],
            attribute: "#[cold]",
            signature: &format!("fn free(&self, {state}, force: &mut [S; {nq}], gamma: &mut [S; {nc}])"),
            arguments: &["t", "u", "x", "force", "gamma"],
        },
    );
    if nx > 0 {
        first_order(text, emission);
    }
    if emission.reduced.is_none() || emission.loops().is_some() {
        let of = (&program.guards, Origin::Arguments);
        reduced::guards(text, emission, of, &format!("fn switching(&self, {state}"), &["t", "u", "x", "g"]);
    }
    text.push_str("    }\n\n");
}

/// `x_dot`.
fn first_order(text: &mut String, emission: &Emission) {
    let inputs = emission.inputs("S");
    let Emission { equations, program, .. } = emission;
    let (length, nx) = (2 * equations.q.len() + equations.x.len(), equations.x.len());
    write(
        text,
        emission,
        &program.x_dot,
        Origin::Arguments,
        &Shape {
            docs: &["Rates of the first-order states."],
            attribute: "#[cold]",
            signature: &format!(
                "fn x_dot(&self, t: S, u: &{inputs}, x: &[S; {length}], x_dot: &mut [S; {nx}])"
            ),
            arguments: &["t", "u", "x", "x_dot"],
        },
    );
}

/// The constraints as functions of the pose, which assembly and projection call.
fn constraints(text: &mut String, emission: &Emission) {
    let Emission { name, equations, program, .. } = emission;
    let (nq, nc, entries) = (equations.q.len(), equations.phi.len(), program.phi_q.results.len());
    push(text, format_args!("    impl<S: Scalar> {name}<S> {{\n"));
    write(
        text,
        emission,
        &program.phi,
        Origin::Pose,
        &Shape {
            docs: &["Residuals of the constraints, m or rad; the rows stand in the table of this module."],
            attribute: "",
            signature: &format!("fn residual(&self, t: S, q: &[S; {nq}], phi: &mut [S; {nc}])"),
            arguments: &["t", "q", "phi"],
        },
    );
    write(
        text,
        emission,
        &program.phi_dot,
        Origin::Pose,
        &Shape {
            docs: &["Their rates, `phi_q v - nu`, m/s or rad/s."],
            attribute: "",
            signature: &format!(
                "fn residual_rate(&self, t: S, q: &[S; {nq}], v: &[S; {nq}], phi_dot: &mut [S; {nc}])"
            ),
            arguments: &["t", "q", "v", "phi_dot"],
        },
    );
    write(
        text,
        emission,
        &program.phi_q,
        Origin::Pose,
        &Shape {
            docs: &["The Jacobian of the constraints: its entries that are not zero, row by row."],
            attribute: "#[cold]",
            signature: &format!("fn jacobian(&self, t: S, q: &[S; {nq}], phi_q: &mut [S; {entries}])"),
            arguments: &["t", "q", "phi_q"],
        },
    );
    write(
        text,
        emission,
        &program.min_norm,
        Origin::Pose,
        &Shape {
            docs: &[
                "The shortest step in the norm of `W^-1` that closes `r`: `dq = W phi_q^T (phi_q W phi_q^T)^-1 r`.",
                "Returns the smallest pivot ratio of the factorisation.",
            ],
            attribute: "",
            signature: &format!(
                "fn closing_step(&self, t: S, q: &[S; {nq}], w: &[S; {nq}], r: &[S; {nc}], dq: &mut [S; {nq}]) -> S"
            ),
            arguments: &["t", "q", "w", "r", "dq"],
        },
    );
    write(
        text,
        emission,
        &program.inverse_mass,
        Origin::Pose,
        &Shape {
            docs: &["Diagonal of `M^-1`: 1/kg, 1/kg, 1/(kg m^2) per body."],
            attribute: "",
            signature: &format!("fn reciprocal_mass(&self, inverse_mass: &mut [S; {nq}])"),
            arguments: &["inverse_mass"],
        },
    );
    text.push_str("    }\n");
}

/// What surrounds the statements of a function.
pub(super) struct Shape<'a> {
    pub(super) docs: &'a [&'a str],
    pub(super) attribute: &'a str,
    pub(super) signature: &'a str,
    pub(super) arguments: &'a [&'a str],
}

pub(super) fn write(
    text: &mut String,
    emission: &Emission,
    function: &Function,
    origin: Origin,
    shape: &Shape,
) {
    let mut reserved = vec!["lit"];
    reserved.extend(shape.arguments);
    let lines: Lines = lines::lower(function, &emission.bindings(origin), &reserved);
    for doc in shape.docs {
        push(text, format_args!("        /// {doc}\n"));
    }
    if lines.count.total() > 0 {
        push(text, format_args!("        ///\n        /// {}.\n", lines.count));
    }
    if !shape.attribute.is_empty() {
        push(text, format_args!("        {}\n", shape.attribute));
    }
    push(text, format_args!("        {} {{\n", shape.signature));
    text.push_str(&blocks::with_literals(&lines, 12));
    text.push_str("        }\n\n");
}

//! CUDA C: the C source of a mechanism with the qualifiers of a device, and many mechanisms side by side, each by a thread. What is
//! compiled for a GPU is what a C compiler compiles, so that both have the same operations in the same order.

use std::fmt::Write as _;

use plm_compiler::lowered::Form;
use plm_dynamic::Mechanism;

use crate::contact::where_wanted;
use crate::plan::Plan;
use crate::template::{fill, indented};
use crate::{Failure, File, Precision, names};

const HEADER: &str = include_str!("batch.h.txt");
const BATCH: &str = include_str!("batch.c.txt");
const RUN: &str = include_str!("run.c.txt");

/// The qualifier of a device, for who includes the header alone.
const DEVICE: &str = "#ifndef __CUDACC_RTC__\n#include <stddef.h>\n#include <stdint.h>\n#elif !defined(NULL)\n#define NULL 0\n#endif\n\n#ifndef PLM_DEVICE\n#ifdef __CUDACC__\n\
    #define PLM_DEVICE __device__\n#else\n#define PLM_DEVICE\n#endif\n#endif\n";
const INCLUDES: &str = "#include <stddef.h>\n#include <stdint.h>\n";

/// CUDA C of a mechanism with the values that its parameters, inputs and start values have: the source of [`c`](crate::c), which a C
/// compiler takes as well, kernels over a structure of arrays that start and step one mechanism a thread, and a program that runs them.
///
/// # Errors
/// Those of [`c`](crate::c).
pub fn cuda(mechanism: &Mechanism, precision: Precision) -> Result<Vec<File>, Failure> {
    let [header, source, math] = crate::printed(mechanism, precision)?;
    let steps = mechanism.steps().map_err(Failure::Start)?;
    let plan = Plan::new(mechanism, &steps, precision);
    let (p, words) = (&plan.name, words(&plan));
    let filled = |template: &str| names::without_hiding(&fill(template, &words), p);
    let header = File { text: on_device(&header.text, p).replace(INCLUDES, DEVICE), ..header };
    let source = File { text: on_device(&source.text, p), ..source };
    let unit = format!(
        "/* {}: all that a GPU runs, as one text for nvcc or NVRTC, with -fmad=false. */\n#include \"{p}.c\"\n#include \"{p}_batch.c\"\n",
        plan.lowered.name
    );
    let own = [
        (format!("{p}_batch.h"), filled(HEADER)),
        (format!("{p}_batch.c"), filled(BATCH)),
        (format!("{p}.cu"), unit),
        (format!("{p}_run.c"), filled(RUN)),
    ];
    let own = own.map(|(name, text)| File { name, text });
    Ok([header, source, math].into_iter().chain(own).collect())
}

/// Functions that a compiler for GPUs leaves apart, so that registers are those of what always runs.
const APART: [&str; 4] = ["arrive", "complement", "motion_in", "split"];

/// A text of the mechanism `p` whose functions and tables have the qualifiers of a device. They stand at the beginning of a line, and
/// nothing else that begins with these words does.
fn on_device(text: &str, p: &str) -> String {
    let is_definition =
        |line: &str| ["static ", "int ", "void ", "const char "].iter().any(|word| line.starts_with(word));
    let is_apart = |line: &str| APART.iter().any(|name| line.contains(&format!(" {p}_{name}(")));
    let mut all = String::with_capacity(text.len());
    for line in text.lines() {
        let qualifiers = match is_definition(line) {
            true if is_apart(line) => "PLM_DEVICE PLM_APART ",
            true => "PLM_DEVICE ",
            false => "",
        };
        let _ = writeln!(all, "{qualifiers}{line}");
    }
    all
}

/// An array of the batch, one of the object for each mechanism.
struct Array {
    kind: &'static str,
    name: &'static str,
    /// Numbers a mechanism.
    count: usize,
    /// Is it one number of the object, no array?
    is_single: bool,
    docs: &'static str,
}

/// The arrays, in their order.
fn arrays(plan: &Plan) -> Vec<Array> {
    let (counts, start) = (&plan.counts, &plan.start);
    let single = |kind, name, docs| Array { kind, name, count: 1, is_single: true, docs };
    let array = |kind, name, count, docs| Array { kind, name, count, is_single: false, docs };
    let mut all = vec![
        single("@real@", "time", "s"),
        single("@real@", "left_out", "what rounding has left out of the time, s"),
        array("@real@", "x", plan.length("x"), "coordinates, their velocities, first-order states"),
        array("@real@", "parameter", start.parameters.len(), "by PLM_PARAMETER"),
        array("@real@", "input", start.inputs.len(), "by PLM_INPUT"),
        array("@real@", "side", start.sides.len(), "of each condition"),
        array("@real@", "memory", counts.memory, "of the loops"),
        array("int32_t", "turns", counts.turns, "whole revolutions of angles"),
        array("int", "mode", counts.places, "of each row of contact"),
        array("int", "carried", counts.places, "is the row at rest by others?"),
        array("int", "negative", counts.places, "is a reaction that bounds frictions negative?"),
        array("@real@", "place", counts.places, "at which a friction sticks, m or rad"),
    ];
    if plan.is_loops() {
        all.push(single("int", "chart", "the coordinates that are in use"));
    }
    if counts.places > 0 {
        all.push(single("@real@", "residual", "of the last step, m/s or rad/s"));
    }
    all.retain(|array| array.count > 0);
    all
}

/// May states be written: is there nothing that has been derived of them?
fn is_free(plan: &Plan) -> bool {
    let lowered = plan.lowered;
    lowered.form == Form::Tree && lowered.contacts.is_none() && lowered.switches.all.is_empty()
}

/// The words of the templates.
fn words(plan: &Plan) -> Vec<(&'static str, String)> {
    let [mut fields, mut load, mut keep, mut room] = [const { String::new() }; 4];
    for Array { kind, name, count, is_single, docs } in arrays(plan) {
        // Writing to a text cannot fail.
        let _ = writeln!(fields, "    {kind} *{name}; /* {count} each: {docs} */");
        let of = if kind == "@real@" { "numbers" } else { "integers" };
        let cast = if kind == "int32_t" { "(int32_t *)" } else { "" };
        let _ = writeln!(room, "    all.{name} = {cast}{of}(count, {count}u);");
        if is_single {
            let _ = writeln!(load, "    self->{name} = all->{name}[n];");
            let _ = writeln!(keep, "    all->{name}[n] = self->{name};");
        } else {
            let each = |line: &str| {
                format!("    for (k = 0u; k < {count}u; k++) {{\n        {line}\n    }}\n")
                    .replace("NAME", name)
            };
            load.push_str(&each("self->NAME[k] = all->NAME[k * all->count + n];"));
            // Those who call write these.
            if !matches!(name, "parameter" | "input") {
                keep.push_str(&each("all->NAME[k * all->count + n] = self->NAME[k];"));
            }
        }
    }
    let (outputs, parameters) = (plan.outputs().count(), plan.start.parameters.len());
    let states_too = if is_free(plan) { "; so may x" } else { "" };
    vec![
        ("fields", fields),
        ("load", load),
        ("keep", keep),
        ("room", room),
        ("fixed", given(plan, GET)),
        ("looked_at", given(plan, SET)),
        ("out", out(outputs)),
        ("vary", where_wanted(parameters > 0, &VARY.replace("COUNT", &parameters.to_string()))),
        ("said", said("x", plan.counts.states) + &said("out", outputs)),
        ("index", where_wanted(plan.counts.states + outputs + parameters > 0, ", k")),
        ("outputs", outputs.to_string()),
        ("places_out", format!("{}u", outputs.max(1))),
        ("states_too", states_too.to_owned()),
        ("up", plan.upper.clone()),
        ("p", plan.name.clone()),
        ("real", if plan.precision == Precision::Single { "float" } else { "double" }.to_owned()),
    ]
}

/// Lines that write the numbers of an array of a mechanism.
fn said(array: &str, count: usize) -> String {
    let each = "        for (k = 0u; k < COUNTu; k++) {
            (void)printf(\" %a\", (double)all.ARRAY[k * count + n]);
        }
";
    where_wanted(count > 0, &each.replace("COUNT", &count.to_string()).replace("ARRAY", array))
}

/// Loops over parameters and inputs of a mechanism: all are written at the start ([`GET`]), and looked at before steps ([`SET`]).
fn given(plan: &Plan, template: &str) -> String {
    let kinds = [
        ("PARAMETER", "parameter", plan.start.parameters.len()),
        ("INPUT", "input", plan.start.inputs.len()),
    ];
    let mut text = String::new();
    for (kind, name, count) in kinds.into_iter().filter(|(_, _, count)| *count > 0) {
        let may_be_fixed = kind == "PARAMETER" && plan.is_fixed.contains(&true);
        let read_only = where_wanted(may_be_fixed, &indented(READ_ONLY, 12));
        text.push_str(
            &template
                .replace("READ_ONLY\n", &read_only)
                .replace("KIND", kind)
                .replace("NAME", name)
                .replace("COUNT", &count.to_string()),
        );
    }
    text
}

/// Parameters that the start fixes are told as well.
const GET: &str = "    {
        size_t k;
        for (k = 0u; k < COUNTu; k++) {
            @real@ value = 0;
            (void)@p@_get(&self, PLM_KIND, k, &value);
            all->NAME[k * all->count + n] = value;
        }
    }
";
/// A number that can be set is set to itself, which looks at it.
const SET: &str = "    {
        size_t k;
        for (k = 0u; (k < COUNTu) && (status == PLM_OK); k++) {
            const @real@ given = all->NAME[k * all->count + n];
            status = @p@_set(self, PLM_KIND, k, given);
READ_ONLY
        }
    }
";
const READ_ONLY: &str = "if (status == PLM_READ_ONLY) {
    @real@ fixed = 0;
    (void)@p@_get(self, PLM_PARAMETER, k, &fixed);
    status = ((fixed < given) || (given < fixed)) ? PLM_READ_ONLY : PLM_OK;
}
";

/// Outputs after the steps; after an error those of the state before it.
fn out(outputs: usize) -> String {
    if outputs == 0 {
        return String::new();
    }
    let text = "    {
        @real@ out[COUNT];
        const int status = @p@_outputs(&self, out);
        for (k = 0; (k < COUNT) && (status == PLM_OK); k++) {
            all->out[(size_t)k * all->count + n] = out[k];
        }
        if (self.status == PLM_OK) {
            self.status = status;
        }
    }
";
    text.replace("COUNT", &outputs.to_string())
}

/// A parameter that grows over the mechanisms.
const VARY: &str = "    for (k = 4u; k + 2u < (size_t)words; k += 3u) {
        const size_t row = (size_t)strtoul(word[k], NULL, 10);
        const @real@ first = (@real@)strtod(word[k + 1u], NULL), last = (@real@)strtod(word[k + 2u], NULL);
        for (n = 0u; (n < count) && (row < COUNTu); n++) {
            const @real@ share = (count > 1u) ? ((@real@)n / (@real@)(count - 1u)) : 0;
            const @real@ part = share * (last - first);
            all.parameter[row * count + n] = first + part;
        }
    }
";

#[cfg(test)]
mod tests {
    use super::on_device;

    #[test]
    fn functions_and_tables_are_of_a_device() {
        let text = "static const int a[1] = { 0 };\nint b_f(void)\n{\n    static const int c = 0;\n    return c;\n}\ntypedef int d;\nstatic int b_arrive(int k)\n";
        let own = "PLM_DEVICE static const int a[1] = { 0 };\nPLM_DEVICE int b_f(void)\n{\n    static const int c = 0;\n    return c;\n}\ntypedef int d;\n\
                   PLM_DEVICE PLM_APART static int b_arrive(int k)\n";
        assert_eq!(on_device(text, "b"), own);
    }
}

//! Functions of a source that read and set numbers: outputs, and all numbers by kind and index.

use std::fmt::Write as _;

use plm_compiler::Source;
use plm_compiler::lowered::{OutputValue, Target};

use crate::Precision;
use crate::block::{Argument, Block};
use crate::dialect::Dialect as _;
use crate::function::Signature;
use crate::numbers::numbers;
use crate::plan::Plan;
use crate::source::{CAUSES, parts};
use crate::template::{fill, indented};

const OUTPUTS: &str = include_str!("c/outputs.c.txt");
const RATE: &str = include_str!("c/rate.c.txt");
const KINDS: &str = include_str!("c/kinds.c.txt");

/// Accelerations and multipliers of a tree.
const REACTIONS: Signature =
    Signature { reads: &["x"], writes: &["a", "lambda"], returns: false, is_forced: true };
/// Accelerations and multipliers by the equations in absolute coordinates.
const SOLVED: Signature =
    Signature { reads: &["full"], writes: &["a", "lambda"], returns: true, is_forced: true };
const VALUES: Signature =
    Signature { reads: &["x", "q", "v"], writes: &["out"], returns: false, is_forced: true };
const SOLVED_VALUES: Signature =
    Signature { reads: &["x", "q", "v", "a", "lambda"], writes: &["out"], returns: false, is_forced: true };
const ENERGY: Signature = Signature { reads: &["x", "q", "v"], writes: &[], returns: true, is_forced: false };
const LIMITED: Signature = Signature { reads: &[], writes: &["values"], returns: false, is_forced: false };

/// The function of all outputs; none without outputs.
pub(crate) fn outputs(plan: &Plan) -> String {
    let count = plan.outputs().count();
    let mut text = energy(plan);
    if count == 0 {
        return text;
    }
    let solves = plan.solves();
    let (block, results) = values(plan);
    let signature = if solves { SOLVED_VALUES } else { VALUES };
    text.push_str(&plan.function("values", &block, &results, signature));
    let [mut solve, mut solution, mut solved] = [const { String::new() }; 3];
    let forced = if plan.reads_forces() { ", force" } else { "" };
    if plan.reads_forces() {
        let _ = writeln!(solution, "    plm_real force[{}];", plan.counts.places);
        solved.push_str("    @p@_forces(self, force);\n");
    }
    if solves {
        solution.push_str("    plm_real a[@of_bodies@], lambda[@rows@];\n");
        let own = plan.lowered.charts.first().and_then(|chart| chart.reactions.as_ref());
        if let Some(reactions) = own.filter(|_| !plan.is_loops()) {
            solve.push_str(&plan.of_routine("solve", reactions, REACTIONS));
            let _ = writeln!(solved, "    @p@_solve(self, self->time, self->x{forced}, a, lambda);");
        } else {
            let (block, results) = solution_of_loops(plan);
            solve.push_str(&plan.function("solve", &block, &results, SOLVED));
            solution.push_str("    plm_real full[@full@];\n    int k;\n");
            solved.push_str(&SOLVE_LOOPS.replace("full, a", &format!("full{forced}, a")));
        }
    }
    let with_solution = format!("{}{forced}", if solves { ", a, lambda" } else { "" });
    let words = [
        ("solve", solve),
        ("solution", solution),
        ("solved", solved),
        ("with_solution", with_solution),
        ("outputs", count.to_string()),
    ];
    text.push_str(&fill(&fill(OUTPUTS, &words), &common(plan)));
    text
}

/// Accelerations and multipliers where loops move: the state in absolute coordinates is filled, then solved.
const SOLVE_LOOPS: &str = "    for (k = 0; k < @of_bodies@; k++) {\n        full[k] = q[k];\n        full[@of_bodies@ + k] = v[k];\n    }\n    \
    for (k = 2 * @nq@; k < @n@; k++) {\n        full[2 * @of_bodies@ + k - 2 * @nq@] = self->x[k];\n    }\n    \
    if (!(@healthy@ < @p@_solve(self, self->time, full, a, lambda))) {\n        return PLM_POSE;\n    }\n";

/// The values of the declared outputs.
pub(crate) fn values(plan: &Plan) -> (Block, Vec<(Target, crate::block::Value)>) {
    let mut block = plan.block();
    let mut results = Vec::new();
    for (k, (_, output)) in plan.outputs().enumerate() {
        let Some(of) = plan.lowered.values.get(output.value) else { continue };
        let own = block.routine(&of.value, |block, source| plan.read(block, source));
        let own = own.into_iter().filter(|(target, _)| OutputValue::is_component(*target, output.component));
        results.extend(own.map(|(_, value)| (Target::Element("out", k), value)));
    }
    (block, results)
}

/// Accelerations and multipliers by the equations in absolute coordinates, whose state is the array `full`.
pub(crate) fn solution_of_loops(plan: &Plan) -> (Block, Vec<(Target, crate::block::Value)>) {
    let mut block = plan.block();
    let results = block.routine(&plan.lowered.absolute.dynamics, |block, source| match source {
        Source::Element("x", k) => block.argument(Argument::Element("full", k)),
        source => plan.read(block, source),
    });
    let bodies = plan.counts.of_bodies;
    let accelerations = results.into_iter().filter_map(|(target, value)| match target {
        Target::Element("dx", k) if (bodies..2 * bodies).contains(&k) => {
            Some((Target::Element("a", k - bodies), value))
        }
        Target::Element("dx", _) => None,
        target => Some((target, value)),
    });
    (block, accelerations.collect())
}

/// Kinetic and gravity energy, where they are known.
fn energy(plan: &Plan) -> String {
    if !plan.lowered.has_energy {
        return String::new();
    }
    let absolute = &plan.lowered.absolute;
    let mut text = plan.of_routine("kinetic", &absolute.kinetic_energy, ENERGY);
    text.push_str(&plan.of_routine("gravity", &absolute.gravity_energy, ENERGY));
    let function = "void @p@_energy(const @p@ *self, @real@ *kinetic, @real@ *gravity)\n{\n    \
        plm_real q[@of_bodies@], v[@of_bodies@];\n    \
        (void)@p@_pose_in(self, self->time, self->x, q, v);\n    \
        *kinetic = @p@_kinetic(self, self->time, self->x, q, v);\n    \
        *gravity = @p@_gravity(self, self->time, self->x, q, v);\n}\n\n";
    text.push_str(&fill(function, &common(plan)));
    text
}

/// Words that many templates have.
fn common(plan: &Plan) -> Vec<(&'static str, String)> {
    let counts = &plan.counts;
    let sizes = [
        ("states", plan.length("x")),
        ("n", counts.states),
        ("nq", counts.coordinates),
        ("of_bodies", plan.length("q")),
        ("bodies", plan.lowered.bodies.len()),
        ("rows", plan.length("lambda")),
        ("full", plan.length("full")),
    ];
    let mut all: Vec<(&'static str, String)> = sizes.map(|(word, size)| (word, size.to_string())).into();
    all.extend(numbers(plan));
    all.push(("p", plan.name.clone()));
    all.push(("real", if plan.precision == Precision::Single { "float" } else { "double" }.to_owned()));
    all
}

/// Functions of the start, and of numbers by kind and index.
pub(crate) fn functions(plan: &Plan) -> String {
    let (mut texts, count) = (String::new(), CAUSES.len() + parts(plan).len());
    let all = CAUSES.iter().map(|cause| (*cause).to_owned()).chain(parts(plan));
    all.for_each(|cause| {
        let _ = writeln!(texts, "        {},", quoted(&cause));
    });
    let words = [
        ("init", init(plan)),
        ("rate", if plan.has_own_rate() { RATE } else { "" }.to_owned()),
        ("whole", whole(plan)),
        ("get", get(plan)),
        ("limits", limits(plan)),
        ("set", set(plan)),
        ("text", texts),
        ("texts", count.to_string()),
    ];
    fill(&fill(KINDS, &words), &common(plan))
}

/// A text as a literal of C.
pub(crate) fn quoted(text: &str) -> String {
    let plain =
        text.chars().map(|letter| if letter.is_ascii() && !letter.is_ascii_control() { letter } else { '?' });
    format!("\"{}\"", plain.collect::<String>().replace('\\', "\\\\").replace('"', "\\\""))
}

/// The mode of a row of contact; one that others carry is closed, or sticks.
const OF_CONTACT: &str = "*value = (@real@)self->mode[index];\nif (self->carried[index]) {\n    \
    *value = (@real@)((self->mode[index] <= PLM_CLOSED) ? PLM_CLOSED : PLM_STICKS);\n}\nreturn PLM_OK;\n";

/// The numbers of the start.
fn init(plan: &Plan) -> String {
    let (c, start) = (plan.c(), &plan.start);
    let mut text = String::new();
    let mut put = |place: String, value: String| {
        let _ = writeln!(text, "    self->{place} = {value};");
    };
    put("time".to_owned(), c.number(start.time));
    let memory = crate::check::memory(plan);
    for (array, numbers) in [
        ("x", &start.x),
        ("parameter", &start.parameters),
        ("input", &start.inputs),
        ("side", &start.sides),
        ("memory", &memory),
    ] {
        for (k, number) in numbers.iter().enumerate() {
            if array == "parameter" && plan.is_fixed[k] {
                continue;
            }
            put(format!("{array}[{k}]"), c.number(*number));
        }
    }
    for (k, turns) in start.turns.iter().enumerate().filter(|(_, turns)| **turns != 0) {
        put(format!("turns[{k}]"), turns.to_string());
    }
    for (k, row) in start.contacts.iter().enumerate().take(plan.counts.places) {
        let numbers = [
            ("mode", row.mode.number()),
            ("carried", u64::from(row.is_carried)),
            ("negative", u64::from(row.is_negative)),
        ];
        for (array, number) in numbers.into_iter().filter(|(_, number)| *number != 0) {
            put(format!("{array}[{k}]"), number.to_string());
        }
        if row.place != 0.0 {
            put(format!("place[{k}]"), c.number(row.place));
        }
    }
    if let Some(chart) = start.chart.filter(|_| plan.is_loops()) {
        put("chart".to_owned(), chart.to_string());
    }
    text
}

/// Adds whole revolutions to the angles of bodies.
fn whole(plan: &Plan) -> String {
    let mut text = String::new();
    for (count, turns) in plan.lowered.turns.iter().enumerate() {
        for place in &turns.in_pose {
            let _ = writeln!(
                text,
                "    {{\n        const plm_real turned = (plm_real)self->turns[{count}] * @turn@;\n        q[{place}] = turned + q[{place}];\n    }}"
            );
        }
    }
    text
}

/// A case of a kind with so many numbers.
fn case(kind: &str, count: usize, inner: &str) -> String {
    if count == 0 {
        return String::new();
    }
    format!(
        "    case PLM_{kind}:\n        if (index < {count}u) {{\n{}        }}\n        break;\n",
        indented(inner, 12)
    )
}

/// Cases of what can be read.
fn get(plan: &Plan) -> String {
    let (counts, states) = (&plan.counts, plan.lowered.states.len());
    let outputs = plan.outputs().count();
    let of_parameter = if plan.is_fixed.contains(&true) {
        let mut text = "switch (index) {\n".to_owned();
        for (k, value) in plan.start.parameters.iter().enumerate().filter(|(k, _)| plan.is_fixed[*k]) {
            let _ = write!(text, "case {k}u:\n    *value = {};\n    break;\n", plan.c().number(*value));
        }
        text.push_str("default:\n    *value = self->parameter[index];\n    break;\n}\nreturn PLM_OK;\n");
        text
    } else {
        "*value = self->parameter[index];\nreturn PLM_OK;\n".to_owned()
    };
    let of_output = format!(
        "plm_real out[{}];\nconst int status = @p@_outputs(self, out);\nif (status == PLM_OK) {{\n    *value = out[index];\n}}\nreturn status;\n",
        plan.length("out")
    );
    let of_rate = "plm_real rates[@states@];\nconst int status = @p@_rate(self, self->time, self->x, rates);\nif (status == PLM_OK) {\n    *value = rates[index];\n}\nreturn status;\n";
    [
        case("PARAMETER", plan.start.parameters.len(), &of_parameter),
        case("INPUT", plan.start.inputs.len(), "*value = self->input[index];\nreturn PLM_OK;\n"),
        case("STATE", states, "*value = self->x[2 * @nq@ + index];\nreturn PLM_OK;\n"),
        case("OUTPUT", outputs, &of_output),
        case("INTEGRATED", counts.states, "*value = self->x[index];\nreturn PLM_OK;\n"),
        case("RATE", if plan.has_own_rate() { counts.states } else { 0 }, of_rate),
        case("CONTACT", counts.contacts, OF_CONTACT),
    ]
    .concat()
}

/// Cases of what can be set.
fn set(plan: &Plan) -> String {
    let fixed: Vec<String> = plan
        .is_fixed
        .iter()
        .enumerate()
        .filter(|(_, fixed)| **fixed)
        .map(|(k, _)| format!("index == {k}u"))
        .collect();
    let mut of_parameter = String::new();
    if !fixed.is_empty() {
        let _ = write!(of_parameter, "if ({}) {{\n    return PLM_READ_ONLY;\n}}\n", fixed.join(" || "));
    }
    if has_limits(plan) {
        of_parameter.push_str(
            "const @real@ before = self->parameter[index];\nself->parameter[index] = value;\nif (!@p@_is_allowed(self)) {\n    self->parameter[index] = before;\n    return PLM_PARAMETER_VALUE;\n}\nreturn PLM_OK;\n",
        );
    } else {
        of_parameter.push_str("self->parameter[index] = value;\nreturn PLM_OK;\n");
    }
    [
        case("PARAMETER", plan.start.parameters.len(), &of_parameter),
        case("INPUT", plan.start.inputs.len(), "self->input[index] = value;\nreturn PLM_OK;\n"),
        case("STATE", plan.lowered.states.len(), "return PLM_READ_ONLY;\n"),
        case("OUTPUT", plan.outputs().count(), "return PLM_READ_ONLY;\n"),
        case("INTEGRATED", plan.counts.states, "return PLM_READ_ONLY;\n"),
        case("RATE", plan.counts.states, "return PLM_READ_ONLY;\n"),
        case("CONTACT", plan.counts.contacts, "return PLM_READ_ONLY;\n"),
    ]
    .concat()
}

fn has_limits(plan: &Plan) -> bool {
    !plan.lowered.starts.limits.is_empty()
}

/// A function that checks the values which parameters give to limited quantities.
fn limits(plan: &Plan) -> String {
    use plm_compiler::lowered::Least;

    if !has_limits(plan) {
        return String::new();
    }
    let starts = &plan.lowered.starts;
    let mut block = plan.block();
    let results = block.routine(&starts.limited, |block, source| plan.read(block, source));
    let mut text = plan.function("limited", &block, &results, LIMITED);
    let length = plan.length("values");
    let _ = write!(
        text,
        "/* Does each mass, stiffness and the like have a value that the equations allow? */\nstatic int @p@_is_allowed(const @p@ *self)\n{{\n    \
         plm_real values[{length}];\n    @p@_limited(self, PLM_C(0.0), values);\n    return 1"
    );
    for (k, limit) in starts.limits.iter().enumerate() {
        let is_finite = format!("plm_is_finite(values[{k}])");
        let range = match limit.least {
            Least::Positive | Least::Carried => format!("(values[{k}] > PLM_C(0.0)) && {is_finite}"),
            Least::Zero => format!("(values[{k}] >= PLM_C(0.0)) && {is_finite}"),
            Least::Required => format!("(values[{k}] >= PLM_C(0.0))"),
            Least::Negative => format!("(values[{k}] <= PLM_C(0.0)) && {is_finite}"),
            Least::Share => format!("(values[{k}] >= PLM_C(0.0)) && (values[{k}] <= PLM_C(1.0))"),
        };
        let _ = write!(text, "\n        && {range}");
    }
    text.push_str(";\n}\n\n");
    text
}

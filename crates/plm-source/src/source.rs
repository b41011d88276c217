//! The C file: routines, the step, and what is read and set by kind and index.

use std::fmt::Write as _;

use crate::Precision;
use crate::function::Signature;
use crate::plan::Plan;
use crate::template::{fill, indented};
use crate::{absolute, check, contact, events, kinds, loops, names, numbers};
use plm_compiler::lowered::{Chart, Form, Routine};

const STEP: &str = include_str!("c/step.c.txt");
const FORMULA: &str = include_str!("c/formula.c.txt");
const CROSSED: &str = include_str!("c/crossed.c.txt");
const FINISH: &str = include_str!("c/finish.c.txt");
const BETWEEN_MODES: &str = include_str!("c/between_modes.c.txt");
const BETWEEN: &str = include_str!("c/between.c.txt");
const ARRIVE: &str = include_str!("c/arrive.c.txt");
const TURNS: &str = include_str!("c/turns.c.txt");
const TREE: &str = include_str!("c/tree.c.txt");
const LOOPS: &str = include_str!("c/loops.c.txt");

pub(crate) const RATE: Signature =
    Signature { reads: &["x"], writes: &["dx"], returns: true, is_forced: true };
const POSE: Signature = Signature { reads: &["x"], writes: &["q", "v"], returns: true, is_forced: false };
const REMEMBER: Signature = Signature { reads: &["x"], writes: &["memory"], returns: true, is_forced: false };
const REMEMBER_POSE: Signature =
    Signature { reads: &["q", "v"], writes: &["memory"], returns: true, is_forced: false };
const FROM_POSE: Signature =
    Signature { reads: &["q", "v"], writes: &["x"], returns: false, is_forced: false };
pub(crate) const GUARDS: Signature =
    Signature { reads: &["x"], writes: &["g"], returns: false, is_forced: false };

/// Causes that end a step, in the order of the numbers that `NAME_text` knows.
pub(crate) const CAUSES: [&str; 7] = [
    "",
    "the length of a step is not positive, or less than the time can resolve",
    "the equations are nearly singular at this pose",
    "a number is infinite or not a number",
    "a body of a loop turned too far in one step to be followed",
    "a reaction is not determined",
    "the joints cannot be closed again",
];

/// The file.
pub(crate) fn source(plan: &Plan) -> String {
    let name = &plan.name;
    let mut text = format!("/* {}: see {name}.h. */\n", plan.lowered.name);
    if plan.precision == Precision::Single {
        text.push_str("#define PLM_SINGLE 1\n");
    }
    let _ = write!(text, "#include \"plm_math.h\"\n\n#include \"{name}.h\"\n\n");
    // A variable of a function may have the name of the mechanism.
    let _ = write!(text, "typedef {name} {name}_object;\n\n");
    let _ = writeln!(text, "/* ---- routines ---- */\n");
    text.push_str(&routines(plan));
    text.push_str(&steps(plan));
    text.push_str(&kinds::outputs(plan));
    text.push_str(&kinds::functions(plan));
    text.push_str(&check::check(plan));
    names::without_hiding(&text, name)
}

/// The routines of each chart, and functions that choose among them.
fn routines(plan: &Plan) -> String {
    if plan.is_absolute() {
        return absolute::functions(plan);
    }
    let mut text = String::new();
    let mut of_charts = |name: &str, signature, of: &dyn Fn(&Chart) -> Option<&Routine>, of_own: bool| {
        text.push_str(&in_charts(plan, name, signature, of, of_own));
    };
    if plan.has_rate() {
        of_charts("rate", RATE, &|chart| Some(&chart.rate), true);
    }
    of_charts("pose", POSE, &|chart| Some(&chart.pose), true);
    if plan.counts.guards > 0 {
        of_charts("guards", GUARDS, &|chart| Some(&chart.guards), true);
    }
    if plan.is_loops() {
        of_charts("remember", REMEMBER, &|chart| chart.remember.as_ref(), true);
        of_charts("remember_pose", REMEMBER_POSE, &|chart| chart.remember_pose.as_ref(), false);
        of_charts("from_pose", FROM_POSE, &|chart| Some(&chart.from_pose), false);
    }
    text
}

/// A function of a routine in the present chart, or in a chart that is given.
fn in_charts<'r>(
    plan: &'r Plan,
    name: &str,
    signature: Signature,
    of: &dyn Fn(&'r Chart) -> Option<&'r Routine>,
    in_own: bool,
) -> String {
    let charts = plan.charts();
    let mut text = String::new();
    for (number, chart) in charts.iter().enumerate() {
        if let Some(routine) = of(chart) {
            text.push_str(&plan.of_routine(&format!("{name}_{number}"), routine, signature));
        }
    }
    let prefix = &plan.name;
    let arrays = || {
        let writes = signature.writes.iter().map(|array| (false, *array));
        signature.read(plan).map(|array| (true, array)).chain(writes)
    };
    let kind = if signature.returns { "plm_real" } else { "void" };
    let chart = if in_own { "" } else { ", int chart" };
    let _ = write!(text, "static {kind} {prefix}_{name}_in(const {prefix} *self{chart}, plm_real t");
    for (reads, array) in arrays() {
        let constant = if reads { "const " } else { "" };
        let _ = write!(text, ", {constant}plm_real {array}[{}]", plan.length(array));
    }
    text.push_str(")\n{\n");
    let passed = arrays().map(|(_, array)| format!(", {array}")).collect::<Vec<_>>().concat();
    if name.starts_with("remember") {
        // Numbers that a routine does not know are zero.
        let length = plan.length("memory");
        let _ = write!(
            text,
            "    int k;\n    for (k = 0; k < {length}; k++) {{\n        memory[k] = PLM_C(0.0);\n    }}\n"
        );
    }
    let call = |number: usize| {
        if signature.returns {
            format!("return {prefix}_{name}_{number}(self, t{passed});")
        } else {
            format!("{prefix}_{name}_{number}(self, t{passed});")
        }
    };
    if charts.len() == 1 {
        if !in_own {
            text.push_str("    (void)chart;\n");
        }
        let _ = writeln!(text, "    {}", call(0));
    } else {
        let own = if in_own { "self->chart" } else { "chart" };
        let _ = writeln!(text, "    switch ({own}) {{");
        for number in 1..charts.len() {
            let _ = writeln!(text, "    case {number}:\n        {}", call(number));
            if !signature.returns {
                text.push_str("        break;\n");
            }
        }
        let _ = writeln!(text, "    default:\n        {}", call(0));
        if !signature.returns {
            text.push_str("        break;\n");
        }
        text.push_str("    }\n");
    }
    text.push_str("}\n\n");
    text
}

/// The step, with what stands between steps.
fn steps(plan: &Plan) -> String {
    let is_plain =
        plan.lowered.form == Form::Tree && plan.counts.turns == 0 && plan.lowered.switches.all.is_empty();
    let (mut follow, mut between) = (String::new(), String::new());
    if !is_plain {
        BETWEEN.clone_into(&mut between);
        follow.push_str(if plan.counts.turns > 0 { TURNS } else { "" });
        follow.push_str(match plan.lowered.form {
            Form::Loops => LOOPS,
            Form::Tree => TREE,
            Form::Absolute => absolute::BETWEEN,
        });
        follow.push_str(&events::functions(plan));
        follow.push_str(ARRIVE);
        if plan.conditions_read_modes() {
            follow.push_str(FINISH);
            between = BETWEEN_MODES.replace("@places@", &plan.counts.places.to_string());
        }
    }
    let mut own = vec![("follow", follow), ("between", between)];
    own.extend(formula(plan));
    fill(&fill(STEP, &own), &words(plan))
}

/// The formula of a step, its call, and what it leaves in the object.
fn formula(plan: &Plan) -> [(&'static str, String); 5] {
    let Some(contacts) = &plan.lowered.contacts else {
        let call = "    health = @p@_formula(self, h, next);\n";
        let own = if plan.is_absolute() { absolute::of_step(plan) } else { String::new() };
        return [("formula", &*(own + FORMULA)), ("call", call), ("commit", ""), ("place", ""), ("row", "")]
            .map(|(word, text)| (word, text.to_owned()));
    };
    let [call, commit] = contact::call();
    let place = format!(", place[{}];\n    @p@_solved solved", plan.counts.places);
    [
        ("formula", contact::functions(plan, contacts)),
        ("call", call.replace("@first_row@", &plan.first_row().to_string())),
        ("commit", commit.replace("@places@", &plan.counts.places.to_string())),
        ("place", place),
        ("row", ", row".to_owned()),
    ]
}

/// All words of the templates.
pub(crate) fn words(plan: &Plan) -> Vec<(&'static str, String)> {
    let (counts, prefix) = (&plan.counts, &plan.name);
    let may_be_singular = plan.is_loops() && plan.lowered.may_be_singular;
    let has_iterated = counts.iterated > 0;
    let mut all: Vec<(&'static str, String)> = Vec::new();
    all.extend(loops::words(plan, has_iterated));
    all.push(("crossed_function", if may_be_singular { CROSSED } else { "" }.to_owned()));
    all.push(("unwind", indented(&loops::unwind(plan), 4)));
    all.push(("near", loops::near(plan)));
    let is_ill = plan.is_absolute() && plan.lowered.may_be_singular;
    let regular = if is_ill {
        " && !@p@_is_ill(self, health, end, next)".to_owned()
    } else if may_be_singular {
        format!(" && !({prefix}_crossed(self, end, next) > @sharp@)")
    } else {
        String::new()
    };
    all.push(("uncrossed", regular));
    all.extend(events::words(plan));
    all.extend(absolute::words(plan));
    let ill = "    if (@p@_is_ill(self, health, end, next)) {\n        return @p@_fail(self, PLM_POSE, @part_pose@);\n    }\n";
    let crossed = "    if (@p@_crossed(self, end, next) > @sharp@) {\n        return @p@_fail(self, PLM_POSE, @part_pose@);\n    }\n";
    all.push((
        "crossed",
        match (is_ill, may_be_singular) {
            (true, _) => ill.to_owned(),
            (_, true) => crossed.to_owned(),
            _ => String::new(),
        },
    ));
    all.extend(numbers::numbers(plan));
    for (word, number) in
        [("part_step", 1), ("part_pose", 2), ("part_finite", 3), ("part_far", 4), ("part_open", 6)]
    {
        all.push((word, number.to_string()));
    }
    all.push(("part_locked", format!("{prefix}_flattest(self->chart, after)")));
    let sizes = [
        ("states", plan.length("x")),
        ("n", counts.states),
        ("nq", counts.coordinates),
        ("intervals", counts.coordinates.max(1)),
        ("memory", plan.length("memory")),
        ("of_bodies", plan.length("q")),
        ("charts", counts.charts),
        ("determinants", counts.determinants),
    ];
    all.extend(sizes.map(|(word, size)| (word, size.to_string())));
    all.push(("first_determinant", (2 * (counts.coordinates + 1) + 3 * counts.angles).to_string()));
    all.push(("up", plan.upper.clone()));
    all.push(("p", prefix.clone()));
    all.push(("real", if plan.precision == Precision::Single { "float" } else { "double" }.to_owned()));
    all
}

/// The names of the parts that a failure may have, after the causes that have none.
pub(crate) fn parts(plan: &Plan) -> Vec<String> {
    let requirements =
        plan.lowered.switches.all.iter().take(plan.counts.guards).map(|switch| switch.name.clone());
    let closing = plan
        .lowered
        .charts
        .iter()
        .filter(|_| plan.is_loops())
        .flat_map(|chart| chart.closing.iter().cloned());
    let rows = plan.lowered.contacts.iter().flat_map(|contacts| &contacts.rows).map(|row| row.name.clone());
    requirements.chain(closing).chain(rows).collect()
}

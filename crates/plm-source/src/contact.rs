//! Rows of contact: what they are at a state, and the time step of Moreau and Jean over them.

use std::fmt::Write as _;

use plm_compiler::Source;
use plm_compiler::lowered::{ContactChart, ContactKind, Contacts, Impacts, OfRows, Routine, RowTerm, Target};
use plm_runtime::{MoreauJean, Real, events};

use crate::Precision;
use crate::absolute;
use crate::block::{Block, Value};
use crate::dialect::Dialect as _;
use crate::function::{RETURNED, Signature};
use crate::plan::Plan;
use crate::template::{fill, indented};

const ROWS: &str = include_str!("c/contact/rows.c.txt");
const LOADS: &str = include_str!("c/contact/loads.c.txt");
const STEP: &str = include_str!("c/contact/step.c.txt");
const IMPACTS: &str = include_str!("c/contact/impacts.c.txt");
const SPLIT: &str = include_str!("c/contact/split.c.txt");
const NEWTON: &str = include_str!("c/contact/newton.c.txt");
const POISSON: &str = include_str!("c/contact/poisson.c.txt");
const FASTEST: &str = include_str!("c/contact/fastest.c.txt");
const SIGNS: &str = include_str!("c/contact/signs.c.txt");
const FORCES: &str = include_str!("c/contact/forces.c.txt");
const APPEAR: &str = include_str!("c/contact/appear.c.txt");
const SUNK: &str = include_str!("c/contact/sunk.c.txt");
const STORED: &str = include_str!("c/contact/stored.c.txt");
const SLIDE: &str = include_str!("c/contact/slide.c.txt");
const CALL: &str = include_str!("c/contact/call.c.txt");
const COMMIT: &str = include_str!("c/contact/commit.c.txt");

const RESTITUTION: Signature =
    Signature { reads: &[], writes: &["restitution"], returns: false, is_forced: false };
const EXIST: Signature = Signature { reads: &[], writes: &["exist"], returns: false, is_forced: false };

/// A step with rows of contact: how it is called, and what it leaves in the object.
pub(crate) fn call() -> [&'static str; 2] {
    [CALL, COMMIT]
}

/// All functions of rows of contact, and the step over them.
pub(crate) fn functions(plan: &Plan, contacts: &Contacts) -> String {
    let mut text = String::new();
    if let Some(exist) = &contacts.exist {
        text.push_str(&plan.of_routine("exist", exist, EXIST));
    }
    if strikes(contacts) {
        let (block, results) = restitutions(plan, contacts);
        text.push_str(&plan.function("restitution", &block, &results, RESTITUTION));
    }
    text.push_str(ROWS);
    text.push_str(&motions(plan, contacts));
    if plan.is_absolute() {
        text.push_str(&absolute::of_step(plan));
    }
    text.push_str(STEP);
    if plan.reads_forces() {
        text.push_str(FORCES);
    }
    if plan.may_appear() || plan.settles() {
        text.push_str(APPEAR);
    }
    if plan.may_appear() && plan.counts.guards > 0 {
        text.push_str(SUNK);
    }
    let words = [of_step(plan, contacts), of_loads(contacts), tables(plan, contacts), numbers(plan)].concat();
    fill(&text, &words)
}

/// The coefficients of restitution of all rows.
fn restitutions(plan: &Plan, contacts: &Contacts) -> (Block, Vec<(Target, Value)>) {
    let mut block = plan.block();
    let mut results = Vec::new();
    for (k, row) in contacts.rows.iter().enumerate() {
        let own = block.routine(&row.restitution, |block, source| plan.read(block, source));
        results.extend(own.first().map(|(_, value)| (Target::Element("restitution", k), *value)));
    }
    let nothing = block.number(0.0);
    let others = contacts.rows.len()..plan.counts.places;
    results.extend(others.map(|k| (Target::Element("restitution", k), nothing)));
    (block, results)
}

/// May a row strike?
fn strikes(contacts: &Contacts) -> bool {
    contacts.rows.iter().any(|row| row.kind == ContactKind::Unilateral)
}

/// The routine of the motion and the rows in a chart: the place of each of its results, and the value.
pub(crate) fn motion(plan: &Plan, chart: &ContactChart) -> (Block, Vec<(Target, Value)>) {
    let mut block = plan.block();
    let mut read =
        |routine: &Routine| block.routine(routine, |block, source: Source| plan.read(block, source));
    let results = match &chart.together {
        Some(together) => read(together),
        None => [read(&chart.kinematics), read(&chart.motion)].concat(),
    };
    (block, results)
}

/// The functions of the motion in each chart, and the one that chooses among them.
fn motions(plan: &Plan, contacts: &Contacts) -> String {
    let arguments = "const @p@ *self, plm_real t, const plm_real x[@states@], @p@_motion *motion";
    let (mut text, mut choice) = (String::new(), String::new());
    let count = plan.charts().len().max(1);
    for (number, chart) in contacts.charts.iter().enumerate().take(count) {
        let (block, results) = motion(plan, chart);
        let _ = writeln!(text, "static plm_real @p@_motion_{number}({arguments})");
        text.push_str(&plan.body(&block, &results, place, &["x", "motion"]));
        let _ = match number {
            0 => Ok(()),
            number => writeln!(
                choice,
                "    case {number}:\n        return @p@_motion_{number}(self, t, x, motion);"
            ),
        };
    }
    let first = "return @p@_motion_0(self, t, x, motion);\n";
    let chosen = match count {
        1 => format!("    {first}"),
        _ => format!("    switch (self->chart) {{\n{choice}    default:\n        {first}    }}\n"),
    };
    let _ = write!(
        text,
        "static plm_real @p@_motion_in({arguments})\n{{\n    (void)memset(motion, 0, sizeof *motion);\n{chosen}}}\n\n"
    );
    text
}

/// The place of a result of the motion.
fn place(target: Target) -> Option<String> {
    let bound = |term| match term {
        RowTerm::Own => "own".to_owned(),
        RowTerm::By(row) => format!("by[{row}]"),
        RowTerm::Share(load) => format!("share[{load}]"),
    };
    Some(match target {
        Target::Value => RETURNED.to_owned(),
        Target::Element("dx", k) => format!("motion->dx[{k}]"),
        Target::Entry("response", row, k) => format!("motion->response[{row}][{k}]"),
        Target::Rows(OfRows::Gap(row)) => format!("motion->rows.gap[{row}]"),
        Target::Rows(OfRows::Rate(row)) => format!("motion->rows.rate[{row}]"),
        Target::Rows(OfRows::Free(row)) => format!("motion->rows.free[{row}]"),
        Target::Rows(OfRows::Bias(row)) => format!("motion->rows.bias[{row}]"),
        Target::Rows(OfRows::Delassus(row, column)) => format!("motion->rows.delassus[{row}][{column}]"),
        Target::Rows(OfRows::Limit { row, sticks, upper, term }) => {
            let kind = if sticks { "adhesion" } else { "kinetic" };
            format!("motion->rows.{kind}[{row}][{}].{}", usize::from(upper), bound(term))
        }
        Target::Rows(OfRows::Reaction { load, component, term }) => match term {
            RowTerm::Share(_) => return None,
            term => format!("motion->rows.reaction[{load}][{component}].{}", bound(term)),
        },
        _ => return None,
    })
}

/// Lines where they are wanted.
pub(crate) fn where_wanted(is_wanted: bool, text: &str) -> String {
    if is_wanted { text.to_owned() } else { String::new() }
}

/// Words of what only reactions need that bound frictions.
fn of_loads(contacts: &Contacts) -> Vec<(&'static str, String)> {
    let has_loads = !contacts.reactions.is_empty();
    let in_plane = contacts.reactions.iter().any(|reaction| reaction.in_plane);
    let with = |text| where_wanted(has_loads, text);
    let each = |inner: &str| {
        let lines = indented(inner, 16);
        format!(
            "        {{\n            int load;\n            for (load = 0; load < @places@; load++) {{\n{lines}            }}\n        }}\n"
        )
    };
    let [nothing_x, nothing_y] = ["        e[i][0] = PLM_C(0.0);\n", "        e[i][1] = PLM_C(0.0);\n"];
    let add = each(
        "if (@p@_reads[row][load]) {\n    const plm_real part = bounds[side]->share[load] * @p@_size(rows, load, force);\n    sum = part + sum;\n}\n",
    );
    let along = each(
        "if (@p@_reads[row][load]) {\n    const plm_real share = bound->share[load];\n    plm_real x = e[load][0] * rows->reaction[load][0].own;\n    \
         plm_real y = e[load][1] * rows->reaction[load][1].own;\n    plm_real part = share * (x + y);\n    own = own + part;\n    \
         for (j = 0; j < @places@; j++) {\n        x = e[load][0] * rows->reaction[load][0].by[j];\n        \
         y = e[load][1] * rows->reaction[load][1].by[j];\n        part = share * (x + y);\n        by[j] = by[j] + part;\n    }\n}\n",
    );
    let stored_direction = "        for (i = 0; i < @places@; i++) {\n            if (!@p@_reads[i][load] || !@p@_slips(self->mode[i])) {\n                \
         continue;\n            }\n            if (@p@_load[load] == 2) {\n                plm_real of[2];\n                \
         @p@_reaction(rows, load, force, of);\n                @p@_unit(of, e[load]);\n            } else {\n                \
         e[load][0] = self->negative[load] ? (-PLM_C(1.0)) : PLM_C(1.0);\n            }\n            break;\n        }\n";
    let direction = "        @p@_direction(rows, i, last, e[i]);\n".to_owned();
    let slide = "    if (!@p@_slide(self, rows, 4, force)) {\n        for (i = 0; i < @places@; i++) {\n            force[i] = PLM_C(0.0);\n        }\n    }\n";
    let all_slide = "    if (!hold && @p@_slide(self, &motion.rows, -1, force)) {\n        return;\n    }\n";
    vec![
        ("of_loads", with(", and of the sizes of reactions")),
        ("share", with(", share[@places@]")),
        ("reaction", with("    @p@_bound reaction[@places@][2];\n")),
        ("loads", with(LOADS)),
        ("add_loads", with(&add)),
        ("along", with(&along)),
        ("has_share", with("(bounds[k]->share[j] != PLM_C(0.0)) || ")),
        ("is_negative", if has_loads { "@p@_is_negative(rows, i, force)" } else { "0" }.to_owned()),
        ("direction", if has_loads { direction } else { format!("{nothing_x}{nothing_y}") }),
        ("end_of_rounds", where_wanted(!has_loads, " else {\n                break;\n            }")),
        (
            "share_factor",
            with(
                "        if (bound->share[j] != PLM_C(0.0)) {\n            factor = bound->share[j];\n            count = count + 1;\n        }\n",
            ),
        ),
        (
            "negative_factor",
            format!("(bound->by[j] < PLM_C(0.0)){}", with(" || (bound->share[j] < PLM_C(0.0))")),
        ),
        ("stored", where_wanted(in_plane, &[STORED, SLIDE].concat())),
        ("stored_direction", with(stored_direction)),
        ("stored_index", with("    int i;\n")),
        ("first_forces", where_wanted(in_plane, slide)),
        ("all_slide", where_wanted(in_plane, all_slide)),
        (
            "without_own",
            with(
                "        problem.reaction[i][0].own = PLM_C(0.0);\n        problem.reaction[i][1].own = PLM_C(0.0);\n",
            ),
        ),
        (
            "expansion",
            with(
                "            problem.reaction[i][0].own = @p@_at(problem.reaction[i][0].own, problem.reaction[i][0].by, back);\n            \
                 problem.reaction[i][1].own = @p@_at(problem.reaction[i][1].own, problem.reaction[i][1].by, back);\n",
            ),
        ),
    ]
}

/// Words of the parts of a step that not every mechanism needs.
fn of_step(plan: &Plan, contacts: &Contacts) -> Vec<(&'static str, String)> {
    let strikes = strikes(contacts);
    let rubs = contacts.rows.iter().any(|row| row.kind == ContactKind::Friction);
    let sequential = contacts.impacts == Impacts::Sequential;
    let look = "    i = @p@_negative_bound(exists, &motion.rows);\n    if (i >= 0) {\n        *part = i;\n        return PLM_PARAMETER_VALUE;\n    }\n";
    let here = look.replace("&motion.", "&motion->");
    let free = "    for (i = 0; i < @places@; i++) {\n        free[i] = motion.rows.free[i];\n    }\n";
    let strike = "    if (@p@_strikes(h, free, exists, &motion.rows, solved, strikes)) {\n        \
         i = @p@_split(self, &h, strikes, exists, free, &motion, &t, x, solved, &residual, health, part);\n        \
         if (i != PLM_OK) {\n            return i;\n        }\n        rest = @theta@ * h;\n        ahead = h - rest;\n        \
         @p@_over_step(self, h, rule, &motion.rows, guess, slack);\n        \
         @p@_complement(&motion.rows, rule, guess, solved);\n    }\n    (void)ahead;\n    (void)t;\n";
    let forced = "    {\n        plm_real dx[@states@];\n        (void)@p@_rate_in(self, t, x, solved->force, dx);\n        \
         for (i = 2 * @nq@; i < @n@; i++) {\n            motion.dx[i] = dx[i];\n        }\n    }\n";
    // Impulses of frictions have no bound of their own.
    let own = "        for (k = 0; k < 2; k++) {\n            problem.kinetic[i][k].own = PLM_C(0.0);\n            problem.adhesion[i][k] = problem.kinetic[i][k];\n        }\n";
    let expansion = "            for (k = 0; (k < 2) && (@p@_law[i] == @up@_FRICTION); k++) {\n                \
         problem.kinetic[i][k].own = @p@_at(problem.kinetic[i][k].own, problem.kinetic[i][k].by, back);\n                \
         problem.adhesion[i][k].own = @p@_at(problem.adhesion[i][k].own, problem.adhesion[i][k].by, back);\n            }\n";
    let forced_here =
        forced.replace("motion.", "motion->").replace("self, t, x", "self, self->time + ahead, x");
    let joined = "    if (@p@_drifts(self, end, x)) {\n        i = @p@_project(self, end, x);\n        \
        if (i != PLM_OK) {\n            *part = @part_open@ - @first_row@;\n            return i;\n        }\n    }\n";
    let law = if contacts.impacts == Impacts::Newton { NEWTON } else { POISSON };
    let exists = match &contacts.exist {
        Some(_) => {
            "    plm_real exist[@places@];\n    @p@_exist(self, PLM_C(0.0), exist);\n    for (i = 0; i < @places@; i++) {\n        \
             exists[i] = (i < @contacts@) && (exist[i] > PLM_C(0.5));\n    }\n"
        }
        None => {
            "    (void)self;\n    for (i = 0; i < @places@; i++) {\n        exists[i] = i < @contacts@;\n    }\n"
        }
    };
    vec![
        ("signs", where_wanted(rubs, SIGNS)),
        ("look_at_signs", where_wanted(rubs, look)),
        ("joined", where_wanted(plan.projects(), joined)),
        ("and_split", where_wanted(strikes, ". An impact splits it")),
        ("impacts", where_wanted(strikes, IMPACTS)),
        ("impact_law", law.to_owned()),
        ("strike", where_wanted(strikes, strike)),
        ("split", where_wanted(strikes, SPLIT)),
        ("joined_here", where_wanted(plan.projects(), &joined.replace("self, end", "self, *t"))),
        ("free", where_wanted(strikes, free)),
        ("look_at_signs_here", where_wanted(rubs, &here)),
        ("with_forces_here", where_wanted(!contacts.is_affine, &forced_here)),
        ("declared", declared(plan, strikes)),
        ("with_forces", where_wanted(!contacts.is_affine, forced)),
        ("without_own_bounds", where_wanted(rubs, own)),
        ("expansion_of_bounds", where_wanted(rubs, expansion)),
        ("bound_index", where_wanted(rubs, "    int k;\n")),
        ("fastest", where_wanted(sequential, FASTEST)),
        ("pairs", if sequential { "16" } else { "1" }.to_owned()),
        ("exists", exists.to_owned()),
        ("first_row", plan.first_row().to_string()),
    ]
}

/// Declarations of a step that not every mechanism needs.
fn declared(plan: &Plan, strikes: bool) -> String {
    let end = where_wanted(plan.projects(), "    const plm_real end = self->time + h;\n");
    end + &where_wanted(strikes, "    plm_real free[@places@];\n    int strikes[@places@];\n")
}

/// Tables of the rows, by number.
fn tables(plan: &Plan, contacts: &Contacts) -> Vec<(&'static str, String)> {
    let places = plan.counts.places;
    let all = |of: &dyn Fn(usize) -> String| (0..places).map(of).collect::<Vec<_>>().join(", ");
    let law = |row: usize| {
        let word = match contacts.rows.get(row).map(|row| row.kind) {
            Some(ContactKind::Unilateral) => "GAP",
            Some(ContactKind::Constraint) => "CONSTRAINT",
            Some(ContactKind::Friction) | None => "FRICTION",
        };
        format!("@up@_{word}")
    };
    let falls =
        |row: usize| u8::from(contacts.rows.get(row).is_some_and(|row| row.bound_may_fall)).to_string();
    let kind = |load: usize| match contacts.reactions.get(load) {
        None => "0".to_owned(),
        Some(reaction) => if reaction.in_plane { "2" } else { "1" }.to_owned(),
    };
    let reads = |row: usize| {
        let own = |load: usize| {
            let is_read = contacts.reactions.get(load).is_some_and(|reaction| reaction.rows.contains(&row));
            u8::from(is_read).to_string()
        };
        format!("{{ {} }}", all(&own))
    };
    let load_tables = format!(
        "/* Of each reaction that bounds frictions: 1 along a line, 2 in the plane; and the rows whose bounds read it. */\n\
         static const int @p@_load[@places@] = {{ {} }};\nstatic const unsigned char @p@_reads[@places@][@places@] = {{ {} }};\n",
        all(&kind),
        all(&reads),
    );
    vec![
        ("load_tables", where_wanted(!contacts.reactions.is_empty(), &load_tables)),
        ("laws", all(&law)),
        ("falls", all(&falls)),
        ("places", places.to_string()),
        ("contacts", contacts.rows.len().to_string()),
    ]
}

/// Numbers of the runtime's tolerances.
fn numbers(plan: &Plan) -> Vec<(&'static str, String)> {
    match plan.precision {
        Precision::Double => numbers_of::<f64>(plan),
        Precision::Single => numbers_of::<f32>(plan),
    }
}

fn numbers_of<S: Real>(plan: &Plan) -> Vec<(&'static str, String)> {
    use plm_runtime::contact::Constants;

    let c = plan.c();
    let number = |value: S| c.number(value.to_f64());
    let sizes = plan.lowered.typical.iter().take(plan.counts.coordinates);
    let typical = sizes.fold(S::ZERO, |most, size| most.max(S::lit(*size)));
    let constants = Constants::<S>::new(S::lit(plan.lowered.length));
    vec![
        ("theta", c.number(MoreauJean::<S>::THETA)),
        ("dependent", number(constants.dependent)),
        ("carried", number(constants.carried)),
        ("rounding", number(constants.rounding)),
        ("no_slip", number(constants.no_slip)),
        ("closed", number(constants.closed)),
        ("tail", number(constants.tail)),
        ("gain", number(constants.gain)),
        ("no_bound", number(constants.no_bound)),
        ("balance", number(constants.balance)),
        ("led_back", number(constants.led_back)),
        ("sunk", number(S::lit(events::SUNK) * typical)),
        ("swept", format!("{:e}", constants.swept)),
    ]
}

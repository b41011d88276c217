//! Conditions of the state and of the time, which change their sides at the end of a step, and events that set states.

use std::fmt::Write as _;

use plm_compiler::lowered::Set;

use crate::function::Signature;
use crate::plan::Plan;
use crate::source::CAUSES;

const EVENTS: &str = include_str!("c/events.c.txt");
const MATTERS: &str = include_str!("c/matters.c.txt");
const REFRESH: &str = include_str!("c/refresh.c.txt");
const INSTANTS: &str = include_str!("c/instants.c.txt");
const SETS: &str = include_str!("c/sets.c.txt");
const FLIP: &str = include_str!("c/flip.c.txt");

const TIMES: Signature = Signature { reads: &[], writes: &["at", "slope"], returns: false, is_forced: false };
const HELD: Signature = Signature { reads: &[], writes: &["holds"], returns: false, is_forced: false };
const SET: Signature =
    Signature { reads: &["x", "q", "v"], writes: &["set"], returns: false, is_forced: false };

/// Is a change of a side followed by more than that?
fn follows(plan: &Plan) -> bool {
    plan.may_appear() || plan.sets_states()
}

/// The functions that look for events and commit them.
pub(crate) fn functions(plan: &Plan) -> String {
    let (mut text, guards) = (String::new(), plan.counts.guards > 0);
    if guards {
        text.push_str(
            "/* By condition: 0 of what changes its side, 1 of a requirement, 2 of a pole or the end of a domain. */\n\
             static const unsigned char @p@_ends[@guards@] = { @ends@ };\n\n",
        );
    }
    if plan.sets_states() {
        let sets = &plan.lowered.sets;
        text.push_str(&plan.of_routine("held", &sets.holds, HELD));
        text.push_str(&plan.of_routine("set_values", &sets.values, SET));
        text.push_str(SETS);
    }
    if guards {
        let (before, after) = EVENTS.split_once("@matters@").unwrap_or((EVENTS, ""));
        text.push_str(before);
        text.push_str("@matters@");
        text.push_str(if follows(plan) { FLIP } else { "" });
        text.push_str(after);
    }
    if plan.counts.times > 0 {
        text.push_str(&plan.of_routine("instants", &plan.lowered.switches.instants, TIMES));
        text.push_str(INSTANTS);
    }
    text
}

/// The words of these and of the step.
pub(crate) fn words(plan: &Plan) -> Vec<(&'static str, String)> {
    let (switches, guards) = (&plan.lowered.switches, plan.counts.guards);
    let list = |numbers: &mut dyn Iterator<Item = usize>| {
        let all: Vec<String> = numbers.map(|number| format!("{number}u")).collect();
        all.join(", ")
    };
    let ends = switches.all.iter().take(guards).map(|switch| match &switch.end {
        _ if switch.must_hold => 1,
        Some(_) => 2,
        None => 0,
    });
    let selective = guards > 0 && !switches.roots.is_empty() && !switches.nodes.is_empty();
    let of_selective = |text: &str| if selective { text.to_owned() } else { String::new() };
    let satisfied = if guards > 0 { " && @p@_are_satisfied(self, end, next)" } else { "" };
    let before = if plan.counts.times > 0 { " && !@p@_is_due(self, self->time, end)" } else { "" };
    let mut then = String::new();
    if guards > 0 {
        then.push_str(
            "    if (!@p@_are_satisfied(self, end, next)) {\n        const int status = @p@_switch(self, end, next);\n        \
             if (status != PLM_OK) {\n            return status;\n        }\n    }\n",
        );
    }
    if plan.counts.times > 0 {
        then.push_str(
            "    if (@p@_is_due(self, self->time, end)) {\n        int part = 0;\n        \
             const int status = @p@_switch_at_time(self, end, next, &part);\n        if (status != PLM_OK) {\n            \
             return @p@_fail(self, status, part);\n        }\n    }\n",
        );
    }
    let mut all = vec![
        ("matters", of_selective(MATTERS)),
        ("refresh", of_selective(REFRESH)),
        ("satisfied", format!("{satisfied}{before}")),
        ("switch", then),
    ];
    all.extend(of_changes(plan));
    all.extend([
        ("ends", list(&mut ends.into_iter())),
        ("nodes", switches.nodes.len().to_string()),
        ("node_sides", list(&mut switches.nodes.iter().map(|(side, ..)| usize::from(*side)))),
        ("node_yes", list(&mut switches.nodes.iter().map(|(_, yes, _)| usize::from(*yes)))),
        ("node_no", list(&mut switches.nodes.iter().map(|(.., no)| usize::from(*no)))),
        ("roots", list(&mut switches.roots.iter().take(guards).map(|root| usize::from(*root)))),
        ("first_guard", CAUSES.len().to_string()),
        ("conditions", guards.max(1).to_string()),
        ("guards", guards.to_string()),
        ("watched", plan.counts.watched.max(1).to_string()),
        ("times", plan.counts.times.to_string()),
    ]);
    all
}

/// Words of what a change of a side leads to.
fn of_changes(plan: &Plan) -> Vec<(&'static str, String)> {
    let (appears, sets) = (plan.may_appear(), plan.sets_states());
    let wanted = |is_wanted: bool, text: &str| if is_wanted { text.to_owned() } else { String::new() };
    let plain = "                if (@p@_ends[k] != 1u) {\n                    self->side[k] = -self->side[k];\n                }\n";
    // A row that a step has led below its surface leads out again: another one does not begin there.
    let sunk = "                    if ((status == PLM_POSE) && @p@_has_sunk(&before, t, x)) {\n                        \
         *self = before;\n                        edge[k] = g[k];\n                        continue;\n                    }\n";
    let checked = format!(
        "                if (@p@_ends[k] != 1u) {{\n{}                    int part = 0;\n                    \
         const int status = @p@_flip(self, t, x, k, &part);\n{}                    if (status != PLM_OK) {{\n                        \
         return @p@_fail(self, status, part);\n                    }}\n                }}\n",
        wanted(appears, "                    const @p@_object before = *self;\n"),
        wanted(appears, sunk),
    );
    let copied = "            plm_real copy[@states@];\n            int j, part = 0;\n            for (j = 0; j < @states@; j++) {\n                \
         copy[j] = x[j];\n            }\n            (void)@p@_flip(self, t, copy, k, &part);\n";
    let existed = "    int existed[@places@];\n";
    let ask = "    @p@_which_exist(self, existed);\n";
    let appear = "    {\n        const int status = @p@_appear(self, t, x, existed, part);\n        if (status != PLM_OK) {\n            return status;\n        }\n    }\n";
    let (before_sets, after_sets) = (
        "    @p@_sides change;\n    @p@_before_change(self, t, x, &change);\n",
        "    {\n        const int status = @p@_after_change(self, t, x, &change, part);\n        if (status != PLM_OK) {\n            return status;\n        }\n    }\n",
    );
    // Declarations come before statements.
    let before = [
        wanted(appears, existed),
        wanted(sets, "    @p@_sides change;\n"),
        wanted(sets, before_sets.split_once('\n').map_or("", |(_, call)| call)),
        wanted(appears, ask),
    ];
    let after = [wanted(appears, appear), wanted(sets, after_sets)];
    let settles = plan.settles();
    let mut anew = String::new();
    for row in plan.moved_rows() {
        let _ = writeln!(anew, "            existed[{row}] = 0;");
    }
    let settle = format!(
        "            int status, existed[@places@], i;\n            for (i = 0; i < @places@; i++) {{\n                \
         existed[i] = change->existed[i];\n            }}\n{anew}            status = @p@_appear(self, t, x, existed, part);\n            \
         if (status != PLM_OK) {{\n                return status;\n            }}\n"
    );
    vec![
        ("flip", if follows(plan) { checked } else { plain.to_owned() }),
        (
            "flip_copy",
            if follows(plan) { copied } else { "            self->side[k] = -self->side[k];\n" }.to_owned(),
        ),
        ("before_change", before.concat()),
        ("after_change", after.concat()),
        ("existed_field", wanted(settles, "\n    int existed[@places@];")),
        ("keep_existed", wanted(settles, "    @p@_which_exist(self, change->existed);\n")),
        ("settle", wanted(settles, &settle)),
        (
            "look_at_guards",
            if plan.counts.guards > 0 {
                "    @p@_guards_in(self, t, x, g);\n"
            } else {
                "    (void)self;\n    (void)t;\n    (void)x;\n    (void)of;\n    (void)g;\n"
            }
            .to_owned(),
        ),
        ("set_cases", set_cases(plan)),
        ("set_values", plan.length("set").to_string()),
        ("events", plan.lowered.sets.events.len().to_string()),
        ("places", plan.counts.places.to_string()),
    ]
}

/// By event, the states that it sets.
fn set_cases(plan: &Plan) -> String {
    let (mut text, mut next) = (String::new(), 0);
    for (event, targets) in plan.lowered.sets.events.iter().enumerate() {
        let _ = writeln!(text, "    case {event}:");
        for target in targets {
            if let Set::State(state) = target {
                let _ = writeln!(text, "        x[{}] = set[{next}];", 2 * plan.counts.coordinates + state);
            }
            next += 1;
        }
        text.push_str("        break;\n");
    }
    text
}

//! Conditions of the state and of the time, which change their sides at the end of a step.

use crate::function::Signature;
use crate::plan::Plan;
use crate::source::CAUSES;

const EVENTS: &str = include_str!("c/events.c.txt");
const MATTERS: &str = include_str!("c/matters.c.txt");
const REFRESH: &str = include_str!("c/refresh.c.txt");
const INSTANTS: &str = include_str!("c/instants.c.txt");

const TIMES: Signature = Signature { reads: &[], writes: &["at", "slope"], returns: false, is_forced: false };

/// The functions that look for events and commit them.
pub(crate) fn functions(plan: &Plan) -> String {
    let mut text = String::new();
    if plan.counts.guards > 0 {
        text.push_str(EVENTS);
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
            "    if (@p@_is_due(self, self->time, end)) {\n        @p@_switch_at_time(self, end);\n    }\n",
        );
    }
    vec![
        ("matters", of_selective(MATTERS)),
        ("refresh", of_selective(REFRESH)),
        ("satisfied", format!("{satisfied}{before}")),
        ("switch", then),
        ("ends", list(&mut ends.into_iter())),
        ("nodes", switches.nodes.len().to_string()),
        ("node_sides", list(&mut switches.nodes.iter().map(|(side, ..)| usize::from(*side)))),
        ("node_yes", list(&mut switches.nodes.iter().map(|(_, yes, _)| usize::from(*yes)))),
        ("node_no", list(&mut switches.nodes.iter().map(|(.., no)| usize::from(*no)))),
        ("roots", list(&mut switches.roots.iter().take(guards).map(|root| usize::from(*root)))),
        ("first_guard", CAUSES.len().to_string()),
        ("guards", guards.to_string()),
        ("watched", plan.counts.watched.max(1).to_string()),
        ("times", plan.counts.times.to_string()),
    ]
}

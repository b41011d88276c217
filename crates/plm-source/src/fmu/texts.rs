//! The functions of FMI over the functions of a source, as text of C.

use std::fmt::Write as _;

use plm_foreign::fmi::{Facts, Variable, Version};

use crate::dialect::Dialect as _;
use crate::kinds::quoted;
use crate::plan::Plan;
use crate::source;
use crate::template::fill;

const VALUES: &str = include_str!("values.c.txt");
const STEP: &str = include_str!("step.c.txt");
const EXCHANGE: &str = include_str!("exchange.c.txt");
const FOLLOW: &str = include_str!("follow.c.txt");
const NEXT: &str = include_str!("next.c.txt");
/// The beginning, the functions, those of model exchange, those of co-simulation.
const TWO: [&str; 4] = [
    include_str!("two_begin.c.txt"),
    include_str!("two.c.txt"),
    include_str!("two_exchange.c.txt"),
    include_str!("two_step.c.txt"),
];
const THREE: [&str; 4] = [
    include_str!("three_begin.c.txt"),
    include_str!("three.c.txt"),
    include_str!("three_exchange.c.txt"),
    include_str!("three_step.c.txt"),
];

/// The functions of 3.0 of an interface that is not there.
const NO_EXCHANGE: &str = include_str!("three_no_exchange.c.txt");
const NO_STEPS: &str = include_str!("three_no_step.c.txt");

/// The functions, which follow those of the source in one file.
pub(super) fn functions(plan: &Plan, version: Version, facts: &Facts, mark: u64) -> String {
    let [begin, common, of_exchange, of_steps] = if version == Version::Two { TWO } else { THREE };
    let (exchange, steps) = (facts.interfaces.exchange(), facts.interfaces.co_simulation());
    let only = |wanted: bool, text: &str| if wanted { text.to_owned() } else { String::new() };
    let [without_exchange, without_steps] =
        if version == Version::Two { [""; 2] } else { [NO_EXCHANGE, NO_STEPS] };
    let of_exchange = if exchange { of_exchange } else { without_exchange };
    let of_steps = if steps { of_steps } else { without_steps };
    let text = [begin, VALUES, common, of_exchange, of_steps].concat();
    let mut words = vec![
        ("exchange", only(exchange, EXCHANGE)),
        ("co_simulation", only(steps, STEP)),
        ("no_exchange", u8::from(!exchange).to_string()),
        ("no_co_simulation", u8::from(!steps).to_string()),
        (
            "update",
            only(exchange, "    status = @p@_fmu_update((@p@_fmu *)instance, &changed, &is_known, &next);\n"),
        ),
        ("of_exchange", only(exchange, OF_EXCHANGE)),
        ("begin_exchange", only(exchange, BEGIN_EXCHANGE)),
        (
            "here",
            if exchange {
                "(self->exchange != 0) ? &self->own.there : &self->own.run"
            } else {
                "&self->own.run"
            }
            .to_owned(),
        ),
        ("reach_values", only(exchange, REACH_VALUES)),
    ];
    words.extend(values(facts, exchange));
    words.extend(events(plan));
    words.extend(numbers(plan, facts, mark));
    fill(&fill(&text, &words), &source::words(plan))
}

/// Fields of model exchange.
const OF_EXCHANGE: &str = "    @p@ there; /* where the solver is */\n    int is_there; /* its continuation data are those of its place */\n    \
    int leaves; /* the loops need other coordinates from there on */\n";
const BEGIN_EXCHANGE: &str = "    self->own.there = self->own.run;\n    self->own.is_there = 1;\n";
const REACH_VALUES: &str = "    if ((self->exchange != 0) && (@p@_fmu_reach(self, @P@_DISCARD) != @P@_OK)) {\n        return @P@_DISCARD;\n    }\n";

/// How variables are read and set, by their ranges of value references.
fn values(facts: &Facts, exchange: bool) -> Vec<(&'static str, String)> {
    let (mut lists, mut get, mut set) = (String::new(), String::new(), String::new());
    let range = |is_of: fn(&Variable) -> bool| {
        let first = facts.variables.iter().position(is_of)?;
        Some((first, first + facts.variables.iter().filter(|variable| is_of(variable)).count()))
    };
    let mut read = |(first, end): (usize, usize), body: &str| {
        let body = body.replace("FIRST", &first.to_string());
        let _ = write!(get, "        else if (reference < {end}u) {{\n{body}        }}\n");
    };
    let write = |(first, end): (usize, usize), kind: &str, always: bool| {
        let mut text = format!("    if ((reference >= {first}u) && (reference < {end}u)) {{\n");
        if !always {
            text.push_str("        if (!is_free) {\n            return PLM_READ_ONLY;\n        }\n");
        }
        if exchange {
            let _ = write!(
                text,
                "        if (self->exchange != 0) {{\n            \
                 const int status = @p@_set(&self->own.there, PLM_{kind}, reference - {first}u, value);\n            \
                 if (status != PLM_OK) {{\n                return status;\n            }}\n            \
                 self->own.is_there = 0;\n        }}\n"
            );
        }
        let _ = write!(
            text,
            "        return @p@_set(&self->own.run, PLM_{kind}, reference - {first}u, value);\n    }}\n"
        );
        text
    };
    if let Some(all) = range(|variable| matches!(variable, Variable::Parameter(_))) {
        read(all, "            status = @p@_get(here, PLM_PARAMETER, reference - FIRSTu, &values[k]);\n");
        set.push_str(&write(all, "PARAMETER", false));
    }
    if let Some(all) = range(|variable| matches!(variable, Variable::Input(_))) {
        read(all, "            status = @p@_get(here, PLM_INPUT, reference - FIRSTu, &values[k]);\n");
        set.push_str(&write(all, "INPUT", true));
    }
    if let Some(all) = range(|variable| matches!(variable, Variable::Output(_))) {
        let _ = writeln!(lists, "    double outputs[{}];\n    int has_outputs = 0;", all.1 - all.0);
        read(all, OUTPUT);
    }
    if let Some(all) = range(|variable| matches!(variable, Variable::State(_))) {
        read(all, "            values[k] = here->x[reference - FIRSTu];\n");
    }
    if let Some(all) = range(|variable| matches!(variable, Variable::Rate(_))) {
        lists.push_str("    double rates[@states@];\n    int has_rates = 0;\n");
        read(all, RATE);
    }
    if let Some(all) = range(|variable| matches!(variable, Variable::Indicator(_))) {
        lists.push_str("    double indicators[@indicator_room@] = { 0.0 };\n");
        read(all, INDICATOR);
    }
    vec![("lists", lists), ("get", get), ("set", set)]
}

const OUTPUT: &str = "            if (has_outputs == 0) {\n                status = @p@_outputs(here, outputs);\n                \
    has_outputs = (status == PLM_OK) ? 1 : 0;\n            }\n            \
    if (has_outputs != 0) {\n                values[k] = outputs[reference - FIRSTu];\n            }\n";
const RATE: &str = "            if (has_rates == 0) {\n                status = @p@_rate(here, here->time, here->x, rates);\n                \
    has_rates = (status == PLM_OK) ? 1 : 0;\n            }\n            \
    if (has_rates != 0) {\n                values[k] = rates[reference - FIRSTu];\n            }\n";
const INDICATOR: &str = "            if (self->exchange == 0) {\n                self->own.there = self->own.run;\n                \
    self->own.is_there = 1;\n                self->own.leaves = 0;\n            }\n            \
    if (@p@_fmu_indicators(self, @P@_DISCARD, indicators) != @P@_OK) {\n                return @P@_DISCARD;\n            }\n            \
    values[k] = indicators[reference - FIRSTu];\n";

/// Events of model exchange: of loops, of conditions, and of conditions on the time.
fn events(plan: &Plan) -> Vec<(&'static str, String)> {
    let (loops, guards, times) = (plan.is_loops(), plan.counts.guards > 0, plan.counts.times > 0);
    let only = |wanted: bool, text: &str| if wanted { text.to_owned() } else { String::new() };
    let indicators = [
        only(guards, GUARD_INDICATORS),
        only(loops, "    values[@guards@] = (self->own.leaves != 0) ? -1.0 : 1.0;\n"),
    ];
    let is_due = [only(loops, "    *event = self->own.leaves;\n"), only(guards, GUARDS_DUE)];
    let happens = [only(loops, LEAVE), only(times, SWITCH_TIMES), only(guards, SWITCH)];
    let crosses = "        if (@p@_crossed(&at, trial.time, trial.x) > @sharp@) {\n            \
        status = @p@_fail(&trial, PLM_POSE, @part_pose@);\n        }\n";
    vec![
        ("follow", only(loops, FOLLOW)),
        ("next", only(times, NEXT)),
        ("crosses", only(loops && plan.lowered.may_be_singular, crosses)),
        (
            "reach",
            only(
                loops,
                "        const int status = @p@_fmu_follow(self, failure);\n        if (status != @P@_OK) {\n            return status;\n        }\n",
            ),
        ),
        ("indicators", indicators.concat()),
        ("is_due", is_due.concat()),
        ("events", happens.concat()),
    ]
}

const GUARD_INDICATORS: &str = "    {\n        const @p@ *there = &self->own.there;\n        double g[@watched@];\n        int k;\n        \
    @p@_guards_in(there, there->time, there->x, g);\n        for (k = 0; k < @guards@; k++) {\n            \
    if (!plm_is_finite(g[k])) {\n                return @p@_fmu_tell(self, failure, \"a condition is not a number\", \"\");\n            }\n            \
    /* It goes on through zero where the condition changes its side. */\n            values[k] = -there->side[k] * g[k];\n        }\n    }\n";
const GUARDS_DUE: &str = "    {\n        const @p@ *there = &self->own.there;\n        double g[@watched@];\n        int k;\n        \
    @p@_guards_in(there, there->time + @p@_fmu_near(there->time), ahead, g);\n        for (k = 0; k < @guards@; k++) {\n            \
    if (g[k] < 0.0) {\n                *event = 1;\n            }\n        }\n    }\n";
const LEAVE: &str = "    if (self->own.leaves != 0) {\n        double memory[@memory@];\n        \
    const double far = @p@_remember_in(&after, after.time, after.x, memory);\n        \
    @p@_leave(&after, after.time, far, after.x);\n        if (after.chart < 0) {\n            \
    return @p@_fmu_tell(self, @P@_ERROR, \"the equations are nearly singular at this pose\", \"\");\n        }\n        \
    self->own.there = after;\n        self->own.is_there = 1;\n        self->own.leaves = 0;\n        \
    *changed = 1;\n        status = @p@_fmu_ahead(self, @P@_ERROR, ahead);\n        if (status != @P@_OK) {\n            return status;\n        }\n    }\n";
const SWITCH_TIMES: &str = "    {\n        int part = 0;\n        \
    (void)@p@_switch_at_time(&after, after.time + @p@_fmu_near(after.time), ahead, &part);\n    }\n    \
    *is_known = @p@_fmu_next(&after, after.time + @p@_fmu_near(after.time), next);\n";
const SWITCH: &str = "    status = @p@_switch(&after, after.time + @p@_fmu_near(after.time), ahead);\n    \
    if (status != PLM_OK) {\n        return @p@_fmu_failed(self, @P@_ERROR, &after, status);\n    }\n";

/// Numbers and names.
fn numbers(plan: &Plan, facts: &Facts, mark: u64) -> Vec<(&'static str, String)> {
    let (c, count) = (plan.c(), facts.variables.len());
    let names: Vec<String> = facts.names().iter().map(|name| format!("    {}", quoted(name))).collect();
    let mut nominals: Vec<String> = facts.states.iter().map(|(_, nominal)| c.number(*nominal)).collect();
    nominals.resize(plan.length("x"), c.number(1.0));
    let indicators =
        facts.variables.iter().filter(|variable| matches!(variable, Variable::Indicator(_))).count();
    // Without a step there is no variable of it.
    let step = facts.variables.iter().position(|variable| *variable == Variable::Step).unwrap_or(count);
    vec![
        ("names", names.join(",\n")),
        ("nominals", nominals.join(", ")),
        ("variables", count.to_string()),
        ("indicator_room", indicators.max(1).to_string()),
        ("indicators_count", indicators.to_string()),
        ("step_reference", step.to_string()),
        ("step", c.number(facts.step)),
        ("start", format!("{:?}", plan.start.time)),
        ("mark", format!("0x{mark:016x}")),
        ("token", facts.token.clone()),
        ("P", format!("{}_FMU", plan.upper)),
    ]
}

//! The function by which a source tells whether it is computed as it was written: bits of a rate and of a step, made here in the numbers of
//! the source.

use std::fmt::Write as _;

use plm_compiler::Source;
use plm_compiler::lowered::{Routine, Target};
use plm_runtime::{Real, Scalar};

use crate::Precision;
use crate::block::Argument;
use crate::contact;
use crate::dialect::Dialect as _;
use crate::plan::Plan;
use crate::rk4;

/// The length of the step, s: exact in all precisions.
pub(crate) const STEP: f64 = 1.0 / 1024.0;

/// Numbers of the start in a type.
struct At<'a, S> {
    t: S,
    x: &'a [S],
    parameters: &'a [S],
    inputs: &'a [S],
    sides: &'a [S],
    turns: &'a [i32],
    memory: &'a [S],
}

impl<S: Real> At<'_, S> {
    fn read(&self, argument: Argument) -> S {
        let of = |all: &[S], k: usize| all.get(k).copied().unwrap_or(S::ZERO);
        match argument {
            Argument::Time => self.t,
            Argument::Parameter(k) => of(self.parameters, k),
            Argument::Input(k) => of(self.inputs, k),
            Argument::Side(k) => of(self.sides, k),
            Argument::Turns(k) => S::lit(self.turns.get(k).copied().map_or(0.0, f64::from)),
            Argument::Remembered(k) => of(self.memory, k),
            // Neither the motion without forces nor its rows read modes.
            Argument::Mode(..) => S::ZERO,
            Argument::Element(_, k) => of(self.x, k),
        }
    }
}

/// Results of a routine of the plan in numbers of a type.
fn results<S: Real>(plan: &Plan, routine: &Routine, at: &At<'_, S>) -> Vec<(Target, S)> {
    let mut block = plan.block();
    let results = block.routine(routine, |block, source: Source| plan.read(block, source));
    let all = block.evaluate(|argument| at.read(argument));
    results.into_iter().map(|(target, value)| (target, all[value.index()])).collect()
}

/// All numbers of the start in a type.
struct Start<S> {
    x: Vec<S>,
    parameters: Vec<S>,
    inputs: Vec<S>,
    sides: Vec<S>,
    memory: Vec<S>,
}

impl<S: Real> Start<S> {
    fn new(plan: &Plan) -> Start<S> {
        let start = &plan.start;
        let all = |numbers: &[f64]| numbers.iter().map(|number| S::lit(*number)).collect();
        Start {
            x: all(&start.x),
            parameters: all(&start.parameters),
            inputs: all(&start.inputs),
            sides: all(&start.sides),
            memory: all(&start.memory),
        }
    }

    fn at<'a>(&'a self, plan: &'a Plan, t: S, x: &'a [S]) -> At<'a, S> {
        let Start { parameters, inputs, sides, memory, .. } = self;
        At { t, x, parameters, inputs, sides, turns: &plan.start.turns, memory }
    }
}

/// Continuation data of the start in the numbers of the source: those of the loops at the rounded state.
pub(crate) fn memory(plan: &Plan) -> Vec<f64> {
    if plan.precision == Precision::Double {
        return plan.start.memory.clone();
    }
    let start = Start::<f32>::new(plan);
    let chart = plan.start.chart.and_then(|chart| plan.lowered.charts.get(chart));
    let Some(remember) = chart.and_then(|chart| chart.remember.as_ref()) else {
        return plan.start.memory.clone();
    };
    let mut memory = vec![0.0; plan.start.memory.len()];
    for (target, value) in results(plan, remember, &start.at(plan, plan.start.time as f32, &start.x)) {
        if let Target::Remembered(k) = target
            && let Some(to) = memory.get_mut(k)
        {
            *to = f64::from(value);
        }
    }
    memory
}

/// Are the equations in absolute coordinates singular at the start, as where rows depend on each other?
pub(crate) fn is_singular(plan: &Plan) -> bool {
    let (start, equations) = (Start::<f64>::new(plan), &plan.lowered.absolute.dynamics);
    let results = results(plan, equations, &start.at(plan, plan.start.time, &start.x));
    // False for NaN.
    let is_good = |(target, value): &(Target, f64)| match target {
        Target::Value => *value > f64::HEALTHY,
        Target::Element("dx", _) => value.is_finite(),
        _ => true,
    };
    !results.iter().all(is_good)
}

/// The function.
pub(crate) fn check(plan: &Plan) -> String {
    match plan.precision {
        Precision::Double => check_of::<f64>(plan),
        Precision::Single => check_of::<f32>(plan),
    }
}

fn check_of<S: Real>(plan: &Plan) -> String {
    let mut start = Start::<S>::new(plan);
    start.memory = memory(plan).into_iter().map(S::lit).collect();
    let chart = plan.start.chart.unwrap_or(0);
    let count = plan.counts.states;
    let t = S::lit(plan.start.time);
    let place = if plan.is_loops() { chart } else { 0 };
    if let Some(chart) = plan.lowered.contacts.as_ref().and_then(|contacts| contacts.charts.get(place)) {
        let (block, results) = contact::motion(plan, chart);
        let at = start.at(plan, t, &start.x);
        let all = block.evaluate(|argument| at.read(argument));
        let mut rates = vec![S::ZERO; count];
        for (target, value) in results {
            if let Target::Element("dx", k) = target {
                rates[k] = all[value.index()];
            }
        }
        let numbers = |step: &Vec<f64>| -> Vec<S> { step.iter().map(|number| S::lit(*number)).collect() };
        let step = plan.over_contact.as_ref().map(numbers);
        return text(plan, &rates, step.as_deref());
    }
    let in_chart = plan.lowered.charts.get(chart).map(|chart| &chart.rate);
    let Some(rate) = in_chart.or(plan.is_absolute().then_some(&plan.lowered.absolute.dynamics)) else {
        return String::new();
    };
    let rates = |t: S, x: &[S]| {
        let mut rates = vec![S::ZERO; count];
        for (target, value) in results(plan, rate, &start.at(plan, t, x)) {
            if let Target::Element("dx", k) = target {
                rates[k] = value;
            }
        }
        rates
    };
    let first = rates(t, &start.x);
    let step = rk4::step((t, S::lit(STEP)), &start.x, plan.counts.coordinates, rates);
    text(plan, &first, Some(&step))
}

/// The text of the function, with the numbers that it expects.
fn text<S: Real>(plan: &Plan, rates: &[S], step: Option<&[S]>) -> String {
    let (p, c, states) = (&plan.name, plan.c(), plan.length("x"));
    let mut text = String::new();
    let array = |numbers: &[S]| {
        let mut all: Vec<String> = numbers.iter().map(|number| c.number(number.to_f64())).collect();
        all.resize(states, c.number(0.0));
        all.join(", ")
    };
    let [rates, after, length] = [array(rates), array(step.unwrap_or_default()), c.number(STEP)];
    let of_contact = plan.lowered.contacts.is_some();
    let fields = if of_contact {
        plan.filled("    @p@_motion motion;\n    @p@_solved solved;\n    plm_real place[@places@], health;\n    int part;\n")
    } else {
        String::new()
    };
    let [own, rate, formula] = if of_contact {
        [
            "motion.dx",
            "@p@_motion_in(&self, self.time, self.x, &motion)",
            "@p@_stride(&self, LENGTH, own, &solved, place, &health, &part)",
        ]
    } else {
        ["own", "@p@_rate_in(&self, self.time, self.x, own)", "@p@_formula(&self, LENGTH, own)"]
    };
    let [rate, formula] = [rate, formula].map(|call| plan.filled(call).replace("LENGTH", &length));
    let table = |name: &str, numbers: &str| {
        format!("    static const plm_real {name}[{states}] = {{ {numbers} }};\n")
    };
    let tables = format!(
        "{}{}",
        table("rates", &rates),
        if step.is_some() { table("after", &after) } else { String::new() }
    );
    let compared = |own: &str, with: &str, number: u32| {
        let count = plan.counts.states;
        format!(
            "    for (k = 0; k < {count}; k++) {{\n        if (plm_to_bits({own}[k]) != plm_to_bits({with}[k])) {{\n            return {number};\n        }}\n    }}\n"
        )
    };
    // A step that cannot be made has no state.
    let of_step = if step.is_some() {
        format!("    (void){formula};\n{}", compared("own", "after", 4))
    } else {
        "    (void)own;\n".to_owned()
    };
    let _ = write!(
        text,
        "/* ---- check ---- */\n\nint {p}_check(void)\n{{\n{tables}    \
         /* A difference of numbers whose exponents are 33 apart, which the soft arithmetic of some libraries rounds wrongly. */\n    \
         const volatile plm_real one = PLM_C(1.0), small = {}, product = {};\n    \
         const plm_real difference = one - small;\n    \
         const plm_real square = product * product;\n    \
         const plm_real fused = square - one;\n    \
         {p}_object self;\n    plm_real own[{states}];\n{fields}    int k;\n    \
         if (plm_to_bits(difference) != plm_to_bits({})) {{\n        return 1;\n    }}\n    \
         if (plm_to_bits(fused) != plm_to_bits({})) {{\n        return 2;\n    }}\n    \
         {p}_init(&self);\n    (void){rate};\n{}{of_step}    \
         return 0;\n}}\n",
        c.number(1.3e-10),
        c.number(fused_factor::<S>()),
        c.number((S::lit(1.0) - S::lit(1.3e-10)).to_f64()),
        c.number({
            let factor = S::lit(fused_factor::<S>());
            (factor * factor - S::lit(1.0)).to_f64()
        }),
        compared(own, "rates", 3),
    );
    text
}

/// A number whose square less one is zero only where it is rounded before the difference.
fn fused_factor<S: Real>() -> f64 {
    (S::lit(1.0) + S::EPSILON).to_f64()
}

//! Numbers of the runtime's tolerances as constants of C.

use plm_runtime::charts::Constants;
use plm_runtime::{Real, turns};

use crate::Precision;
use crate::dialect::Dialect as _;
use crate::plan::Plan;

/// The words of templates that are numbers, in the precision of a source.
pub(crate) fn numbers(plan: &Plan) -> Vec<(&'static str, String)> {
    match plan.precision {
        Precision::Double => numbers_of::<f64>(plan),
        Precision::Single => numbers_of::<f32>(plan),
    }
}

fn numbers_of<S: Real>(plan: &Plan) -> Vec<(&'static str, String)> {
    let c = plan.c();
    let number = |value: S| c.number(value.to_f64());
    let constants = Constants::<S>::new();
    let [farthest, _, inverse, turn, low] = turns::constants::<S>();
    let mut all = vec![
        ("healthy", c.number(S::HEALTHY)),
        ("sixth", c.number(1.0 / 6.0)),
        ("farthest_turn", number(farthest)),
        ("inverse_turn", number(inverse)),
        ("turn", number(turn)),
        ("turn_low", number(low)),
        ("flat", number(constants.flat)),
        ("better", number(constants.better)),
        ("regular", number(constants.regular)),
        ("open", number(constants.open)),
        ("box", number(constants.interval)),
        ("boxes", number(constants.intervals)),
        ("part_of_interval", number(constants.probe)),
        ("far", number(constants.far)),
        ("farthest", number(constants.farthest)),
        ("farthest_iterated", number(constants.farthest_iterated)),
        ("narrowest_square", number(constants.narrowest_square)),
        ("noticed", number(constants.noticed)),
        ("narrowest", number(constants.narrowest)),
        ("sharp", number(constants.sharp)),
    ];
    if plan.is_loops() {
        let typical = |k: usize| S::lit(plan.lowered.typical.get(k).copied().unwrap_or(1.0));
        let of_each = |of: &dyn Fn(usize) -> S| {
            let all: Vec<String> = (0..plan.counts.coordinates.max(1)).map(|k| number(of(k))).collect();
            all.join(", ")
        };
        let count = plan.counts.coordinates.max(1);
        all.push(("tight", of_each(&|k| Constants::<S>::tight(count) * typical(k))));
        all.push(("ample", of_each(&|k| Constants::<S>::ample(count) * typical(k))));
        all.push(("typical", of_each(&typical)));
    }
    all
}

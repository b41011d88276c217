//! Mechanisms by rustc: those from text have to have their bits.

use plm_oracle::Look;
use plm_runtime::Start;

use crate::judge::{Case, TOLERANCE};
use crate::run::{Method, Order, Outcome, Pace, run};

/// A declared mechanism that takes its numbers from a case.
pub trait Build: Look<S = f64> {
    /// With parameters in the order of the declaration and start values of each body.
    fn build(numbers: &[f64], starts: &[Start<f64>]) -> Self;
}

/// Runs a case.
pub type Runner = fn(&Order) -> Outcome;

pub fn runner<M: Build>(order: &Order) -> Outcome {
    run(M::build(order.numbers, order.starts), order)
}

/// Runs of a case by every formulation, from event to event and by `MoreauJean`: how many there are, how many end with a fault, and how many
/// have other bits by rustc, which are printed.
pub fn compare(case: &Case) -> [usize; 3] {
    let mut counts = [0; 3];
    for (number, (formulation, _)) in case.family.declarations.iter().enumerate() {
        let by_events = Method::Events { pace: Pace::Samples, tolerance: TOLERANCE };
        for method in [by_events, Method::Steps { length: 1e-3 }] {
            let text = case.run(number, method);
            counts[0] += 1;
            counts[1] += usize::from(text.fault.is_some());
            // Every digit of every number.
            let compiled = case.with_order(method, case.family.compiled[number]);
            let [text, compiled] = [text, compiled].map(|outcome| format!("{outcome:?}"));
            if text != compiled {
                counts[2] += 1;
                println!("{}, {formulation}, {method:?}: {}", case.family.name, difference(&text, &compiled));
            }
        }
    }
    counts
}

/// The first difference of two texts, with what stands around it.
fn difference(text: &str, compiled: &str) -> String {
    let same = text.chars().zip(compiled.chars()).take_while(|(text, compiled)| text == compiled).count();
    let from = |all: &str| all.chars().skip(same.saturating_sub(40)).take(120).collect::<String>();
    format!("{} from text, {} compiled", from(text), from(compiled))
}

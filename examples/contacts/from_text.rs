//! Cases that run from text as well, as machine code: their outcomes have to be those of compiled mechanisms to the bit.

use std::collections::BTreeMap;
use std::sync::Arc;

use plm::dynamic::{Compiled, Small, State};
use plm::jit::Host;
use plm::runtime::{Described, StartValues, Statics};
use plm::{BodyState, Start};

use crate::judge::{Case, TOLERANCE};
use crate::run::{Look, Method, Order, Outcome, Pace, run};

impl Look for Small {
    fn bodies(state: &Self::State, mut each: impl FnMut(BodyState<f64>)) {
        Self::poses(state, &mut each);
    }

    fn energies(state: &Self::State) -> [f64; 2] {
        [State::kinetic_energy(state), State::gravity_energy(state)]
    }
}

/// Mechanisms of declarations, each compiled once.
#[derive(Default)]
pub struct Texts(BTreeMap<&'static str, Small>);

impl Texts {
    /// The outcomes of a case by every formulation, from event to event and by `MoreauJean`: how many there are, how many end with a fault,
    /// and how many differ.
    pub fn compare(&mut self, case: &Case) -> Result<[usize; 3], String> {
        let mut counts = [0; 3];
        for (number, declaration) in case.family.declarations.iter().enumerate() {
            let text = self.mechanism(declaration)?;
            let by_events = Method::Events { pace: Pace::Samples, tolerance: TOLERANCE };
            for method in [by_events, Method::Steps { length: 1e-3 }] {
                let own = case.with_order(method, |order| run(built(text, order), order));
                counts[1] += usize::from(own.fault.is_some());
                // Every digit of every number.
                let [own, compiled] =
                    [own, case.run(number, method)].map(|outcome: Outcome| format!("{outcome:?}"));
                counts[0] += 1;
                if own != compiled {
                    counts[2] += 1;
                    let formulation = case.family.runners[number].0;
                    println!(
                        "{}, {formulation}, {method:?}: {}",
                        case.family.name,
                        difference(&own, &compiled)
                    );
                }
            }
        }
        Ok(counts)
    }

    fn mechanism(&mut self, declaration: &'static str) -> Result<Small, String> {
        if let Some(known) = self.0.get(declaration) {
            return Ok(*known);
        }
        let compiled = Compiled::new("case.plm", declaration).map_err(|refused| refused.to_string())?;
        let text: Small = compiled.mechanism().map_err(|refused| refused.to_string())?;
        text.translate_by(Arc::new(Host::new().ok_or("no machine code for this processor")?.after(20)));
        self.0.insert(declaration, text);
        Ok(text)
    }
}

/// A mechanism from text with the numbers of a case.
fn built(mut text: Small, order: &Order) -> Small {
    for (index, number) in order.numbers.iter().enumerate() {
        if let Some(parameter) = text.parameter_mut(index) {
            *parameter = *number;
        }
    }
    let mut starts = order.starts.iter();
    text.starts_mut().each(&mut |_, start| {
        if let Some(value) = starts.next() {
            *start = Start::free(*value);
        }
    });
    text
}

/// The first difference of two texts, with what stands around it.
fn difference(own: &str, compiled: &str) -> String {
    let same = own.chars().zip(compiled.chars()).take_while(|(own, compiled)| own == compiled).count();
    let from = |text: &str| text.chars().skip(same.saturating_sub(40)).take(120).collect::<String>();
    format!("{} from text, {} compiled", from(own), from(compiled))
}

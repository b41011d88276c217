//! Steps of a mechanism from its start, as both benches run them.

use std::hint::black_box;

use plm::runtime::method::{Formula, Rk4Formula};
use plm::{Mechanism, Moment, Rk4};

/// Makes so many Runge-Kutta 4 steps from the start.
pub(crate) type Steps = Box<dyn FnMut(u32)>;

/// Which step is made.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Level {
    /// The formula alone: four rates and their combinations, with the health of the solutions.
    Formula,
    /// A step of `Sim`, with the watch over drift and health that a user gets.
    Sim,
}

/// Steps of length h of a mechanism.
pub(crate) fn steps<M: Mechanism<S = f64> + 'static>(mechanism: M, h: f64, level: Level) -> Steps {
    let start = mechanism.start_with(Rk4::new(h)).expect("the mechanism can be assembled");
    match level {
        Level::Formula => {
            let (input, start) = (start.state().held(), *start.state().x());
            Box::new(move |steps| {
                let mut x = start;
                for step in 0..steps {
                    let t = f64::from(step) * h;
                    black_box(Rk4Formula::plain_step(&mechanism, t, &input, &mut x, h));
                }
                black_box(&x);
            })
        }
        Level::Sim => Box::new(move |steps| {
            let mut sim = start;
            for _ in 0..steps {
                sim.step(h).expect("the mechanism can be moved");
            }
            black_box(sim.state().x());
        }),
    }
}

//! One step, from its proposal to its commit.
//!
//! 1. A method proposes a step ([`Method::advance`](crate::Method::advance),
//!    [`FixedLength::fast_step`](crate::method::FixedLength::fast_step)). With dense output the event detector
//!    ([`crate::events`]) ends it at the first event.
//! 2. The judge returns a verdict, and changes nothing but the copies of the proposal.
//! 3. The verdict is carried out: the state is projected, or the step is shortened, split, left to the near-singular method, refused, or
//!    committed: discrete state, charts, revolutions, then the events at its end.
//!
//! | path | proposal | what is done |
//! |---|---|---|
//! | general | any method | `advance`; a fixed step in which contact changes in two parts (`cut`) |
//! | steps that need no further action, of systems with a large discrete state | a formula | commits, else as general |
//! | an interval of one fixed step | a formula, on a copy of the state | commits if accepted at once, else the general path repeats it |
//! | a single step ([`crate::step`]) | code that is emitted | commits, or is a fault |
//! | lanes ([`crate::lanes`]) | eight formulas at once | as `advance`, lane by lane |

mod advance;
mod coast;
mod cut;
mod energy;
mod judge;
mod near_singular;
mod observer;
mod parts;

pub(crate) use self::advance::{Advance, Guarded, Made};
pub(crate) use self::judge::{Limits, Proposal, Rules, Verdict, judge};
pub use self::near_singular::{Nearness, Rescue};
pub(crate) use self::observer::{Observer, Trigger, Unobserved};

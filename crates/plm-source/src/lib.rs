//! A mechanism as C99 source: its routines printed as straight-line functions, and around them the step of fixed length that targets run.
//!
//! The source needs no library, allocates nothing and has no variables of its own. Its numbers are those of the compiled mechanism, to the
//! bit, as far as a C compiler rounds as IEEE 754 says: `NAME_check` of each source tells whether it does. [`Refused`] names the part
//! of a mechanism that no source has yet; nothing is printed with other numbers instead.

mod absolute;
mod block;
mod c;
mod check;
mod contact;
mod cuda;
mod dialect;
mod events;
mod fmu;
mod function;
mod header;
mod kinds;
mod loops;
mod names;
mod numbers;
mod plan;
mod print;
mod rk4;
mod ros2;
mod source;
mod template;

use std::fmt;

use plm_dynamic::{Error, Mechanism, Steps};
use plm_runtime::Fault;

pub use self::cuda::cuda;
pub use self::fmu::{Fmu, fmu};
pub use self::plan::Refused;
pub use self::ros2::ros2;
pub use plm_foreign::fmi::{Interfaces, Version};

/// The numbers that a source computes with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// `double`
    #[default]
    Double,
    /// `float`
    Single,
}

/// A file of a source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Why there is no source.
#[derive(Clone, Debug)]
pub enum Failure {
    /// The mechanism cannot be started.
    Start(Error),
    /// It has parts that no source has.
    Refused(Vec<Refused>),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start(error) => write!(f, "{error}"),
            Self::Refused(all) => {
                f.write_str("a C source does not have:")?;
                all.iter().try_for_each(|refused| write!(f, "\n  {refused}"))
            }
        }
    }
}

impl std::error::Error for Failure {}

/// The elementary functions, which every source includes.
const MATH: &str = include_str!("c/plm_math.h");

/// C99 of a mechanism with the values that its parameters, inputs and start values have: a header, a source, and `plm_math.h`. Steps are
/// those of the classical Runge-Kutta method; over rows of contact those of Moreau and Jean, with one evaluation and theta 1/2.
///
/// # Errors
/// [`Failure::Start`], where it cannot be assembled; [`Failure::Refused`].
pub fn c(mechanism: &Mechanism, precision: Precision) -> Result<Vec<File>, Failure> {
    printed(mechanism, precision).map(Vec::from)
}

/// Makes the step of a source by text, of `h`, s: over rows of contact that of Moreau and Jean, else that of Runge and Kutta.
///
/// # Errors
/// Those of the step; the mechanism stays as it was.
pub fn step(steps: &mut Steps, mechanism: &Mechanism, h: f64) -> Result<(), Fault> {
    if mechanism.lowered().contacts.is_some() { steps.step_moreau_jean(h).map(|_| ()) } else { steps.step(h) }
}

/// The header, the source and `plm_math.h`.
fn printed(mechanism: &Mechanism, precision: Precision) -> Result<[File; 3], Failure> {
    let lowered = mechanism.lowered();
    let refused = plan::refused(lowered);
    if !refused.is_empty() {
        return Err(Failure::Refused(refused));
    }
    let steps = mechanism.steps().map_err(Failure::Start)?;
    if let Some(refused) = plan::without_chart(lowered, &steps.numbers()) {
        return Err(Failure::Refused(vec![refused]));
    }
    let plan = plan::Plan::new(mechanism, &steps, precision);
    if plan.is_absolute() && check::is_singular(&plan) {
        let part = lowered.rows.first().map_or_else(String::new, |row| row.part.clone());
        let what = "a start at which rows depend on each other, which the library solves by rank";
        return Err(Failure::Refused(vec![Refused { part, what }]));
    }
    let name = plan.name.clone();
    let math = File { name: "plm_math.h".to_owned(), text: MATH.to_owned() };
    Ok([
        File { name: format!("{name}.h"), text: header::header(&plan) },
        File { name: format!("{name}.c"), text: source::source(&plan) },
        math,
    ])
}

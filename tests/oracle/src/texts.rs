//! Mechanisms of declarations, each compiled once in a program, as machine code.

use std::any::{Any, TypeId};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use plm_dynamic::{Compiled, Dynamic, ROWS, SWITCHES, State};
use plm_jit::Host;
use plm_runtime::{BodyState, Described, Mechanism, Start, StartValues, Statics};

/// A mechanism from text of at most `NQ / 3` bodies, `NC` rows and `P` parameters.
pub type Text<const NQ: usize, const NC: usize, const N: usize, const P: usize> =
    Dynamic<f64, NQ, NC, N, NQ, SWITCHES, ROWS, P>;

/// A mechanism whose bodies and energies are looked at.
pub trait Look: Mechanism {
    /// Gives `each` the bodies in their order.
    fn bodies(state: &Self::State, each: impl FnMut(BodyState<Self::S>));
    /// Kinetic energy and that of gravity, J.
    fn energies(state: &Self::State) -> [Self::S; 2];
}

impl<const NQ: usize, const NC: usize, const N: usize, const L: usize, const P: usize> Look
    for Dynamic<f64, NQ, NC, N, L, SWITCHES, ROWS, P>
{
    fn bodies(state: &Self::State, mut each: impl FnMut(BodyState<f64>)) {
        Self::poses(state, &mut each);
    }

    fn energies(state: &Self::State) -> [f64; 2] {
        [State::kinetic_energy(state), State::gravity_energy(state)]
    }
}

/// A function is machine code from so many evaluations on.
const TRANSLATED_AFTER: u32 = 20;

/// Mechanisms by their sizes and declarations.
type Known = BTreeMap<(TypeId, String), Box<dyn Any + Send>>;

/// The mechanism of a declaration, with its defaults; its loops remember at most `L` numbers of each kind.
///
/// # Errors
/// A mistake in the declaration, with its place; what there is no room for; a processor without machine code.
pub fn mechanism<const NQ: usize, const NC: usize, const N: usize, const L: usize, const P: usize>(
    declaration: &str,
) -> Result<Dynamic<f64, NQ, NC, N, L, SWITCHES, ROWS, P>, String> {
    static KNOWN: OnceLock<Mutex<Known>> = OnceLock::new();
    let mut known = KNOWN.get_or_init(Mutex::default).lock().unwrap_or_else(PoisonError::into_inner);
    let key = (TypeId::of::<Dynamic<f64, NQ, NC, N, L, SWITCHES, ROWS, P>>(), declaration.to_owned());
    if let Some(known) = known.get(&key).and_then(|known| known.downcast_ref()) {
        return Ok(*known);
    }
    let compiled = Compiled::new("case.plm", declaration).map_err(|refused| refused.to_string())?;
    let text: Dynamic<f64, NQ, NC, N, L, SWITCHES, ROWS, P> =
        compiled.mechanism().map_err(|refused| refused.to_string())?;
    let host = Host::new().ok_or("no machine code for this processor")?;
    text.translate_by(Arc::new(host.after(TRANSLATED_AFTER)));
    known.insert(key, Box::new(text));
    Ok(text)
}

/// The mechanism of a declaration with parameters in its order, and with start values: of each body x, y, angle, vx, vy, omega.
///
/// # Errors
/// A mistake in the declaration, with its place; a processor without machine code; numbers that are too many or too few.
pub fn with_numbers<const NQ: usize, const NC: usize, const N: usize, const P: usize>(
    declaration: &'static str,
    numbers: &[f64],
    starts: &[Start<f64>],
) -> Result<Text<NQ, NC, N, P>, String> {
    let mut text: Text<NQ, NC, N, P> = mechanism(declaration)?;
    for (index, number) in numbers.iter().enumerate() {
        *text.parameter_mut(index).ok_or_else(|| format!("there is no parameter {index}"))? = *number;
    }
    if text.parameter_mut(numbers.len()).is_some() {
        return Err(format!("there are more than {} parameters", numbers.len()));
    }
    let (mut left, mut missing) = (starts.iter(), 0);
    text.starts_mut().each(&mut |_, start| match left.next() {
        Some(value) => *start = *value,
        None => missing += 1,
    });
    match (left.count(), missing) {
        (0, 0) => Ok(text),
        (more, less) => Err(format!("{more} start values are too many, {less} are missing")),
    }
}

//! Runge-Kutta 4 steps of fixed length of five mechanisms, and steps of Moreau and Jean of three with contact, by [`Sim`] and by the
//! step that their code holds; and steps of a filter.

use plm::runtime::Vector;
use plm::{Fault, Moment, MoreauJean, Real, Rk4, Sim};

use crate::arm::Arm;
use crate::contact::{Limits, Rack, Ratchet};
use crate::filter::Filter;
use scenes::{andrews, double_pendulum, four_bar, slider_crank};

#[path = "../../../tests/support/scenes.rs"]
#[allow(unused_imports, unreachable_pub, reason = "scenes of tests, benches and examples")]
mod scenes;

double_pendulum!(s1: emit: step(rk4););
four_bar!(s2: emit: step(rk4););
slider_crank!(s6: emit: step(rk4););
andrews!(s5: emit: step(rk4););

/// Steps of each run.
const STEPS: u32 = 10_000;
/// Square roots that are compared beside them.
const ROOTS: u64 = 20_000;

/// What is known of a run.
#[cfg_attr(feature = "std", expect(dead_code, reason = "an ordinary program counts nothing"))]
pub struct Run {
    /// Name of the mechanism, of its scalar, and who made the steps.
    pub name: [&'static str; 3],
    /// Instructions of a step, the fewest and the most; 0 where none are counted.
    pub instructions: [u32; 2],
    /// Stack of the start and all steps, bytes.
    pub stack: u32,
    /// What a program holds between steps, bytes.
    pub size: usize,
}

/// Runs all; `emit` gets the bits, `done` what a run took.
///
/// # Errors
/// If a mechanism cannot be assembled or moved.
pub fn run(emit: &mut impl FnMut(u64), done: &mut impl FnMut(&Run)) -> Result<(), Fault> {
    #[cfg(feature = "f32")]
    precision::<f32>("f32", emit, done)?;
    #[cfg(feature = "f64")]
    precision::<f64>("f64", emit, done)?;
    Ok(())
}

fn precision<S: Real>(
    scalar: &'static str,
    emit: &mut impl FnMut(u64),
    done: &mut impl FnMut(&Run),
) -> Result<(), Fault> {
    /// A mechanism has its own step as a method of its own state, which no trait names.
    macro_rules! mechanism {
        ($name:literal, $mechanism:ty, $h:literal) => {
            mechanism!($name, $mechanism, $h, Rk4, |s, h| s.step_rk4(h))
        };
        ($name:literal, $mechanism:ty) => {
            mechanism!($name, $mechanism, 1e-3, MoreauJean, |s, h| s.step_moreau_jean(h).map(|_| ()))
        };
        ($name:literal, $mechanism:ty, $h:literal, $method:ident, |$s:ident, $step:ident| $alone:expr) => {{
            let (mechanism, h) = (<$mechanism>::of(), S::lit($h));
            let mut sim = |sim: &mut Sim<$mechanism, $method<S>>| sim.step(h);
            done(&steps(
                [$name, scalar, "Sim"],
                || mechanism.start_with($method::new(h)),
                |s| *s.state().x(),
                &mut sim,
                emit,
            )?);
            let start = || Ok(*mechanism.start_with($method::new(h))?.state());
            let $step = h;
            done(&steps([$name, scalar, "step"], start, |s| *s.x(), &mut |$s| $alone, emit)?);
        }};
    }
    mechanism!("double pendulum", s1::DoublePendulum::<S>, 1e-3);
    mechanism!("four-bar", s2::FourBar::<S>, 1e-3);
    mechanism!("slider-crank", s6::SliderCrank::<S>, 1e-3);
    mechanism!("Andrews", s5::Andrews::<S>, 1e-5);
    mechanism!("arm on a jack", Arm::<S>, 1e-5);
    mechanism!("four-bar with limits", Limits::<S>);
    mechanism!("rack with backlash", Rack::<S>);
    mechanism!("ratchet", Ratchet::<S>);
    let name = ["extended Kalman filter", scalar, "filter"];
    done(&steps(name, Filter::<S>::new, Filter::all, &mut Filter::step, emit)?);
    emit(roots::<S>());
    Ok(())
}

/// A number in which each bit of many square roots counts: of numbers of all exponents and signs, of subnormal ones, squares and
/// their neighbours, zeros, infinities, and what is not a number.
fn roots<S: Real>() -> u64 {
    let special = [0.0, -0.0, 1.0, f64::INFINITY, -1.0, f64::NAN, f64::MAX, 5e-324].map(f64::to_bits);
    // Multiples of the golden ratio meet all exponents.
    let all = (1..ROOTS).map(|k| k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let subnormal = all.clone().map(|bits| bits >> 12);
    let numbers = special.into_iter().chain(all).chain(subnormal).map(|bits| S::lit(f64::from_bits(bits)));
    numbers.fold(0xcbf2_9ce4_8422_2325, |sum, x| {
        let square = x * x;
        let near = S::EPSILON * square;
        [x, square, square - near, square + near].into_iter().fold(sum, |sum, x| {
            let root = x.sqrt();
            // Which bits of what is not a number come out is left open.
            fnv(sum, if root.to_f64().is_nan() { 1 } else { root.to_f64().to_bits() })
        })
    })
}

/// Makes the steps of one run. Emits the last state, and a number in which each bit of all states counts.
fn steps<T, X: Vector<S>, S: Real>(
    name: [&'static str; 3],
    start: impl FnOnce() -> Result<T, Fault>,
    x: impl Fn(&T) -> X,
    step: &mut impl FnMut(&mut T) -> Result<(), Fault>,
    emit: &mut impl FnMut(u64),
) -> Result<Run, Fault> {
    let mut all = 0xcbf2_9ce4_8422_2325;
    let (outcome, stack) = machine::stack(|| -> Result<_, Fault> {
        let (mut simulated, mut range) = (start()?, [u32::MAX, 0]);
        for _ in 0..STEPS {
            let (made, count) = machine::instructions(|| step(&mut simulated));
            made?;
            range = [range[0].min(count), range[1].max(count)];
            let x = x(&simulated);
            for index in 0..X::LEN {
                all = fnv(all, x.at(index).to_f64().to_bits());
            }
        }
        Ok((x(&simulated), range))
    });
    let (x, instructions) = outcome?;
    (0..X::LEN).for_each(|index| emit(x.at(index).to_f64().to_bits()));
    emit(all);
    Ok(Run { name, instructions, stack, size: size_of::<T>() })
}

/// The hash of Fowler, Noll and Vo, by words (FNV-1a).
fn fnv(hash: u64, word: u64) -> u64 {
    (hash ^ word).wrapping_mul(0x0100_0000_01b3)
}

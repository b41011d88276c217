//! The scenes as one would write them by hand: minimal coordinates, loops in closed form, constants folded, each with
//! its Runge-Kutta 4 step.
//!
//! There are two steps. The plain one evaluates four times what depends on the state, as any method for x' = f(x) does;
//! the paired one computes the poses of two stages side by side ([`crank`]). Both give the same bits.

// A kernel is one straight piece of code; what stays a call passes its numbers through memory.
#![allow(clippy::inline_always)]

mod andrews;
mod chain;
mod check;
mod crank;
mod double_pendulum;
mod dyad;
mod four_bar;
mod lanes;
mod slider_crank;

use std::f64::consts::{FRAC_PI_3, FRAC_PI_4};
use std::hint::black_box;

use super::Steps;
use andrews::Andrews;
pub(crate) use check::all_right;
use crank::Crank;
use four_bar::FourBar;
use lanes::Lanes;
use slider_crank::SliderCrank;

/// How the poses of the stages are computed.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Poses {
    OneByOne,
    InPairs,
}

/// A kernel of the scene that has its name.
pub(crate) struct Kernel {
    pub(crate) name: &'static str,
    /// Instructions that such kernels were seen to need, built for AVX2 and with fused multiply-add.
    pub(crate) known: Option<u32>,
    pub(crate) steps: fn(f64, Poses) -> Steps,
    /// Of eight trajectories side by side, which start a hundredth of a radian apart.
    pub(crate) lanes: Option<fn(f64) -> Steps>,
}

pub(crate) const KERNELS: &[Kernel] = &[
    kernel("S1", Some(340), double_pendulum, Some(double_pendula)),
    kernel(
        "S2",
        Some(726),
        |h, poses| crank::<FourBar>(FOUR_BAR, h, poses),
        Some(|h| cranks::<FourBar>(FOUR_BAR, h)),
    ),
    kernel(
        "S6",
        Some(465),
        |h, poses| crank::<SliderCrank>(SLIDER_CRANK, h, poses),
        Some(|h| cranks::<SliderCrank>(SLIDER_CRANK, h)),
    ),
    kernel(
        "S5",
        Some(1954),
        |h, poses| crank::<Andrews>(ANDREWS, h, poses),
        Some(|h| cranks::<Andrews>(ANDREWS, h)),
    ),
    kernel("chain 4", None, chain::<4>, None),
    kernel("chain 16", None, chain::<16>, None),
    kernel("chain 64", None, chain::<64>, None),
];

const fn kernel(
    name: &'static str,
    known: Option<u32>,
    steps: fn(f64, Poses) -> Steps,
    lanes: Option<fn(f64) -> Steps>,
) -> Kernel {
    Kernel { name, known, steps, lanes }
}

// Where the scenes start.
const DOUBLE_PENDULUM: double_pendulum::State = [[FRAC_PI_4, 0.0], [0.0; 2]];
const FOUR_BAR: [f64; 2] = [FRAC_PI_3, 0.0];
const SLIDER_CRANK: [f64; 2] = [FRAC_PI_3, 0.0];
const ANDREWS: [f64; 2] = [-0.061_713_890_014_276_45, 0.0];

/// The kernel of this name.
pub(crate) fn named(name: &str) -> &'static Kernel {
    KERNELS.iter().find(|kernel| kernel.name == name).expect("a kernel of the table")
}

fn double_pendulum(h: f64, poses: Poses) -> Steps {
    match poses {
        Poses::OneByOne => {
            repeat(DOUBLE_PENDULUM.map(|x| x.map(Lanes::<1>::from)), h, double_pendulum::plain_step)
        }
        Poses::InPairs => repeat(DOUBLE_PENDULUM, h, double_pendulum::paired_step),
    }
}

fn crank<K: Crank + 'static>(start: [f64; 2], h: f64, poses: Poses) -> Steps {
    match poses {
        Poses::OneByOne => repeat(start.map(Lanes::<1>::from), h, crank::plain_step::<K, 1>),
        Poses::InPairs => repeat(start, h, crank::paired_step::<K>),
    }
}

/// Eight start angles, from one on.
fn spread(first: f64) -> Lanes<8> {
    Lanes([0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|lane| first + 0.01 * lane))
}

fn double_pendula(h: f64) -> Steps {
    let mut start = DOUBLE_PENDULUM.map(|x| x.map(Lanes::from));
    start[0][0] = spread(DOUBLE_PENDULUM[0][0]);
    repeat(start, h, double_pendulum::plain_step)
}

fn cranks<K: Crank + 'static>([q, v]: [f64; 2], h: f64) -> Steps {
    repeat([spread(q), Lanes::from(v)], h, crank::plain_step::<K, 8>)
}

/// Steps from `start`; the function's own type, so that it becomes part of the loop.
fn repeat<X: Copy + 'static>(start: X, h: f64, step: impl Fn(X, f64) -> X + 'static) -> Steps {
    Box::new(move |steps| {
        let mut x = start;
        for _ in 0..steps {
            x = step(x, h);
        }
        black_box(&x);
    })
}

fn chain<const BARS: usize>(h: f64, poses: Poses) -> Steps {
    let step = match poses {
        Poses::OneByOne => chain::plain_step::<BARS>,
        Poses::InPairs => chain::paired_step::<BARS>,
    };
    Box::new(move |steps| {
        let mut x = chain::State::<BARS>::START;
        for _ in 0..steps {
            step(&mut x, h);
        }
        black_box(&x);
    })
}

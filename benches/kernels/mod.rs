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

use crate::scenes::Steps;
use andrews::Andrews;
pub(crate) use check::all_right;
use crank::Crank;
use four_bar::FourBar;
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
}

pub(crate) const KERNELS: &[Kernel] = &[
    Kernel { name: "S1", known: Some(340), steps: double_pendulum },
    Kernel { name: "S2", known: Some(726), steps: |h, poses| crank::<FourBar>(FOUR_BAR, h, poses) },
    Kernel { name: "S6", known: Some(465), steps: |h, poses| crank::<SliderCrank>(SLIDER_CRANK, h, poses) },
    Kernel { name: "S5", known: Some(1954), steps: |h, poses| crank::<Andrews>(ANDREWS, h, poses) },
    Kernel { name: "chain 4", known: None, steps: chain::<4> },
    Kernel { name: "chain 16", known: None, steps: chain::<16> },
    Kernel { name: "chain 64", known: None, steps: chain::<64> },
];

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
        Poses::OneByOne => repeat(DOUBLE_PENDULUM, h, double_pendulum::plain_step),
        Poses::InPairs => repeat(DOUBLE_PENDULUM, h, double_pendulum::paired_step),
    }
}

fn crank<K: Crank + 'static>(start: [f64; 2], h: f64, poses: Poses) -> Steps {
    match poses {
        Poses::OneByOne => repeat(start, h, crank::plain_step::<K>),
        Poses::InPairs => repeat(start, h, crank::paired_step::<K>),
    }
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

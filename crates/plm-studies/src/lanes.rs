//! Eight numbers of `f64` in vector registers.
//!
//! Plain arrays that rustc vectorises take a fifth longer in the double pendulum, and nearly twice the time to compile.

use core::ops::{Add, Div, Mul, Neg, Sub};

use plm_runtime::lanes::{LANES, Lanes};
use plm_runtime::scalar::Registers;
use plm_runtime::{Rk4, Scalar};
use wide::f64x8;

/// Eight simulations of one mechanism side by side; [`lanes::Batch`](plm_runtime::lanes::Batch) tells more.
pub type Batch<M, I = Rk4<f64>> = plm_runtime::lanes::Batch<M, F64x8, I>;

/// Eight numbers of `f64`, each with the bits that it would have alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct F64x8(f64x8);

impl F64x8 {
    /// `f` of each lane, one by one.
    fn each(self, mut f: impl FnMut(f64) -> f64) -> Self {
        Self::of(self.values().map(&mut f))
    }
}

impl Lanes for F64x8 {
    #[inline]
    fn of(values: [f64; LANES]) -> Self {
        Self(f64x8::new(values))
    }
    #[inline]
    fn values(self) -> [f64; LANES] {
        self.0.to_array()
    }
    #[inline]
    fn value(&self, lane: usize) -> f64 {
        self.0.as_array()[lane % LANES]
    }
    /// Write in place: a copy of all lanes would have to wait for the changed one.
    #[inline]
    fn put(&mut self, lane: usize, value: f64) {
        self.0.as_mut_array()[lane % LANES] = value;
    }
}

macro_rules! operator {
    ($trait:ident, $name:ident) => {
        impl $trait for F64x8 {
            type Output = Self;

            #[inline]
            fn $name(self, other: Self) -> Self {
                Self(self.0.$name(other.0))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for F64x8 {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// Functions for which `f64` has no vector instruction are computed lane by lane.
macro_rules! one_by_one {
    ($($name:ident),+) => {
        $(fn $name(self) -> Self {
            self.each(Scalar::$name)
        })+
    };
}

impl Scalar for F64x8 {
    /// All bits of a lane are set, or none.
    type Mask = f64x8;
    type Turns = Self;

    const ZERO: Self = Self(f64x8::ZERO);
    const REGISTERS: Registers = Registers::Filled;
    const HEALTHY: f64 = f64::HEALTHY;
    const AGREEMENT: f64 = f64::AGREEMENT;
    const PRECISION: f64 = f64::PRECISION;

    #[inline]
    fn lit(x: f64) -> Self {
        Self(f64x8::splat(x))
    }
    #[inline]
    fn of_turns(turns: Self) -> Self {
        turns
    }
    #[inline]
    fn to_turns(self) -> Self {
        self
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.values()[0]
    }
    #[inline]
    fn is_finite(self) -> bool {
        self.0.is_finite().all()
    }
    #[inline]
    fn mul_add(self, a: Self, b: Self) -> Self {
        #[cfg(all(feature = "fma", target_feature = "fma"))]
        return Self(self.0.mul_add(a.0, b.0));
        #[cfg(all(feature = "fma", not(target_feature = "fma")))]
        return {
            let (x, a, b) = (self.values(), a.values(), b.values());
            Self::of(core::array::from_fn(|i| Scalar::mul_add(x[i], a[i], b[i])))
        };
        #[cfg(not(feature = "fma"))]
        return self * a + b;
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sines, cosines) = f64::sin_cos_all(self.values());
        (Self::of(sines), Self::of(cosines))
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        // A loop, not `array::map`: compilers see through it.
        let (mut sines, mut cosines) = (angles, angles);
        for i in 0..N {
            (sines[i], cosines[i]) = angles[i].sin_cos();
        }
        (sines, cosines)
    }
    #[inline]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    one_by_one!(tan, asin, acos, floor);
    #[inline]
    fn exp(self) -> Self {
        Self::of(f64::exp_all(self.values()))
    }
    #[inline]
    fn ln(self) -> Self {
        Self::of(f64::ln_all(self.values()))
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        Self::of(f64::atan2_all(self.values(), x.values()))
    }
    #[inline]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline]
    fn lt(self, other: Self) -> f64x8 {
        self.0.simd_lt(other.0)
    }
    #[inline]
    fn select(mask: f64x8, a: Self, b: Self) -> Self {
        Self(mask.select(a.0, b.0))
    }
    #[inline]
    fn choose(mask: f64x8, a: f64x8, b: f64x8) -> f64x8 {
        mask.select(a, b)
    }
    #[inline]
    fn any(mask: f64x8) -> bool {
        mask.any()
    }
    #[inline]
    fn all(mask: f64x8) -> bool {
        mask.all()
    }
}

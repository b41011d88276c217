//! Numbers in lanes: the poses of several stages are computed side by side.

use std::ops::{Add, Mul, Neg, Sub};

use plm::Scalar;

/// N numbers with the same fate; one lane is an ordinary number.
#[derive(Clone, Copy)]
pub(crate) struct Lanes<const N: usize>(pub(crate) [f64; N]);

/// Every function here is a few instructions or, as the sines are, has its arguments in registers only in its caller.
macro_rules! each_lane {
    ($lane:ident => $value:expr) => {{
        // A loop, not `array::map`: compilers see through it.
        let mut lanes = [0.0; N];
        for $lane in 0..N {
            lanes[$lane] = $value;
        }
        Self(lanes)
    }};
}

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        if N == 1 {
            let (s, c) = Scalar::sin_cos(self.0[0]);
            return (Self([s; N]), Self([c; N]));
        }
        let (sines, cosines) = f64::sin_cos_all(self.0);
        (Self(sines), Self(cosines))
    }

    /// (sin, cos) of two angles in one vector, for at most two lanes.
    #[inline(always)]
    pub(crate) fn sin_cos_of_two([a, b]: [Self; 2]) -> [(Self, Self); 2] {
        if N == 1 {
            let ([s1, s2], [c1, c2]) = f64::sin_cos_all([a.0[0], b.0[0]]);
            return [(Self([s1; N]), Self([c1; N])), (Self([s2; N]), Self([c2; N]))];
        }
        let ([s1, s2, s3, s4], [c1, c2, c3, c4]) = f64::sin_cos_all([a.0[0], a.0[1], b.0[0], b.0[1]]);
        let two = |x, y| each_lane!(i => if i == 0 { x } else { y });
        [(two(s1, s2), two(c1, c2)), (two(s3, s4), two(c3, c4))]
    }

    #[inline(always)]
    pub(crate) fn sqrt(self) -> Self {
        each_lane!(i => self.0[i].sqrt())
    }

    /// `numerator / self`.
    #[inline(always)]
    pub(crate) fn under(self, numerator: f64) -> Self {
        each_lane!(i => numerator / self.0[i])
    }

    /// `self * a + b`, fused with the feature `fma`.
    #[inline(always)]
    pub(crate) fn times_plus(self, a: impl Into<Self>, b: impl Into<Self>) -> Self {
        let (a, b) = (a.into(), b.into());
        each_lane!(i => Scalar::mul_add(self.0[i], a.0[i], b.0[i]))
    }
}

impl<const N: usize> From<f64> for Lanes<N> {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self([x; N])
    }
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        each_lane!(i => -self.0[i])
    }
}

macro_rules! operator {
    ($trait:ident, $name:ident) => {
        impl<const N: usize, T: Into<Self>> $trait<T> for Lanes<N> {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: T) -> Self {
                let other = other.into();
                each_lane!(i => self.0[i].$name(other.0[i]))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);

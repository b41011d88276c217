//! Functions of numbers with derivatives, by the chain rule: numbers that carry derivatives and numbers that are recorded have them alike.

use super::Real;

/// The functions of a `Scalar` that has a `value` of `S`. `chain(value, slope)` gives the function of a number by the value and the
/// derivative there; `$steep` is the same where the derivative may be infinite.
macro_rules! by_chain_rule {
    ($steep:ident) => {
        #[inline]
        fn of_turns(turns: i32) -> Self {
            Self::constant(S::of_turns(turns))
        }
        #[inline]
        fn to_turns(self) -> i32 {
            self.value.to_turns()
        }
        #[inline]
        fn to_f64(self) -> f64 {
            self.value.to_f64()
        }
        #[inline]
        fn is_finite(self) -> bool {
            self.value.is_finite()
        }
        #[inline]
        fn sin_cos(self) -> (Self, Self) {
            let (sin, cos) = self.value.sin_cos();
            (self.chain(sin, cos), self.chain(cos, -sin))
        }
        #[allow(clippy::inline_always, reason = "a call would lead all angles through memory")]
        #[inline(always)]
        fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
            let mut values = [S::ZERO; N];
            for i in 0..N {
                values[i] = angles[i].value;
            }
            let (sin, cos) = S::sin_cos_all(values);
            let (mut sines, mut cosines) = (angles, angles);
            for i in 0..N {
                sines[i] = angles[i].chain(sin[i], cos[i]);
                cosines[i] = angles[i].chain(cos[i], -sin[i]);
            }
            (sines, cosines)
        }
        #[inline]
        fn sqrt(self) -> Self {
            let root = self.value.sqrt();
            self.$steep(root, S::lit(0.5) / root)
        }
        #[inline]
        fn tan(self) -> Self {
            let tan = self.value.tan();
            self.chain(tan, tan.mul_add(tan, S::lit(1.0)))
        }
        #[inline]
        fn asin(self) -> Self {
            self.$steep(self.value.asin(), S::lit(1.0) / $crate::scalar::chain_rule::half_chord(self.value))
        }
        #[inline]
        fn acos(self) -> Self {
            self.$steep(self.value.acos(), S::lit(-1.0) / $crate::scalar::chain_rule::half_chord(self.value))
        }
        #[inline]
        fn exp(self) -> Self {
            let exp = self.value.exp();
            self.chain(exp, exp)
        }
        #[inline]
        fn ln(self) -> Self {
            self.$steep(self.value.ln(), S::lit(1.0) / self.value)
        }
        /// The derivative at zero is zero, the middle of its two sides.
        #[inline]
        fn abs(self) -> Self {
            self.chain(self.value.abs(), self.value.signum0())
        }
        #[inline]
        fn floor(self) -> Self {
            Self::constant(self.value.floor())
        }
        #[inline]
        fn lt(self, other: Self) -> bool {
            self.value < other.value
        }
        #[inline]
        fn select(mask: bool, a: Self, b: Self) -> Self {
            if mask { a } else { b }
        }
        #[inline]
        fn any(mask: bool) -> bool {
            mask
        }
        #[inline]
        fn all(mask: bool) -> bool {
            mask
        }
        #[inline]
        fn powi(self, n: i32) -> Self {
            // x^0 is constant; everywhere else x^(n-1) exists where x^n does.
            let slope =
                if n == 0 { S::ZERO } else { S::lit(f64::from(n)) * self.value.powi(n.saturating_sub(1)) };
            self.$steep(self.value.powi(n), slope)
        }
    };
}
pub(crate) use by_chain_rule;

/// sqrt(1 - x^2) without cancellation.
#[inline]
pub(crate) fn half_chord<S: Real>(x: S) -> S {
    let one = S::lit(1.0);
    ((one - x) * (one + x)).sqrt()
}

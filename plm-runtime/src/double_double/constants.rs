//! Constants in several words, as tools/double_double.py prints them.
#![allow(
    clippy::unreadable_literal,
    clippy::excessive_precision,
    clippy::approx_constant,
    reason = "printed"
)]

use super::DoubleDouble;
use crate::scalar::Real;

/// Unevaluated sums, the largest word first, in the words of either type.
pub(super) struct Words {
    double: &'static [f64],
    single: &'static [f32],
}

impl Words {
    /// One word; zero after the last one.
    #[inline]
    pub(super) fn at<S: Real>(&self, index: usize) -> S {
        // All numbers of a type are made by `lit`; a word of f32 passes through f64 unchanged.
        S::lit(if is_single::<S>() {
            f64::from(self.single.get(index).copied().unwrap_or(0.0))
        } else {
            self.double.get(index).copied().unwrap_or(0.0)
        })
    }

    /// Two words one after the other as a number.
    #[inline]
    pub(super) fn pair<S: Real>(&self, index: usize) -> DoubleDouble<S> {
        DoubleDouble { high: self.at(index), low: self.at(index + 1) }
    }
}

/// Does a number of this type have the digits of `f32`?
#[inline]
pub(super) fn is_single<S: Real>() -> bool {
    S::DIGITS < f64::MANTISSA_DIGITS
}

/// pi/2 in four words.
pub(super) const PI_OVER_2: Words = Words {
    double: &[1.5707963267948966, 6.123233995736766e-17, -1.4973849048591698e-33, 5.562271104316826e-50],
    single: &[1.5707964, -4.371139e-8, -1.7151245e-15, 1.0562999e-23],
};

/// ln 2 in three words.
pub(super) const LN_2: Words = Words {
    double: &[0.6931471805599453, 2.3190468138462996e-17, 5.707708438416212e-34],
    single: &[6.931472e-1, -1.9046542e-9, -8.783184e-17],
};

/// 1/n! in two words each, from n = 0.
pub(super) const INVERSE_FACTORIALS: Words = Words {
    double: &[
        1.0,
        0.0,
        1.0,
        0.0,
        0.5,
        0.0,
        0.16666666666666666,
        9.25185853854297e-18,
        0.041666666666666664,
        2.3129646346357427e-18,
        0.008333333333333333,
        1.1564823173178714e-19,
        0.001388888888888889,
        -5.300543954373577e-20,
        0.0001984126984126984,
        1.7209558293420705e-22,
        2.48015873015873e-05,
        2.1511947866775882e-23,
        2.7557319223985893e-06,
        -1.858393274046472e-22,
        2.755731922398589e-07,
        2.3767714622250297e-23,
        2.505210838544172e-08,
        -1.448814070935912e-24,
        2.08767569878681e-09,
        -1.20734505911326e-25,
        1.6059043836821613e-10,
        1.2585294588752098e-26,
        1.1470745597729725e-11,
        2.0655512752830745e-28,
        7.647163731819816e-13,
        7.03872877733453e-30,
        4.779477332387385e-14,
        4.399205485834081e-31,
        2.8114572543455206e-15,
        1.6508842730861433e-31,
        1.5619206968586225e-16,
        1.1910679660273754e-32,
        8.22063524662433e-18,
        2.2141894119604265e-34,
        4.110317623312165e-19,
        1.4412973378659527e-36,
        1.9572941063391263e-20,
        -1.3643503830087908e-36,
        8.896791392450574e-22,
        -7.911402614872376e-38,
        3.868170170630684e-23,
        -8.843177655482344e-40,
        1.6117375710961184e-24,
        -3.6846573564509766e-41,
        6.446950284384474e-26,
        -1.9330404233703465e-42,
        2.4795962632247976e-27,
        -1.2953730964765229e-43,
        9.183689863795546e-29,
        1.4303150396787322e-45,
        3.279889237069838e-30,
        1.5117542744029879e-46,
    ],
    single: &[
        1.0,
        0.0,
        1.0,
        0.0,
        5.0e-1,
        0.0,
        1.6666667e-1,
        -4.967054e-9,
        4.1666668e-2,
        -1.2417635e-9,
        8.333334e-3,
        -4.346172e-10,
        1.3888889e-3,
        -3.3631094e-11,
        1.984127e-4,
        -2.7255969e-12,
        2.4801588e-5,
        -3.406996e-13,
        2.7557319e-6,
        3.7935712e-14,
        2.755732e-7,
        -7.575112e-15,
        2.5052108e-8,
        4.417623e-16,
        2.0876756e-9,
        1.1082839e-16,
        1.6059044e-10,
        -5.3525265e-18,
        1.1470745e-11,
        2.3722077e-19,
        7.6471636e-13,
        1.22007105e-20,
        4.7794773e-14,
        7.625444e-22,
        2.8114574e-15,
        -1.0462085e-22,
        1.5619207e-16,
        1.5404471e-24,
        8.220635e-18,
        1.6814781e-25,
        4.1103176e-19,
        3.2375117e-27,
        1.9572942e-20,
        -4.6129455e-28,
        8.896791e-22,
        4.3288372e-29,
        3.8681703e-23,
        -1.2733404e-30,
        1.6117376e-24,
        -2.0186648e-32,
        6.4469503e-26,
        -5.609469e-34,
        2.4795963e-27,
        -2.1574882e-35,
        9.18369e-29,
        0.0,
        3.279889e-30,
        0.0,
    ],
};

//! The same bits on every target and in every profile.

use plm_runtime::{DoubleDouble, Real, Scalar};

use super::{FUNCTIONS, call, from_words};
use crate::random::Random;

/// A number of any sign, from 2^-12 to 2^12, whose low word is anything below a rounding of the high one.
fn number<S: Real>(random: &mut Random) -> DoubleDouble<S> {
    let size = S::lit(2.0).powi((random.bits() % 25) as i32 - 12);
    let [high, low] = [(), ()].map(|()| S::lit(random.unit()));
    from_words(high * size, low * size * S::EPSILON)
}

/// FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo) over the words of results; all NaNs count as one.
fn sum<S: Real>(name: &str, arity: usize, bits: impl Fn(S) -> u64) -> String {
    let mut random = Random(5);
    let mut sum = 0xcbf2_9ce4_8422_2325_u64;
    for _ in 0..2000 {
        let mut arguments = [number::<S>(&mut random), number(&mut random)];
        if ["asin", "acos"].contains(&name) {
            arguments[0] = arguments[0] * DoubleDouble::lit(1.0 / 4096.0);
        }
        let result = call(name, &arguments[..arity]).unwrap();
        for word in [result.high(), result.low()] {
            let bits = if word.is_finite() { bits(word) } else { 1 };
            sum = (sum ^ bits).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    format!("{name} {sum:016x}")
}

#[test]
fn results_have_the_bits_of_the_reference_machine() {
    let double: Vec<String> = FUNCTIONS.map(|(name, arity)| sum::<f64>(name, arity, f64::to_bits)).into();
    let single: Vec<String> =
        FUNCTIONS.map(|(name, arity)| sum::<f32>(name, arity, |x| x.to_bits().into())).into();
    // The feature fma has other bits in the functions of one word.
    if cfg!(not(feature = "fma")) {
        assert_eq!(double, DOUBLE);
        assert_eq!(single, SINGLE);
    }
}

const DOUBLE: [&str; 14] = [
    "add fbf1daca9c8d0c05",
    "sub b426c98ac74d271f",
    "mul 1b05c33d33fe9bf7",
    "div 499b70c1159241fd",
    "sqrt bc3bb57a33ca849d",
    "floor 7134eea73e186ba5",
    "sin 0937fa5bc8ceb0c2",
    "cos 8b759dfe3f7fc073",
    "tan 058ba7d856eeeeef",
    "asin daeb13f7832ad155",
    "acos bf6534d1844d1765",
    "atan2 ee191555e306ef52",
    "exp 108a0229c8ed160c",
    "ln 2d9d05e5070a7e1a",
];

const SINGLE: [&str; 14] = [
    "add 6b880c5de8395d3a",
    "sub eed81d5947934fcb",
    "mul 88969c63967e2af8",
    "div 102a17421972aca7",
    "sqrt a71fd67a23560fea",
    "floor 5c7f49a960bfaba5",
    "sin 9e0014514211d01d",
    "cos 15c425c22224be4c",
    "tan 131f22220d85ce44",
    "asin c81ce03d63c8f594",
    "acos 303dfbb085b84bc8",
    "atan2 60f0f656c3705d38",
    "exp 911a3666c86321e5",
    "ln 96e9ffad03b18f35",
];

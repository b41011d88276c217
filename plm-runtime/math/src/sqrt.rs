//! Square root, correctly rounded: by the processor through std or plm-processor, else by a first guess that integers correct.

macro_rules! root {
    ($float:ident) => {
        #[inline]
        pub(crate) fn $float(x: $float) -> $float {
            #[cfg(feature = "std")]
            return x.sqrt();
            #[cfg(all(not(feature = "std"), feature = "processor-sqrt-f32"))]
            return plm_processor::$float(x).unwrap_or_else(|| integer::$float(x));
            #[cfg(not(any(feature = "std", feature = "processor-sqrt-f32")))]
            return integer::$float(x);
        }
    };
}

root!(f64);
root!(f32);

/// For targets whose square root instruction Rust cannot reach without std.
#[cfg(any(test, not(feature = "std")))]
mod integer {
    use crate::float::Float;
    use crate::pair::Pair;

    macro_rules! integer_root {
        ($float:ident, $bits:ident, $signed:ident, $digits:literal, $start:literal, $steps:literal) => {
            /// The root n of the significand is an integer of p bits, the nearest one to sqrt(X), X of 2p - 1 or 2p
            /// bits. Floating-point numbers find it within one unit; the exact remainder X - n^2, which is below 4n
            /// and so can be had modulo 2^(p+11) or 2^(p+8), decides: it must be above -n and at most n. No root lies
            /// in the middle between two integers, since (n + 1/2)^2 is none.
            #[inline]
            pub(crate) fn $float(x: $float) -> $float {
                const LEADING: $bits = 1 << ($digits - 1);
                const BIAS: i32 = $float::MAX_EXP - 1;
                if !(x > 0.0 && x < $float::INFINITY) {
                    return if x >= 0.0 { x } else { $float::NAN };
                }
                let (x, shift) =
                    if x < $float::MIN_POSITIVE { (x * LEADING as $float, 1 - $digits) } else { (x, 0) };
                let exponent = x.exponent() + shift;
                let odd = exponent & 1;
                let significand = x.significand() * $float::from_i32(1 + odd);

                let start = $float::from_bits($start - (significand.to_bits() >> 1));
                let root = approximate::<_, $steps>(significand, start).clamp(1.0, 2.0 - $float::EPSILON);
                let n = (root.to_bits() & (LEADING - 1)) | LEADING;
                let square = (x.to_bits() | LEADING) << ($digits - 1 + odd);
                let remainder = square.wrapping_sub(n.wrapping_mul(n)) as $signed;
                let n = n + $bits::from(remainder > n as $signed) - $bits::from(remainder <= -(n as $signed));
                // The leading bit of n adds one to the exponent below it.
                $float::from_bits(((((exponent >> 1) + BIAS - 1) as $bits) << ($digits - 1)) + n)
            }
        };
    }

    // First guesses of 1/sqrt within 3.5 %: C. Lomont, Fast Inverse Square Root, 2003 (f32); M. Robertson, A Brief
    // History of InvSqrt, 2012 (f64).
    integer_root!(f64, u64, i64, 53, 0x5fe6_eb50_c7b5_37a9, 3);
    integer_root!(f32, u32, i32, 24, 0x5f37_59df, 2);

    /// sqrt(m), with an error just above half a unit in the last place. Each step squares the relative error of 1/sqrt
    /// (Newton), and so does the last one, whose difference r^2 - m is exact (Dekker).
    fn approximate<F: Float, const STEPS: usize>(m: F, start: F) -> F {
        let half = F::HALF * m;
        let mut inverse = start;
        for _ in 0..STEPS {
            inverse = inverse * (F::HALF + F::ONE - half * inverse * inverse);
        }
        let root = m * inverse;
        let square = Pair::product(root, root);
        root - ((square.high - m) - square.less) * (F::HALF * inverse)
    }
}

#[cfg(test)]
mod tests {
    use super::integer;

    /// Compares with the processor: near powers of two, squares and their neighbours, all exponents, subnormals.
    #[test]
    fn integers_give_the_bits_of_the_processor() {
        let mut bits = 1_u64;
        for step in 0..200_000_u64 {
            // Low-discrepancy bits (multiples of the golden ratio) meet all exponents and both signs.
            bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let root = f64::from_bits(bits >> 1).abs().sqrt();
            for x in [f64::from_bits(bits), f64::from_bits(bits >> 12), root * root, f64::from_bits(step)] {
                for x in [x.next_down(), x, x.next_up()] {
                    compare(x);
                    compare_single(x as f32);
                }
            }
            compare_single(f32::from_bits((bits >> 32) as u32));
            compare_single(f32::from_bits(step as u32));
        }
    }

    fn compare(x: f64) {
        let (got, expected) = (integer::f64(x), x.sqrt());
        assert!(got.to_bits() == expected.to_bits() || (got.is_nan() && expected.is_nan()), "{x:e}");
    }

    fn compare_single(x: f32) {
        let (got, expected) = (integer::f32(x), x.sqrt());
        assert!(got.to_bits() == expected.to_bits() || (got.is_nan() && expected.is_nan()), "{x:e}");
    }
}

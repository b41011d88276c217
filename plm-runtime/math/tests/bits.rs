//! The same bits everywhere: from all forms of a function, and on every target, profile and feature. All NaNs count as
//! one.

#[path = "support/random.rs"]
mod random;

use random::Random;

macro_rules! bits {
    ($float:ident, $from:expr, $golden:expr) => {
        mod $float {
            use super::Random;
            use plm_math::$float as m;

            const FROM_RANDOM: fn(u64, f64) -> $float = $from;

            fn number(random: &mut Random) -> $float {
                let number = random.number();
                FROM_RANDOM(random.bits(), number)
            }

            fn bits(x: $float) -> u64 {
                if x.is_nan() { 0 } else { u64::from(x.to_bits()) + 1 }
            }

            #[test]
            fn all_forms_of_sine_and_cosine_agree() {
                fn lanes<const N: usize>(random: &mut Random, within: $float) -> bool {
                    let angles: [$float; N] = core::array::from_fn(|_| number(random) % within);
                    let (sines, cosines) = m::sin_cos_lanes(angles);
                    let direct = m::are_direct(angles);
                    if direct {
                        let (s, c) = m::sin_cos_lanes_direct(angles);
                        assert_eq!((s.map(bits), c.map(bits)), (sines.map(bits), cosines.map(bits)));
                    }
                    for lane in 0..N {
                        let (s, c) = m::sin_cos(angles[lane]);
                        let both = (bits(s), bits(c));
                        if direct {
                            let (s, c) = m::sin_cos_direct(angles[lane]);
                            assert_eq!((bits(s), bits(c)), both, "without a branch: {:e}", angles[lane]);
                        }
                        assert_eq!(
                            (bits(sines[lane]), bits(cosines[lane])),
                            both,
                            "lanes: {:e}",
                            angles[lane]
                        );
                        assert_eq!((bits(m::sin(angles[lane])), bits(m::cos(angles[lane]))), both);
                        let (s, c) = m::sin_cos(-angles[lane]);
                        assert_eq!((bits(-s), bits(c)), both, "symmetry: {:e}", angles[lane]);
                    }
                    direct
                }
                let (mut random, mut direct) = (Random(1), 0);
                for _ in 0..5000 {
                    for within in [400.0, $float::INFINITY] {
                        direct += u32::from(lanes::<1>(&mut random, within));
                        direct += u32::from(lanes::<2>(&mut random, within));
                        direct += u32::from(lanes::<3>(&mut random, within));
                        direct += u32::from(lanes::<8>(&mut random, within));
                    }
                }
                assert!((10_000..30_000).contains(&direct), "{direct} of 40 000 are direct");
                for far in [1e9, $float::INFINITY, $float::NAN] {
                    assert!(!m::are_direct([0.5, far]) && !m::are_direct([-far]), "{far}");
                }
                assert!(m::are_direct([0.5, -300.0, 100.0]) && m::are_direct([]));
            }

            #[test]
            fn directions_of_several_vectors_are_those_of_one() {
                fn lanes<const N: usize>(random: &mut Random, within: $float) {
                    let mut numbers = || core::array::from_fn(|_| number(random) % within);
                    let (y, x): ([$float; N], [$float; N]) = (numbers(), numbers());
                    let together = m::atan2_lanes(y, x).map(bits);
                    let alone = core::array::from_fn(|lane| bits(m::atan2(y[lane], x[lane])));
                    assert_eq!(together, alone, "{y:?}, {x:?}");
                }
                let mut random = Random(3);
                for _ in 0..5000 {
                    // Signs, quadrants and both sides of the diagonal; then zeros, infinities, NaN and extreme quotients.
                    for within in [1.0, $float::INFINITY] {
                        lanes::<1>(&mut random, within);
                        lanes::<2>(&mut random, within);
                        lanes::<3>(&mut random, within);
                        lanes::<8>(&mut random, within);
                    }
                }
            }

            #[test]
            fn powers_and_logarithms_of_several_numbers_are_those_of_one() {
                fn lanes<const N: usize>(random: &mut Random, within: $float) {
                    let x: [$float; N] = core::array::from_fn(|_| number(random) % within);
                    assert_eq!(m::exp_lanes(x).map(bits), x.map(m::exp).map(bits), "exp {x:?}");
                    assert_eq!(m::ln_lanes(x).map(bits), x.map(m::ln).map(bits), "ln {x:?}");
                    let x = x.map(m::abs);
                    assert_eq!(m::ln_lanes(x).map(bits), x.map(m::ln).map(bits), "ln {x:?}");
                }
                let mut random = Random(4);
                for _ in 0..5000 {
                    // All on the direct path; then zeros, infinities, NaN, subnormal numbers and what overflows.
                    for within in [80.0, $float::INFINITY] {
                        lanes::<1>(&mut random, within);
                        lanes::<3>(&mut random, within);
                        lanes::<8>(&mut random, within);
                    }
                }
            }

            #[test]
            fn results_have_the_bits_of_the_reference_machine() {
                let unary: [(&str, fn($float) -> $float); 11] = [
                    ("sin", m::sin),
                    ("cos", m::cos),
                    ("tan", m::tan),
                    ("asin", m::asin),
                    ("acos", m::acos),
                    ("atan", m::atan),
                    ("sqrt", m::sqrt),
                    ("exp", m::exp),
                    ("ln", m::ln),
                    ("floor", m::floor),
                    ("round_ties_even", m::round_ties_even),
                ];
                let binary: [(&str, fn($float, $float) -> $float); 3] =
                    [("atan2", m::atan2), ("hypot", m::hypot), ("powi", |x, n| m::powi(x, n as i32 % 20))];
                let sum = |name: &str, f: &dyn Fn($float, $float) -> $float| {
                    let mut random = Random(2);
                    // FNV-1a over words: G. Fowler, L. C. Noll, K.-P. Vo.
                    let mut sum = 0xcbf2_9ce4_8422_2325_u64;
                    for _ in 0..5000 {
                        let (a, b) = (number(&mut random), number(&mut random));
                        sum = (sum ^ bits(f(a, b))).wrapping_mul(0x0000_0100_0000_01b3);
                    }
                    format!("{name} {sum:016x}")
                };
                let mut sums: Vec<String> = unary.iter().map(|(name, f)| sum(name, &|a, _| f(a))).collect();
                sums.extend(binary.iter().map(|(name, f)| sum(name, f)));
                let mut golden = Vec::from($golden);
                if cfg!(feature = "fma") {
                    // What is exact stays exact; all else has other bits.
                    let exact = ["sqrt", "floor", "round_ties_even"];
                    sums.retain(|line| exact.iter().any(|name| line.starts_with(name)));
                    golden.retain(|line| exact.iter().any(|name| line.starts_with(name)));
                }
                assert_eq!(sums, golden);
            }
        }
    };
}

bits!(
    f64,
    |_, number| number,
    [
        "sin 01cf09f56d9dda45",
        "cos 150b5d7588bdcd00",
        "tan 6deb5a5d0ad49d62",
        "asin 6bd7b97efcd4da62",
        "acos a7c917cc7b49ca88",
        "atan 869e95b2e5bf9dec",
        "sqrt 64024c515073e005",
        "exp 5dbbaac1c69d5971",
        "ln 0ef5081030fec4cb",
        "floor f49c3220f0de8a4f",
        "round_ties_even c85a6a5abdb6def3",
        "atan2 53eb27d4a1f0ee08",
        "hypot 54e145cc002a5518",
        "powi dc6e602dd9a670ac"
    ]
);
bits!(
    f32,
    |bits, number| if bits & 1 == 0 { f32::from_bits((bits >> 32) as u32) } else { number as f32 },
    [
        "sin 3dc42eb75193d642",
        "cos 2782fcadf96cf224",
        "tan 29a8b8fed6ab355f",
        "asin a60b0f949b12f155",
        "acos 19f5d18623f79c17",
        "atan aff9bcb6e8a03394",
        "sqrt 40fe2b79869e57ec",
        "exp 50fa002b7195c6c2",
        "ln b56d97815044e047",
        "floor 19f547d9fc09ad2c",
        "round_ties_even 80fda52f53f28c88",
        "atan2 962babd64d89fe77",
        "hypot 85086bab92d0ca0e",
        "powi be906e93bc672be3"
    ]
);

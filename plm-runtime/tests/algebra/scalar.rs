//! Numbers as scalars of generated code.

use plm_runtime::{Real, Scalar};

/// Also where std has methods of the same names: its sines have other bits.
#[test]
fn functions_of_scalars_are_those_of_plm_math() {
    fn all_forms<S: Real>(name: &str, sin_cos: impl Fn(S) -> (S, S), of_std: impl Fn(S) -> (S, S)) {
        let mut differ = 0;
        for k in -2000..2000 {
            let x = S::lit(f64::from(k) * 0.0731);
            let (s, c) = sin_cos(x);
            let forms = [x.sin_cos(), x.sin_cos_by::<false>(), x.sin_cos_by::<true>(), (x.sin(), x.cos())];
            let ([s1, s2], [c1, c2]) = S::sin_cos_all([x, x]);
            let ([s3, s4], [c3, c4]) = S::sin_cos_all_by::<false, 2>([x, x]);
            let ([s5, s6], [c5, c6]) = S::sin_cos_all_by::<true, 2>([x, x]);
            let lanes = [(s1, c1), (s2, c2), (s3, c3), (s4, c4), (s5, c5), (s6, c6)];
            assert!(S::are_direct([x, x]), "{name} {k}");
            assert!(forms.into_iter().chain(lanes).all(|form| form == (s, c)), "{name} {k}");
            differ += u32::from(of_std(x) != (s, c));
        }
        assert!(differ > 0, "{name}: std has the same bits, and this test tells nothing");
    }
    all_forms("f64", plm_math::f64::sin_cos, f64::sin_cos);
    all_forms("f32", plm_math::f32::sin_cos, f32::sin_cos);
    for (x, root) in [(2.0, 2.0_f64.sqrt()), (0.0, 0.0), (-1.0, 0.0)] {
        assert!(x.root_by::<false>() == root, "{x}");
    }
    assert!((-1.0_f64).root_by::<true>().is_nan() && 2.0.root_by::<true>() == 2.0_f64.sqrt());
}

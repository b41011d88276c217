//! The formula of a step, on numbers of any type: what a check compares the C with.

use plm_runtime::Scalar;

/// The state after a step of `h` from `t`, with so many coordinates: W. Kutta's formula as
/// [`Rk4`](plm_runtime::Rk4) has it.
pub(crate) fn step<S: Scalar>(
    (t, h): (S, S),
    x: &[S],
    coordinates: usize,
    mut rate: impl FnMut(S, &[S]) -> Vec<S>,
) -> Vec<S> {
    let (half, sixth) = (S::lit(0.5) * h, S::lit(1.0 / 6.0) * h);
    let stages = [(S::ZERO, half), (half, half), (half, h), (h, S::ZERO)];
    let mut ahead = x.to_vec();
    let k = stages.map(|(node, next)| {
        let stage = ahead.clone();
        for j in 0..coordinates {
            ahead[j] = next.mul_add(stage[coordinates + j], x[j]);
        }
        let rates = rate(t + node, &stage);
        for j in coordinates..x.len() {
            ahead[j] = next.mul_add(rates[j], x[j]);
        }
        rates
    });
    let [k1, k2, k3, k4] = &k;
    let place = |i: usize| {
        let v = coordinates + i;
        let sum = k1[v] + (k2[v] + k3[v]);
        h.mul_add(sixth.mul_add(sum, x[v]), x[i])
    };
    let other = |i: usize| {
        let sum = S::lit(2.0).mul_add(k2[i] + k3[i], k1[i] + k4[i]);
        sixth.mul_add(sum, x[i])
    };
    (0..x.len()).map(|i| if i < coordinates { place(i) } else { other(i) }).collect()
}

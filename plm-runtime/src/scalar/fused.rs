//! Fused multiplication and addition of the processor.

extern crate std;
macro_rules! fused {
    ($real:ident) => {
        #[inline]
        pub(super) fn $real(x: $real, a: $real, b: $real) -> $real {
            x.mul_add(a, b)
        }
    };
}
fused!(f64);
fused!(f32);

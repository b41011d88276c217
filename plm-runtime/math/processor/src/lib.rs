//! Square roots by an instruction of the processor, for programs without std.
//!
//! Without std, stable Rust has no safe way to one: `core` has no root, its intrinsics are unsafe to call, and of ARM and RISC-V
//! no crate is told whether the processor has a floating-point unit. So this is inline assembly, the only unsafe code that the
//! equations of a mechanism can come to. It stands in a crate of its own, which is built only where the feature
//! `processor-sqrt-f32` or `processor-sqrt-f64` of `plm` asks for it. IEEE 754 rounds roots correctly: the bits are those of any
//! other way.
//!
//! An instruction that the processor has not is refused by rustc or its assembler; no program comes of it.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![no_std]

#[cfg(test)]
extern crate std;

/// The root of `x` by an instruction from one floating-point register to another.
#[allow(unused_macros, reason = "not used on machines without such an instruction")]
macro_rules! root {
    ($instruction:literal, $class:ident, $x:ident) => {{
        let root;
        // SAFETY: the instruction touches no memory, no stack and no register that is not named here. Its result depends on
        // `x` alone, in the mode of rounding that Rust demands. It may raise flags of floating-point exceptions, so that
        // `preserves_flags` does not hold.
        #[allow(unsafe_code, reason = "assembly")]
        unsafe {
            core::arch::asm!($instruction, out($class) root, in($class) $x, options(pure, nomem, nostack));
        }
        Some(root)
    }};
}

/// The square root of `x`, correctly rounded; none where no instruction for it is known.
#[inline]
#[allow(unused_variables, unreachable_code, reason = "machines differ")]
pub fn f32(x: f32) -> Option<f32> {
    // The interpreter Miri knows no assembly.
    #[cfg(not(miri))]
    {
        #[cfg(all(target_arch = "x86_64", target_feature = "sse"))]
        return root!("sqrtss {}, {}", xmm_reg, x);
        #[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
        return root!("fsqrt {:s}, {:s}", vreg, x);
        #[cfg(all(feature = "f64", target_arch = "arm", target_abi = "eabihf"))]
        return root!("vsqrt.f32 {}, {}", sreg, x);
        #[cfg(all(not(feature = "f64"), target_arch = "arm", target_abi = "eabihf"))]
        return single_unit(x);
        #[cfg(any(target_arch = "riscv32", target_arch = "riscv64"))]
        return root!("fsqrt.s {}, {}", freg, x);
    }
    None
}

/// Square root by a processor whose unit has f32 alone; there is one, because numbers are handed over in its registers. The number goes
/// through a general register: rustc lends assembly registers of a unit for f64 only.
#[cfg(all(not(feature = "f64"), target_arch = "arm", target_abi = "eabihf"))]
#[inline]
#[allow(unsafe_code, reason = "assembly")]
fn single_unit(x: f32) -> Option<f32> {
    let root;
    // SAFETY: as above; the register on the way is named.
    unsafe {
        core::arch::asm!(
            "vmov s0, {x}", "vsqrt.f32 s0, s0", "vmov {x}, s0",
            x = inout(reg) x => root, out("s0") _, options(pure, nomem, nostack));
    }
    Some(root)
}

/// The square root of `x`, correctly rounded; none where no instruction for it is known. On ARM and RISC-V the feature `f64` says
/// that there is one.
#[inline]
#[allow(unused_variables, unreachable_code, reason = "machines differ")]
pub fn f64(x: f64) -> Option<f64> {
    #[cfg(not(miri))]
    {
        #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
        return root!("sqrtsd {}, {}", xmm_reg, x);
        #[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
        return root!("fsqrt {:d}, {:d}", vreg, x);
        #[cfg(all(feature = "f64", target_arch = "arm", target_abi = "eabihf"))]
        return root!("vsqrt.f64 {}, {}", dreg_low16, x);
        #[cfg(all(feature = "f64", any(target_arch = "riscv32", target_arch = "riscv64")))]
        return root!("fsqrt.d {}, {}", freg, x);
    }
    None
}

#[cfg(all(test, any(target_arch = "x86_64", target_arch = "aarch64"), not(miri)))]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    /// Bits of all exponents and both signs, by multiples of the golden ratio, and what is special.
    fn numbers() -> impl Iterator<Item = u64> {
        let special = [0.0, -0.0, 1.0, -1.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 5e-324, f64::MAX];
        let all = (1..200_000_u64).map(|k| k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        special.into_iter().map(f64::to_bits).chain(all)
    }

    #[test]
    fn roots_have_the_bits_of_std() {
        for bits in numbers() {
            let x = f64::from_bits(bits);
            let (got, expected) = (super::f64(x).unwrap(), x.sqrt());
            assert!(got.to_bits() == expected.to_bits() || (got.is_nan() && expected.is_nan()), "{x:e}");
            for x in [f32::from_bits((bits >> 32) as u32), x as f32] {
                let (got, expected) = (super::f32(x).unwrap(), x.sqrt());
                assert!(got.to_bits() == expected.to_bits() || (got.is_nan() && expected.is_nan()), "{x:e}");
            }
        }
    }
}

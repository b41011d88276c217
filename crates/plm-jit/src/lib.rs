//! Machine code of the host for mechanisms that come from text: by Cranelift, and in a browser as WebAssembly.
//!
//! [`plm_dynamic`] evaluates the functions of a mechanism step by step. A [`Translator`](plm_dynamic::Translator) of this crate makes
//! machine code of those that are evaluated often. It does the operations of the steps in their order, sines and their kin are calls of
//! those of compiled code, and products and sums round as there: so the bits are those of the steps, and of compiled code.
//!
//! ```
//! use std::sync::Arc;
//!
//! use plm_dynamic::Mechanism;
//!
//! let text = "pub Pendulum {
//!     gravity: 9.81 m/s^2;
//!     ground { port o: (0, 0) m; }
//!     body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 30 deg, locked; }
//!     revolute hinge(ground.o, bob.pivot);
//! }";
//! let (pendulum, interpreted) = (Mechanism::from_text(text)?, Mechanism::from_text(text)?);
//! if let Some(translator) = plm_jit::Host::new() {
//!     pendulum.translate_by(Arc::new(translator));
//! }
//! let angles = [pendulum, interpreted].map(|mechanism| {
//!     let mut run = mechanism.start()?;
//!     run.step_to(2.0)?;
//!     Ok::<_, plm_dynamic::Error>(run.body("bob")?.angle.to_bits())
//! });
//! assert_eq!(angles[0], angles[1]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[allow(unsafe_code, reason = "calls of machine code, and what machine code calls")]
mod call;
mod functions;
#[cfg(not(target_arch = "wasm32"))]
mod host;
#[cfg(target_arch = "wasm32")]
mod page;
#[cfg(not(target_arch = "wasm32"))]
mod schedule;
#[cfg(not(target_arch = "wasm32"))]
mod translate;
#[cfg(target_arch = "wasm32")]
mod webassembly;

#[cfg(not(target_arch = "wasm32"))]
pub use self::host::Host;
#[cfg(target_arch = "wasm32")]
pub use self::page::Host;

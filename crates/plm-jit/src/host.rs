//! The machine that the program runs on.

use std::sync::Arc;

use cranelift_codegen::Context;
use cranelift_codegen::isa::TargetIsa;
use cranelift_codegen::settings::{self, Configurable, Flags, SetResult};
use cranelift_frontend::FunctionBuilderContext;
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{Module, default_libcall_names};
use plm_dynamic::{Function, MachineCode, Tier, Translator};

use crate::call::{Lengths, Loaded};
use crate::functions::is_fused;
use crate::translate::translate;

/// A maker of machine code for the processor that the program runs on.
#[derive(Clone)]
pub struct Host {
    isa: Arc<dyn TargetIsa>,
    is_fused: bool,
    evaluations_before: u32,
    tier: Tier,
}

impl std::fmt::Debug for Host {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Host").field("isa", &self.isa.name()).finish_non_exhaustive()
    }
}

impl Host {
    /// A translator of functions that have been evaluated often enough that the time of their translation comes back; nothing where there
    /// is no machine code for the processor.
    pub fn new() -> Option<Host> {
        let isa = cranelift_native::builder().ok()?.finish(flags().ok()?).ok()?;
        // A step of a function takes as long to translate as to interpret some thousand times.
        Some(Host { isa, is_fused: is_fused(), evaluations_before: 2000, tier: Tier::AtOnce })
    }

    /// Functions are translated after so many evaluations by steps.
    #[must_use]
    pub fn after(mut self, evaluations: u32) -> Host {
        self.evaluations_before = evaluations;
        self
    }

    /// Functions are translated on threads of their own while runs go on by steps; machine code takes their place between two evaluations.
    /// No run waits, so that functions are translated after fewer evaluations. The results are the same to the bit, whenever that is.
    #[must_use]
    pub fn in_background(self) -> Host {
        Host { tier: Tier::InBackground, evaluations_before: self.evaluations_before.min(200), ..self }
    }
}

fn flags() -> SetResult<Flags> {
    let mut flags = settings::builder();
    for (name, value) in [
        ("opt_level", "none"),
        ("enable_verifier", if cfg!(debug_assertions) { "true" } else { "false" }),
        ("is_pic", "false"),
        ("use_colocated_libcalls", "false"),
        // Frames of large functions are larger than the page that guards the stack.
        ("enable_probestack", "true"),
        ("probestack_strategy", "inline"),
        ("unwind_info", "false"),
    ] {
        flags.set(name, value)?;
    }
    Ok(Flags::new(flags))
}

/// The most steps of a function that is translated.
const MOST_STEPS: usize = 1 << 20;
/// The most numbers of a list: offsets of Cranelift have 32 bits.
const MOST_NUMBERS: usize = 1 << 27;

/// Has a function no more lists, and no longer ones, than a call takes?
fn fits(function: &Function<'_>) -> bool {
    let lengths = Lengths::of(function);
    lengths.fit() && lengths.inputs.iter().chain(&lengths.outputs).all(|length| *length <= MOST_NUMBERS)
}

impl Translator for Host {
    fn translate(&self, function: &Function<'_>) -> Option<Box<dyn MachineCode>> {
        let mut module = JITModule::new(JITBuilder::with_isa(self.isa.clone(), default_libcall_names()));
        let (mut context, mut frontend) = (Context::new(), FunctionBuilderContext::new());
        context.func.signature.call_conv = self.isa.default_call_conv();
        if function.steps.len() > MOST_STEPS || !fits(function) {
            return None;
        }
        let (lengths, constants) =
            translate(function, (&mut context.func, &mut frontend), &*self.isa, self.is_fused);
        let id = module.declare_anonymous_function(&context.func.signature).ok()?;
        module.define_function(id, &mut context).ok()?;
        module.finalize_definitions().ok()?;
        Some(Box::new(Loaded::new(&module, id, lengths, constants)))
    }

    fn evaluations_before(&self) -> u32 {
        self.evaluations_before
    }

    fn tier(&self) -> Tier {
        self.tier
    }
}

//! A page of a browser, or node: modules of WebAssembly that the program writes, and the page makes.
//!
//! The page gives the import `plm.plm_translated`, which makes a module of bytes and puts its function into the program's table; the
//! program exports its memory and its table, which can grow (`crates/plm-view/page/src/machine.js`).

use plm_dynamic::{Function, MachineCode, Translator};

use crate::call::{Lengths, Loaded};
use crate::functions::is_fused;
use crate::webassembly::module;

/// A maker of machine code for the browser that the program runs in.
#[derive(Clone, Debug)]
pub struct Host {
    evaluations_before: u32,
}

impl Host {
    /// A translator of functions that have been evaluated often enough that the time of their translation comes back.
    pub fn new() -> Option<Host> {
        Some(Host { evaluations_before: 2000 })
    }

    /// Functions are translated after so many evaluations by steps.
    #[must_use]
    pub fn after(mut self, evaluations: u32) -> Host {
        self.evaluations_before = evaluations;
        self
    }

    /// As on other hosts; a page has no threads for it, so that functions are translated at once.
    #[must_use]
    pub fn in_background(self) -> Host {
        self
    }
}

/// The most steps of a function that is translated: browsers take bodies of 7 MB.
const MOST_STEPS: usize = 1 << 18;

impl Translator for Host {
    fn translate(&self, function: &Function<'_>) -> Option<Box<dyn MachineCode>> {
        let lengths = Lengths::of(function);
        // WebAssembly has no product and sum with one rounding.
        if function.steps.len() > MOST_STEPS || !lengths.fit() || is_fused() {
            return None;
        }
        let room: Box<[f64]> = Box::new([0.0; 2]);
        let module = module(function, room.as_ptr().addr());
        Some(Box::new(Loaded::of_page(&module, lengths, room)?))
    }

    fn evaluations_before(&self) -> u32 {
        self.evaluations_before
    }
}

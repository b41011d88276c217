//! Machine code that is called, and functions that it calls with pointers: all unsafe code of the crate.

use std::mem;

#[cfg(not(target_arch = "wasm32"))]
use cranelift_jit::JITModule;
#[cfg(not(target_arch = "wasm32"))]
use cranelift_module::FuncId;
use plm_dynamic::{Element, Function, Input, MachineCode};
use plm_runtime::Scalar;

/// Lists that are read, lists that are written, and one that is written beside them; gives the value that the function returns.
type Entry = unsafe extern "C" fn(*const *const f64, *const *mut f64, *mut f64) -> f64;

/// The most lists that are read.
const LISTS: usize = 24;
/// The most lists that are written; most functions read no more either.
const FEW: usize = 6;

/// The lengths that a function needs of its lists.
#[derive(Debug, Default)]
pub(crate) struct Lengths {
    pub(crate) inputs: Vec<usize>,
    pub(crate) outputs: Vec<usize>,
    pub(crate) others: usize,
}

impl Lengths {
    /// Lengths of the lists that a function reads and writes.
    pub(crate) fn of(function: &Function<'_>) -> Lengths {
        let mut lengths = Lengths { others: function.others.len(), ..Lengths::default() };
        for input in function.arguments {
            if let Input::Element(element) = input {
                note(&mut lengths.inputs, *element);
            }
        }
        function.outputs.iter().for_each(|(element, _)| note(&mut lengths.outputs, *element));
        lengths
    }

    /// Are there no more lists than a call takes?
    pub(crate) fn fit(&self) -> bool {
        self.inputs.len() <= LISTS && self.outputs.len() <= FEW
    }
}

/// Notes that a list is long enough for an element.
fn note(lengths: &mut Vec<usize>, Element { list, index }: Element) {
    if lengths.len() <= list {
        lengths.resize(list + 1, 0);
    }
    lengths[list] = lengths[list].max(index + 1);
}

/// A function as machine code.
#[derive(Debug)]
pub(crate) struct Loaded {
    entry: Entry,
    lengths: Lengths,
    /// Numbers that the code reads where they are, or writes.
    _numbers: Box<[f64]>,
}

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "plm")]
unsafe extern "C" {
    /// Makes a module of bytes, and gives the place of its function `run` in the table; 0 where it cannot.
    fn plm_translated(bytes: *const u8, length: usize) -> usize;
}

#[cfg(target_arch = "wasm32")]
impl Loaded {
    /// The function of a module of WebAssembly, which was made for lists of these lengths and for these numbers where they are; nothing
    /// where the page cannot make it.
    pub(crate) fn of_page(module: &[u8], lengths: Lengths, numbers: Box<[f64]>) -> Option<Loaded> {
        // SAFETY: the page reads these bytes alone.
        let place = unsafe { plm_translated(module.as_ptr(), module.len()) };
        // SAFETY: a function is its place in the table; the page has put one of this type there, which stays.
        let entry = (place != 0).then(|| unsafe { mem::transmute::<usize, Entry>(place) })?;
        Some(Loaded { entry, lengths, _numbers: numbers })
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl Loaded {
    /// A function of a module, which was made for lists of these lengths and for these constants where they are.
    pub(crate) fn new(module: &JITModule, id: FuncId, lengths: Lengths, constants: Box<[f64]>) -> Loaded {
        let code = module.get_finalized_function(id);
        // SAFETY: the module has a function of this type; what modules have finalised stays in memory when they are dropped.
        let entry = unsafe { mem::transmute::<*const u8, Entry>(code) };
        Loaded { entry, lengths, _numbers: constants }
    }
}

impl MachineCode for Loaded {
    fn run(&self, inputs: &[&[f64]], outputs: &mut [&mut [f64]], others: &mut [f64]) -> Option<f64> {
        if self.lengths.inputs.len() <= FEW {
            self.call::<FEW>(inputs, outputs, others)
        } else {
            self.call::<LISTS>(inputs, outputs, others)
        }
    }
}

impl Loaded {
    /// Calls the code, which reads at most `K` lists.
    #[inline]
    fn call<const K: usize>(
        &self,
        inputs: &[&[f64]],
        outputs: &mut [&mut [f64]],
        others: &mut [f64],
    ) -> Option<f64> {
        let Lengths { inputs: read, outputs: written, others: beside } = &self.lengths;
        if inputs.len() < read.len() || outputs.len() < written.len() || others.len() < *beside {
            return None;
        }
        let (mut from, mut to) = ([std::ptr::null(); K], [std::ptr::null_mut(); FEW]);
        for ((pointer, list), length) in from.iter_mut().zip(inputs).zip(read) {
            if list.len() < *length {
                return None;
            }
            *pointer = list.as_ptr();
        }
        for ((pointer, list), length) in to.iter_mut().zip(outputs).zip(written) {
            if list.len() < *length {
                return None;
            }
            *pointer = list.as_mut_ptr();
        }
        // SAFETY: the code reads and writes below these lengths; it was made for no more lists than there are pointers.
        Some(unsafe { (self.entry)(from.as_ptr(), to.as_ptr(), others.as_mut_ptr()) })
    }
}

/// Sines and cosines one after the other: of the angles in order.
///
/// # Safety
/// There is room for two numbers of each angle.
unsafe fn store<const N: usize>(angles: [f64; N], to: *mut f64) {
    let (sines, cosines) = f64::sin_cos_all(angles);
    // SAFETY: the caller's.
    unsafe {
        to.cast::<[f64; N]>().write(sines);
        to.cast::<[f64; N]>().add(1).write(cosines);
    }
}

unsafe extern "C" fn sines_1(a: f64, to: *mut f64) {
    // SAFETY: machine code has room for two numbers of each angle.
    unsafe { store([a], to) }
}

unsafe extern "C" fn sines_2(a: f64, b: f64, to: *mut f64) {
    // SAFETY: as above.
    unsafe { store([a, b], to) }
}

unsafe extern "C" fn sines_4(a: f64, b: f64, c: f64, d: f64, to: *mut f64) {
    // SAFETY: as above.
    unsafe { store([a, b, c, d], to) }
}

#[allow(clippy::too_many_arguments, reason = "angles in registers")]
unsafe extern "C" fn sines_8(a: f64, b: f64, c: f64, d: f64, e: f64, f: f64, g: f64, h: f64, to: *mut f64) {
    // SAFETY: as above.
    unsafe { store([a, b, c, d, e, f, g, h], to) }
}

/// Address of the function that computes the sines of so many angles: 1, 2, 4, else 8.
pub(crate) fn sines(count: usize) -> *const () {
    match count {
        1 => sines_1 as *const (),
        2 => sines_2 as *const (),
        4 => sines_4 as *const (),
        _ => sines_8 as *const (),
    }
}

//! From steps to a module of WebAssembly with one function, `run`.

use plm_compiler::lowered::{Operation, Register, Step};
use plm_dynamic::{Element, Function, Input};
use wasm_encoder::{
    CodeSection, EntityType, ExportKind, ExportSection, FunctionSection, ImportSection, InstructionSink,
    MemArg, MemArgTarget, MemoryType, Module, RefType, TableType, TypeSection, ValType,
};

use crate::functions::Function as Called;

/// Bytes of a number, and of a place in memory.
const SIZE: u64 = 8;
const POINTER: u64 = 4;
/// Parameters of the function: where the lists stand that are read, those that are written, and the one beside them.
const READ: u32 = 0;
const WRITTEN: u32 = 1;
const BESIDE: u32 = 2;
/// Types of functions, by number.
const RUN: u32 = 0;
const OF_ONE: u32 = 1;
const OF_TWO: u32 = 2;
const SINES: u32 = 3;

/// The module's bytes. The function uses the memory and the table of the program that makes it; sine and cosine go through two numbers at
/// `room`.
pub(crate) fn module(function: &Function<'_>, room: usize) -> Vec<u8> {
    let (i, f) = (ValType::I32, ValType::F64);
    let mut kinds = TypeSection::new();
    kinds.ty().function([i; 3], [f]);
    kinds.ty().function([f], [f]);
    kinds.ty().function([f; 2], [f]);
    kinds.ty().function([f, i], []);
    let mut imports = ImportSection::new();
    let memory =
        MemoryType { minimum: 0, maximum: None, memory64: false, shared: false, page_size_log2: None };
    imports.import("plm", "memory", EntityType::Memory(memory));
    let table = TableType {
        element_type: RefType::FUNCREF,
        minimum: 0,
        maximum: None,
        table64: false,
        shared: false,
    };
    imports.import("plm", "table", EntityType::Table(table));
    let mut functions = FunctionSection::new();
    functions.function(RUN);
    let mut exports = ExportSection::new();
    exports.export("run", ExportKind::Func, 0);
    let mut code = CodeSection::new();
    code.function(&body(function, room));
    let mut module = Module::new();
    module.section(&kinds).section(&imports).section(&functions).section(&exports).section(&code);
    module.finish()
}

fn body(function: &Function<'_>, room: usize) -> wasm_encoder::Function {
    let lists = |elements: &mut dyn Iterator<Item = Element>| -> u32 {
        elements.map(|element| element.list as u32 + 1).max().unwrap_or(0)
    };
    let read = lists(&mut function.arguments.iter().filter_map(|input| match input {
        Input::Element(element) => Some(*element),
        Input::Number(_) => None,
    }));
    let written = lists(&mut function.outputs.iter().map(|(element, _)| *element));
    let pointers = read + written;
    let locals = [(pointers, ValType::I32), (function.registers as u32, ValType::F64)];
    let mut body = wasm_encoder::Function::new(locals);
    let first = BESIDE + 1;
    let mut writer =
        Writer { to: body.instructions(), function, read: first, first: first + pointers, room: room as i32 };
    for (table, count, begin) in [(READ, read, first), (WRITTEN, written, first + read)] {
        for k in 0..count {
            let place = place(u64::from(k) * POINTER, 2);
            writer.to.local_get(table).i32_load(place).local_set(begin + k);
        }
    }
    function.steps.iter().for_each(|step| writer.step(*step));
    for (Element { list, index }, register) in function.outputs {
        writer.store((first + read + *list as u32, *index), *register);
    }
    for (index, register) in function.others.iter().enumerate() {
        writer.store((BESIDE, index), *register);
    }
    match function.returned {
        Some(register) => writer.get(register),
        None => writer.number(0.0),
    }
    writer.to.end();
    body
}

struct Writer<'a> {
    to: InstructionSink<'a>,
    function: &'a Function<'a>,
    /// The local that has the begin of the first list that is read.
    read: u32,
    /// The local that is the first register.
    first: u32,
    room: i32,
}

impl<'a> Writer<'a> {
    fn get(&mut self, register: Register) {
        self.to.local_get(self.first + register);
    }

    fn set(&mut self, register: Register) {
        self.to.local_set(self.first + register);
    }

    fn number(&mut self, number: f64) {
        self.to.f64_const(number.into());
    }

    fn load(&mut self, list: u32, index: usize) {
        self.to.local_get(list).f64_load(element(index));
    }

    fn store(&mut self, (list, index): (u32, usize), register: Register) {
        self.to.local_get(list);
        self.get(register);
        self.to.f64_store(element(index));
    }

    fn step(&mut self, step: Step) {
        match step.operation {
            Operation::SinCos(angle, cosine) => self.sines(angle, [Some(step.to), Some(cosine)]),
            Operation::Sin(angle) => self.sines(angle, [Some(step.to), None]),
            Operation::Cos(angle) => self.sines(angle, [None, Some(step.to)]),
            operation => {
                self.value(operation);
                self.set(step.to);
            }
        }
    }

    /// Puts the result of an operation that finds no sine on the stack.
    fn value(&mut self, operation: Operation) {
        use Operation as O;
        match operation {
            O::Number(number) => self.number(number),
            O::Argument(k) => self.argument(k as usize),
            O::Add(a, b) => {
                self.of([a, b]).f64_add();
            }
            O::Sub(a, b) => {
                self.of([a, b]).f64_sub();
            }
            O::Mul(a, b) => {
                self.of([a, b]).f64_mul();
            }
            O::Div(a, b) => {
                self.of([a, b]).f64_div();
            }
            O::Neg(a) => {
                self.of([a]).f64_neg();
            }
            O::Sqrt(a) => {
                self.of([a]).f64_sqrt();
            }
            O::Abs(a) => {
                self.of([a]).f64_abs();
            }
            O::MulAdd(a, b, c) => {
                self.of([a, b]).f64_mul();
                self.of([c]).f64_add();
            }
            O::NegMulAdd(a, b, c) => {
                self.of([c, a, b]).f64_mul().f64_sub();
            }
            O::MulSub(a, b, c) => {
                self.of([a, b]).f64_mul();
                self.of([c]).f64_sub();
            }
            O::Asin(a) => self.elementary(Called::Asin, &[a]),
            O::Acos(a) => self.elementary(Called::Acos, &[a]),
            O::Atan2(y, x) => self.elementary(Called::Atan2, &[y, x]),
            O::Exp(a) => self.elementary(Called::Exp, &[a]),
            O::Ln(a) => self.elementary(Called::Ln, &[a]),
            O::Floor(a) => self.elementary(Called::Floor, &[a]),
            O::Min(a, b) => self.where_less([a, b], [a, b]),
            O::Max(a, b) => self.where_less([b, a], [a, b]),
            O::Select(a, b, c, d) => self.where_less([a, b], [c, d]),
            O::Sign(a) => self.sign(a),
            // Sines have two results.
            O::SinCos(..) | O::Sin(_) | O::Cos(_) => self.number(f64::NAN),
        }
    }

    /// Puts values on the stack.
    fn of<const N: usize>(&mut self, registers: [Register; N]) -> &mut InstructionSink<'a> {
        registers.into_iter().for_each(|register| self.get(register));
        &mut self.to
    }

    fn argument(&mut self, k: usize) {
        match self.function.arguments.get(k) {
            Some(Input::Element(Element { list, index })) => self.load(self.read + *list as u32, *index),
            Some(Input::Number(number)) => self.number(*number),
            None => self.number(0.0),
        }
    }

    /// `if a < b { c } else { d }`.
    fn where_less(&mut self, less: [Register; 2], [c, d]: [Register; 2]) {
        self.of([c, d]);
        self.of(less).f64_lt().select();
    }

    /// -1 below zero, 1 above, else 0.
    fn sign(&mut self, a: Register) {
        for number in [-1.0, 1.0, 0.0, 0.0] {
            self.number(number);
        }
        self.of([a]).f64_lt().select();
        self.of([a]);
        self.number(0.0);
        self.to.f64_lt().select();
    }

    /// A call of a function that is known by its place in the table.
    fn call(&mut self, called: Called, kind: u32) {
        self.to.i32_const(called.address() as i32).call_indirect(0, kind);
    }

    fn elementary(&mut self, called: Called, of: &[Register]) {
        of.iter().for_each(|register| self.get(*register));
        self.call(called, if called.arguments() == 2 { OF_TWO } else { OF_ONE });
    }

    /// Sine, cosine or both of an angle.
    fn sines(&mut self, angle: Register, to: [Option<Register>; 2]) {
        self.get(angle);
        self.to.i32_const(self.room);
        self.call(Called::Sines(1), SINES);
        for (index, register) in to.into_iter().enumerate() {
            let Some(register) = register else { continue };
            self.to.i32_const(self.room).f64_load(element(index));
            self.set(register);
        }
    }
}

/// The place of an element after the begin of its list.
fn element(index: usize) -> MemArg {
    place(index as u64 * SIZE, 3)
}

/// So many bytes after an address that is a multiple of a power of two.
fn place(offset: u64, align: u32) -> MemArg {
    MemArg { offset, align, target: MemArgTarget::Memory(0), ordering: None }
}

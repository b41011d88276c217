//! From steps to the operations of Cranelift.

use std::collections::BTreeMap;

use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::immediates::Offset32;
use cranelift_codegen::ir::{
    self, AbiParam, InstBuilder, MemFlags, SigRef, Signature, StackSlot, StackSlotData, StackSlotKind, types,
};
use cranelift_codegen::isa::TargetIsa;
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use plm_compiler::lowered::Operation;
use plm_dynamic::{Element, Function, Input};

use crate::call::Lengths;
use crate::functions::Function as Called;
use crate::schedule::{Item, Schedule, Value, cosine, value};

/// Bytes of a number.
const SIZE: usize = 8;

/// Location of a value.
#[derive(Clone, Copy)]
enum Found {
    /// Not computed.
    Nowhere,
    /// In a register.
    Known(ir::Value),
    /// In a list, or among the constants: its begin, and the offset.
    Stored(ir::Value, i32),
    /// On the stack.
    OnStack(StackSlot, i32),
}

/// Writes the operations of a function into `to`; gives the lengths that it needs of its lists, and the constants that it reads where they
/// are.
pub(crate) fn translate(
    function: &Function<'_>,
    (to, frontend): (&mut ir::Function, &mut FunctionBuilderContext),
    isa: &dyn TargetIsa,
    is_fused: bool,
) -> (Lengths, Box<[f64]>) {
    let pointer = isa.pointer_type();
    to.signature.params.extend([AbiParam::new(pointer); 3]);
    to.signature.returns.push(AbiParam::new(types::F64));
    let constants = constants(function);
    let mut builder = FunctionBuilder::new(to, frontend);
    let block = builder.create_block();
    builder.append_block_params_for_function_params(block);
    builder.switch_to_block(block);
    builder.seal_block(block);
    let schedule = Schedule::new(function.steps, function.registers);
    let mut translation = Translation {
        found: vec![Found::Nowhere; 2 * function.steps.len()],
        places: BTreeMap::new(),
        signatures: BTreeMap::new(),
        lists: Vec::new(),
        constants: None,
        pointer,
        is_fused,
        builder,
        function,
        schedule: &schedule,
        numbers: &constants,
    };
    let lengths = translation.all(block);
    translation.builder.finalize();
    (lengths, constants)
}

/// Numbers of a function, in the order of their bits.
fn constants(function: &Function<'_>) -> Box<[f64]> {
    let steps = function.steps.iter().filter_map(|step| match step.operation {
        Operation::Number(number) => Some(number),
        _ => None,
    });
    let arguments = function.arguments.iter().filter_map(|input| match input {
        Input::Number(number) => Some(*number),
        Input::Element(_) => None,
    });
    let mut bits: Vec<u64> = steps.chain(arguments).chain([0.0, 1.0, -1.0]).map(f64::to_bits).collect();
    bits.sort_unstable();
    bits.dedup();
    bits.into_iter().map(f64::from_bits).collect()
}

struct Translation<'a> {
    builder: FunctionBuilder<'a>,
    function: &'a Function<'a>,
    schedule: &'a Schedule,
    numbers: &'a [f64],
    found: Vec<Found>,
    /// By value, where results go: the begin of a list, and the offset.
    places: BTreeMap<Value, Vec<(ir::Value, i32)>>,
    signatures: BTreeMap<Called, SigRef>,
    /// Begins of the lists that are read.
    lists: Vec<ir::Value>,
    constants: Option<ir::Value>,
    pointer: ir::Type,
    is_fused: bool,
}

impl Translation<'_> {
    fn all(&mut self, block: ir::Block) -> Lengths {
        let lengths = self.begin(block);
        let schedule = self.schedule;
        for item in &schedule.items {
            match item {
                Item::Step(step) => self.step(*step),
                Item::Sines(steps) => {
                    for some in steps.chunks(8) {
                        self.sines(some);
                    }
                }
            }
        }
        let returned = self.function.returned.map(|register| self.schedule.result(register));
        let value = match returned {
            Some(value) => self.read(value),
            None => self.builder.ins().f64const(0.0),
        };
        self.builder.ins().return_(&[value]);
        lengths
    }

    /// Loads where lists begin.
    fn begin(&mut self, block: ir::Block) -> Lengths {
        let [inputs, outputs, others] = [0, 1, 2].map(|k| self.builder.block_params(block)[k]);
        let lengths = Lengths::of(self.function);
        let lists = self.pointers(inputs, lengths.inputs.len());
        let written = self.pointers(outputs, lengths.outputs.len());
        self.lists = lists;
        for (Element { list, index }, register) in self.function.outputs {
            let places = self.places.entry(self.schedule.result(*register)).or_default();
            places.push((written[*list], offset(*index)));
        }
        for (index, register) in self.function.others.iter().enumerate() {
            let places = self.places.entry(self.schedule.result(*register)).or_default();
            places.push((others, offset(index)));
        }
        lengths
    }

    /// Begins of so many lists.
    fn pointers(&mut self, table: ir::Value, count: usize) -> Vec<ir::Value> {
        let (pointer, bytes) = (self.pointer, self.pointer.bytes() as usize);
        let load = |k: usize| self.builder.ins().load(pointer, unchanging(), table, (k * bytes) as i32);
        (0..count).map(load).collect()
    }

    /// The value, in a register.
    fn read(&mut self, value: Value) -> ir::Value {
        match self.found[value] {
            Found::Known(value) => value,
            Found::Stored(list, offset) => self.builder.ins().load(types::F64, unchanging(), list, offset),
            Found::OnStack(slot, offset) => {
                self.builder.ins().stack_load(types::F64, slot, Offset32::new(offset))
            }
            Found::Nowhere => self.builder.ins().f64const(f64::NAN),
        }
    }

    /// A constant, where it is.
    fn number(&mut self, number: f64) -> Found {
        let index = self.numbers.partition_point(|known| known.to_bits() < number.to_bits());
        let (pointer, begin) = (self.pointer, self.numbers.as_ptr().addr() as i64);
        let constants = *self.constants.get_or_insert_with(|| self.builder.ins().iconst(pointer, begin));
        Found::Stored(constants, offset(index))
    }

    fn constant(&mut self, number: f64) -> ir::Value {
        if number.to_bits() == 0 {
            return self.builder.ins().f64const(0.0);
        }
        match self.number(number) {
            Found::Stored(list, offset) => self.builder.ins().load(types::F64, unchanging(), list, offset),
            _ => self.builder.ins().f64const(number),
        }
    }

    /// Notes where a value is, and stores it where results are.
    fn put(&mut self, value: Value, found: Found) {
        self.found[value] = found;
        for (list, offset) in self.places.remove(&value).unwrap_or_default() {
            let number = self.read(value);
            self.builder.ins().store(MemFlags::trusted(), number, list, offset);
        }
    }

    /// Calls a function.
    fn call(&mut self, called: Called, arguments: &[ir::Value]) -> ir::Inst {
        let signature = self.signature(called);
        let address = self.builder.ins().iconst(self.pointer, called.address() as i64);
        self.builder.ins().call_indirect(signature, address, arguments)
    }

    fn signature(&mut self, called: Called) -> SigRef {
        if let Some(known) = self.signatures.get(&called) {
            return *known;
        }
        let mut signature = Signature::new(self.builder.func.signature.call_conv);
        signature.params.extend(vec![AbiParam::new(types::F64); called.arguments()]);
        match called {
            Called::Sines(_) => signature.params.push(AbiParam::new(self.pointer)),
            _ => signature.returns.push(AbiParam::new(types::F64)),
        }
        let signature = self.builder.import_signature(signature);
        self.signatures.insert(called, signature);
        signature
    }

    fn elementary(&mut self, called: Called, of: &[u32]) -> ir::Value {
        let arguments: Vec<ir::Value> = of.iter().map(|value| self.read(*value as Value)).collect();
        let call = self.call(called, &arguments);
        self.builder.inst_results(call)[0]
    }

    /// Sines and cosines of at most eight angles, by one call.
    fn sines(&mut self, steps: &[usize]) {
        let count = match steps.len() {
            few @ 1..=2 => few,
            3..=4 => 4,
            _ => 8,
        };
        let angle = |step: &usize| match self.schedule.operation(*step) {
            Operation::SinCos(angle, _) | Operation::Sin(angle) | Operation::Cos(angle) => angle as Value,
            _ => 0,
        };
        let angles: Vec<Value> = steps.iter().map(angle).collect();
        let mut arguments: Vec<ir::Value> = angles.into_iter().map(|angle| self.read(angle)).collect();
        // What is left of a call finds sines of the last angle again.
        arguments.extend(arguments.last().copied().into_iter().cycle().take(count - steps.len()));
        let bytes = (2 * count * SIZE) as u32;
        let data = StackSlotData::new(StackSlotKind::ExplicitSlot, bytes, 4);
        let slot = self.builder.create_sized_stack_slot(data);
        arguments.push(self.builder.ins().stack_addr(self.pointer, slot, 0));
        self.call(Called::Sines(count), &arguments);
        for (k, step) in steps.iter().enumerate() {
            let [sin, cos] = [k, count + k].map(|k| Found::OnStack(slot, offset(k)));
            match self.schedule.operation(*step) {
                Operation::Cos(_) => self.put(value(*step), cos),
                _ => self.put(value(*step), sin),
            }
            self.put(cosine(*step), cos);
        }
    }

    /// One step that finds no sine.
    fn step(&mut self, step: usize) {
        let operation = self.schedule.operation(step);
        let found = match operation {
            Operation::Number(number) => self.number(number),
            Operation::Argument(k) => match self.function.arguments.get(k as usize) {
                Some(Input::Element(Element { list, index })) => {
                    Found::Stored(self.lists[*list], offset(*index))
                }
                Some(Input::Number(number)) => self.number(*number),
                None => self.number(0.0),
            },
            _ => Found::Known(self.result(operation)),
        };
        self.put(value(step), found);
    }

    fn result(&mut self, operation: Operation) -> ir::Value {
        use Operation as O;
        match operation {
            O::Asin(a) => self.elementary(Called::Asin, &[a]),
            O::Acos(a) => self.elementary(Called::Acos, &[a]),
            O::Atan2(y, x) => self.elementary(Called::Atan2, &[y, x]),
            O::Exp(a) => self.elementary(Called::Exp, &[a]),
            O::Ln(a) => self.elementary(Called::Ln, &[a]),
            O::Floor(a) => self.elementary(Called::Floor, &[a]),
            O::MulAdd(a, b, c) | O::NegMulAdd(a, b, c) | O::MulSub(a, b, c) => {
                let [a, b, c] = [a, b, c].map(|value| self.read(value as Value));
                self.product_and_sum(operation, [a, b, c])
            }
            O::Neg(a) => self.of_one(a, |ins, a| ins.fneg(a)),
            O::Sqrt(a) => self.of_one(a, |ins, a| ins.sqrt(a)),
            O::Abs(a) => self.of_one(a, |ins, a| ins.fabs(a)),
            O::Add(a, b) => self.of_two([a, b], |ins, a, b| ins.fadd(a, b)),
            O::Sub(a, b) => self.of_two([a, b], |ins, a, b| ins.fsub(a, b)),
            O::Mul(a, b) => self.of_two([a, b], |ins, a, b| ins.fmul(a, b)),
            O::Div(a, b) => self.of_two([a, b], |ins, a, b| ins.fdiv(a, b)),
            O::Sign(a) => {
                let a = self.read(a as Value);
                let [zero, one, minus] = [0.0, 1.0, -1.0].map(|number| self.constant(number));
                let upper = self.where_less([zero, a], [one, zero]);
                self.where_less([a, zero], [minus, upper])
            }
            O::Min(a, b) => {
                let [a, b] = [a, b].map(|value| self.read(value as Value));
                self.where_less([a, b], [a, b])
            }
            O::Max(a, b) => {
                let [a, b] = [a, b].map(|value| self.read(value as Value));
                self.where_less([b, a], [a, b])
            }
            O::Select(a, b, c, d) => {
                let [a, b, c, d] = [a, b, c, d].map(|value| self.read(value as Value));
                self.where_less([a, b], [c, d])
            }
            // Numbers, arguments and sines have their places.
            O::Number(_) | O::Argument(_) | O::SinCos(..) | O::Sin(_) | O::Cos(_) => {
                self.builder.ins().f64const(f64::NAN)
            }
        }
    }

    fn of_one(
        &mut self,
        a: u32,
        make: impl FnOnce(cranelift_frontend::FuncInstBuilder<'_, '_>, ir::Value) -> ir::Value,
    ) -> ir::Value {
        let a = self.read(a as Value);
        make(self.builder.ins(), a)
    }

    fn of_two(
        &mut self,
        of: [u32; 2],
        make: impl FnOnce(cranelift_frontend::FuncInstBuilder<'_, '_>, ir::Value, ir::Value) -> ir::Value,
    ) -> ir::Value {
        let [a, b] = of.map(|value| self.read(value as Value));
        make(self.builder.ins(), a, b)
    }

    /// A product in a sum, rounded as `mul_add` is.
    fn product_and_sum(&mut self, operation: Operation, [a, b, c]: [ir::Value; 3]) -> ir::Value {
        if self.is_fused {
            let (a, c) = match operation {
                Operation::NegMulAdd(..) => (self.builder.ins().fneg(a), c),
                Operation::MulSub(..) => (a, self.builder.ins().fneg(c)),
                _ => (a, c),
            };
            return self.builder.ins().fma(a, b, c);
        }
        let product = self.builder.ins().fmul(a, b);
        match operation {
            Operation::NegMulAdd(..) => self.builder.ins().fsub(c, product),
            Operation::MulSub(..) => self.builder.ins().fsub(product, c),
            _ => self.builder.ins().fadd(product, c),
        }
    }

    /// `if a < b { c } else { d }`.
    fn where_less(&mut self, [a, b]: [ir::Value; 2], [c, d]: [ir::Value; 2]) -> ir::Value {
        let is_less = self.builder.ins().fcmp(FloatCC::LessThan, a, b);
        self.builder.ins().select(is_less, c, d)
    }
}

/// Flags of lists that are constant while the function runs.
fn unchanging() -> MemFlags {
    MemFlags::trusted().with_readonly().with_can_move()
}

/// The offset of an element.
fn offset(index: usize) -> i32 {
    (index * SIZE) as i32
}

//! Straight-line functions that are evaluated step by step on any scalar, or on `f64` as machine code.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, OnceLock};
use std::thread;

use plm_compiler::lowered::{Register, Routine, Step, Target};
use plm_runtime::Scalar;

use crate::evaluation::{evaluate, factors};
use crate::native::{Element, Function, Input, MachineCode, Tier, Translator};
use crate::places::{Argument, Array, List, Place, Room, in_state, of_scalar};
use crate::recorded::{Recorded, repeat};

/// A function: its steps, its arguments, and the places of its results.
#[derive(Debug)]
pub(crate) struct Code {
    steps: &'static [Step],
    /// The constant that a step multiplies or divides, if it does one.
    factors: Vec<Option<f64>>,
    registers: usize,
    arguments: Vec<Argument>,
    /// Results that are elements of the outputs.
    elements: Vec<(Element, Register)>,
    /// Results that have other places.
    others: Vec<(Place, Register)>,
    returned: Option<Register>,
    inputs: Inputs,
    evaluations: AtomicU32,
    is_being_translated: AtomicBool,
    translation: OnceLock<Option<Box<dyn MachineCode>>>,
    /// Of a rate: the steps of formulas by it.
    whole: [OnceLock<Whole>; FORMULAS],
}

/// The name of a formula, and its step; none where that would be too long.
type Whole = (&'static str, Option<Box<Code>>);

/// Formulas whose steps are computed as a whole.
const FORMULAS: usize = 2;

/// The arguments as elements of lists.
#[derive(Debug)]
struct Inputs {
    arguments: Vec<Input>,
    /// Those of [`FIRST`], then others.
    lists: Vec<List>,
    /// Arguments that stand in no list.
    gathered: Vec<Argument>,
}

impl Code {
    /// A function whose outputs have these names, in order. The arrays `x` and `dx` have the room of the state.
    pub(crate) fn new(routine: &'static Routine, outputs: &[&str], room: Room) -> Code {
        let arguments: Vec<Argument> =
            routine.sources.iter().map(|source| Argument::of(source, room)).collect();
        let mut code = Code {
            steps: &routine.steps,
            factors: factors(&routine.steps),
            registers: routine.registers,
            inputs: Inputs::new(&arguments),
            arguments,
            elements: Vec::new(),
            others: Vec::new(),
            returned: None,
            evaluations: AtomicU32::new(0),
            is_being_translated: AtomicBool::new(false),
            translation: OnceLock::new(),
            whole: Default::default(),
        };
        for (target, register) in &routine.results {
            let place = match *target {
                Target::Value => {
                    code.returned = Some(*register);
                    continue;
                }
                Target::Element(name, k) => {
                    let output = outputs.iter().position(|known| *known == name);
                    let element = |list| Element { list, index: in_state(name, k, room) };
                    code.elements.extend(output.map(|list| (element(list), *register)));
                    continue;
                }
                Target::Rows(place) => Place::Rows(place),
                Target::Entry("response", row, column) => Place::Response(row, room.place(column)),
                Target::Entry(_, row, column) => Place::Entry(room.place(row), room.place(column)),
                Target::Remembered(k) => Place::Remembered(k),
            };
            code.others.push((place, *register));
        }
        code
    }

    /// A function of steps, whose results are elements of outputs but for the one that it returns.
    pub(crate) fn of_steps(
        (steps, registers): (Vec<Step>, usize),
        arguments: Vec<Argument>,
        elements: Vec<(Element, Register)>,
        returned: Register,
    ) -> Code {
        Code {
            factors: factors(&steps),
            steps: Vec::leak(steps),
            registers,
            inputs: Inputs::new(&arguments),
            arguments,
            elements,
            others: Vec::new(),
            returned: Some(returned),
            evaluations: AtomicU32::new(0),
            is_being_translated: AtomicBool::new(false),
            translation: OnceLock::new(),
            whole: Default::default(),
        }
    }

    /// Its steps.
    pub(crate) fn steps(&self) -> &'static [Step] {
        self.steps
    }

    /// Its arguments.
    pub(crate) fn arguments(&self) -> &[Argument] {
        &self.arguments
    }

    /// Its steps recorded with other arguments: elements of the first output and their numbers, and what is returned.
    pub(crate) fn repeated(
        &self,
        argument: impl Fn(usize) -> Recorded,
    ) -> (impl Iterator<Item = (usize, Recorded)>, Option<Recorded>) {
        let own = repeat(self.steps, self.registers, argument);
        let returned = self.returned.map(|register| own[register as usize]);
        let first = self.elements.iter().filter(|(element, _)| element.list == 0);
        (first.map(move |(element, register)| (element.index, own[*register as usize])), returned)
    }

    /// The step of a formula by this rate, where it was made.
    #[inline]
    pub(crate) fn known_whole(&'static self, formula: &'static str) -> Option<&'static Code> {
        let own = self.whole.iter().find_map(|place| place.get().filter(|(own, _)| is_same(own, formula)));
        own?.1.as_deref()
    }

    /// The step of a formula by this rate, which `make` makes once.
    pub(crate) fn whole(
        &'static self,
        formula: &'static str,
        make: impl FnOnce() -> Option<Code>,
    ) -> Option<&'static Code> {
        let mut make = Some(make);
        self.whole.iter().find_map(|place| {
            let (own, code) =
                place.get_or_init(|| (formula, make.take().and_then(|make| make().map(Box::new))));
            is_same(own, formula).then_some(code.as_deref())
        })?
    }

    /// Evaluates step by step: `argument` gives what is read, results go to `outputs` and to `other`, and what is returned comes back.
    pub(crate) fn interpret<S: Scalar>(
        &self,
        argument: &dyn Fn(Argument) -> S,
        outputs: &mut [&mut [S]],
        other: &mut dyn FnMut(Place, S),
    ) -> Option<S> {
        let mut room = Zeros::new();
        let registers = room.of(self.registers);
        for (step, factor) in self.steps.iter().zip(&self.factors) {
            evaluate((step, *factor), registers, |k| {
                self.arguments.get(k).map_or(S::ZERO, |place| argument(*place))
            });
        }
        for (Element { list, index }, register) in &self.elements {
            if let Some(to) = outputs.get_mut(*list).and_then(|output| output.get_mut(*index)) {
                *to = registers[*register as usize];
            }
        }
        for (place, register) in &self.others {
            other(*place, registers[*register as usize]);
        }
        self.returned.map(|register| registers[register as usize])
    }

    /// Evaluates by machine code: `list` gives what is read, `gathered` what stands in no list, and what is returned comes back, or zero;
    /// nothing where a list is too short.
    pub(crate) fn compute<'a>(
        &self,
        code: &dyn MachineCode,
        first: [&'a [f64]; FIRST.len()],
        list: &dyn Fn(List) -> &'a [f64],
        gathered: &dyn Fn(Argument) -> f64,
        outputs: &mut [&mut [f64]],
        other: &mut dyn FnMut(Place, f64),
    ) -> Option<f64> {
        let Inputs { lists, gathered: beside, .. } = &self.inputs;
        let (mut room, mut room_of_others) = (Zeros::new(), Zeros::new());
        let own = room.of(beside.len());
        for (to, argument) in own.iter_mut().zip(beside) {
            *to = gathered(*argument);
        }
        let mut all: [&[f64]; LISTS];
        let inputs = if lists.len() <= FIRST.len() {
            &first[..]
        } else {
            all = [&[]; LISTS];
            all[..FIRST.len()].copy_from_slice(&first);
            for (to, from) in all.iter_mut().zip(lists).skip(FIRST.len()) {
                *to = if *from == List::Gathered { own } else { list(*from) };
            }
            &all[..lists.len()]
        };
        let others = room_of_others.of(self.others.len());
        let value = code.run(inputs, outputs, others)?;
        for ((place, _), value) in self.others.iter().zip(others) {
            other(*place, *value);
        }
        Some(value)
    }

    /// Does it return a value?
    pub(crate) fn returns(&self) -> bool {
        self.returned.is_some()
    }

    /// Its machine code; nothing until it is worth the translation.
    #[inline]
    pub(crate) fn machine_code(
        &'static self,
        translator: &Arc<dyn Translator>,
    ) -> Option<&'static dyn MachineCode> {
        match self.translation.get() {
            Some(code) => code.as_deref(),
            None => self.translated(translator),
        }
    }

    #[cold]
    fn translated(&'static self, translator: &Arc<dyn Translator>) -> Option<&'static dyn MachineCode> {
        // A count that two threads have at once may be short by one: that is no harm.
        let evaluations = self.evaluations.load(Ordering::Relaxed);
        if evaluations < translator.evaluations_before() {
            self.evaluations.store(evaluations + 1, Ordering::Relaxed);
            return None;
        }
        if translator.tier() == Tier::InBackground {
            if self.is_being_translated.swap(true, Ordering::Relaxed) {
                return None;
            }
            let own = Arc::clone(translator);
            let name = "translation of a function".to_owned();
            let thread = thread::Builder::new().name(name).spawn(move || {
                self.translation.get_or_init(|| self.translate(own.as_ref()));
            });
            if thread.is_ok() {
                return None;
            }
        }
        self.translation.get_or_init(|| self.translate(translator.as_ref())).as_deref()
    }

    fn translate(&self, translator: &dyn Translator) -> Option<Box<dyn MachineCode>> {
        let others: Vec<Register> = self.others.iter().map(|(_, register)| *register).collect();
        translator.translate(&Function {
            steps: self.steps,
            registers: self.registers,
            arguments: &self.inputs.arguments,
            outputs: &self.elements,
            others: &others,
            returned: self.returned,
        })
    }
}

/// Are two names the same? They are constants: most often in the same place.
fn is_same(name: &'static str, other: &'static str) -> bool {
    std::ptr::eq(name, other) || name == other
}

/// The most lists that a function reads: every [`Array`] and every other [`List`].
const LISTS: usize = 20;
/// Lists that every function has, in this order: most functions read no others, and none of these is looked for.
pub(crate) const FIRST: [List; 6] = [
    List::Time,
    List::Parameters,
    List::Inputs,
    List::Switches,
    List::Array(Array::X),
    List::Array(Array::Step),
];

impl Inputs {
    fn new(arguments: &[Argument]) -> Inputs {
        let mut inputs = Inputs { arguments: Vec::new(), lists: FIRST.to_vec(), gathered: Vec::new() };
        for argument in arguments {
            let input = inputs.input(*argument);
            inputs.arguments.push(input);
        }
        inputs
    }

    fn input(&mut self, argument: Argument) -> Input {
        let (list, index) = match argument {
            Argument::Time => (List::Time, 0),
            Argument::Parameter(k) => (List::Parameters, k),
            Argument::Input(k) => (List::Inputs, k),
            Argument::Switch(k) => (List::Switches, k),
            Argument::Multiplier(k) => (List::Multipliers, k),
            Argument::Element(array, k) => (List::Array(array), k),
            Argument::Scalar(number) => return Input::Number(of_scalar::<f64>(number)),
            Argument::None => return Input::Number(f64::NAN),
            Argument::Turns(_) | Argument::Remembered(_) | Argument::Mode(..) => {
                self.gathered.push(argument);
                (List::Gathered, self.gathered.len() - 1)
            }
        };
        let known = self.lists.iter().position(|known| *known == list);
        let list = known.unwrap_or_else(|| {
            self.lists.push(list);
            self.lists.len() - 1
        });
        Input::Element(Element { list, index })
    }
}

/// A list of zeros, of which few stand in this value. What works on them is not told how many there are, so that a program has it once.
pub(crate) struct Zeros<S> {
    very_few: [S; 8],
    few: Option<[S; 48]>,
    many: Vec<S>,
}

impl<S: Scalar> Zeros<S> {
    #[inline]
    pub(crate) fn new() -> Self {
        Self { very_few: [S::ZERO; 8], few: None, many: Vec::new() }
    }

    /// A list of so many zeros, once.
    #[inline]
    pub(crate) fn of(&mut self, count: usize) -> &mut [S] {
        if let Some(room) = self.very_few.get_mut(..count) {
            return room;
        }
        let few = self.few.insert([S::ZERO; 48]);
        if let Some(room) = few.get_mut(..count) {
            return room;
        }
        self.many.resize(count, S::ZERO);
        &mut self.many
    }
}

//! The order in which steps are done: sines that do not need each other stand side by side, so that one call finds several.

use plm_compiler::lowered::{Operation, Register, Step};

/// A value: the result of a step.
pub(crate) type Value = usize;

/// A routine whose registers are values, each of which one step writes.
#[derive(Debug)]
pub(crate) struct Schedule {
    /// The operations, by number of the step; operands are values.
    operations: Vec<Operation>,
    /// Items in the order of execution.
    pub(crate) items: Vec<Item>,
    /// The value that a register has at the end.
    last: Vec<Value>,
}

/// Something that is done.
#[derive(Debug)]
pub(crate) enum Item {
    /// A step that finds no sine.
    Step(usize),
    /// Steps that find sines or cosines, of angles that are known.
    Sines(Vec<usize>),
}

/// The value of a step; of sine and cosine, the sine.
pub(crate) fn value(step: usize) -> Value {
    2 * step
}

/// The second value of a step that finds sine and cosine.
pub(crate) fn cosine(step: usize) -> Value {
    2 * step + 1
}

fn step_of(value: Value) -> usize {
    value / 2
}

impl Schedule {
    /// Orders the steps of a routine.
    pub(crate) fn new(steps: &[Step], registers: usize) -> Schedule {
        let (operations, last) = with_values(steps, registers);
        let mut schedule = Schedule { operations, items: Vec::new(), last };
        schedule.order();
        schedule
    }

    /// The operation of a step: its operands are values; so is the cosine of sine and cosine.
    pub(crate) fn operation(&self, step: usize) -> Operation {
        self.operations[step]
    }

    /// The value of a register at the end.
    pub(crate) fn result(&self, register: Register) -> Value {
        self.last[register as usize]
    }

    fn order(&mut self) {
        let levels = self.levels();
        let mut is_done = vec![false; self.operations.len()];
        let deepest = levels.iter().flatten().max();
        for level in 0..deepest.map_or(0, |deepest| deepest + 1) {
            let sines: Vec<usize> = (0..levels.len()).filter(|step| levels[*step] == Some(level)).collect();
            for step in self.needed(&sines, &is_done) {
                is_done[step] = true;
                self.items.push(Item::Step(step));
            }
            for step in &sines {
                is_done[*step] = true;
            }
            self.items.push(Item::Sines(sines));
        }
        let rest = (0..is_done.len()).filter(|step| !is_done[*step]);
        self.items.extend(rest.map(Item::Step));
    }

    /// Of each step that finds a sine, the number of such steps that its angle needs one after the other.
    fn levels(&self) -> Vec<Option<usize>> {
        let mut before = vec![0; self.operations.len()];
        let mut levels = vec![None; self.operations.len()];
        for (step, operation) in self.operations.iter().enumerate() {
            before[step] = operands(*operation).map(|value| before[step_of(value)]).max().unwrap_or(0);
            if finds_sine(*operation) {
                levels[step] = Some(before[step]);
                before[step] += 1;
            }
        }
        levels
    }

    /// The steps that some steps need and that are not done, in order.
    fn needed(&self, steps: &[usize], is_done: &[bool]) -> Vec<usize> {
        let mut is_needed = vec![false; self.operations.len()];
        let mut open: Vec<usize> = steps.to_vec();
        while let Some(step) = open.pop() {
            for needed in operands(self.operations[step]).map(step_of) {
                if !is_done[needed] && !is_needed[needed] {
                    is_needed[needed] = true;
                    open.push(needed);
                }
            }
        }
        (0..is_needed.len()).filter(|step| is_needed[*step]).collect()
    }
}

fn finds_sine(operation: Operation) -> bool {
    matches!(operation, Operation::SinCos(..) | Operation::Sin(_) | Operation::Cos(_))
}

/// The operations with values in place of registers, and the last value of each register.
fn with_values(steps: &[Step], registers: usize) -> (Vec<Operation>, Vec<Value>) {
    let mut current: Vec<Value> = vec![0; registers];
    let mut operations = Vec::with_capacity(steps.len());
    for (number, step) in steps.iter().enumerate() {
        let operation = step.operation.with_operands(|register| current[register as usize] as Register);
        operations.push(operation);
        current[step.to as usize] = value(number);
        if let Operation::SinCos(_, register) = step.operation {
            current[register as usize] = cosine(number);
        }
    }
    (operations, current)
}

/// The values that an operation reads.
fn operands(mut operation: Operation) -> impl Iterator<Item = Value> {
    let read: Vec<Value> = operation.operands_mut().into_iter().map(|value| *value as Value).collect();
    read.into_iter()
}

//! Registers of a routine: a value leaves its register after its last use.

use super::routine::{Operation, Register, Routine};

/// Gives each value a register that no value which is still needed has.
pub(super) fn share(routine: &mut Routine) {
    const KEPT: usize = usize::MAX;
    let mut last_use = vec![0; routine.registers];
    for (at, step) in routine.steps.iter_mut().enumerate() {
        last_use[step.to as usize] = at;
        if let Operation::SinCos(_, cosine) = step.operation {
            last_use[cosine as usize] = at;
        }
        for operand in step.operation.operands_mut() {
            last_use[*operand as usize] = at;
        }
    }
    for (_, result) in &routine.results {
        last_use[*result as usize] = KEPT;
    }
    let mut place = vec![0; routine.registers];
    let (mut free, mut count): (Vec<Register>, Register) = (Vec::new(), 0);
    for (at, step) in routine.steps.iter_mut().enumerate() {
        let mut ended = Vec::new();
        for operand in step.operation.operands_mut() {
            let value = *operand as usize;
            *operand = place[value];
            if last_use[value] == at && !ended.contains(&place[value]) {
                ended.push(place[value]);
            }
        }
        let mut take = |value: Register, free: &mut Vec<Register>| {
            place[value as usize] = free.pop().unwrap_or_else(|| {
                count += 1;
                count - 1
            });
            place[value as usize]
        };
        // Sine and cosine are written one after the other: neither may take the place of the angle.
        if let Operation::SinCos(_, cosine) = &mut step.operation {
            let (value, own) = (*cosine, step.to);
            step.to = take(own, &mut free);
            *cosine = take(value, &mut free);
            free.append(&mut ended);
            for value in [own, value] {
                if last_use[value as usize] == at {
                    free.push(place[value as usize]);
                }
            }
            continue;
        }
        free.append(&mut ended);
        let own = step.to;
        step.to = take(own, &mut free);
        if last_use[own as usize] == at {
            free.push(step.to);
        }
    }
    for (_, result) in &mut routine.results {
        *result = place[*result as usize];
    }
    routine.registers = count as usize;
}

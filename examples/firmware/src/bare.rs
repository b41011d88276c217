//! Mechanisms on a board: their bits, one number a line in hexadecimal, and after `#` what each run took.
//!
//! It links only without std, allocation and panic. On Linux and as WebAssembly it prints the same bits and counts nothing.
#![no_std]
#![no_main]

mod arm;
mod contact;
mod filter;
mod steps;

use steps::Run;

machine::program!(main);

fn main() -> i32 {
    let outcome = steps::run(&mut machine::print_line, &mut report);
    machine::print(b"# program");
    numbers(&machine::sizes());
    i32::from(outcome.is_err())
}

/// Prints a line `# mechanism,scalar,by,minimum,maximum,stack,size`.
fn report(run: &Run) {
    machine::print(b"#");
    for (index, name) in run.name.iter().enumerate() {
        machine::print(if index == 0 { b" " } else { b"," });
        machine::print(name.as_bytes());
    }
    numbers(&[run.instructions[0], run.instructions[1], run.stack, run.size as u32]);
}

fn numbers(numbers: &[u32]) {
    for &number in numbers {
        machine::print(b",");
        decimal(number);
    }
    machine::print(b"\n");
}

/// Prints a number without leading zeros.
fn decimal(number: u32) {
    if number >= 10 {
        decimal(number / 10);
    }
    machine::print(&[b'0' + (number % 10) as u8]);
}

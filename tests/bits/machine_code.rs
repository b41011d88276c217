//! Machine code that takes the place of steps during a run.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use plm::dynamic::{Function, Integrator, MachineCode, Mechanism as Text, Run, Tier, Translator};
use plm::jit::Host;
use plm::runtime::Described as _;

use crate::emitted::{double_pendulum, four_bar};

/// A translator whose machine code counts its calls.
#[derive(Clone, Debug)]
struct Counting(Host, Arc<AtomicU64>);

#[derive(Debug)]
struct Counted(Box<dyn MachineCode>, Arc<AtomicU64>);

impl Translator for Counting {
    fn translate(&self, function: &Function<'_>) -> Option<Box<dyn MachineCode>> {
        let code = self.0.translate(function)?;
        Some(Box::new(Counted(code, Arc::clone(&self.1))))
    }

    fn evaluations_before(&self) -> u32 {
        self.0.evaluations_before()
    }

    fn tier(&self) -> Tier {
        self.0.tier()
    }
}

impl MachineCode for Counted {
    fn run(&self, inputs: &[&[f64]], outputs: &mut [&mut [f64]], others: &mut [f64]) -> Option<f64> {
        self.1.fetch_add(1, Ordering::Relaxed);
        self.0.run(inputs, outputs, others)
    }
}

/// Runs of a declaration in steps of a millisecond: by steps, and by machine code whose calls are counted.
fn counted(declaration: &str, host: Host) -> ([Run; 2], Arc<AtomicU64>) {
    let calls = Arc::default();
    let run = |translator: Option<Counting>| {
        let mechanism = Text::from_text(declaration).unwrap();
        if let Some(translator) = translator {
            mechanism.translate_by(Arc::new(translator));
        }
        mechanism.start_with(Integrator::Rk4(1e-3)).unwrap()
    };
    ([run(None), run(Some(Counting(host, Arc::clone(&calls))))], calls)
}

/// Runs both to a time, and compares them.
fn to_same_bits(runs: &mut [Run; 2], time: f64) {
    let [by_steps, machine] = runs;
    by_steps.step_to(time).unwrap();
    machine.step_to(time).unwrap();
    for body in by_steps.bodies() {
        assert_eq!(by_steps.body(body).unwrap(), machine.body(body).unwrap(), "{body} at {time}");
    }
    assert_eq!(by_steps.stats(), machine.stats());
}

#[test]
fn a_step_of_a_formula_is_one_call_of_machine_code() {
    let declarations = [<double_pendulum::DoublePendulum>::DECLARATION, <four_bar::FourBar>::DECLARATION];
    for declaration in declarations {
        let (mut runs, calls) = counted(declaration, Host::new().unwrap().after(0));
        to_same_bits(&mut runs, 0.1);
        let (calls_before, steps) = (calls.load(Ordering::Relaxed), runs[1].stats().steps);
        to_same_bits(&mut runs, 1.1);
        let steps = runs[1].stats().steps - steps;
        let calls_in_between = calls.load(Ordering::Relaxed) - calls_before;
        // Loops are looked at now and then.
        assert!(
            steps >= 1000 && (steps..steps + steps / 5).contains(&calls_in_between),
            "{calls_in_between}"
        );
    }
}

#[test]
fn machine_code_takes_the_place_of_steps_while_a_run_goes_on() {
    let host = Host::new().unwrap().after(0).in_background();
    let (mut runs, calls) = counted(<double_pendulum::DoublePendulum>::DECLARATION, host);
    let (mut time, begin) = (0.0, Instant::now());
    while calls.load(Ordering::Relaxed) < 100 {
        time += 0.01;
        to_same_bits(&mut runs, time);
        assert!(begin.elapsed() < Duration::from_secs(60), "nothing was translated");
    }
    to_same_bits(&mut runs, time + 0.1);
}

//! A mechanism from text beside the compiled one: the same bits of poses and outputs, the same steps, evaluations, events and faults; by
//! steps, and with the feature `jit`, which `cargo test --workspace` has, by machine code that takes their place during a run.

use plm::dynamic::{self, Integrator, Run};
use plm::runtime::{Described, Moment};
use plm::{Method, Sim, Stats};

fn of_compiled<M: Described<S = f64>>(state: &M::State) -> Vec<u64> {
    let mut all = Vec::new();
    M::poses(state, &mut |body| all.extend(body.components()));
    (0..M::OBSERVED.len()).for_each(|k| all.extend(M::observed(state, k)));
    all.into_iter().map(f64::to_bits).collect()
}

fn of_text(run: &Run) -> Vec<u64> {
    let poses = run.bodies().flat_map(|name| run.body(name).unwrap().components());
    let outputs = run.all_columns().iter().map(|column| run.output(&column.name).unwrap());
    poses.chain(outputs).map(f64::to_bits).collect()
}

fn counted(stats: Stats) -> [u64; 5] {
    [stats.steps, stats.rejected, stats.evaluations, stats.switches, stats.projected]
}

/// By steps at first, then by machine code.
#[cfg(feature = "jit")]
fn translated(text: dynamic::Mechanism) -> dynamic::Mechanism {
    text.translate_by(std::sync::Arc::new(plm::jit::Host::new().unwrap().after(20)));
    text
}

/// Compares a run of so many intervals of some length, s, by a method, which `integrator` names as text does.
#[track_caller]
pub(crate) fn same_bits<M: Described<S = f64>, I: Method<M>>(
    mechanism: M,
    (method, integrator): (I, &str),
    (times, by): (u32, f64),
) {
    let from_text = || dynamic::Mechanism::from_text(M::DECLARATION).unwrap();
    let texts = [
        from_text(),
        #[cfg(feature = "jit")]
        translated(from_text()),
    ];
    let name = texts[0].name().to_owned();
    let integrator: Integrator = integrator.parse().unwrap();
    let mut compiled: Sim<M, I> = mechanism.start_with(method).unwrap();
    let mut runs = texts.map(|text| text.start_with(integrator).unwrap());
    for k in 1..=times {
        let end = f64::from(k) * by;
        let ends = compiled.step_to(end).map_err(|fault| fault.to_string());
        for run in &mut runs {
            assert_eq!(ends, run.step_to(end).map_err(|error| error.to_string()), "{name} to {end}");
            let time = compiled.state().time();
            assert_eq!(of_compiled::<M>(compiled.state()), of_text(run), "{name} at {time}");
        }
        if ends.is_err() {
            return;
        }
    }
    for run in runs {
        assert_eq!(counted(compiled.stats()), counted(run.stats()), "{name}");
    }
}

/// Compares runs of mechanisms with their declared values by `Dop853` over an interval, s, in four parts. Each has the stack of a
/// program, since one of many bodies with contact takes up to 2 MB without optimisation.
#[allow(unused_macros, reason = "some compare by methods of their own")]
macro_rules! same {
    ($($mechanism:path: $time:literal),* $(,)?) => {
        $({
            type M = $mechanism;
            let by = (plm::Dop853::new(1e-8), "Dop853:1e-8");
            let compare = move || $crate::beside_text::same_bits(M::new(), by, (4, $time / 4.0));
            std::thread::Builder::new().stack_size(8 << 20).spawn(compare).unwrap().join().unwrap();
        })*
    };
}
#[allow(unused_imports, reason = "some compare by methods of their own")]
pub(crate) use same;

//! A mechanism from text beside the compiled one: the same bits of poses and outputs, the same steps, evaluations, events and faults; by
//! steps, and with the feature `jit`, which `cargo test --workspace` has, by machine code that takes their place during a run.

use plm::dynamic::{self, Integrator, Run};
use plm::runtime::{Described, Moment};
use plm::{Method, Sim, Stats};

/// What a run has been, bit by bit.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Course {
    /// Poses and outputs after each interval, with its end; none where assembly fails.
    pub(crate) moments: Vec<(u64, Vec<u64>)>,
    counts: [u64; 5],
    pub(crate) fault: Option<String>,
}

/// So many intervals of some length, s.
pub(crate) type Intervals = (u32, f64);

fn ends((times, by): Intervals) -> impl Iterator<Item = f64> {
    (1..=times).map(move |k| f64::from(k) * by)
}

fn counted(stats: Stats) -> [u64; 5] {
    [stats.steps, stats.rejected, stats.evaluations, stats.switches, stats.projected]
}

/// That of a compiled mechanism: all that is built for each.
fn of_compiled<M: Described<S = f64>, I: Method<M>>(
    mechanism: M,
    method: I,
    intervals: Intervals,
    course: &mut Course,
) -> Result<(), String> {
    let told = |fault: plm::Fault| fault.to_string();
    let mut sim: Sim<M, I> = mechanism.start_with(method).map_err(told)?;
    for end in ends(intervals) {
        let ends = sim.step_to(end);
        let (mut all, state) = (Vec::new(), sim.state());
        M::poses(state, &mut |body| all.extend(body.components().map(f64::to_bits)));
        all.extend((0..M::OBSERVED.len()).filter_map(|k| M::observed(state, k)).map(f64::to_bits));
        course.moments.push((state.time().to_bits(), all));
        course.counts = counted(sim.stats());
        ends.map_err(told)?;
    }
    Ok(())
}

fn of_text(
    text: &dynamic::Mechanism,
    integrator: Integrator,
    intervals: Intervals,
    course: &mut Course,
) -> Result<(), dynamic::Error> {
    let mut run: Run = text.start_with(integrator)?;
    for end in ends(intervals) {
        let ends = run.step_to(end);
        let poses = run.bodies().flat_map(|name| run.body(name).unwrap().components());
        let outputs = run.all_columns().iter().map(|column| run.output(&column.name).unwrap());
        let all = poses.chain(outputs).map(f64::to_bits).collect();
        course.moments.push((run.time().to_bits(), all));
        course.counts = counted(run.stats());
        ends?;
    }
    Ok(())
}

/// By steps at first, then by machine code.
#[cfg(feature = "jit")]
fn translated(text: dynamic::Mechanism) -> dynamic::Mechanism {
    text.translate_by(std::sync::Arc::new(plm::jit::Host::new().unwrap().after(20)));
    text
}

/// How runs of a declaration by a method differ from the course of the compiled mechanism.
fn difference(
    declaration: &str,
    integrator: &str,
    intervals: Intervals,
    compiled: &Course,
) -> Option<String> {
    let from_text = || dynamic::Mechanism::from_text(declaration).unwrap();
    let texts = [
        ("steps", from_text()),
        #[cfg(feature = "jit")]
        ("machine code", translated(from_text())),
    ];
    let integrator: Integrator = integrator.parse().unwrap();
    texts.iter().find_map(|(by, text)| {
        let mut own = Course::default();
        own.fault = of_text(text, integrator, intervals, &mut own).err().map(|error| error.to_string());
        if own == *compiled {
            return None;
        }
        let all = own.moments.iter().zip(&compiled.moments);
        let first =
            all.filter(|(own, compiled)| own != compiled).map(|(own, _)| f64::from_bits(own.0)).next();
        let [(own, own_fault), (counts, fault)] =
            [&own, compiled].map(|course| (course.counts, &course.fault));
        Some(format!(
            "{}, by {by}: other bits at {first:?} s; {own:?}, {own_fault:?} for {counts:?}, {fault:?}",
            text.name()
        ))
    })
}

/// The course of runs over so many intervals by a method, which is named as text does; or how a run from text differs from the compiled one.
pub(crate) fn beside<M: Described<S = f64>, I: Method<M>>(
    mechanism: M,
    (method, integrator): (I, &str),
    intervals: Intervals,
) -> Result<Course, String> {
    let mut compiled = Course::default();
    compiled.fault = of_compiled(mechanism, method, intervals, &mut compiled).err();
    difference(M::DECLARATION, integrator, intervals, &compiled).map_or(Ok(compiled), Err)
}

/// Compares a run of so many intervals of some length, s, by a method, which `integrator` names as text does: it begins, and has the bits.
#[track_caller]
#[allow(dead_code, reason = "who counts differences asks for them")]
pub(crate) fn same_bits<M: Described<S = f64>, I: Method<M>>(
    mechanism: M,
    by: (I, &str),
    intervals: Intervals,
) {
    let found = beside(mechanism, by, intervals);
    let has_begun = found.as_ref().is_ok_and(|course| !course.moments.is_empty());
    let why = || found.map_or_else(|difference| difference, |course| format!("{:?}", course.fault));
    assert!(has_begun, "{}", why());
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

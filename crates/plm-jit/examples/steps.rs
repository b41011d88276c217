//! Times of a step: from text by machine code and by steps, over compiled by rustc. `cargo run --release -p plm-jit --example steps`
//! prints a line for each mechanism, or for those whose name begins with an argument, and ends where bits differ; ratios of one run are
//! what counts.
#![allow(
    unused_imports,
    unreachable_pub,
    dead_code,
    missing_docs,
    reason = "declarations that others use more of"
)]

#[path = "../../../examples/firmware/src/arm.rs"]
mod arm;
#[path = "../../../benches/scenes/chain.rs"]
mod chain;
#[path = "../../../tests/support/standard.rs"]
mod declared;

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use declared::{s1, s2, s5, s6};
use plm::runtime::{Described, Mechanism as _};
use plm::{Dop853, Method, Rk4};
use plm_dynamic::{Integrator, Mechanism};
use plm_jit::Host;

chain::chain!(Chain64, 64);

/// Turns of which the shortest counts.
const TURNS: u32 = 12;

/// The time of a run to an end, ns, and the bits of all poses there.
type Outcome = (f64, Vec<u64>);

fn compiled<M: Described<S = f64>, I: Method<M>>(
    mechanism: M,
    method: I,
    end: f64,
) -> Result<Outcome, plm::Fault> {
    let mut sim = mechanism.start_with(method)?;
    let begin = Instant::now();
    sim.step(end)?;
    let time = begin.elapsed().as_secs_f64() * 1e9;
    let mut bits = Vec::new();
    M::poses(sim.state(), &mut |body| bits.extend(body.components().map(f64::to_bits)));
    Ok((time, bits))
}

fn from_text(mechanism: &Mechanism, method: Integrator, end: f64) -> Result<Outcome, plm_dynamic::Error> {
    let mut run = mechanism.start_with(method)?;
    let begin = Instant::now();
    run.step_to(end)?;
    let time = begin.elapsed().as_secs_f64() * 1e9;
    let poses = run.bodies().filter_map(|name| run.body(name).ok());
    Ok((time, poses.flat_map(|body| body.components().map(f64::to_bits)).collect()))
}

/// A mechanism of a text, and the time until it has made its first step, ms.
fn ready(text: &str, host: Option<Host>, method: Integrator) -> Result<(Mechanism, f64), plm_dynamic::Error> {
    let begin = Instant::now();
    let mechanism = Mechanism::from_text(text)?;
    if let Some(host) = host {
        mechanism.translate_by(Arc::new(host));
    }
    mechanism.start_with(method)?.step_to(1e-5)?;
    Ok((mechanism, begin.elapsed().as_secs_f64() * 1e3))
}

/// Compares runs of so many steps of a length, or to an end.
fn compare<M: Described<S = f64>, I: Method<M>>(
    (name, mechanism): (&str, M),
    (method, by_name): (impl Fn() -> I, Integrator),
    (end, steps): (f64, f64),
) -> Result<(), Box<dyn Error>> {
    if std::env::args().nth(1).is_some_and(|wanted| !name.starts_with(&wanted)) {
        return Ok(());
    }
    let Some(host) = Host::new() else { return Err("no machine code for this processor".into()) };
    let (interpreted, _) = ready(M::DECLARATION, None, by_name)?;
    let (translated, lazily) = ready(M::DECLARATION, Some(host.clone()), by_name)?;
    let (_, at_once) = ready(M::DECLARATION, Some(host.after(0)), by_name)?;
    let mut least = [f64::INFINITY; 3];
    for _ in 0..TURNS {
        let outcomes = [
            compiled(mechanism, method(), end)?,
            from_text(&translated, by_name, end)?,
            from_text(&interpreted, by_name, end)?,
        ];
        if outcomes.iter().any(|(_, bits)| *bits != outcomes[0].1) {
            return Err(format!("{name}: other bits").into());
        }
        for (least, (time, _)) in least.iter_mut().zip(outcomes) {
            *least = least.min(time);
        }
    }
    let [rustc, machine, by_steps] = least;
    println!(
        "{name:16} rustc {:7.0} ns, machine code {:7.0} ns ({:.2}), interpreted {:7.0} ns ({:.1}); \
         first step {lazily:.1} ms after the text, {at_once:.1} ms with all translated",
        rustc / steps,
        machine / steps,
        machine / rustc,
        by_steps / steps,
        by_steps / rustc,
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let rk4 = |h: f64| (move || Rk4::new(h), Integrator::Rk4(h));
    compare(("S1", s1::DoublePendulum::new()), rk4(1e-4), (0.2, 2000.0))?;
    compare(("S2", s2::FourBar::new()), rk4(1e-4), (0.2, 2000.0))?;
    compare(("S6", s6::SliderCrank::new()), rk4(1e-4), (0.2, 2000.0))?;
    compare(("S5", s5::Andrews::new()), rk4(1e-5), (0.01, 1000.0))?;
    compare(("hydraulic arm", arm::Arm::new()), rk4(1e-4), (0.2, 2000.0))?;
    let dop853 = (|| Dop853::new(1e-6), Integrator::Dop853(1e-6));
    compare(("arm, Dop853", arm::Arm::new()), dop853, (0.2, 1.0))?;
    compare(("chain of 64", Chain64::new()), rk4(1e-4), (0.02, 200.0))
}

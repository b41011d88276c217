//! Instructions of a second of a slider-crank with friction, beside the same without; counted by valgrind.
//!
//! `bash benches/contact.sh` builds it and prints the table of the book's page on contact. How it counts: `scenes/count.rs`.
//! `bash benches/contact.sh -- count NAME run 1` runs one second of a mechanism alone, as for a profile.
#![allow(clippy::panic, reason = "benches")]

#[path = "scenes/count.rs"]
mod count;
#[path = "../tests/contact/machines.rs"]
mod machines;

use machines::slider_crank;
use plm::{Dop853, Fault, Mechanism, Stats, mechanism};

/// Makes so many units of work, as [`count`] asks for.
pub(crate) type Steps = Box<dyn FnMut(u32)>;

slider_crank!(None, loops, 30, output used = mu;);
slider_crank!(Own, loops, 30, friction rub: rate(slider.x) within mu*(25 N););
slider_crank!(Rail, loops, 30, friction rub: rate(slider.x) within mu*norm(rail.force););
slider_crank!(Pins, loops, 30,
    friction rub: rate(slider.x) within mu*norm(rail.force);
    friction at_o: rate(crank.angle) within mu*(0.01 m)*norm(o.force);
    friction at_a: rate(rod.angle - crank.angle) within mu*(0.01 m)*norm(a.force);
    friction at_b: rate(rod.angle) within mu*(0.01 m)*norm(b.force););

/// A mechanism of the table.
struct Scene {
    name: &'static str,
    friction: &'static str,
    run: fn(u32) -> Result<Stats, Fault>,
}

const SCENES: [Scene; 4] = [
    Scene { name: "none", friction: "none", run: |seconds| run(None { mu: 0.05, ..None::new() }, seconds) },
    Scene {
        name: "own",
        friction: "of the slider, by a bound of its own",
        run: |seconds| run(Own { mu: 0.05, ..Own::new() }, seconds),
    },
    Scene {
        name: "rail",
        friction: "of the slider, by the reaction of its rail",
        run: |seconds| run(Rail { mu: 0.05, ..Rail::new() }, seconds),
    },
    Scene {
        name: "pins",
        friction: "of the slider and in three pins, by their reactions",
        run: |seconds| run(Pins { mu: 0.05, ..Pins::new() }, seconds),
    },
];

/// Counters of a run of so many seconds.
fn run<M: Mechanism<S = f64>>(mechanism: M, seconds: u32) -> Result<Stats, Fault> {
    let mut sim = mechanism.start_with(Dop853::new(1e-9))?;
    sim.step_to(f64::from(seconds))?;
    Ok(sim.stats())
}

fn main() {
    let find = |name: &str, _: &str| -> Steps {
        let scene = SCENES.into_iter().find(|scene| scene.name == name).expect("a scene of the table");
        Box::new(move |seconds| {
            (scene.run)(seconds).expect("the mechanism moves");
        })
    };
    if count::counted(find) {
        return;
    }
    println!(
        "{:<53} {:>5} {:>11} {:>6} {:>12} {:>5}",
        "friction", "steps", "evaluations", "events", "instructions", "ratio"
    );
    let mut least = f64::INFINITY;
    for scene in SCENES {
        let Stats { steps, evaluations, switches, .. } = (scene.run)(1).expect("the mechanism moves");
        let instructions = count::between(scene.name, "run", [0, 1]);
        least = least.min(instructions);
        println!(
            "{:<53} {steps:>5} {evaluations:>11} {switches:>6} {instructions:>12} {:>5.1}",
            scene.friction,
            instructions / least
        );
    }
}

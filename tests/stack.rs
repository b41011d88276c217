//! What starts and steps take of the stack: it grows with the number of bodies, and what does not is asked for by a size
//! that is known, and refused with a fault. A stack that overflows would end this program.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use std::thread;

use plm::runtime::workspace;
use plm::{Cause, Fault, Mechanism};

#[path = "../benches/scenes/chain.rs"]
mod chain;

chain::chain!(Chain32, 32);

plm::mechanism! {
    /// A parallelogram with a third crank, which says what the others say.
    pub ThreeCranks {
        formulation: absolute;
        allow(W0001);
        gravity: 9.81 m/s^2;
        ground { port o1: (0, 0) m; port o2: (1, 0) m; port o3: (2, 0) m; }
        repeat i in 1..=3 {
            body crank[i] {
                mass: 1 kg;
                inertia: 0.1 kg*m^2;
                port a: (0, 0) m;
                port b: (0.5, 0) m;
                start x: (i - 1)*1 m;
                start angle: 30 deg;
            }
        }
        body bar {
            mass: 2 kg;
            inertia: 0.1 kg*m^2;
            port p1: (0, 0) m;
            port p2: (1, 0) m;
            port p3: (2, 0) m;
            start x: 0.433012701892219 m;
            start y: 0.25 m;
        }
        revolute foot1(ground.o1, crank[1].a);
        revolute foot2(ground.o2, crank[2].a);
        revolute foot3(ground.o3, crank[3].a);
        revolute head1(crank[1].b, bar.p1);
        revolute head2(crank[2].b, bar.p2);
        revolute head3(crank[3].b, bar.p3);
    }
}

/// Runs in a thread that has so many bytes of stack.
fn with_stack<T: Send>(bytes: usize, run: impl FnOnce() -> T + Send) -> T {
    thread::scope(|scope| {
        let thread = thread::Builder::new().stack_size(bytes).spawn_scoped(scope, run).unwrap();
        thread.join().unwrap()
    })
}

fn start_and_step<M: Mechanism<S = f64>>(mechanism: M) -> Result<u64, Fault> {
    let mut sim = mechanism.start()?;
    sim.step(1e-2)?;
    Ok(sim.stats().steps)
}

/// Bytes of a bar of a chain in builds without optimisation; 2 MiB hold 256 bars.
const BAR: usize = 8 << 10;

#[test]
fn a_chain_takes_stack_in_proportion_to_its_bars() {
    assert!(with_stack(32 * BAR, || start_and_step(Chain32::new())).unwrap() > 0);
}

#[test]
fn what_a_solution_by_rank_takes_is_known_and_refused() {
    const WORKSPACE: usize = ThreeCranks::<f64>::WORKSPACE;
    // phi_q and combinations of its rows: 12 rows, 12 coordinates.
    assert_eq!(WORKSPACE, 8 * 12 * (12 + 12));
    assert_eq!(ThreeCranks::<f32>::WORKSPACE, WORKSPACE / 2);
    assert_eq!(workspace::allowed(), workspace::USUAL);

    workspace::allow(WORKSPACE);
    assert!(start_and_step(ThreeCranks::new()).unwrap() > 0);

    workspace::allow(WORKSPACE - 1);
    let refused = Cause::Workspace { bytes: WORKSPACE, allowed: WORKSPACE - 1 };
    let fault = ThreeCranks::new().start().err().unwrap();
    assert_eq!((fault.time, fault.cause), (0.0, refused));
    // Nothing of it is needed where elimination is healthy.
    assert!(start_and_step(Chain32::new()).unwrap() > 0);
    // A lock too many is one of the cases that are solved by rank.
    let mut locked = Chain32::new();
    (locked.start.bar_0.x.locked, locked.start.bar_0.angle.locked) = (true, true);
    let fault = locked.start().err().unwrap();
    let bytes = 8 * 64 * (96 + 64);
    assert_eq!(fault.cause, Cause::Workspace { bytes, allowed: WORKSPACE - 1 });

    // So much, beside what every start takes, is enough for it.
    workspace::allow(bytes);
    let fault = with_stack(32 * BAR + bytes, || locked.start().err()).unwrap();
    assert!(matches!(fault.cause, Cause::Redundant { count: 1, .. }), "{fault}");
    workspace::allow(workspace::USUAL);
}

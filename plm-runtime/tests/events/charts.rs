//! What a system holds over a step and brings up to date between steps; states that it refuses.

use core::f64::consts::PI;

use plm_runtime::method::Method;
use plm_runtime::system::Updated;
use plm_runtime::{Cause, Constraints, Dop853, Events, Fault, Health, Labels, Mechanism, Rate, Rk4, Sim};

use crate::linkage::At;

/// x'' = 1 - x from rest at -1: x = 1 - 2 cos t. The state is y = chart x, with the chart 1 or -1 that makes y
/// negative where |x| is above 1/2.
#[derive(Clone, Copy, Debug)]
struct Charted {
    /// States above this are refused.
    most: f64,
}

impl Rate for Charted {
    type S = f64;
    type X = [f64; 2];
    type U = f64;
    const NQ: usize = 1;

    fn rate(&self, _t: f64, chart: &f64, y: &[f64; 2], dy: &mut [f64; 2]) -> Health<f64> {
        *dy = [y[1], chart - y[0]];
        Health::perfect()
    }
}

impl Constraints for Charted {
    fn update(&self, t: f64, chart: &mut f64, y: &mut [f64; 2]) -> Result<Updated, Fault> {
        if *chart * y[0] > self.most {
            return Err(Fault::of_part(
                t,
                "coupler",
                Cause::Drift { phi: y[0].abs() - self.most, phi_dot: 0.0 },
            ));
        }
        let moved = y[0] > 0.5;
        if moved {
            *chart = -*chart;
            *y = y.map(|y| -y);
        }
        Ok(Updated { moved, ..Updated::default() })
    }
}

impl Events for Charted {
    type G = [f64; 0];
}

impl Labels for Charted {}

impl Mechanism for Charted {
    type State = At<Self>;
    type Rescue = plm_runtime::singular::Never<Self>;

    fn start_state(&self, _t: f64) -> Result<(f64, [f64; 2]), Fault> {
        Ok((1.0, [-1.0, 0.0]))
    }
}

fn exact(t: f64) -> f64 {
    1.0 - 2.0 * t.cos()
}

#[test]
fn charts_change_between_steps_and_samples_know_theirs() {
    fn worst<I: Method<Charted>>(method: I) -> (f64, Sim<Charted, I>) {
        let mut sim = Charted { most: 4.0 }.start_with(method).unwrap();
        let mut worst: f64 = 0.0;
        let mut sample = |moment: &At<Charted>| {
            worst = worst.max((moment.held * moment.x[0] - exact(moment.time)).abs());
        };
        sim.run(4.0 * PI, 0.01, &mut sample).unwrap();
        (worst, sim)
    }
    let (error, sim) = worst(Dop853::new(1e-10));
    assert!(error < 1e-8, "{error:e}");
    // Two turns, each from -1 to 3 and back.
    assert_eq!(sim.stats().charts, 4);
    let (error, sim) = worst(Rk4::new(1e-3));
    assert!(error < 1e-8, "{error:e}");
    assert_eq!(sim.stats().charts, 4);
}

#[test]
fn a_state_that_is_refused_is_not_kept() {
    fn refused<I: Method<Charted>>(method: I) -> (Sim<Charted, I>, Fault) {
        let mut sim = Charted { most: 2.5 }.start_with(method).unwrap();
        let mut last: f64 = 0.0;
        let sample = |moment: &At<Charted>| last = last.max(moment.held * moment.x[0]);
        let fault = sim.run(4.0, 0.001, sample).unwrap_err();
        assert_eq!(fault.part, "coupler");
        assert!(matches!(fault.cause, Cause::Drift { phi, .. } if phi > 0.0), "{fault}");
        // Neither the state nor a sample is beyond it.
        assert!((sim.held * sim.x[0] - exact(sim.time)).abs() < 1e-8, "{}", sim.time);
        assert!(last <= 2.5, "{last}");
        (sim, fault)
    }
    // 2.5 is passed at 2.419 s.
    let limit = (-0.75_f64).acos();
    // Fixed steps end with the last one before it, and go on from there if they may.
    let (mut sim, fault) = refused(Rk4::new(1e-3));
    assert!(sim.time < limit && limit < fault.time && fault.time - sim.time < 1.001e-3, "{fault}");
    sim.step(0.9 * (limit - sim.time)).unwrap();
    assert!(sim.step(1e-3).is_err());
    // Steps that may be shortened come as near as there are numbers between.
    let (sim, fault) = refused(Dop853::new(1e-12));
    assert!((sim.time - limit).abs() < 1e-9 && (fault.time - limit).abs() < 1e-9, "{fault}");
    assert!(sim.stats().rejected > 30 && sim.stats().steps < 200, "{:?}", sim.stats());
}

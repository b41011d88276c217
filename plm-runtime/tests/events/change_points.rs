//! Passing through positions where the rank of phi_q falls: all these linkages keep their cranks parallel, so that they
//! move as one pendulum, and at their flat positions other branches begin.

use core::f64::consts::FRAC_PI_2;

use plm_runtime::method::Method;
use plm_runtime::{Constraints, Dopri5, Events, Fault, Health, Labels, Mechanism, Rate, Rk4, Sim};

use crate::linkage::At;
use crate::mechanisms::{Ladder, bars, ladder, parallelogram};

/// theta'' = -k cos(theta).
#[derive(Clone, Copy, Debug)]
struct Equivalent {
    k: f64,
    start: [f64; 2],
}

impl Rate for Equivalent {
    type S = f64;
    type X = [f64; 2];
    type U = ();
    const NQ: usize = 1;

    fn rate(&self, _t: f64, (): &(), x: &[f64; 2], dx: &mut [f64; 2]) -> Health<f64> {
        *dx = [x[1], -self.k * x[0].cos()];
        Health::perfect()
    }
}

impl Constraints for Equivalent {}

impl Events for Equivalent {
    type G = [f64; 0];
}

impl Labels for Equivalent {}

impl Mechanism for Equivalent {
    type State = At<Self>;
    type Rescue = plm_runtime::singular::Never<Self>;

    fn start_state(&self, _t: f64) -> Result<(Self::U, [f64; 2]), Fault> {
        Ok(((), self.start))
    }
}

impl Equivalent {
    /// The angle after `t`, to some 1e-11 rad.
    fn angle(self, t: f64) -> f64 {
        let mut sim = self.start_with(Dopri5::new(1e-13)).unwrap();
        sim.step(t).unwrap();
        sim.x[0]
    }
}

fn run<M, I>(mut sim: Sim<M, I>, t: f64) -> Sim<M, I>
where
    M: Mechanism<S = f64>,
    I: Method<M>,
{
    sim.step(t).unwrap();
    // The tolerance of fixed steps, and what the steps between two looks may add.
    assert!(sim.drift().phi < 1e-9 && sim.drift().phi_dot < 1e-9, "{:?}", sim.drift());
    sim
}

/// Bar and cranks of the parallelograms: (m r + n m_c r / 2) / (m r^2 + n m_c r^2 / 3) of n cranks.
fn parallel(bar: f64, crank: f64, r: f64, n: f64) -> f64 {
    9.81 * (bar * r + n * crank * r / 2.0) / (bar * r * r + n * crank * r * r / 3.0)
}

#[test]
fn a_redundant_parallelogram_swings_through_its_flat_positions() {
    for angle in [0.3, 0.77] {
        let m = parallelogram(angle);
        let expected = Equivalent { k: parallel(2.0, 0.5, 0.5, 3.0), start: [angle, 0.0] }.angle(2.0);
        let error = |h: f64| {
            let sim = run(m.start_with(Rk4::new(h)).unwrap(), 2.0);
            assert!(sim.x[2].abs() < 1e-12, "the bar turned by {:e}", sim.x[2]);
            (sim.x[5] - expected).abs().max((sim.x[11] - expected).abs())
        };
        let (coarse, fine) = (error(4e-3), error(2e-3));
        assert!(fine < 1e-8, "{angle}: {fine:e}");
        assert!(((coarse / fine).log2() - 4.0).abs() < 0.5, "{angle}: {coarse:e} {fine:e}");
        let sim = run(m.start_with(Dopri5::new(1e-9)).unwrap(), 2.0);
        assert!((sim.x[5] - expected).abs() < 1e-7, "{angle}: {:e}", sim.x[5] - expected);
    }
}

#[test]
fn a_parallelogram_four_bar_does_not_change_its_branch() {
    // Healthy but near the flat positions; the stages come as near as they may.
    for k in 0..8 {
        let angle = 0.3 + 0.031 * f64::from(k);
        let mut m = bars([0.5, 1.0, 0.5], [angle, 0.0, angle]);
        m.0.start[0].angle.locked = false;
        let expected = Equivalent { k: parallel(1.0, 0.5, 0.5, 2.0), start: [angle, 0.0] }.angle(2.0);
        for h in [5e-3, 2e-3] {
            let sim = run(m.start_with(Rk4::new(h)).unwrap(), 2.0);
            assert!(
                (sim.x[2] - expected).abs() < 5e-8 * (h / 5e-3_f64).powi(4),
                "{angle} {h}: {:e}",
                sim.x[2] - expected
            );
            assert!(sim.stats().by_rank < sim.stats().evaluations / 10);
        }
        let sim = run(m.start_with(Dopri5::new(1e-8)).unwrap(), 2.0);
        assert!((sim.x[2] - expected).abs() < 1e-6, "{angle}: {:e}", sim.x[2] - expected);
    }
}

#[test]
fn a_ladder_turns_over_and_over() {
    // S4, N = 2, 10 s: three cranks of (1/3) kg m^2 and two bars of 1 kg that move on circles of 1 m; without
    // stabilisation it blows up at 4.61 s (benchmarks, scenes.md).
    let start = [FRAC_PI_2, -1.0];
    let expected = Equivalent { k: 9.81 * (3.0 * 0.5 + 2.0) / (3.0 / 3.0 + 2.0), start }.angle(10.0);
    let error = |sim: Sim<Ladder<f64>, Rk4<f64>>| {
        let sim = run(sim, 10.0);
        [2, 8, 14].into_iter().fold(0.0, |worst, i| f64::max(worst, (sim.x[i] - expected).abs()))
    };
    for h in [1e-2, 5e-3, 2e-3] {
        let error = error(ladder().start_with(Rk4::new(h)).unwrap());
        println!("S4, N = 2, rk4 {h}: error {error:e}");
        assert!(error < 2e-6 * (h / 1e-2_f64).powi(3), "{h}: {error:e}");
    }
}

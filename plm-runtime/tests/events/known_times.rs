//! Conditions of the time alone, which are hit exactly.

use plm_runtime::method::{Gauss, Method};
use plm_runtime::{Adams, Dop853, Dopri5, Mechanism, Rk4, Seen, SemiImplicitEuler, Sim, Vern9};

use super::events::{SMOOTH, Scene, run};

/// x' = -x + (0 until 1, 1 until 2.5, then 3).
const KNOWN: Scene = Scene {
    rate: |t, held, x| {
        // What applies after a known time must not be seen before it, and what applied before not after it.
        let [from, to] = [[0.0, 1.0], [1.0, 2.5], [2.5, f64::INFINITY]][held.passed];
        assert!(from <= t && t <= to, "{t} {held:?}");
        [0.0, 0.0, [0.0, 1.0, 3.0][held.passed] - x[2]]
    },
    instants: &[1.0, 2.5],
    start: [0.0, 0.0, 1.0],
    ..SMOOTH
};

#[test]
fn known_times_are_hit_exactly() {
    let exact = {
        let at_1 = (-1.0_f64).exp();
        let at_2_5 = 1.0 + (at_1 - 1.0) * (-1.5_f64).exp();
        3.0 + (at_2_5 - 3.0) * (-1.5_f64).exp()
    };
    let sim = run(KNOWN, Dop853::new(1e-11), 4.0);
    assert!((sim.x[2] - exact).abs() < 1e-11, "{:e}", sim.x[2] - exact);
    assert_eq!((sim.stats().switches, sim.held.passed), (2, 2));
    // Steps of 0.3 s at most: four to 1, five to 2.5, five to 4; the order is kept.
    let error = |h: f64| (run(KNOWN, Rk4::new(h), 4.0).x[2] - exact).abs();
    assert_eq!(run(KNOWN, Rk4::new(0.3), 4.0).stats().steps, 14);
    let order = (error(0.05) / error(0.025)).log2();
    assert!((order - 4.0).abs() < 0.1, "{order}");
    // An interval that ends at such a time has passed it.
    let mut sim = KNOWN.start_with(Dop853::new(1e-11)).unwrap();
    sim.step(1.0).unwrap();
    assert_eq!(sim.held.passed, 1);
    sim.step(3.0).unwrap();
    assert!((sim.x[2] - exact).abs() < 1e-11);
}

#[test]
fn known_times_are_hit_by_every_method() {
    fn passes<I: Method<Scene>>(method: I) {
        // The rate of KNOWN itself refuses times beyond what is held.
        let sim = run(KNOWN, method, 4.0);
        assert_eq!((sim.time, sim.held.passed), (4.0, 2));
    }
    passes(Dop853::new(1e-4));
    passes(Vern9::new(1e-4));
    passes(Adams::new(1e-4));
    passes(Dopri5::new(1e-4));
    passes(Rk4::new(0.7));
    passes(SemiImplicitEuler::new(0.7));
    passes(Gauss::<_, 2>::new(0.7));
    passes(Gauss::<_, 3>::new(0.7));
}

/// Samples at the very times of conditions: without dense output after them, with it before; watched or not.
#[test]
fn samples_at_known_times_are_those_of_a_run_where_it_is_watched() {
    fn samples<I: Method<Scene>>(method: impl Fn() -> I) -> [Vec<(u64, usize)>; 2] {
        let (mut run, mut watched) = (Vec::new(), Vec::new());
        let mut sim = KNOWN.start_with(method()).unwrap();
        sim.run(4.0, 0.5, |state| run.push((state.x[2].to_bits(), state.held.passed))).unwrap();
        let mut sim = KNOWN.start_with(method()).unwrap();
        Sim::watch(&mut sim, 4.0, 0.5, |seen| {
            if let Seen::Sample(state) = seen {
                watched.push((state.x[2].to_bits(), state.held.passed));
            }
        })
        .unwrap();
        [run, watched]
    }
    let [run, watched] = samples(|| Rk4::new(0.5));
    assert_eq!(run, watched);
    assert_eq!(run.iter().map(|(_, passed)| *passed).collect::<Vec<_>>(), [0, 0, 1, 1, 1, 2, 2, 2, 2]);
    let [run, watched] = samples(|| Dop853::new(1e-9));
    assert_eq!(run, watched);
    assert_eq!(run.iter().map(|(_, passed)| *passed).collect::<Vec<_>>(), [0, 0, 0, 1, 1, 1, 2, 2, 2]);
}

//! The Rosenbrock-W method: order with exact and with wrong derivatives, stability, what a step costs.

use plm_runtime::linalg::Dense;
use plm_runtime::method::Ros34Pw2;
use plm_runtime::{Cause, Constraints, Dual, Events, Fault, Health, Labels, Linear, Mechanism, Rate};

use crate::linkage::At;
use crate::mechanisms::double_pendulum;
use crate::oscillator::{Oscillator, error, oscillator};
use crate::random::Random;
use crate::smooth::{Chirp, ProtheroRobinson, Spring, StiffPendulum};

fn error_with<M: Mechanism<State = At<M>, X = [f64; 3], S = f64> + Linear>(mechanism: M, h: f64) -> f64 {
    let mut sim = mechanism.start_with(Ros34Pw2::new(h)).unwrap();
    sim.step(2.0).unwrap();
    error(2.0, &sim.x)
}

#[test]
fn order_is_3() {
    let order = (error_with(oscillator(), 0.02) / error_with(oscillator(), 0.01)).log2();
    println!("ROS34PW2: {order:.3}");
    assert!((order - 3.0).abs() < 0.05, "{order}");
}

/// The oscillator with derivatives that are wrong everywhere, but for q' = v.
#[derive(Clone, Copy, Debug)]
struct Wrong(Oscillator<f64>);

impl Rate for Wrong {
    type S = f64;
    type X = [f64; 3];
    type U = f64;
    const NQ: usize = 1;

    fn rate(&self, t: f64, u: &f64, x: &[f64; 3], dx: &mut [f64; 3]) -> Health<f64> {
        self.0.rate(t, u, x, dx)
    }
}

impl Constraints for Wrong {}

impl Events for Wrong {
    type G = [f64; 0];
}

impl Labels for Wrong {}

impl Linear for Wrong {
    type Lifted<const K: usize> = Oscillator<Dual<f64, K>>;
    type In<T: plm_runtime::Real> = Oscillator<T>;
    type Derivatives = [[f64; 3]; 3];

    fn lift<const K: usize>(&self, held: &f64) -> (Self::Lifted<K>, f64) {
        self.0.lift(held)
    }
    fn in_numbers<T: plm_runtime::Real>(
        &self,
        held: &f64,
        number: impl Fn(f64) -> T,
    ) -> (Oscillator<T>, f64) {
        self.0.in_numbers(held, number)
    }
    fn jacobian(
        &self,
        _t: f64,
        _u: &f64,
        _x: &[f64; 3],
        by_x: &mut [[f64; 3]; 3],
        by_t: Option<&mut [f64; 3]>,
    ) -> Health<f64> {
        let mut random = Random(5);
        for i in 1..3 {
            for j in 0..3 {
                <[f64; 3]>::set_entry(by_x, i, j, random.unit());
            }
        }
        by_x[0] = [0.0, 1.0, 0.0];
        if let Some(by_t) = by_t {
            *by_t = [0.0, random.unit(), random.unit()];
        }
        Health::perfect()
    }
}

impl Mechanism for Wrong {
    type State = At<Self>;
    type Rescue = plm_runtime::singular::Never<Self>;

    fn start_state(&self, t: f64) -> Result<(f64, [f64; 3]), Fault> {
        self.0.start_state(t)
    }
}

#[test]
fn order_is_3_with_wrong_derivatives() {
    let order = (error_with(Wrong(oscillator()), 0.02) / error_with(Wrong(oscillator()), 0.01)).log2();
    println!("ROS34PW2 with wrong derivatives: {order:.3}");
    assert!((order - 3.0).abs() < 0.1, "{order}");
}

/// The table of Rang and Angermann: alpha_ij, then gamma_ij, with gamma on the diagonal.
const TABLE: [[[f64; 4]; 4]; 2] = [
    [
        [0.0; 4],
        [8.717_330_430_169_18e-1, 0.0, 0.0, 0.0],
        [8.445_706_001_536_942e-1, -1.129_906_423_648_418_5e-1, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0],
    ],
    [
        [4.358_665_215_084_59e-1, 0.0, 0.0, 0.0],
        [-8.717_330_430_169_18e-1, 4.358_665_215_084_59e-1, 0.0, 0.0],
        [-9.033_805_701_304_408e-1, 5.418_067_238_809_532_6e-2, 4.358_665_215_084_59e-1, 0.0],
        [
            2.421_238_070_609_534_6e-1,
            -1.223_250_583_904_514_7,
            5.452_602_553_351_021e-1,
            4.358_665_215_084_59e-1,
        ],
    ],
];

/// k_i = h f(t + alpha_i h, x + sum alpha_ij k_j) + h f_x sum gamma_ij k_j + gamma_i h^2 f_t (Hairer and Wanner II, IV.7,
/// eq. (7.4a)) for x' = cos(w t x). No order tells of a derivative by time that is left out: it does not depend on it.
fn step_of_the_formula(w: f64, t: f64, x: f64, h: f64) -> f64 {
    let [alpha, gamma] = TABLE;
    let (f_x, f_t) = (-w * t * (w * t * x).sin(), -w * x * (w * t * x).sin());
    let mut k = [0.0; 4];
    for i in 0..4 {
        let dot = |row: &[f64; 4], k: &[f64; 4]| (0..i).map(|j| row[j] * k[j]).sum::<f64>();
        let sum = |row: &[f64; 4]| row.iter().sum::<f64>();
        let rate = (w * (t + sum(&alpha[i]) * h) * (x + dot(&alpha[i], &k))).cos();
        let right = h * rate + h * f_x * dot(&gamma[i], &k) + sum(&gamma[i]) * h * h * f_t;
        k[i] = right / (1.0 - h * gamma[i][i] * f_x);
    }
    x + (0..4).map(|i| (alpha[3][i] + gamma[3][i]) * k[i]).sum::<f64>()
}

#[test]
fn steps_are_those_of_the_formula() {
    for (w, h) in [(2.0, 0.1), (5.0, 0.2), (9.0, 0.05)] {
        let mut method = Ros34Pw2::new(h);
        method.worst_error = f64::INFINITY;
        let mut sim = Chirp { w }.start_with(method).unwrap();
        let mut x = 0.3;
        for step in 0..8 {
            x = step_of_the_formula(w, sim.time, x, h);
            sim.step(h).unwrap();
            // Rounding, in an order of its own, and what a step makes of that.
            assert!((sim.x[0] - x).abs() < 1e-13, "w = {w}, step {step}: {} {x}", sim.x[0]);
        }
    }
}

/// R(z) = 1 + z b^T (I - z (alpha + gamma))^-1 1 at z = i w, from one step of an oscillator.
fn amplification(wh: f64) -> f64 {
    let mut method = Ros34Pw2::new(1.0);
    method.worst_error = f64::INFINITY;
    let mut sim = Spring { w: wh, z: 0.0 }.start_with(method).unwrap();
    sim.step(1.0).unwrap();
    sim.x[0].hypot(sim.x[1] / wh)
}

#[test]
fn a_stable() {
    let mut wh = 1e-3;
    while wh < 1e6 {
        let amplification = amplification(wh);
        assert!(amplification <= 1.0 + 1e-14, "{wh}: {amplification}");
        wh *= 1.05;
    }
}

#[test]
fn l_stable() {
    assert!(amplification(1e7) < 1e-5, "{}", amplification(1e7));
    for lambda in [-1e4_f64, -1e8, -1e12] {
        let mut method = Ros34Pw2::new(0.5);
        method.worst_error = f64::INFINITY;
        let mut sim = ProtheroRobinson { lambda }.start_with(method).unwrap();
        sim.x[0] = 2.0;
        sim.step(0.5).unwrap();
        let left = (sim.x[0] - 0.5_f64.cos()).abs();
        assert!(left < 10.0 / (0.5 * lambda).abs(), "{lambda:e}: {left:e}");
    }
}

#[test]
fn order_falls_to_2_where_the_equations_are_infinitely_stiff() {
    let error = |h: f64| {
        let mut sim = ProtheroRobinson { lambda: -1e6_f64 }.start_with(Ros34Pw2::new(h)).unwrap();
        sim.step(2.0).unwrap();
        (sim.x[0] - 2.0_f64.cos()).abs()
    };
    let order = (error(0.02) / error(0.01)).log2();
    println!("Prothero-Robinson: {order:.3}, error {:e}", error(0.01));
    assert!((order - 2.0).abs() < 0.1 && error(0.01) < 1e-10, "{order} {:e}", error(0.01));
}

#[test]
fn a_step_costs_four_rates_and_one_decomposition() {
    let mut sim = double_pendulum::<f64>().start_with(Ros34Pw2::new(1e-3)).unwrap();
    sim.step(1.0).unwrap();
    let stats = sim.stats();
    assert_eq!(
        (stats.steps, stats.evaluations, stats.jacobians, stats.factorisations),
        (1000, 4000, 1000, 1000)
    );
    // S1@1 of the references.
    assert!(
        (sim.x[2] + 1.982_300_799_7).abs() < 1e-4 && (sim.x[5] + 2.289_294_970_6).abs() < 1e-4,
        "{:?}",
        sim.x
    );
    assert!(sim.drift().phi < 1e-9, "{:?}", sim.drift());
}

#[test]
fn a_spring_that_turns_too_much_in_a_step_ends_the_run() {
    for (stiffness, h) in [(1e6_f64, 0.1), (1e8, 0.05), (1e10, 0.1), (1e12, 0.0125)] {
        let mut sim = StiffPendulum { stiffness }.start_with(Ros34Pw2::new(h)).unwrap();
        let cause = sim.step(1.0).unwrap_err().cause;
        assert!(matches!(cause, Cause::StepTooLong { step, error } if step == h && error > 0.05), "{cause}");
    }
    // With shorter steps it works; an explicit method could take 2.8e-3 s at most.
    let mut sim = StiffPendulum { stiffness: 1e6_f64 }.start_with(Ros34Pw2::new(5e-3)).unwrap();
    sim.step(1.0).unwrap();
    // The rigid pendulum is at (0.87955, -0.47581).
    assert!((sim.x[0] - 0.879_55).abs() < 3e-3, "{:?}", sim.x);
}

#[test]
fn steps_that_make_no_sense_are_refused() {
    for h in [0.0, -1.0, f64::NAN] {
        let mut sim = oscillator().start_with(Ros34Pw2::new(h)).unwrap();
        assert!(matches!(sim.step(1.0).unwrap_err().cause, Cause::StepTooSmall { .. }), "{h}");
    }
}

//! Errors are values that say when, where and why.

use plm_runtime::method::{Gauss, Method};
use plm_runtime::{
    Cause, Constraints, Dop853, Dopri5, Events, Fault, Health, Labels, Mechanism, Notice, Operations, Rate,
    Rk4, SemiImplicitEuler,
};

use crate::linkage::At;
use crate::oscillator::oscillator;

/// x' = x^2 from x = 1: infinite at t = 1.
#[derive(Clone, Copy, Debug)]
struct BlowUp;

impl Rate for BlowUp {
    type S = f64;
    type X = [f64; 1];
    type U = ();
    const NQ: usize = 0;

    fn rate(&self, _t: f64, (): &(), x: &[f64; 1], dx: &mut [f64; 1]) -> Health<f64> {
        *dx = [x[0] * x[0]];
        Health::perfect()
    }
}

impl Constraints for BlowUp {}

impl Events for BlowUp {
    type G = [f64; 0];
}

impl Labels for BlowUp {
    fn part_of_state(&self, _index: usize) -> &'static str {
        "tank"
    }
}

impl Mechanism for BlowUp {
    type State = At<Self>;
    type Rescue = plm_runtime::singular::Never<Self>;

    fn start_state(&self, _t: f64) -> Result<(Self::U, [f64; 1]), Fault> {
        Ok(((), [1.0]))
    }
}

#[test]
fn a_pole_makes_the_step_too_small() {
    let mut sim = BlowUp.start_with(Dopri5::new(1e-9)).unwrap();
    let fault = sim.step(2.0).unwrap_err();
    assert!((fault.time - 1.0).abs() < 1e-6, "{fault}");
    assert!(matches!(fault.cause, Cause::StepTooSmall { .. } | Cause::NotFinite), "{fault}");
    assert_eq!(fault.part, "tank");
    // The state of the last accepted step is kept, and it is on the solution 1 / (1 - t).
    assert!(sim.time < 1.0 && sim.x[0].is_finite());
    assert!((sim.time + 1.0 / sim.x[0] - 1.0).abs() < 1e-7);
}

/// `fn main() -> Result<(), Fault>` shows `Debug`, and so does `unwrap`.
#[test]
fn a_fault_reads_as_words_wherever_it_is_shown() {
    let fault = Fault::of_part(1.5, "elbow", Cause::Locked);
    let words = "t = 1.5 s: elbow: its loop cannot be closed beyond this pose: the mechanism locks up";
    assert_eq!([fault.to_string(), format!("{fault:?}"), format!("{fault:#?}")], [words; 3]);
}

#[test]
fn what_people_look_at_can_be_shown() {
    let mut sim = BlowUp.start_with(Dopri5::new(1e-9)).unwrap();
    sim.step(0.5).unwrap();
    let shown = format!("{sim:?} {:?}", sim.save());
    assert!(shown.starts_with("Sim { state: At") && shown.contains("Snapshot(Sim {"), "{shown}");
    assert!(shown.contains(&format!("steps: {}", sim.stats().steps)), "{shown}");
    let count = Operations { add: 14, mul: 12, sin_cos: 4, ..Operations::default() };
    assert_eq!(count.to_string(), "30 operations: 14 add, 12 mul, 4 sin_cos");
    assert_eq!(Operations { div: 1, ..Operations::default() }.to_string(), "1 operation: 1 div");
    assert_eq!(Operations::default().to_string(), "0 operations");
    let notice = Notice::PassedOver { conditions: 3 }.to_string();
    assert!(notice.contains("3 times") && notice.contains("shorter steps"), "{notice}");
    let notice = Notice::DividedSteps { steps: 7 }.to_string();
    assert!(notice.contains("7 times") && notice.contains("shorter steps"), "{notice}");
}

#[test]
fn samples_before_a_failure_are_given() {
    let mut sim = BlowUp.start_with(Dopri5::new(1e-9)).unwrap();
    let mut times = Vec::new();
    sim.run(2.0, 0.125, |moment| times.push(moment.time)).unwrap_err();
    assert_eq!(times, [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875]);
}

#[test]
fn a_fixed_step_over_a_pole_names_the_part() {
    let mut sim = BlowUp.start_with(Rk4::new(0.1)).unwrap();
    let fault = sim.step(3.0).unwrap_err();
    assert_eq!(fault.part, "tank");
    assert!(matches!(fault.cause, Cause::StepTooLong { error, .. } if error > 1.0), "{fault}");
    assert!(sim.x[0].is_finite());
    // The pole is at 1 s: the step that begins there is the one.
    assert!(fault.time > 0.95 && fault.time < 2.0, "{fault}");
    assert!(fault.to_string().ends_with(" of the state; shorter steps"), "{fault}");
}

#[test]
fn a_state_that_is_not_a_number_is_named_at_once() {
    let mut sim = oscillator::<f64>().start().unwrap();
    sim.x[2] = f64::NAN;
    let fault = sim.step(1.0).unwrap_err();
    assert_eq!((fault.time, fault.part, fault.cause), (0.0, "filter", Cause::NotFinite));
}

/// x' = sqrt(1 - t) in the second of two states: not a number after t = 1.
#[derive(Clone, Copy, Debug)]
struct Ends;

impl Rate for Ends {
    type S = f64;
    type X = [f64; 2];
    type U = ();
    const NQ: usize = 0;

    fn rate(&self, t: f64, (): &(), _x: &[f64; 2], dx: &mut [f64; 2]) -> Health<f64> {
        *dx = [1.0, (1.0 - t).sqrt()];
        Health::perfect()
    }
}

impl Constraints for Ends {}

impl Events for Ends {
    type G = [f64; 0];
}

impl Labels for Ends {
    fn part_of_state(&self, index: usize) -> &'static str {
        ["clock", "valve"][index]
    }
}

impl Mechanism for Ends {
    type State = At<Self>;
    type Rescue = plm_runtime::singular::Never<Self>;

    fn start_state(&self, _t: f64) -> Result<(Self::U, [f64; 2]), Fault> {
        Ok(((), [0.0; 2]))
    }
}

#[test]
fn a_rate_that_is_not_a_number_is_named_with_its_time_by_every_method() {
    fn ends<I: Method<Ends>>(method: I) {
        let mut sim = Ends.start_with(method).unwrap();
        let fault = sim.step(2.0).unwrap_err();
        assert_eq!((fault.part, fault.cause), ("valve", Cause::NotFinite), "{fault}");
        // Euler's method needs no rate at the end of a step: it comes one step further than the others.
        assert!((0.9..1.21).contains(&fault.time), "{fault}");
        assert!(sim.time < 1.15 && sim.x.iter().all(|x| x.is_finite()), "{:?}", sim.x);
        assert!(
            (sim.x[1] - 2.0 / 3.0 * (1.0 - (1.0 - sim.time).max(0.0).powf(1.5))).abs() < 0.06,
            "{:?}",
            sim.x
        );
    }
    ends(Dop853::new(1e-6));
    ends(Dopri5::new(1e-6));
    ends(Rk4::new(0.1));
    ends(SemiImplicitEuler::new(0.1));
    ends(Gauss::<_, 2>::new(0.1));
    ends(Gauss::<_, 3>::new(0.1));
}

#[test]
fn too_many_steps_are_counted() {
    let mut sim = oscillator().start_with(Dopri5::new(1e-12).with_most_steps(10)).unwrap();
    let fault = sim.step(10.0).unwrap_err();
    assert_eq!(fault.cause, Cause::TooManySteps { steps: 10 });
    // The next interval may take as many again.
    sim.step(0.01).unwrap();
}

#[test]
fn intervals_that_make_no_sense_are_refused() {
    let mut sim = oscillator::<f64>().start().unwrap();
    for dt in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(sim.step(dt).unwrap_err().cause, Cause::Interval { .. }));
    }
    for every in [0.0, -0.1, f64::NAN] {
        assert!(matches!(sim.run(1.0, every, |_| ()).unwrap_err().cause, Cause::Interval { .. }));
    }
    assert_eq!(sim.stats().evaluations, 0);
    sim.step(0.0).unwrap();
}

#[test]
fn steps_that_make_no_sense_are_refused() {
    for h in [0.0, -1.0, f64::NAN, 1e-300] {
        let mut sim = oscillator().start_with(Rk4::new(h)).unwrap();
        *sim = At { time: 1.0, ..*sim };
        assert!(matches!(sim.step(1.0).unwrap_err().cause, Cause::StepTooSmall { .. }), "{h}");
    }
    for h in [0.0, -1.0, f64::NAN] {
        let mut sim = oscillator().start_with(Dopri5::new(1e-6).with_longest_step(h)).unwrap();
        assert!(matches!(sim.step(1.0).unwrap_err().cause, Cause::StepTooSmall { .. }), "{h}");
    }
}

#[test]
fn too_many_steps_name_the_part_that_needs_them() {
    let mut sim = BlowUp.start_with(Dopri5::new(1e-9).with_most_steps(20)).unwrap();
    let fault = sim.step(2.0).unwrap_err();
    assert_eq!((fault.part, fault.cause), ("tank", Cause::TooManySteps { steps: 20 }));
    let mut sim = BlowUp.start_with(Dop853::new(1e-12).with_most_steps(10)).unwrap();
    assert_eq!(sim.step(2.0).unwrap_err().part, "tank");
}

#[test]
fn a_drift_says_which_of_the_two_it_is() {
    let text = |phi, phi_dot| Fault::of_part(1.0, "pin", Cause::Drift { phi, phi_dot }).to_string();
    assert!(
        text(1e-14, 1.5e-9)
            .starts_with("t = 1 s: pin: the pose is singular: this joint is closed, but 1.50e-9 m/s")
    );
    assert!(
        text(1e-3, 1e-2).starts_with("t = 1 s: pin: the joints come apart by 0.00100 m or rad, 0.0100 m/s")
    );
}

#[test]
fn an_error_beyond_the_state_is_told_in_a_few_words() {
    let said = |error| Cause::StepTooLong { step: 1e-2, error }.to_string();
    assert_eq!(said(1.4), "a step of 1e-2 s errs by about 140 % of the state; shorter steps");
    for error in [10.0, 2e132, f64::INFINITY, f64::NAN] {
        assert_eq!(said(error), "a step of 1e-2 s errs by more than 10 times the state; shorter steps");
    }
}

//! What generated mechanisms do with their rows: multipliers in the discrete state, other numbers, names, counters, saved runs.

use plm_runtime::contact::{self, Contacts, Doubts, Modal, Mode, Outcome};
use plm_runtime::words::{InWords, Words};
use plm_runtime::{Cause, Dop853, Dual, Enclosed, Interval, Linear, Mechanism, Notice, Rate, Rk4, Sim};

use crate::block::{Block, Held};

const REST: Block = Block { incline: 0.3, mu: 0.5, e: 0.0, until: 1e3, start: [0.0; 4] };
const LEVEL: Block = Block { incline: 0.0, ..REST };
const GRAVITY: f64 = 9.81;
const MASS: f64 = 1.7;

fn start(block: Block) -> Sim<Block> {
    block.start_with(Dop853::new(1e-12)).unwrap()
}

/// It sticks below the angle of friction, and stays where it is to the bit.
#[test]
fn a_block_rests_for_an_hour() {
    for k in 0..12 {
        let incline = 0.03 * f64::from(k) + 0.017;
        let mut sim = start(Block { incline, start: [0.3, 0.0, 0.0, 0.0], ..REST });
        sim.step(3600.0).unwrap();
        assert_eq!(sim.x, [0.3, 0.0, 0.0, 0.0], "{incline}");
        assert!(sim.stats().steps < 20, "{incline}: {:?}", sim.stats());
        assert_eq!((sim.contact("tip"), sim.contact("slip")), (Some(Mode::Closed), Some(Mode::Sticks)));
    }
}

/// Rows have names; what has none is not there.
#[test]
fn rows_are_found_by_name() {
    let sim = start(Block { start: [0.0, 1.0, 0.0, 0.0], ..REST });
    assert_eq!((sim.contact("tip"), sim.contact("slip")), (Some(Mode::Open), Some(Mode::Off)));
    assert_eq!((sim.contact("top"), sim.contact("")), (None, None));
    let all: Vec<_> = sim.contacts().collect();
    assert_eq!(all, [("tip", Mode::Open), ("slip", Mode::Off)]);
    assert!(!sim.is_undetermined());
    let fault = Block { start: [0.0, -0.1, 0.0, 0.0], ..REST }.start().unwrap_err();
    assert_eq!((fault.part, fault.cause), ("tip", Cause::Sunk { by: 0.1 }));
    assert!(
        fault.to_string().ends_with("the gap is negative by 0.1000 m or rad; begin where it is zero or open"),
        "{fault}"
    );
}

/// It falls, bounces until it rests, and is pulled: by which times, and what was counted.
#[test]
fn a_block_bounces_and_is_pulled() {
    let block = Block { e: 0.5, start: [0.0, 1.0, 0.0, 0.0], ..LEVEL };
    let mut sim = start(block);
    let fall = (2.0 / GRAVITY).sqrt();
    sim.step_to(1.5 * fall).unwrap();
    assert!((sim.x[1] - 0.25).abs() < 1e-12, "{:?}", sim.x);
    let stats = sim.contact_stats();
    assert_eq!((stats.impacts, stats.closures, stats.undetermined), (1, 0, 0));
    // It struck with sqrt(2 g h), and keeps a quarter of its energy.
    let impulse = sim.impulse("tip").unwrap();
    assert!((impulse.time - fall).abs() < 1e-12, "{impulse:?}");
    assert!((impulse.size - 1.5 * MASS * (2.0 * GRAVITY).sqrt()).abs() < 1e-11, "{impulse:?}");
    assert_eq!((sim.impulse("slip"), sim.impulse("top")), (None, None));
    let energy = sim.impact_energy();
    assert!((energy.lost - 0.75 * MASS * GRAVITY).abs() < 1e-11 && energy.last == energy.lost, "{energy:?}");
    sim.step_to(3.0 * fall + 0.1).unwrap();
    let stats = sim.contact_stats();
    // Each flight is a quarter as high as the one before.
    assert!((15..30).contains(&stats.impacts), "{stats:?}");
    assert_eq!((stats.closures, stats.openings, stats.ambiguous), (1, 0, 0));
    assert_eq!((stats.sticks, stats.slips), (1, 0));
    let energy = sim.impact_energy();
    assert!((energy.lost - MASS * GRAVITY).abs() < 1e-10 && energy.work == 0.0, "{energy:?}");
    assert_eq!((sim.contact("tip"), sim.contact("slip")), (Some(Mode::Closed), Some(Mode::Sticks)));
    // The friction holds 0.5 m g.
    let limit = 0.5 * MASS * GRAVITY;
    let (time, place) = (sim.time, sim.x[0]);
    sim.held.input.pull = 0.999 * limit;
    sim.step(1.0).unwrap();
    assert_eq!((sim.contact("slip"), sim.x[0]), (Some(Mode::Sticks), place));
    sim.held.input.pull = 1.5 * limit;
    sim.step(1.0).unwrap();
    assert_eq!(sim.contact("slip"), Some(Mode::Forwards));
    let acceleration = 0.5 * limit / MASS;
    assert!((sim.x[0] - place - 0.5 * acceleration).abs() < 1e-11, "{:?}", sim.x);
    sim.held.input.pull = 0.0;
    sim.step(2.0).unwrap();
    let slides = acceleration * acceleration / (2.0 * 0.5 * GRAVITY);
    assert!((sim.x[0] - place - 0.5 * acceleration - slides).abs() < 1e-11, "{:?}", sim.x);
    assert_eq!((sim.time - time, sim.contact("slip")), (4.0, Some(Mode::Sticks)));
    let stats = sim.contact_stats();
    assert_eq!((stats.sticks, stats.slips, stats.newton), (2, 1, 0), "{stats:?}");
}

/// Case C01: its impacts are at t_n+1 = t_n + 2 e^n sqrt(2 h/g).
#[test]
fn a_block_strikes_at_its_times() {
    let mut sim = start(Block { e: 0.5, start: [0.0, 1.0, 0.0, 0.0], ..LEVEL });
    let (mut time, mut flight) = ((2.0 / GRAVITY).sqrt(), (2.0 / GRAVITY).sqrt());
    for n in 1..12 {
        sim.step_to(time + 0.5 * flight).unwrap();
        let impulse = sim.impulse("tip").unwrap();
        assert!((impulse.time - time).abs() < 1e-13, "{n}: {impulse:?} {time}");
        let struck = 1.5 * MASS * GRAVITY * if n == 1 { time } else { flight };
        assert!((impulse.size - struck).abs() < 1e-12 * struck.max(1.0), "{n}: {impulse:?} {struck}");
        time += flight;
        flight *= 0.5;
    }
}

/// Thrown along the table it strikes with friction: mu times the normal impulse while it slips, or all of its momentum.
#[test]
fn an_impact_rubs() {
    let fall = (2.0 / GRAVITY).sqrt();
    let normal = 1.5 * MASS * (2.0 * GRAVITY).sqrt();
    for (speed, rubs) in [(9.0, 0.5 * normal), (1.0, MASS), (-9.0, -0.5 * normal)] {
        let mut sim = start(Block { e: 0.5, start: [0.0, 1.0, speed, 0.0], ..LEVEL });
        sim.step_to(1.2 * fall).unwrap();
        let (tip, slip) = (sim.impulse("tip").unwrap(), sim.impulse("slip").unwrap());
        assert!((tip.size - normal).abs() < 1e-11 && (slip.size + rubs).abs() < 1e-11, "{tip:?} {slip:?}");
        assert!((slip.time - fall).abs() < 1e-12 && slip.time == tip.time, "{slip:?}");
        let after = speed - rubs / MASS;
        let lost = 0.5 * MASS * (speed * speed - after * after) + 0.75 * MASS * GRAVITY;
        assert!((sim.impact_energy().lost - lost).abs() < 1e-10, "{:?} {lost}", sim.impact_energy());
    }
}

/// Events that have several outcomes, and rows that others hold, are told.
#[test]
fn what_is_not_unique_is_told() {
    let mut sim = start(REST);
    assert_eq!(sim.notice(), None);
    let doubts = |is_ambiguous: bool| Doubts { is_ambiguous, is_undetermined: !is_ambiguous };
    let outcome = Outcome { doubts: doubts(false), ..Outcome::default() };
    sim.held.count(&outcome, false);
    assert_eq!(sim.notice(), Some(Notice::UndeterminedImpact { events: 1 }));
    let outcome = Outcome { doubts: doubts(true), ..Outcome::default() };
    sim.held.count(&outcome, false);
    assert_eq!(sim.notice(), Some(Notice::AmbiguousImpact { events: 1 }));
    let outcome = Outcome { is_ambiguous: true, is_undetermined: true, ..Outcome::default() };
    sim.held.count(&outcome, false);
    let contact = &mut sim.held.contact;
    (contact.modes.of, contact.modes.carried) = ([Mode::Open, Mode::Forwards], [true; 2]);
    let stats = sim.contact_stats();
    assert_eq!((stats.ambiguous, stats.undetermined, stats.impacts), (1, 1, 0));
    assert_eq!((stats.ambiguous_impacts, stats.undetermined_impacts), (1, 1));
    assert_eq!(sim.notice(), Some(Notice::AmbiguousContact { events: 1 }));
    assert!(sim.is_undetermined());
    assert_eq!((sim.contact("tip"), sim.contact("slip")), (Some(Mode::Closed), Some(Mode::Sticks)));
}

/// A condition of its own ends the pull: the block slows down, from the event on.
#[test]
fn a_condition_lets_the_force_jump() {
    for start in [[0.0; 4], [0.99, 0.0, 0.0, 0.0]] {
        let mut sim = Block { until: 1.0, start, ..LEVEL }.start_with(Dop853::new(1e-12)).unwrap();
        sim.held.input.pull = 2.0 * 0.5 * MASS * GRAVITY;
        // It gets the speed that friction takes on an equal way.
        sim.step(3.0).unwrap();
        assert_eq!(sim.contact("slip"), Some(Mode::Sticks), "{:?}", sim.x);
        assert!((sim.x[0] - (2.0 - start[0])).abs() < 1e-11, "{:?}", sim.x);
        // Set after its place, it is pulled again; on the other side it sticks.
        sim.x[0] = 0.9;
        sim.step(0.01).unwrap();
        assert_eq!(sim.contact("slip"), Some(Mode::Forwards));
    }
}

/// Whoever sets the state moves rows that hold: it falls from where it was lifted, and slides with the velocity that it was given.
#[test]
fn a_state_that_is_set_moves_rows_that_hold() {
    let mut sim = start(LEVEL);
    sim.x = [0.3, 0.5, 0.0, 0.0];
    sim.step(0.1).unwrap();
    assert_eq!((sim.contact("tip"), sim.contact("slip")), (Some(Mode::Open), Some(Mode::Off)));
    assert!((sim.x[1] - 0.5 + 0.005 * GRAVITY).abs() < 1e-12 && sim.x[0] == 0.3, "{:?}", sim.x);
    sim.step(1.0).unwrap();
    assert_eq!((sim.contact("tip"), sim.contact("slip")), (Some(Mode::Closed), Some(Mode::Sticks)));
    sim.x[2] = -1.0;
    sim.step(0.1).unwrap();
    assert_eq!(sim.contact("slip"), Some(Mode::Backwards));
    assert!((sim.x[2] + 1.0 - 0.05 * GRAVITY).abs() < 1e-12, "{:?}", sim.x);
    sim.x[3] = 1.0;
    sim.step(0.1).unwrap();
    assert_eq!(sim.contact("tip"), Some(Mode::Open));
    sim.step(1.0).unwrap();
    // Moved along the table it sticks where it is; nothing leads it back.
    sim.x[0] = 7.0;
    sim.project().unwrap();
    sim.step(1.0).unwrap();
    assert_eq!((sim.x[0], sim.contact("slip")), (7.0, Some(Mode::Sticks)));
}

/// The multipliers are those of the copy that the rate computes with: push and friction.
#[test]
fn multipliers_are_those_of_the_modes_held() {
    let sim = start(REST);
    let (sin, cos) = 0.3_f64.sin_cos();
    let weight = MASS * GRAVITY;
    assert_eq!(sim.held.contact.lambda, [0.0; 2]);
    let rows = REST.rows_at(0.0, &sim.held, &sim.x);
    let [push, friction] = contact::with_multipliers(&rows, &sim.held.contact).lambda;
    assert!((push - weight * cos).abs() < 1e-13 && (friction + weight * sin).abs() < 1e-13);
    assert_eq!(contact::reactions(&REST, 0.0, &sim.held, &sim.x), [push, friction]);
    // Where two rows say the same they are none.
    let mut rows = rows;
    (rows.delassus, rows.free) = ([[1.0; 2]; 2], [1.0; 2]);
    assert!(contact::with_multipliers(&rows, &sim.held.contact).lambda.iter().all(|lambda| lambda.is_nan()));
}

/// Rows in dual numbers have the derivatives along a motion, in enclosures all values of an interval.
#[test]
fn rows_are_packed_into_other_numbers() {
    let mut sim = start(REST);
    sim.held.input.pull = 3.0;
    let x = [0.2, 0.1, 0.5, -0.25];
    let here = REST.rows_at(0.0, &sim.held, &x);
    let dual = |i: usize| Dual { value: x[i], tangents: [[0.5, -0.25, 3.0, 4.0][i]] };
    let along = REST.rows(Dual::variable(0.0, 0), &sim.held, &dual, &Dual::constant);
    assert_eq!((along.gap.map(|z| z.value), along.gap.map(|z| z.tangents)), (here.gap, [[-0.25], [0.5]]));
    assert_eq!((along.rate.map(|z| z.value), along.rate.map(|z| z.tangents)), (here.rate, [[4.0], [3.0]]));
    assert_eq!((along.free.map(|z| z.value), along.free.map(|z| z.tangents)), (here.free, [[0.0]; 2]));
    assert_eq!(along.kinetic[1].upper.by[0].value, 0.5);
    let within = |i: usize| {
        let (low, high) = (x[i] - 0.125, x[i] + 0.125);
        Enclosed { value: Interval { low, high }, ..Enclosed::constant(x[i]) }
    };
    let within = REST.rows(Enclosed::constant(0.0), &sim.held, &within, &Enclosed::constant);
    assert!(
        (within.gap[0].value.low + 0.025).abs() < 1e-15 && (within.gap[0].value.high - 0.225).abs() < 1e-15
    );
}

/// Derivatives of the rate see that multipliers depend on inputs and states, also where they are zero.
#[test]
fn derivatives_of_the_rate_have_those_of_the_multipliers() {
    for (pull, by_mu) in [(0.0, 0.0), (1.0, 0.0), (50.0, -GRAVITY)] {
        let mut sim = start(LEVEL);
        sim.held.input.pull = pull;
        sim.step(0.1).unwrap();
        let (mut lifted, held) = sim.mechanism.lift::<1>(&sim.held);
        lifted.mu = Dual::variable(0.5, 0);
        let x = sim.x.map(Dual::constant);
        let mut dx = x;
        let _ = lifted.rate(Dual::constant(0.0), &held, &x, &mut dx);
        let mut own = sim.x;
        let _ = sim.mechanism.rate(0.0, &sim.held, &sim.x, &mut own);
        assert_eq!(dx.map(|rate| rate.value), own);
        assert!((dx[2].tangents[0] - by_mu).abs() < 1e-12, "{pull}: {dx:?}");
    }
}

/// Writes words, or reads them from the front.
struct Saved(Vec<u64>, bool);

impl Words for Saved {
    fn word(&mut self, word: &mut u64) {
        if self.1 {
            *word = self.0.remove(0);
        } else {
            self.0.push(*word);
        }
    }
}

/// A saved run has modes, places and orientation, in as many words whatever the modes are.
#[test]
fn what_is_held_is_saved() {
    let mut sim = start(Block { start: [0.0, 0.1, 0.5, 0.0], ..LEVEL });
    sim.step(1.0).unwrap();
    assert!(sim.impulse("slip").is_some());
    sim.held.contact.counts = contact::Counts::default();
    sim.held.contact.modes.place[1] = 0.1;
    sim.held.contact.modes.orientation = -1.0;
    sim.held.contact.modes.carried = [true, false];
    sim.held.contact.lambda = [0.3, -0.7];
    let mut saved = Saved(Vec::new(), false);
    sim.held.contact.each(&mut saved);
    let mut read = contact::Held::<f64, 2>::open();
    let mut open = Saved(Vec::new(), false);
    read.each(&mut open);
    assert_eq!(open.0.len(), saved.0.len());
    saved.1 = true;
    read.each(&mut saved);
    assert_eq!(read, sim.held.contact);
    assert!(saved.0.is_empty());
    // With the side of the one condition; inputs are shown elsewhere.
    let mut held: Held<f64> = sim.held;
    let mut whole = Saved(Vec::new(), false);
    held.each(&mut whole);
    assert_eq!(whole.0.len(), open.0.len() + 1);
}

/// Runs in single precision do the same, less exactly.
#[test]
fn single_precision_comes_to_rest() {
    let block = Block { incline: 0.0_f32, mu: 0.5, e: 0.5, until: 1e3, start: [0.0, 0.1, 0.5, 0.0] };
    let mut sim = block.start_with(Dop853::new(1e-5)).unwrap();
    sim.step(3.0).unwrap();
    assert_eq!((sim.contact("tip"), sim.contact("slip")), (Some(Mode::Closed), Some(Mode::Sticks)));
    assert!(sim.x[1].abs() < 1e-5, "{:?}", sim.x);
}

/// Steps of fixed length are cut where contact changes: bouncing ends all the same where a flight is shorter than a step, and a slip where
/// its rate is zero.
#[test]
fn steps_of_fixed_length_come_to_rest() {
    for e in [0.0, 0.5, 0.8, 0.95] {
        let block = Block { e, start: [0.0, 0.1, 3.0, 0.0], ..LEVEL };
        let mut exact = start(block);
        exact.step(9.0).unwrap();
        for h in [1e-3, 1e-4] {
            let mut fixed = block.start_with(Rk4::new(h)).unwrap();
            fixed.step(9.0).unwrap();
            let (stats, switches) = (fixed.contact_stats(), fixed.stats().switches);
            assert_eq!(
                (fixed.contact("tip"), fixed.contact("slip")),
                (Some(Mode::Closed), Some(Mode::Sticks)),
                "{e} {h}"
            );
            assert!(stats.impacts < 200 && switches < 210 && stats.closures == 1, "{e} {h}: {stats:?}");
            assert!((exact.x[0] - fixed.x[0]).abs() < 5.0 * h, "{e} {h}: {:?} {:?}", exact.x, fixed.x);
            assert_eq!([fixed.x[2], fixed.x[3]], [0.0; 2]);
        }
    }
}

/// On an incline it stays, by steps of fixed length too.
#[test]
fn steps_of_fixed_length_stay_on_an_incline() {
    let block = Block { incline: 0.2, start: [0.0, 0.0, 1.0, 0.0], ..REST };
    let mut fixed = block.start_with(Rk4::new(1e-3)).unwrap();
    fixed.step(1.0).unwrap();
    let place = fixed.x[0];
    assert_eq!(fixed.contact("slip"), Some(Mode::Sticks));
    let slows = GRAVITY * (0.5 * 0.2_f64.cos() - 0.2_f64.sin());
    assert!((place - 0.5 / slows).abs() < 1e-5, "{place}");
    fixed.step(10.0).unwrap();
    assert_eq!(fixed.x[0], place);
}

//! Event times of known cases to 1e-10 s, with a tolerance of 1e-10.

use plm::runtime::contact::Mode::{self, Backwards, Closed, Forwards, Open, Sticks};
use plm::{Dop853, Fault, Mechanism as _, Moment as _};

use crate::declared::Oscillator;
use crate::scene::{Given as _, Named as _};
use crate::{flights, friction, near};

/// A row has one mode 1e-10 s before a time, and another one 1e-10 s after it.
macro_rules! changes {
    ($sim:expr, $row:literal, $time:expr, $modes:expr) => {
        let modes: [Mode; 2] = $modes;
        for (at, mode) in [$time - 1e-10, $time + 1e-10].into_iter().zip(modes) {
            $sim.step_to(at).unwrap();
            assert_eq!($sim.contact($row), Some(mode), "{} at {at} s", $row);
        }
    };
}

/// Cases C04 and C06.
#[test]
fn c04_c06_a_mass_sticks_and_slips_at_its_times() {
    let mut sim = Oscillator::new().start_with(Dop853::new(1e-10)).unwrap();
    let half = core::f64::consts::PI / 10.0;
    for k in 1..5 {
        let [before, after] = if k % 2 == 0 { [Forwards, Backwards] } else { [Backwards, Forwards] };
        changes!(sim, "slip", half * f64::from(k), [before, after]);
    }
    changes!(sim, "slip", 5.0 * half, [Backwards, Sticks]);
    near(sim.state_of("mass").x, -0.0019, 1e-9);

    let belt = Oscillator::new()
        .with("kinetic", 0.25 * 9.81)
        .with("adhesion", 0.4 * 9.81)
        .with("belt", 0.1)
        .with_start("mass.x", 0.0)
        .with_start("mass.vx", 0.1);
    let mut sim = belt.start_with(Dop853::new(1e-10)).unwrap();
    for k in 0..10 {
        let begins = 0.3924 + f64::from(k) * 0.727_836_962_770_418_5;
        changes!(sim, "slip", begins, [Sticks, Backwards]);
        near(sim.state_of("mass").x, 0.039_24, 1e-9);
        changes!(sim, "slip", begins + 0.433_536_962_770_418_6, [Backwards, Sticks]);
        near(sim.state_of("mass").x, 0.009_81, 1e-9);
    }
}

/// Cases C13, C18 and C26.
#[test]
fn c13_c18_c26_bodies_strike_and_let_go_at_their_times() {
    let block = flights::Block::new();
    let tilt: f64 = 0.5 * 0.2_f64.atan();
    let (sin, cos) = tilt.sin_cos();
    let block = block
        .with_start("block.angle", tilt)
        .with_start("block.x", -0.1 + 0.1 * cos - 0.5 * sin)
        .with_start("block.y", 0.1 * sin + 0.5 * cos);
    let mut sim = block.start_with(Dop853::new(1e-10)).unwrap();
    let times =
        [0.347_093_586_788_881_3, 0.950_920_536_477_668_3, 1.487_939_643_105_267, 1.972_072_334_511_498];
    let mut speed = 0.648_049_012_267_532_3;
    for (k, time) in times.into_iter().enumerate() {
        let [before, after] = if k % 2 == 0 { [Closed, Open] } else { [Open, Closed] };
        changes!(sim, "left", time, [before, after]);
        speed *= 0.942_307_692_307_692_3;
        near(sim.state_of("block").omega.abs(), speed, 2e-9);
    }

    let mut sim = flights::Ladder::new().start_with(Dop853::new(1e-10)).unwrap();
    changes!(sim, "wall", 0.698_777_341_146_781_6, [Closed, Open]);

    let mut sim = flights::Pendulum::new().start_with(Dop853::new(1e-10)).unwrap();
    let times = [
        0.538_218_666_720_129,
        1.574_285_377_335_238_3,
        2.592_900_903_225_063_4,
        3.603_434_181_165_172,
        4.610_111_044_992_927,
    ];
    for time in times {
        sim.step_to(time - 1e-10).unwrap();
        assert!(sim.state_of("bob").omega < 0.0, "{time} s");
        sim.step_to(time + 1e-10).unwrap();
        assert!(sim.state_of("bob").omega > 0.0, "{time} s");
    }
}

/// Cases C38 and C44.
#[test]
fn c38_c44_a_clutch_locks_and_a_pendulum_turns() {
    for (engine, time, omega) in [(0.0, 0.514_285_714_285_714_2, 71.428_571_428_571_43), (30.0, 0.9, 110.0)] {
        let mut sim = friction::Clutch::new().with("engine", engine).start_with(Dop853::new(1e-10)).unwrap();
        let before = sim.kinetic_energy();
        changes!(sim, "plates", time, [Forwards, Sticks]);
        near(sim.state_of("first").omega, omega, 1e-8);
        near(sim.state_of("second").omega, sim.state_of("first").omega, 1e-12);
        if engine == 0.0 {
            near(before - sim.kinetic_energy(), 2_314.285_714_285_714, 1e-6);
        }
    }
    let mut sim = friction::Pendulum::new().start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(0.546_000_293_457_115_3).unwrap();
    near(sim.state_of("bob").angle, 0.0, 1e-9);
    for turn in [-0.998_334_532_278_349_8, 0.950_310_223_978_209_7, -0.903_052_596_006_498_4_f64] {
        // The pendulum moves to this side, and turns within the next two seconds.
        let (saved, mut low) = (sim.save(), sim.time());
        let mut high = low + 0.8;
        let mut moves = |at: f64| -> Result<bool, Fault> {
            sim.resume(&saved);
            sim.step_to(at)?;
            Ok(sim.state_of("bob").omega * turn > 0.0)
        };
        while high - low > 1e-9 {
            let half = 0.5 * (low + high);
            *(if moves(half).unwrap() { &mut low } else { &mut high }) = half;
        }
        near(sim.state_of("bob").angle, turn, 1e-9);
        sim.step(0.5).unwrap();
    }
}

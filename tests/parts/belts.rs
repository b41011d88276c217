//! Belts and chains: slip by Euler and Eytelwein, stretching, bearings, slack, a tensioner.

use plm::{Dop853, Mechanism as _, Sim};

use crate::declared::{Belts, Chains};
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

fn started(belts: &Scene) -> Sim<Scene> {
    belts.start_with(Dop853::new(1e-11)).unwrap()
}

/// Wrap of the smaller pulley pi - 2 asin(0.1): T1 + T2 = 2 F0 and T1/T2 = exp(mu wrap) where it slips.
#[test]
fn a_belt_slips_by_euler_and_eytelwein() {
    let wrap = std::f64::consts::PI - 2.0 * 0.1_f64.asin();
    let ratio = (0.3 * wrap).exp();
    let most = 400.0 * (ratio - 1.0) / (ratio + 1.0);
    for sense in [1.0, -1.0] {
        let mut sim = started(&Belts::new().with("pull", sense * 60.0));
        near(sim.value_of("drive.wrap"), wrap, 1e-12);
        // It sticks: seen from the first pulley 0.02 + 0.05/4 kg m^2. The belt takes 0.05/4 of that.
        let torque = |time: f64| 60.0 * time * 0.0125 / 0.0325;
        sim.step_to(0.1).unwrap();
        near(sim.value_of("drive.force"), -sense * torque(0.1) / 0.05, 1e-8);
        near(sim.value_of("first.omega"), 2.0 * sim.value_of("second.omega"), 1e-10);
        near(
            sim.value_of("drive.tension_right") - sim.value_of("drive.tension_left"),
            sim.value_of("drive.force"),
            1e-9,
        );
        let slips = most * 0.05 * 0.0325 / 0.0125 / 60.0;
        sim.step_to(slips - 1e-4).unwrap();
        near(sim.value_of("drive.slip"), 0.0, 1e-10);
        sim.step_to(slips + 0.2).unwrap();
        let (tight, loose) = (sim.value_of("drive.tension_left"), sim.value_of("drive.tension_right"));
        near((tight / loose).powf(sense), ratio, 1e-9);
        near(sim.value_of("drive.torque_b"), sense * most * 0.1, 1e-9);
        near(sim.value_of("drive.lost"), most * sim.value_of("drive.slip").abs(), 1e-9);
        // 0.02 dw = 60 t dt - 0.05 F dt
        let before = 30.0 * slips * slips / 0.0325;
        let after = 30.0 * ((slips + 0.2).powi(2) - slips * slips) - 0.05 * most * 0.2;
        near(sim.value_of("first.omega"), sense * (before + after / 0.02), 1e-7);
        // The bearings bear both strands along the line of the centres.
        near(sim.vector_of("one.force")[0].abs(), 400.0 * 0.99_f64.sqrt(), 1e-8);
        near(sim.vector_of("one.force")[1].abs(), most * 0.1, 1e-8);
    }
}

/// Both pulleys swing against each other with w^2 = 2 c (ra^2/Ja + rb^2/Jb), about a common motion that stays.
#[test]
fn an_elastic_belt_swings() {
    let mut sim = started(&Belts::new());
    let [ra, rb, ja, jb, c] = [0.05_f64, 0.1, 0.02, 0.05, 2e4];
    let rate = (2.0 * c * (ra * ra / ja + rb * rb / jb)).sqrt();
    // Speed of the left strand's elongation at the start; its mass along the belt.
    let speed = ra * 1.0 + rb * 0.2;
    for time in [0.01, 0.1] {
        sim.step_to(time).unwrap();
        let strain = speed / rate * (rate * time).sin();
        near(sim.value_of("rubber.tension_left"), 100.0 + c * strain, 1e-6);
        near(sim.value_of("rubber.tension_right"), 100.0 - c * strain, 1e-6);
        near(
            ra * sim.value_of("third.omega") - rb * sim.value_of("fourth.omega"),
            speed * (rate * time).cos(),
            1e-9,
        );
        near(sim.value_of("rubber.torque_a"), -2.0 * ra * c * strain, 1e-7);
        near(sim.value_of("rubber.torque_b"), 2.0 * rb * c * strain, 1e-7);
        near(
            ja / ra * sim.value_of("third.omega") + jb / rb * sim.value_of("fourth.omega"),
            ja / ra - 0.2 * jb / rb,
            1e-10,
        );
        let sin: f64 = (ra - rb) / 0.6;
        near(sim.vector_of("three.force")[0].abs(), 200.0 * (1.0 - sin * sin).sqrt(), 1e-8);
        near(sim.vector_of("three.force")[1].abs(), 2.0 * c * strain.abs() * sin.abs(), 1e-7);
        near(sim.value_of("rubber.lost"), 0.0, 1e-9);
    }
}

/// Without slack wheels are tied; with slack the right strand pulls once it is taut, along its tangent.
#[test]
fn a_chain_ties_and_its_taut_strand_pulls_on_the_bearings() {
    let mut sim = started(&Chains::new());
    sim.step_to(0.5).unwrap();
    let radius = |teeth: f64| 0.0127 / (2.0 * (std::f64::consts::PI / teeth).sin());
    let ratio = radius(17.0) / radius(34.0);
    near(sim.value_of("sixth.omega"), ratio * sim.value_of("fifth.omega"), 1e-9);
    near(sim.value_of("fifth.omega"), 0.5 * 3.0 / (0.02 + 0.05 * ratio * ratio), 1e-8);
    near(sim.value_of("tied.torque_a"), radius(17.0) * sim.value_of("tied.force"), 1e-12);

    // The first wheel turns freely until 2 mm are taken up, then an impact takes both along.
    let alpha = 3.0 / 0.02;
    let taut = (2.0_f64 * 2e-3 / 0.05 / alpha).sqrt();
    let (m1, m2) = (0.02 / 0.0025, 0.05 / 0.01);
    let speed = 0.05 * alpha * taut * m1 / (m1 + m2) + 3.0 / 0.05 / (m1 + m2) * (0.5 - taut);
    near(0.05 * sim.value_of("seventh.omega"), speed, 1e-7);
    near(0.1 * sim.value_of("eighth.omega"), speed, 1e-7);
    let pull = 3.0 / 0.05 * m2 / (m1 + m2);
    near(sim.value_of("loose.tension_left"), pull, 1e-7);
    near(sim.value_of("loose.tension_right"), 0.0, 0.0);
    let [along, across] = sim.vector_of("seven.force");
    near(along.hypot(across), pull, 1e-7);
    near(across.abs(), 0.1 * pull, 1e-7);
}

/// At rest the push is the tension times both sines, and the tension follows from the way that the idler adds.
#[test]
fn a_tensioner_is_pushed_back_by_both_sides_of_its_strand() {
    let mut sim = started(&Chains::new());
    sim.step_to(5.0).unwrap();
    let y = sim.value_of("idler.position");
    let (before, behind) = (0.2_f64.hypot(y), 0.4_f64.hypot(y));
    near(sim.value_of("strand.elongation"), before + behind - 0.6, 1e-12);
    near(sim.value_of("push.tension"), 1e4 * (before + behind - 0.6), 1e-8);
    near(sim.value_of("push.force"), 60.0, 1e-7);
    near(sim.value_of("push.tension") * (y / before + y / behind), 60.0, 1e-7);
}

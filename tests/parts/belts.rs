//! Belts and chains: slip by Euler and Eytelwein, stretching, bearings, slack, a tensioner.

use plm::{Dop853, Sim};

use crate::near;

plm::mechanism! {
    pub Belts {
        param pull: N*m = 60 N*m;
        ground {
            port a: (0, 0) m; port b: (0.5, 0) m; port c: (0, 1) m; port d: (0.6, 1) m; port e: (0, 2) m; port f: (0.5, 2) m;
            port g: (0, 3) m; port h: (0.5, 3) m;
        }
        body first { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; }
        body second { mass: 2 kg; inertia: 0.05 kg*m^2; port hub: (0, 0) m; start x: 0.5 m; }
        revolute one(ground.a, first.hub) { drive: pull*t/(1 s); }
        revolute two(ground.b, second.hub);
        belt drive(ground.a, first.hub, second.hub) { radius_a: 50 mm; radius_b: 100 mm; preload: 200 N; friction: 0.3; }

        body third { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start y: 1 m; start omega: 1 rad/s, locked; }
        body fourth { mass: 2 kg; inertia: 0.05 kg*m^2; port hub: (0, 0) m; start x: 0.6 m; start y: 1 m; start omega: -0.2 rad/s, locked; }
        revolute three(ground.c, third.hub);
        revolute four(ground.d, fourth.hub);
        elastic_belt rubber(ground.c, third.hub, fourth.hub) {
            radius_a: 50 mm; radius_b: 100 mm; distance: 0.6 m; preload: 100 N; stiffness: 2e4 N/m;
        }

        body fifth { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start y: 2 m; }
        body sixth { mass: 2 kg; inertia: 0.05 kg*m^2; port hub: (0, 0) m; start x: 0.5 m; start y: 2 m; }
        revolute five(ground.e, fifth.hub) { drive: 3 N*m; }
        revolute six(ground.f, sixth.hub);
        chain tied(ground.e, fifth.hub, sixth.hub) { pitch: 12.7 mm; teeth_a: 17; teeth_b: 34; }

        body seventh { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start y: 3 m; }
        body eighth { mass: 2 kg; inertia: 0.05 kg*m^2; port hub: (0, 0) m; start x: 0.5 m; start y: 3 m; }
        revolute seven(ground.g, seventh.hub) { drive: 3 N*m; }
        revolute eight(ground.h, eighth.hub);
        chain loose(ground.g, seventh.hub, eighth.hub) { radius_a: 50 mm; radius_b: 100 mm; slack: 2 mm; distance: 0.5 m; }

        elastic_rope strand() { length: 0.6 m; stiffness: 1e4 N/m; }
        slider_ground span() { position: 0.6 m; }
        strand_of_length straight(strand.end, span.slider);
        sliding_mass idler() { mass: 0.2 kg; start: 0.1 m; drive: 60 N; y: -1 m; }
        slider_ground base();
        slider_spring damper(base.slider, idler.slider) { damping: 100 N/(m/s); }
        belt_tensioner push(strand.end, idler.slider) { span: 0.6 m; place: 0.2 m; }

        part strand_of_length(rope: cable, a: slider) { way on rope: a.position; }

        output drive.force, drive.slip, drive.wrap, drive.lost, drive.tension_left, drive.tension_right, drive.torque_a, drive.torque_b;
        output one.force, two.force, three.force, first.omega, second.omega, third.omega, fourth.omega;
        output rubber.tension_left, rubber.tension_right, rubber.energy, rubber.lost, rubber.torque_a, rubber.torque_b;
        output tied.force, tied.torque_a, fifth.omega, sixth.omega;
        output loose.force, loose.tension_left, loose.tension_right, seven.force, seventh.omega, eighth.omega;
        output push.force, push.tension, idler.position, strand.elongation;
    }
}

fn started(belts: &Belts) -> Sim<Belts> {
    belts.start_with(Dop853::new(1e-11)).unwrap()
}

/// Wrap of the smaller pulley pi - 2 asin(0.1): T1 + T2 = 2 F0 and T1/T2 = exp(mu wrap) where it slips.
#[test]
fn a_belt_slips_by_euler_and_eytelwein() {
    let wrap = std::f64::consts::PI - 2.0 * 0.1_f64.asin();
    let ratio = (0.3 * wrap).exp();
    let most = 400.0 * (ratio - 1.0) / (ratio + 1.0);
    for sense in [1.0, -1.0] {
        let mut sim = started(&Belts { pull: sense * 60.0, ..Belts::new() });
        near(sim.drive_wrap(), wrap, 1e-12);
        // It sticks: seen from the first pulley 0.02 + 0.05/4 kg m^2. The belt takes 0.05/4 of that.
        let torque = |time: f64| 60.0 * time * 0.0125 / 0.0325;
        sim.step_to(0.1).unwrap();
        near(sim.drive_force(), -sense * torque(0.1) / 0.05, 1e-8);
        near(sim.first_omega(), 2.0 * sim.second_omega(), 1e-10);
        near(sim.drive_tension_right() - sim.drive_tension_left(), sim.drive_force(), 1e-9);
        let slips = most * 0.05 * 0.0325 / 0.0125 / 60.0;
        sim.step_to(slips - 1e-4).unwrap();
        near(sim.drive_slip(), 0.0, 1e-10);
        sim.step_to(slips + 0.2).unwrap();
        let (tight, loose) = (sim.drive_tension_left(), sim.drive_tension_right());
        near((tight / loose).powf(sense), ratio, 1e-9);
        near(sim.drive_torque_b(), sense * most * 0.1, 1e-9);
        near(sim.drive_lost(), most * sim.drive_slip().abs(), 1e-9);
        // 0.02 dw = 60 t dt - 0.05 F dt
        let before = 30.0 * slips * slips / 0.0325;
        let after = 30.0 * ((slips + 0.2).powi(2) - slips * slips) - 0.05 * most * 0.2;
        near(sim.first_omega(), sense * (before + after / 0.02), 1e-7);
        // The bearings bear both strands along the line of the centres.
        near(sim.one_force()[0].abs(), 400.0 * 0.99_f64.sqrt(), 1e-8);
        near(sim.one_force()[1].abs(), most * 0.1, 1e-8);
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
        near(sim.rubber_tension_left(), 100.0 + c * strain, 1e-6);
        near(sim.rubber_tension_right(), 100.0 - c * strain, 1e-6);
        near(ra * sim.third_omega() - rb * sim.fourth_omega(), speed * (rate * time).cos(), 1e-9);
        near(sim.rubber_torque_a(), -2.0 * ra * c * strain, 1e-7);
        near(sim.rubber_torque_b(), 2.0 * rb * c * strain, 1e-7);
        near(ja / ra * sim.third_omega() + jb / rb * sim.fourth_omega(), ja / ra - 0.2 * jb / rb, 1e-10);
        let sin: f64 = (ra - rb) / 0.6;
        near(sim.three_force()[0].abs(), 200.0 * (1.0 - sin * sin).sqrt(), 1e-8);
        near(sim.three_force()[1].abs(), 2.0 * c * strain.abs() * sin.abs(), 1e-7);
        near(sim.rubber_lost(), 0.0, 1e-9);
    }
}

/// Without slack wheels are tied; with slack the right strand pulls once it is taut, along its tangent.
#[test]
fn a_chain_ties_and_its_taut_strand_pulls_on_the_bearings() {
    let mut sim = started(&Belts::new());
    sim.step_to(0.5).unwrap();
    let radius = |teeth: f64| 0.0127 / (2.0 * (std::f64::consts::PI / teeth).sin());
    let ratio = radius(17.0) / radius(34.0);
    near(sim.sixth_omega(), ratio * sim.fifth_omega(), 1e-9);
    near(sim.fifth_omega(), 0.5 * 3.0 / (0.02 + 0.05 * ratio * ratio), 1e-8);
    near(sim.tied_torque_a(), radius(17.0) * sim.tied_force(), 1e-12);

    // The first wheel turns freely until 2 mm are taken up, then an impact takes both along.
    let alpha = 3.0 / 0.02;
    let taut = (2.0_f64 * 2e-3 / 0.05 / alpha).sqrt();
    let (m1, m2) = (0.02 / 0.0025, 0.05 / 0.01);
    let speed = 0.05 * alpha * taut * m1 / (m1 + m2) + 3.0 / 0.05 / (m1 + m2) * (0.5 - taut);
    near(0.05 * sim.seventh_omega(), speed, 1e-7);
    near(0.1 * sim.eighth_omega(), speed, 1e-7);
    let pull = 3.0 / 0.05 * m2 / (m1 + m2);
    near(sim.loose_tension_left(), pull, 1e-7);
    near(sim.loose_tension_right(), 0.0, 0.0);
    let [along, across] = sim.seven_force();
    near(along.hypot(across), pull, 1e-7);
    near(across.abs(), 0.1 * pull, 1e-7);
}

/// At rest the push is the tension times both sines, and the tension follows from the way that the idler adds.
#[test]
fn a_tensioner_is_pushed_back_by_both_sides_of_its_strand() {
    let mut sim = started(&Belts::new());
    sim.step_to(5.0).unwrap();
    let y = sim.idler_position();
    let (before, behind) = (0.2_f64.hypot(y), 0.4_f64.hypot(y));
    near(sim.strand_elongation(), before + behind - 0.6, 1e-12);
    near(sim.push_tension(), 1e4 * (before + behind - 0.6), 1e-8);
    near(sim.push_force(), 60.0, 1e-7);
    near(sim.push_tension() * (y / before + y / behind), 60.0, 1e-7);
}

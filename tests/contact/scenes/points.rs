//! Points on circles, drums and tables.

use plm::runtime::contact::Mode;
use plm::{Dop853, Mechanism as _};

use crate::near;
use crate::scene::{Given as _, Named as _};

scene! {
    /// A bead on a ring, with friction by what the ring carries.
    pub Bead {
        param fall: m/s^2 = 9.81 m/s^2;
        gravity: fall;
        body bead { mass: 1 kg; inertia: 1 kg*m^2; start x: -1 m; start y: 0 m, locked; start vy: 0 m/s, locked; }
        constraint level: bead.angle = 0;
        constraint ring: (dot(bead.position, bead.position) - 1 m^2)/(2 m) = 0;
        friction rub: rate((1 m)*atan2(bead.x, -bead.y)) within 0.2*abs(reaction(ring));
        output carries = abs(reaction(ring));
    }
}

/// Cases C47 and C48: v = v_0 exp(-mu theta) without gravity; by quadrature with it.
#[test]
fn c47_c48_a_bead_rubs_on_a_ring() {
    let bead = Bead::new().with("fall", 0.0).with_start("bead.vy", -3.0);
    let mut sim = bead.start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(4.189_309_373_809_556).unwrap();
    near(sim.state_of("bead").vx.hypot(sim.state_of("bead").vy), 0.853_828_630_008_087_8, 1e-9);
    near(sim.state_of("bead").x, -1.0, 1e-9);
    near(sim.state_of("bead").y, 0.0, 1e-9);

    let mut sim = Bead::new().start_with(Dop853::new(1e-10)).unwrap();
    let saved = sim.save();
    // The time at the bottom, by bisection.
    let (mut low, mut high) = (0.5, 1.5);
    for _ in 0..45 {
        let half = 0.5 * (low + high);
        sim.resume(&saved);
        sim.step_to(half).unwrap();
        *(if sim.state_of("bead").x < 0.0 { &mut low } else { &mut high }) = half;
    }
    near(sim.state_of("bead").vx, 3.185_389_354_168_705_3, 3e-9);
    near(sim.value_of("carries"), 19.956_705_337_651_32, 2e-8);
}

scene! {
    /// A point on a sphere of 1 m, and the same in a rope of 1 m.
    pub Point {
        gravity: 9.81 m/s^2;
        body rider { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; start vx: 0.1 m/s; }
        unilateral sphere: (dot(rider.position, rider.position) - 1 m^2)/(2 m) >= 0;
        body load { mass: 2 kg; inertia: 1 kg*m^2; start x: 0.6 m; }
        unilateral rope: norm(load.position) <= 1 m;
        output tension = reaction(rope);
    }
}

/// Case C17: cos = 2/3 + v^2/(3 g R), at a time by quadrature.
#[test]
fn c17_a_point_leaves_a_sphere() {
    let mut sim = Point::new().start_with(Dop853::new(1e-10)).unwrap();
    let time = 1.270_346_989_271_610_4;
    sim.step_to(time - 1e-10).unwrap();
    assert_eq!(sim.contact("sphere"), Some(Mode::Closed));
    near(sim.state_of("rider").y, 0.667_006_455_997_281_7, 1e-9);
    sim.step_to(time + 1e-10).unwrap();
    assert_eq!(sim.contact("sphere"), Some(Mode::Open));
}

/// A load falls from 0.6 m beside the pivot until the rope of 1 m is tight, 0.8 m lower; there it loses its speed along the rope.
#[test]
fn a_rope_catches_a_load() {
    let mut sim = Point::new().start_with(Dop853::new(1e-10)).unwrap();
    let (g, fall) = (9.81, (2.0 * 0.8 / 9.81_f64).sqrt());
    sim.step_to(fall - 1e-10).unwrap();
    assert_eq!((sim.contact("rope"), sim.state_of("load").vx), (Some(Mode::Open), 0.0));
    sim.step_to(fall + 1e-10).unwrap();
    assert_eq!(sim.contact("rope"), Some(Mode::Closed));
    // Across the rope (-0.8, -0.6) of (0, -g t).
    let across = 0.6 * g * fall;
    near(sim.state_of("load").vx, -0.8 * across, 1e-8);
    near(sim.state_of("load").vy, -0.6 * across, 1e-8);
    // Then a pendulum: 2 g (y + 0.8) + v^2 stays; the tension is m (v^2/l + g cos).
    let mut least = 0.0_f64;
    for k in 0..200 {
        sim.step(0.01).unwrap();
        let load = sim.state_of("load");
        let v2 = load.vx * load.vx + load.vy * load.vy;
        near(v2 + 2.0 * g * (load.y + 0.8), across * across, 1e-8 * across * across);
        near(load.x.hypot(load.y), 1.0, 1e-12);
        near(sim.value_of("tension"), 2.0 * (v2 - g * load.y), 1e-7);
        least = least.min(load.x);
        assert!(k > 3 || sim.contact("rope") == Some(Mode::Closed));
    }
    let height = -0.8 + across * across / (2.0 * g);
    // Samples stand 10 ms apart, at up to 10 m/s^2.
    near(least, -(1.0 - height * height).sqrt(), 1e-3);
}

scene! {
    /// Two masses on a rope over a fixed rough drum, half a turn. The part of the rope on the drum is a body of its own.
    pub Capstan {
        param left_mass: kg = 2 kg;
        param rope: kg = 0.1 kg;
        gravity: 9.81 m/s^2;
        body left { mass: left_mass; inertia: 1 kg*m^2; }
        body right { mass: 1 kg; inertia: 1 kg*m^2; }
        body middle { mass: rope; inertia: 1 kg*m^2; }
        constraint left_x: left.x = 0;
        constraint left_level: left.angle = 0;
        constraint right_x: right.x = 0;
        constraint right_level: right.angle = 0;
        constraint middle_y: middle.y = 0;
        constraint middle_level: middle.angle = 0;
        constraint left_rope: left.y + middle.x = 0;
        constraint right_rope: right.y - middle.x = 0;
        // The rope goes to the left: the right end is the loose one.
        friction drum: rate(middle.x) within (exp(0.25*pi) - 1)*abs(reaction(right_rope));
        output left_pull = reaction(left_rope), right_pull = reaction(right_rope), drag = reaction(drum);
    }
}

/// Case C34: L. Euler, A. Eytelwein: T_1 = K T_2, K = exp(mu beta), a = g (m_1 - K m_2)/(m_1 + K m_2 + m) with a rope of the mass m on
/// the drum.
#[test]
fn c34_a_rope_slides_over_a_drum() {
    let k = 2.193_280_050_738_015_7;
    let acceleration = |rope: f64| 9.81 * (3.0 - k) / (3.0 + k + rope);
    near(acceleration(0.0), 1.523_877_515_739_869_2, 1e-15);
    let mut sim = Capstan::new().with("left_mass", 3.0).start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(1.0).unwrap();
    near(sim.state_of("left").vy, -acceleration(0.1), 1e-9);
    let pulls = [sim.value_of("left_pull").abs(), sim.value_of("right_pull").abs()];
    near(pulls[0] - 0.1 * acceleration(0.1), k * pulls[1], 1e-8);
    for (mass, moves) in [(2.0, false), (k - 1e-7, false), (k + 1e-7, true)] {
        let mut sim = Capstan::new().with("left_mass", mass).start_with(Dop853::new(1e-10)).unwrap();
        sim.step_to(1.0).unwrap();
        assert_eq!(sim.state_of("left").y != 0.0, moves, "{mass} kg: {:?}", sim.state_of("left"));
    }
}

scene! {
    /// A block on another one on a table that shakes; the lower one is pulled.
    pub Stack {
        part hand(on: body) {
            param pull: N;
            force on on: (pull, 0 N);
        }
        gravity: 9.81 m/s^2;
        param pull: N = 0 N;
        param amplitude: m = 0 m;
        param rough_table = 0.1;
        param rough_block = 0.4;
        body lower { mass: 3 kg; inertia: 1 kg*m^2; start vx: 0 m/s, locked; }
        body upper { mass: 2 kg; inertia: 1 kg*m^2; start vx: 0 m/s, locked; }
        constraint lower_level: lower.angle = 0;
        constraint upper_level: upper.angle = 0;
        hand hand(lower) { pull: pull; }
        unilateral on_table: lower.y >= 0 m;
        unilateral on_block: upper.y - lower.y >= 0 m;
        friction table: rate(lower.x - amplitude*sin(10 rad/s*t)) within rough_table*reaction(on_table);
        friction between: rate(upper.x - lower.x) within rough_block*reaction(on_block);
        output drag = reaction(between);
    }
}

/// Case C42: nothing moves; both move; the upper one slips.
#[test]
fn c42_a_block_on_a_block_is_pulled() {
    for (pull, table, between, [upper, lower]) in [
        (4.905 * (1.0 - 1e-8), Mode::Sticks, Mode::Sticks, [0.0, 0.0]),
        (4.905 * (1.0 + 1e-8), Mode::Forwards, Mode::Sticks, [9.81e-9, 9.81e-9]),
        (20.0, Mode::Forwards, Mode::Sticks, [3.019, 3.019]),
        (24.525 * (1.0 - 1e-8), Mode::Forwards, Mode::Sticks, [3.924, 3.924]),
        (24.525 * (1.0 + 1e-8), Mode::Forwards, Mode::Backwards, [3.924, 3.924]),
        (40.0, Mode::Forwards, Mode::Backwards, [3.924, 9.082_333_333_333_333]),
    ] {
        let mut sim = Stack::new().with("pull", pull).start_with(Dop853::new(1e-10)).unwrap();
        sim.step_to(1.0).unwrap();
        assert_eq!((sim.contact("table"), sim.contact("between")), (Some(table), Some(between)), "{pull} N");
        let within = if pull == 20.0 || pull == 40.0 { 1e-9 } else { 1e-7 };
        near(sim.state_of("upper").vx, upper, within * 9.0);
        near(sim.state_of("lower").vx, lower, within * 9.0);
        if pull == 20.0 {
            near(sim.value_of("drag"), 6.038, 1e-9 * 6.0);
        }
    }
}

//! One body over an inclined floor: balls, blocks, rollers, cubes. Known values are those of the cases of the same number in closed form.

use plm::runtime::contact::Mode;
use plm::{Dop853, Mechanism as _, Sim};

use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// A body of 1 kg on two feet, or on one round foot at its centre; x goes down the slope, y away from it.
    pub Body {
        part touch(a: frame) {
            param radius: m;
            param friction = 0;
            param e = 0;
            // So much higher than the floor it touches nothing.
            param lift: m = 0 m;
            unilateral gap: a.y + lift - radius >= 0 { restitution: e; }
            friction slip: rate(a.x + radius*a.angle) within friction*reaction(gap);
            output push = reaction(gap), drag = reaction(slip);
        }
        param incline: rad = 0 rad;
        param inertia: kg*m^2 = 1 kg*m^2;
        param radius: m = 0 m;
        param half: m = 0 m;
        param lift: m = 100 m;
        param friction = 0;
        param e = 0;
        gravity: 9.81 m/s^2*(sin(incline), -cos(incline));
        body body { mass: 1 kg; inertia: inertia; port left: (-half, -half); port right: (half, -half); }
        touch left(body.left) { radius: radius; friction: friction; e: e; }
        touch right(body.right) { radius: radius; friction: friction; e: e; lift: lift; }
        output left.push, right.push, left.drag;
    }
}

const G: f64 = 9.81;

/// Runs with a tolerance of 1e-10 from a place, with velocities.
fn from(body: Scene, [x, y]: [f64; 2], [vx, vy, omega]: [f64; 3]) -> Sim<Scene> {
    let body = body.with_start("body.x", x).with_start("body.y", y);
    let body = body.with_start("body.vx", vx).with_start("body.vy", vy).with_start("body.omega", omega);
    body.start_with(Dop853::new(1e-10)).unwrap()
}

/// The row has one mode 1e-10 s before a time, and another one 1e-10 s after it.
#[track_caller]
fn changes(sim: &mut Sim<Scene>, row: &str, time: f64, modes: [Mode; 2]) {
    for (at, mode) in [time - 1e-10, time + 1e-10].into_iter().zip(modes) {
        sim.step_to(at).unwrap();
        assert_eq!(sim.contact(row), Some(mode), "{row} at {at} s");
    }
}

/// The velocity away from the floor changes its sign at these times.
#[track_caller]
fn strikes(sim: &mut Sim<Scene>, times: &[f64]) {
    for time in times {
        sim.step_to(time - 1e-10).unwrap();
        assert!(sim.state_of("body").vy < 0.0, "before {time} s: {:?}", sim.state_of("body"));
        sim.step_to(time + 1e-10).unwrap();
        assert!(sim.state_of("body").vy > 0.0, "after {time} s: {:?}", sim.state_of("body"));
    }
}

/// Case C01: t_n+1 = t_n + 2 e^n sqrt(2 h/g), until t_1 (1 + e)/(1 - e).
#[test]
fn c01_a_ball_strikes_at_its_times() {
    let mut sim = from(Body::new().with("e", 0.5), [0.0, 1.0], [0.0; 3]);
    let first = 0.451_523_640_985_730_9;
    sim.step_to(first + 1e-10).unwrap();
    near(sim.state_of("body").vy, 2.214_723_459_035_010_2, 2e-9);
    strikes(
        &mut sim,
        &[0.903_047_281_971_461_8, 1.128_809_102_464_327_2, 1.241_690_012_710_76, 1.298_130_467_833_976_5],
    );
    sim.step_to(1.354_570_922_957_192_7 + 1e-10).unwrap();
    near(sim.state_of("body").y, 0.0, 1e-9);
    sim.step_to(1.4).unwrap();
    assert_eq!((sim.contact("left.gap"), sim.state_of("body").vy), (Some(Mode::Closed), 0.0));
}

/// Case C03: along the slope the motion is that of a point that slides; away from it that of a bouncing ball.
#[test]
fn c03_a_ball_on_a_smooth_slope_slides_at_last() {
    let incline = 30_f64.to_radians();
    let mut sim = from(Body::new().with("incline", incline).with("e", 0.6), [0.0, incline.cos()], [0.0; 3]);
    let (first, zeno) = (0.451_523_640_985_730_9, 1.806_094_563_942_923_6);
    strikes(&mut sim, &[first]);
    near(sim.state_of("body").x, 0.5, 1e-9);
    sim.step_to(zeno).unwrap();
    near(sim.state_of("body").x - 0.5, 7.5, 1e-9 * 7.5);
    near(sim.state_of("body").vx, 8.858_893_836_140_041, 1e-9 * 8.0);
    sim.step_to(2.0).unwrap();
    near(sim.state_of("body").x - 0.5, 9.31, 1e-9 * 9.0);
    assert_eq!(sim.state_of("body").vy, 0.0);
    near(sim.value_of("left.push"), G * incline.cos(), 1e-9);
}

/// Case C08: a = g (sin a +- mu cos a).
#[test]
fn c08_a_block_is_thrown_up_a_slope() {
    let block = |degrees: f64| Body::new().with("incline", degrees.to_radians()).with("friction", 0.3);
    let mut sim = from(block(20.0), [0.0; 2], [-3.0, 0.0, 0.0]);
    let (turn, way, back) = (0.490_137_374_950_454_4, 0.735_206_062_425_681_5, 0.931_184_889_711_645_9);
    changes(&mut sim, "left.slip", turn, [Mode::Backwards, Mode::Forwards]);
    near(sim.state_of("body").x, -way, 1e-9);
    sim.step_to(turn + 2.0 * way / back).unwrap();
    near(sim.state_of("body").x, 0.0, 1e-9);
    near(sim.state_of("body").vx, back, 1e-9);

    let mut sim = from(block(10.0), [0.0; 2], [-3.0, 0.0, 0.0]);
    sim.step_to(1.0).unwrap();
    near(sim.state_of("body").x, -0.977_882_930_561_701, 1e-9);
    let place = sim.state_of("body").x;
    sim.step_to(3600.0).unwrap();
    assert_eq!((sim.state_of("body").x, sim.state_of("body").vx), (place, 0.0));

    let critical = 16.699_244_233_993_62;
    for (degrees, moves) in [(critical - 1e-7, false), (critical + 1e-7, true)] {
        let mut sim = from(block(degrees), [0.0; 2], [0.0; 3]);
        sim.step_to(1.0).unwrap();
        assert_eq!(sim.state_of("body").x != 0.0, moves, "{degrees} deg: {:?}", sim.state_of("body"));
    }
}

/// Case C09: at 99 % of the angle of friction.
#[test]
fn c09_a_block_stays_for_an_hour() {
    let incline = 16.532_251_791_653_685_f64.to_radians();
    let mut sim = from(Body::new().with("incline", incline).with("friction", 0.3), [0.0; 2], [0.0; 3]);
    sim.step_to(3600.0).unwrap();
    let body = sim.state_of("body");
    assert_eq!((body.x, body.y, body.angle, body.vx), (0.0, 0.0, 0.0, 0.0));
    assert!(sim.stats().steps < 20, "{:?}", sim.stats());
    near(-sim.value_of("left.drag") / (0.3 * sim.value_of("left.push")), 0.989_419_624_342_013_6, 1e-12);
}

/// A round body with the moment of inertia c m r^2, r = 1 m.
fn roller(c: f64, incline: f64) -> Scene {
    Body::new().with("incline", incline).with("inertia", c).with("radius", 1.0).with("friction", 0.2)
}

/// Case C10: v becomes v_0/(1 + c) at v_0 c/(mu g (1 + c)).
#[test]
fn c10_rollers_that_slide_begin_to_roll() {
    for (c, time, speed, way, lost) in [
        (1.0, 1.274_209_989_806_320_2, 2.5, 4.778_287_461_773_7, 0.5),
        (0.5, 0.849_473_326_537_546_7, 3.333_333_333_333_333_5, 3.539_472_193_906_444_6, 1.0 / 3.0),
        (0.4, 0.728_119_994_175_04, 3.571_428_571_428_571_6, 3.120_514_260_750_171_7, 2.0 / 7.0),
    ] {
        let mut sim = from(roller(c, 0.0), [0.0, 1.0], [5.0, 0.0, 0.0]);
        let before = sim.kinetic_energy();
        changes(&mut sim, "left.slip", time, [Mode::Forwards, Mode::Sticks]);
        near(sim.state_of("body").x, way, 1e-9 * way);
        near(sim.state_of("body").vx, speed, 1e-9 * speed);
        near(sim.kinetic_energy(), before * (1.0 - lost), 1e-9 * before);
        sim.step_to(time + 10.0).unwrap();
        near(sim.state_of("body").vx, speed, 1e-9 * speed);
        near(sim.state_of("body").omega, -speed, 1e-9 * speed);
    }
}

/// Case C11: the speed after is (2 v_0 - r omega_0)/3.
#[test]
fn c11_a_disc_with_backspin_comes_back() {
    let mut sim = from(roller(0.5, 0.0), [0.0, 1.0], [5.0, 0.0, 12.0]);
    changes(&mut sim, "left.slip", 2.888_209_310_227_659, [Mode::Forwards, Mode::Sticks]);
    near(sim.state_of("body").x, 6.257_786_838_826_594, 6e-9);
    near(sim.state_of("body").vx, -2.0 / 3.0, 1e-9);
}

/// Case C12: it rolls up to tan a = mu (1 + 1/c).
#[test]
fn c12_a_disc_rolls_down_a_slope_or_slips() {
    let disc = |degrees: f64| from(roller(0.5, degrees.to_radians()), [0.0, 1.0], [0.0; 3]);
    let mut sim = disc(35.0);
    sim.step_to(2.0).unwrap();
    near(sim.state_of("body").vx, 2.0 * 4.019_608_529_708_76, 1e-8);
    near(sim.state_of("body").omega, -2.0 * 3.214_352_621_790_004, 1e-8);
    let mut sim = disc(30.0);
    sim.step_to(2.0).unwrap();
    near(sim.state_of("body").vx, 2.0 * 3.27, 1e-8);
    near(-sim.value_of("left.drag"), 1.635, 1e-9);
    for (c, threshold) in
        [(0.5, 30.963_756_532_073_52), (0.4, 34.992_020_198_558_66), (1.0, 21.801_409_486_351_81)]
    {
        for (degrees, mode) in [(threshold - 1e-7, Mode::Sticks), (threshold + 1e-7, Mode::Forwards)] {
            let sim = from(roller(c, f64::to_radians(degrees)), [0.0, 1.0], [0.0; 3]);
            assert_eq!(sim.contact("left.slip"), Some(mode), "c = {c}, {degrees} deg");
        }
    }
}

/// Case C29: the slip ends within the impact from mu = v_x/(3 (1 + e) |v_y|) = 0.2778 on. The energy falls by what the laws say.
#[test]
fn c29_a_disc_strikes_a_rough_floor() {
    for (friction, after) in [(0.05, [2.82, 1.6, -3.6]), (0.3, [2.0, 1.6, -20.0])] {
        let disc =
            Body::new().with("inertia", 0.005).with("radius", 0.1).with("friction", friction).with("e", 0.8);
        let sim = from(disc, [0.0, 0.1], [3.0, -2.0, 0.0]);
        let body = sim.state_of("body");
        for (found, known) in [body.vx, body.vy, body.omega].iter().zip(after) {
            near(*found, known, 1e-12 * known.abs());
        }
        let [vx, vy, omega] = after;
        near(sim.kinetic_energy(), 0.5 * (vx * vx + vy * vy + 0.005 * omega * omega), 1e-12 * 6.5);
        assert_eq!(sim.contact_stats().impacts, 1);
    }
}

/// Case C53: three quarters of the load are on the front edge; it tips from mu = 1 on.
#[test]
fn c53_a_cube_slides_without_lifting() {
    let cube = |friction: f64| {
        let cube = Body::new()
            .with("inertia", 0.01 / 6.0)
            .with("half", 0.05)
            .with("lift", 0.0)
            .with("friction", friction);
        from(cube, [0.0, 0.05], [6.0, 0.0, 0.0])
    };
    let mut sim = cube(0.5);
    near(sim.value_of("right.push") / G, 0.75, 1e-12);
    near(sim.value_of("left.push") / G, 0.25, 1e-12);
    let time = 1.223_241_590_214_067_2;
    changes(&mut sim, "right.slip", time, [Mode::Forwards, Mode::Sticks]);
    sim.step_to(3.0).unwrap();
    near(sim.state_of("body").x, 3.669_724_770_642_201_6, 3.7e-9);
    near(sim.state_of("body").y, 0.05, 1e-15);
    near(sim.state_of("body").angle, 0.0, 1e-14);
    for (friction, mode) in [(1.0 - 1e-7, Mode::Closed), (1.0 + 1e-7, Mode::Open)] {
        assert_eq!(cube(friction).contact("left.gap"), Some(mode), "mu = {friction}");
    }
}

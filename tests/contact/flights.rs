//! Bodies that fly, strike, bounce and let go.

use plm::runtime::Seen;
use plm::{Dop853, Mechanism as _, Moment, Sim};

use crate::declared::Ball;
use crate::near;
use crate::scene::{Given as _, Named as _};

/// t_n+1 = t_n + 2 e^n sqrt(2 h/g); bouncing ends at t_1 (1 + e)/(1 - e).
#[test]
fn a_ball_bounces_and_comes_to_rest() {
    let mut sim = Ball::new().start_with(Dop853::new(1e-11)).unwrap();
    let (first, e): (f64, f64) = ((2.0_f64 / 9.81).sqrt(), 0.5);
    let mut begins = first;
    for n in 1..6 {
        let flight = 2.0 * e.powi(n) * first;
        sim.step_to(begins + 0.5 * flight).unwrap();
        near(sim.state_of("ball").y, e.powi(2 * n), 1e-10);
        assert_eq!(sim.value_of("push"), 0.0);
        begins += flight;
    }
    sim.step_to(first * (1.0 + e) / (1.0 - e) + 1e-4).unwrap();
    assert!(
        sim.state_of("ball").y.abs() < 1e-15 && sim.state_of("ball").vy == 0.0,
        "{:?}",
        sim.state_of("ball")
    );
    near(sim.value_of("push"), 9.81, 1e-13);
}

scene! {
    pub Pendulum {
        gravity: 9.81 m/s^2;
        ground { port pivot: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 1e-12 kg*m^2;
            port pivot: (0, 1) m;
            start angle: 60 deg, locked;
        }
        revolute hinge(ground.pivot, bob.pivot);
        unilateral wall: bob.angle >= 0 rad { restitution: 0.7; }
    }
}

/// 1 - cos theta_n+1 = e^2 (1 - cos theta_n); impact times by elliptic integrals.
#[test]
fn a_pendulum_strikes_a_wall_at_its_lowest_point() {
    let mut sim = Pendulum::new().start_with(Dop853::new(1e-11)).unwrap();
    let times =
        [0.538_218_666_720_129, 1.574_285_377_335_238_3, 2.592_900_903_225_063_4, 3.603_434_181_165_172];
    let amplitudes = [0.715_142_207_291_020_5, 0.495_039_385_067_631_84, 0.344_704_052_068_480_26];
    for (two, amplitude) in times.windows(2).zip(amplitudes) {
        sim.step_to(0.5 * (two[0] + two[1])).unwrap();
        near(sim.state_of("bob").angle, amplitude, 1e-9);
    }
}

scene! {
    pub Ladder {
        gravity: 9.81 m/s^2;
        body ladder {
            mass: 3 kg;
            inertia: 1 kg*m^2;
            port top: (0, 1) m;
            port foot: (0, -1) m;
            start angle: 15 deg;
            start x: sin(15 deg)*(1 m);
            start y: cos(15 deg)*(1 m);
        }
        unilateral wall: ladder.top.x >= 0 m;
        unilateral floor: ladder.foot.y >= 0 m;
        output push = reaction(wall);
    }
}

/// cos theta = 2/3 cos theta_0 where the wall is left (theta from the vertical); then the foot slides on at its speed.
#[test]
fn a_ladder_leaves_the_wall() {
    let mut sim = Ladder::new().start_with(Dop853::new(1e-12)).unwrap();
    let leaves = 0.698_777_341_146_781_6;
    sim.step_to(leaves - 1e-6).unwrap();
    assert!(sim.value_of("push") > 0.0);
    sim.step_to(leaves).unwrap();
    near(sim.state_of("ladder").angle, 49.912_963_091_516_716_f64.to_radians(), 1e-10);
    near(sim.state_of("ladder").omega, 2.176_664_002_079_301_3, 1e-10);
    sim.step_to(leaves + 0.1).unwrap();
    assert_eq!(sim.value_of("push"), 0.0);
    near(sim.state_of("ladder").vx, 1.401_663_983_174_746_2, 1e-9);
}

scene! {
    pub Block {
        gravity: 9.81 m/s^2;
        param friction = 5;
        body block {
            mass: 1 kg;
            inertia: (0.1*0.1 + 0.5*0.5)/3*(1 kg*m^2);
            port left: (-0.1, -0.5) m;
            port right: (0.1, -0.5) m;
        }
        unilateral left: block.left.y >= 0 m;
        unilateral right: block.right.y >= 0 m;
        friction slides_left: rate(block.left.x) within friction*reaction(left);
        friction slides_right: rate(block.right.x) within friction*reaction(right);
    }
}

/// G. W. Housner, Bull. Seismol. Soc. Am. 53, 1963: times of impact and amplitudes, by quadrature.
#[test]
fn a_block_rocks() {
    let block = Block::new();
    let tilt: f64 = 0.5 * 0.2_f64.atan();
    let block = block.with_start("block.angle", tilt);
    // The left corner stays where it was.
    let (sin, cos) = tilt.sin_cos();
    let block = block.with_start("block.x", -0.1 + 0.1 * cos - 0.5 * sin);
    let block = block.with_start("block.y", 0.1 * sin + 0.5 * cos);
    let mut sim = block.start_with(Dop853::new(1e-11)).unwrap();
    let times = [0.347_093_586_788_881_3, 0.950_920_536_477_668_3, 1.487_939_643_105_267];
    let amplitudes = [0.083_339_113_164_354_69, 0.071_253_454_724_768_92];
    sim.step_to(times[0] - 1e-6).unwrap();
    assert!(sim.state_of("block").angle.abs() < 1e-5, "{:?}", sim.state_of("block"));
    near(sim.state_of("block").omega.abs(), 0.648_049_012_267_532_3, 1e-5);
    for (two, amplitude) in times.windows(2).zip(amplitudes) {
        sim.step_to(0.5 * (two[0] + two[1])).unwrap();
        near(sim.state_of("block").angle.abs(), amplitude, 1e-9);
    }
    sim.step_to(10.0).unwrap();
    assert!(sim.state_of("block").angle.abs() < 1e-12, "{:?}", sim.state_of("block"));
    // Then it rests on two corners, at any tolerance.
    for tolerance in [1e-4, 1e-8, 1e-12] {
        let mut sim = Block::new().with_start("block.y", 0.5).start_with(Dop853::new(tolerance)).unwrap();
        let (x, y, angle) = (sim.state_of("block").x, sim.state_of("block").y, sim.state_of("block").angle);
        sim.step(3600.0).unwrap();
        assert_eq!(
            (sim.state_of("block").x, sim.state_of("block").y, sim.state_of("block").angle),
            (x, y, angle),
            "{tolerance}"
        );
        assert!(sim.stats().steps < 20, "{tolerance}: {:?}", sim.stats());
    }
}

/// From an impact to the widest angle of a rocking block, s: from the energy, with theta = widest (1 - s^2), by Gauss's formula for the two
/// halves. The speed is that after the impact, `p2` = 3 g/(4 R).
fn half_swing(alpha: f64, p2: f64, speed: f64) -> f64 {
    let lean = (alpha.cos() + speed * speed / (2.0 * p2)).acos();
    let widest = alpha - lean;
    let inverse_rate = |s: f64| {
        let left = 0.5 * widest * s * s;
        2.0 * widest * s / (4.0 * p2 * (lean + left).sin() * left.sin()).sqrt()
    };
    let nodes: [(f64, f64); 5] = [
        (0.148_874_338_981_631_2, 0.295_524_224_714_752_9),
        (0.433_395_394_129_247_2, 0.269_266_719_309_996_4),
        (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
        (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
        (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
    ];
    let at = |half: f64, x: f64| inverse_rate(0.5 * (half + 0.5 * (1.0 + x)));
    let both = |half: f64, x: f64| at(half, x) + at(half, -x);
    [0.0, 1.0].iter().flat_map(|half| nodes.map(|(x, weight)| 0.25 * weight * both(*half, x))).sum()
}

/// Every impact has its time from the state at the end of a step, not from its dense output, which is less exact: the slower a corner comes
/// the more that would count, 3e-8 s and 6e-9 s at the last of these. Times by quadrature, as above; a speed falls by 1 - 3/2 sin^2 alpha at
/// each impact.
#[test]
fn impacts_of_a_rocking_block_are_on_time() {
    let (alpha, p2) = (0.2_f64.atan(), 3.0 * 9.81 / (4.0 * 0.26_f64.sqrt()));
    let tilt = 0.5 * alpha;
    let kept = 1.0 - 1.5 * alpha.sin().powi(2);
    for (tolerance, within) in [(1e-9, 1e-8), (1e-10, 1e-9)] {
        let block = Block::new();
        let block = block.with_start("block.angle", tilt);
        let (sin, cos) = tilt.sin_cos();
        let block = block.with_start("block.x", -0.1 + 0.1 * cos - 0.5 * sin);
        let block = block.with_start("block.y", 0.1 * sin + 0.5 * cos);
        let mut times = Vec::new();
        let mut sim = block.start_with(Dop853::new(tolerance)).unwrap();
        let see = |seen: Seen<'_, _>| {
            if let Seen::Switched(state) = seen {
                times.push(Moment::time(state));
            }
        };
        Sim::watch(&mut sim, 6.5, 6.5, see).unwrap();
        let mut speed = (2.0 * p2 * ((alpha - tilt).cos() - alpha.cos())).sqrt();
        let mut known = half_swing(alpha, p2, speed);
        for impact in 0..20 {
            let off = times.iter().fold(f64::INFINITY, |off: f64, time| off.min((time - known).abs()));
            assert!(off < within, "{tolerance:e}: impact {impact} at {known} s is {off:e} s off");
            speed *= kept;
            known += 2.0 * half_swing(alpha, p2, speed);
        }
    }
}

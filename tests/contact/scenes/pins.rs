//! Friction in every joint of a loop, bounded by what the joint carries: against statics and dynamics that were written down by hand.

use plm::{Dop853, Mechanism as _};

use crate::declared::RubbingInAbsolute;
use crate::near;
use crate::scene::{Given as _, Named as _};

rubbing!(InCharts, loops);

/// The same by Newton's and Euler's equations, with the angle of the crank as the independent variable: slips change their directions
/// at multiples of 90 deg.
struct ByHand;

struct Motion {
    /// The angular acceleration of the crank, rad/s^2.
    alpha: f64,
    /// The power of the friction over the rate of the crank, N m.
    drag: f64,
    /// What pins o, a, b and the rail carry, N.
    loads: [f64; 4],
    /// The push of the rail, N.
    push: f64,
}

impl ByHand {
    const CRANK: f64 = 0.1;
    const ROD: f64 = 0.3;
    const G: f64 = 9.81;
    const MASS: [f64; 3] = [1.0, 0.5, 2.0];
    const INERTIA: [f64; 2] = [0.01, 0.004];
    const MU: f64 = 0.2;
    const ARM: f64 = 0.003;
    /// Of the pin of the crank in the bound of that of the slider, m.
    const PART: f64 = 0.001;
    const STEPS: u32 = 250;

    /// Directions of the slips at an angle.
    fn signs(angle: f64) -> [f64; 4] {
        [1.0, -1.0, -angle.cos().signum(), -angle.sin().signum()]
    }

    /// The motion; `side` is the sign of the push of the rail.
    fn motion(angle: f64, omega: f64, signs: [f64; 4], side: f64) -> Motion {
        let (l1, l2) = (Self::CRANK, Self::ROD);
        let [m1, m2, m3] = Self::MASS;
        let (sin, cos) = angle.sin_cos();
        let sin_rod = -l1 / l2 * sin;
        let cos_rod = (1.0 - sin_rod * sin_rod).sqrt();
        // phi' = k omega, phi'' = k alpha + bend omega^2
        let k = -l1 / l2 * cos / cos_rod;
        let bend = l1 / l2 * sin / cos_rod + k * k * sin_rod / cos_rod;
        let by_rod = |part: f64, alpha: f64| {
            let (turn, phi2) = (k * omega, k * alpha + bend * omega * omega);
            let x =
                -l1 * (sin * alpha + cos * omega * omega) - part * (sin_rod * phi2 + cos_rod * turn * turn);
            let y =
                l1 * (cos * alpha - sin * omega * omega) + part * (cos_rod * phi2 - sin_rod * turn * turn);
            [x, y, phi2]
        };
        let partial = |part: f64| [-l1 * sin - part * sin_rod * k, l1 * cos + part * cos_rod * k];
        let (p2, p3) = (partial(0.5 * l2), partial(l2));
        let inertia_forces = |alpha: f64| {
            let ([x2, y2, phi2], [x3, ..]) = (by_rod(0.5 * l2, alpha), by_rod(l2, alpha));
            Self::INERTIA[0] * alpha
                + m2 * (x2 * p2[0] + y2 * p2[1])
                + Self::INERTIA[1] * phi2 * k
                + m3 * x3 * p3[0]
        };
        let (without, mass) = (inertia_forces(0.0), inertia_forces(1.0) - inertia_forces(0.0));
        let mut loads = [0.0; 4];
        let mut alpha = 0.0;
        let mut drag = 0.0;
        for _ in 0..60 {
            let before = loads;
            let [in_o, in_a, in_b, _]: [f64; 4] = core::array::from_fn(|i| -Self::ARM * signs[i] * loads[i]);
            let in_b = in_b - Self::PART * signs[2] * loads[0];
            let on_rail = -Self::MU * signs[3] * loads[3];
            drag = in_o + in_a * (k - 1.0) + in_b * k + on_rail * p3[0];
            alpha = (drag - m2 * Self::G * p2[1] - without) / mass;
            let ([x2, y2, phi2], [x3, ..]) = (by_rod(0.5 * l2, alpha), by_rod(l2, alpha));
            let arm = [0.5 * l2 * cos_rod, 0.5 * l2 * sin_rod];
            let moment = Self::INERTIA[1] * phi2 + m2 * (arm[0] * y2 - arm[1] * x2) + m2 * Self::G * arm[0];
            let b_x = m3 * x3 - on_rail;
            let b_y = (in_a + in_b - moment) / (l2 * cos_rod) + sin_rod / cos_rod * b_x;
            let (a_x, a_y) = (m2 * x2 + b_x, m2 * (y2 + Self::G) + b_y);
            let push = m3 * Self::G - b_y;
            loads = [a_x.hypot(a_y + m1 * Self::G), a_x.hypot(a_y), b_x.hypot(b_y), side * push];
            if loads.iter().zip(before).all(|(now, before)| (now - before).abs() < 1e-13 * (1.0 + now.abs()))
            {
                break;
            }
        }
        Motion { alpha, drag, loads, push: side * loads[3] }
    }

    /// Rate, time, work of the friction at the angle `to`, all slips having one direction from here to there.
    fn advance(mut state: [f64; 3], from: f64, to: f64, side: &mut f64) -> [f64; 3] {
        let signs = Self::signs(0.5 * (from + to));
        let h = (to - from) / f64::from(Self::STEPS);
        for step in 0..Self::STEPS {
            let at = from + f64::from(step) * h;
            let next = Self::step(state, at, h, signs, *side);
            let push = |state: &[f64; 3], at: f64| Self::motion(at, state[0], signs, *side).push;
            if push(&next, at + h) * *side > 0.0 {
                state = next;
                continue;
            }
            // The push changes its sign within the step: there it ends.
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let half: f64 = 0.5 * (low + high);
                let there = Self::step(state, at, half * h, signs, *side);
                *(if push(&there, at + half * h) * *side > 0.0 { &mut low } else { &mut high }) = half;
            }
            state = Self::step(state, at, high * h, signs, *side);
            *side = -*side;
            state = Self::step(state, at + high * h, (1.0 - high) * h, signs, *side);
        }
        state
    }

    /// A step of the classical method of Runge and Kutta.
    fn step(state: [f64; 3], at: f64, h: f64, signs: [f64; 4], side: f64) -> [f64; 3] {
        let slope = |at: f64, state: [f64; 3]| {
            let Motion { alpha, drag, .. } = Self::motion(at, state[0], signs, side);
            [alpha / state[0], 1.0 / state[0], drag]
        };
        let along = |slope: &[f64; 3], h: f64| core::array::from_fn(|i| state[i] + h * slope[i]);
        let a = slope(at, state);
        let b = slope(at + 0.5 * h, along(&a, 0.5 * h));
        let c = slope(at + 0.5 * h, along(&b, 0.5 * h));
        let d = slope(at + h, along(&c, h));
        core::array::from_fn(|i| state[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
    }
}

/// Both formulations meet each quarter turn at its time, with its rate; the energy falls by the work of all four frictions.
#[test]
fn a_slider_crank_rubs_in_three_pins_and_on_its_rail() {
    let mut charts = InCharts::new().start_with(Dop853::new(1e-12)).unwrap();
    let mut absolute = RubbingInAbsolute::new().start_with(Dop853::new(1e-12)).unwrap();
    let quarter = core::f64::consts::FRAC_PI_2;
    let (mut from, mut state, mut side) = (40.0_f64.to_radians(), [60.0, 0.0, 0.0], 1.0);
    let energy = charts.kinetic_energy() + charts.gravity_energy();
    for k in 1..=8 {
        for to in [(f64::from(k) - 0.4) * quarter, f64::from(k) * quarter] {
            state = ByHand::advance(state, from, to, &mut side);
            from = to;
            let [omega, time, work] = state;
            let loads = ByHand::motion(to, omega, ByHand::signs(to), side).loads;
            for sim in [&mut charts, &mut absolute] {
                sim.step_to(time).unwrap();
                near(sim.state_of("crank").angle, to, 1e-9 * to.max(1.0));
                near(sim.state_of("crank").omega, omega, 1e-9 * 60.0);
                near(sim.kinetic_energy() + sim.gravity_energy(), energy + work, 1e-9 * energy);
                // At a quarter turn friction jumps, and loads with it.
                if to != f64::from(k) * quarter {
                    let found = [
                        sim.value_of("carries_o"),
                        sim.value_of("carries_a"),
                        sim.value_of("carries_b"),
                        sim.value_of("carries_rail"),
                    ];
                    found.iter().zip(loads).for_each(|(found, load)| near(*found, load, 1e-9 * 400.0));
                }
            }
        }
    }
}

scene! {
    /// A four-bar linkage with friction in its pins, moved by a torque at its crank.
    pub FourBar {
        part torque_of(on: body) {
            param torque: N*m;
            torque on on: torque;
        }
        gravity: 9.81 m/s^2;
        // Coefficient of friction times the radius of a pin.
        param arm: m = 8 mm;
        param torque: N*m = 0 N*m;
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body crank {
            mass: 1 kg; inertia: 0.02 kg*m^2;
            port a: (-0.25, 0) m; port b: (0.25, 0) m;
            start angle: 70 deg, locked;
            start x: 0.08 m; start y: 0.23 m;
        }
        body coupler {
            mass: 2 kg; inertia: 0.1 kg*m^2;
            port b: (-0.5, 0) m; port c: (0.5, 0) m;
            start x: 0.65 m; start y: 0.6 m; start angle: 15 deg;
        }
        body rocker {
            mass: 1.5 kg; inertia: 0.05 kg*m^2;
            port c: (0.4, 0) m; port d: (-0.4, 0) m;
            start x: 1.05 m; start y: 0.38 m; start angle: 80 deg;
        }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(ground.d, rocker.d);
        torque_of motor(crank) { torque: torque; }
        friction in_a: rate(crank.angle) within arm*norm(a.force);
        friction in_b: rate(coupler.angle - crank.angle) within arm*norm(b.force);
        friction in_c: rate(rocker.angle - coupler.angle) within arm*norm(c.force);
        friction in_d: rate(rocker.angle) within arm*norm(d.force);
    }
}

/// The torque that moves the crank slowly to one side: statics, with the friction of every pin against its turning. The pins carry what
/// is in balance with this friction.
fn statics(side: f64) -> f64 {
    const G: f64 = 9.81;
    let (crank, coupler, rocker, ground) = (0.5, 1.0, 0.8, 1.0);
    let angle = 70.0_f64.to_radians();
    let b = [crank * angle.cos(), crank * angle.sin()];
    // c by its distances from b and d, above the line between them.
    let between = [ground - b[0], -b[1]];
    let far = between[0].hypot(between[1]);
    let along = (coupler * coupler - rocker * rocker + far * far) / (2.0 * far);
    let off = (coupler * coupler - along * along).sqrt();
    let unit = [between[0] / far, between[1] / far];
    let from_b = [along * unit[0] - off * unit[1], along * unit[1] + off * unit[0]];
    let from_d = [b[0] + from_b[0] - ground, b[1] + from_b[1]];
    // Turning of coupler and rocker for that of the crank: b + w2 from_b = w3 from_d.
    let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let determinant = cross(from_b, from_d);
    let [of_coupler, of_rocker] = [cross(from_d, b) / determinant, cross(from_b, b) / determinant];
    let turns = [1.0, of_coupler - 1.0, of_rocker - of_coupler, of_rocker].map(|turn| side * turn);
    let mut frictions = [0.0; 4];
    let mut torque = 0.0;
    for _ in 0..60 {
        let [in_a, in_b, in_c, in_d]: [f64; 4] = frictions;
        // The force f on the coupler in b; on the rocker in c it is f less the weight of the coupler.
        let (w2, w3) = (2.0 * G, 1.5 * G);
        let about_b = 0.5 * w2 * from_b[0] + in_b - in_c;
        let about_d = (w2 + 0.5 * w3) * from_d[0] - in_c - in_d;
        // from_b x f and from_d x f are these.
        let f: [f64; 2] = core::array::from_fn(|i| (about_b * from_d[i] - about_d * from_b[i]) / determinant);
        let on_rocker = [f[0], f[1] - w2];
        let on_crank = [f[0], f[1] + G];
        let in_ground = [on_rocker[0], on_rocker[1] - w3];
        torque = cross(b, f) + 0.5 * b[0] * G - in_a + in_b;
        let loads = [on_crank, f, on_rocker, in_ground].map(|[x, y]| x.hypot(y));
        frictions = core::array::from_fn(|i| -0.008 * loads[i] * turns[i].signum());
    }
    torque
}

/// It rests between the two torques, where more rows stick than it has freedoms, and moves beyond them.
#[test]
fn a_four_bar_breaks_away() {
    for side in [-1.0, 1.0] {
        let limit = statics(side);
        for beyond in [-1e-3, -1e-9, 1e-9, 1e-3] {
            let four_bar = FourBar::new().with("torque", limit + side * beyond * limit.abs());
            let mut sim = four_bar.start_with(Dop853::new(1e-11)).unwrap();
            let begun = sim.state_of("crank").angle;
            sim.step(1.0).unwrap();
            let way = side * (sim.state_of("crank").angle - begun);
            if beyond < 0.0 {
                assert!(way == 0.0 && sim.is_undetermined(), "{limit} N m {beyond:+e}: {way:e} rad");
            } else {
                assert!(way > 5.0 * beyond && !sim.is_undetermined(), "{limit} N m {beyond:+e}: {way:e} rad");
            }
        }
    }
}

//! Clutches, torque limiters, freewheels and brakes: times, heat, self-energising shoes.

use plm::{Dop853, Sim};

use crate::near;

plm::mechanism! {
    pub Brakes {
        param pull: N*m = 2 N*m;
        rotor one() { start_speed: 100 rad/s; inertia: 0.2 kg*m^2; }
        rotor two() { start_speed: 20 rad/s; inertia: 0.3 kg*m^2; }
        clutch coupling(one.shaft, two.shaft) { force: 1 kN; radius: 5 cm; friction: 0.3; static_ratio: 1.2; }
        state heat: J = 0;
        rate heat = coupling.lost;
        rotor three() { inertia: 0.1 kg*m^2; drive: if t < 1 s then pull else if t < 2 s then -pull else pull; }
        rotor four() { inertia: 0.3 kg*m^2; }
        freewheel hub(three.shaft, four.shaft) { capacity: 100 N*m; }
        rotor five() { start_speed: 20 rad/s; inertia: 10 kg*m^2; }
        drum_brake drum(five.shaft) {
            force: 2.28 kN; radius: 150 mm; pivot_radius: 122.7 mm; arm: 212 mm; end: 126 deg; friction: 0.32;
        }
        rotor six() { start_speed: 20 rad/s; inertia: 10 kg*m^2; }
        drum_brake pair(six.shaft) {
            force: 2.28 kN; radius: 150 mm; pivot_radius: 122.7 mm; arm: 212 mm; end: 126 deg; friction: 0.32;
            shoes: two_leading;
        }
        rotor seven() { start_speed: 10 rad/s; inertia: 1 kg*m^2; drive: 1 N*m*(t/1 s); }
        brake stop(seven.shaft) { capacity: 10 N*m; static_ratio: 1.5; }
        ground { port bed: (0, 0) m; }
        body driver { mass: 1 kg; inertia: 0.2 kg*m^2; port hub: (0, 0) m; start omega: 20 rad/s; }
        body driven { mass: 1 kg; inertia: 0.3 kg*m^2; port hub: (0, 0) m; start omega: 20 rad/s; }
        revolute front(ground.bed, driver.hub) { drive: if t < 1 s then 0 else if t < 2 s then 100 N*m/s*(t - 1 s) else 0; }
        revolute rear(ground.bed, driven.hub);
        torque_limiter limiter(driver.hub, driven.hub) { capacity: 30 N*m; static_ratio: 1.5; }
        when t > 0.1 s { driver.omega = 100 rad/s; }
        state slip_heat: J = 0;
        rate slip_heat = limiter.lost;
        output one.speed, two.speed, coupling.speed, coupling.locked, coupling.torque, heat;
        output three.speed, four.speed, hub.torque, hub.locked;
        output drum.torque, drum.leading_torque, drum.trailing_torque, drum.lost, pair.torque, seven.speed, stop.torque, stop.lost;
        output driver.omega, driven.omega, limiter.slip, limiter.torque, limiter.lost, limiter.locked, slip_heat;
    }
}

fn started(brakes: &Brakes) -> Sim<Brakes> {
    brakes.start_with(Dop853::new(1e-10)).unwrap()
}

/// C = 2 0.3 1 kN 5 cm = 30 N m: the speeds meet after dw J1 J2/((J1 + J2) C), and the heat is J1 J2/(J1 + J2) dw^2/2.
#[test]
fn a_clutch_locks_in_time_and_with_its_heat() {
    let mut sim = started(&Brakes::new());
    let reduced = 0.2 * 0.3 / 0.5;
    let time = 80.0 * reduced / 30.0;
    sim.step_to(time - 1e-6).unwrap();
    near(sim.coupling_locked(), 0.0, 0.0);
    near(sim.coupling_torque(), 30.0, 1e-12);
    sim.step_to(time + 1e-6).unwrap();
    near(sim.coupling_locked(), 1.0, 0.0);
    near(sim.heat(), 0.5 * reduced * 80.0 * 80.0, 1e-6);
    sim.step_to(3.0).unwrap();
    near(sim.one_speed(), (0.2 * 100.0 + 0.3 * 20.0) / 0.5, 1e-9);
    near(sim.coupling_speed(), 0.0, 1e-12);
    near(sim.coupling_torque(), 0.0, 1e-9);
}

/// 2 N m on 0.4 kg m^2 for 1 s, then -2 N m on 0.1 kg m^2 alone; from 2 s on it catches up what it has lost, in 1 s.
#[test]
fn a_freewheel_takes_along_and_overruns() {
    let mut sim = started(&Brakes::new());
    sim.step_to(0.9).unwrap();
    near(sim.hub_torque(), 1.5, 1e-9);
    near(sim.hub_locked(), 1.0, 0.0);
    sim.step_to(1.5).unwrap();
    near(sim.four_speed(), 5.0, 1e-9);
    near(sim.three_speed(), 5.0 - 10.0, 1e-9);
    near(sim.hub_torque(), 0.0, 0.0);
    sim.step_to(2.999).unwrap();
    near(sim.hub_locked(), 0.0, 0.0);
    sim.step_to(4.0).unwrap();
    near(sim.four_speed(), 5.0 + 5.0, 1e-9);
    near(sim.three_speed(), 10.0, 1e-9);
}

/// J. E. Shigley, C. R. Mischke, Mechanical Engineering Design, example 16-2: 366 and 162 N m of the shoes.
#[test]
fn a_drum_brake_presses_its_leading_shoe_on() {
    for sense in [1.0, -1.0] {
        let mut brakes = Brakes::new();
        brakes.start.five_wheel.omega.value = 20.0 * sense;
        brakes.start.six_wheel.omega.value = 20.0 * sense;
        let mut sim = started(&brakes);
        sim.step_to(0.1).unwrap();
        near(sim.drum_leading_torque(), 366.0, 1.0);
        near(sim.drum_trailing_torque(), 162.0, 1.0);
        let both = sim.drum_leading_torque() + sim.drum_trailing_torque();
        near(sim.drum_torque(), -sense * both, 1e-9);
        near(sim.drum_lost(), both * (20.0 - 0.1 * both / 10.0), 1e-6);
        let shoe = if sense > 0.0 { sim.drum_leading_torque() } else { sim.drum_trailing_torque() };
        near(sim.pair_torque(), -2.0 * sense * shoe, 1e-9);
        sim.step_to(1.0).unwrap();
        near(sim.drum_torque(), 0.0, 1e-9);
    }
}

/// The speed 10 - 10 t + t^2/2 is zero at 10 - sqrt(80) s. What holds is 15 N m, which the drive t N m reaches at 15 s; what slips is 10 N m.
#[test]
fn a_brake_stops_holds_and_breaks_away() {
    let mut sim = started(&Brakes::new());
    let rest = 10.0 - 80_f64.sqrt();
    sim.step_to(1.0).unwrap();
    near(sim.seven_speed(), 0.5, 1e-9);
    near(sim.stop_lost(), 5.0, 1e-8);
    sim.step_to(rest + 1e-6).unwrap();
    near(sim.seven_speed(), 0.0, 1e-9);
    sim.step_to(14.0).unwrap();
    near(sim.stop_torque(), -14.0, 1e-9);
    sim.step_to(16.0).unwrap();
    near(sim.stop_torque(), -10.0, 1e-12);
    near(sim.seven_speed(), (36.0 - 25.0) / 2.0, 1e-8);
}

/// The driver jumps by dw = 80 rad/s: the slip ends after J1 J2 dw/((J1 + J2) T), and its heat is J1 J2 dw^2/(2 (J1 + J2)).
#[test]
fn a_torque_limiter_slips_after_a_jump_until_the_speeds_meet() {
    let mut sim = started(&Brakes::new());
    let reduced = 0.2 * 0.3 / 0.5;
    let end = 0.1 + reduced * 80.0 / 30.0;
    sim.step_to(0.05).unwrap();
    near(sim.limiter_locked(), 1.0, 0.0);
    near(sim.limiter_torque(), 0.0, 1e-9);
    sim.step_to(0.1 + 1e-9).unwrap();
    near(sim.driver_omega(), 100.0, 1e-6);
    near(sim.driven_omega(), 20.0, 1e-6);
    sim.step_to(end - 1e-6).unwrap();
    near(sim.limiter_locked(), 0.0, 0.0);
    near(sim.limiter_torque(), 30.0, 1e-12);
    near(sim.limiter_slip(), -30.0 / reduced * 1e-6, 1e-9);
    near(sim.limiter_lost(), 30.0 * 30.0 / reduced * 1e-6, 1e-7);
    sim.step_to(end + 1e-6).unwrap();
    near(sim.limiter_locked(), 1.0, 0.0);
    near(sim.slip_heat(), 0.5 * reduced * 80.0 * 80.0, 1e-6);
    near(sim.driver_omega(), (0.2 * 100.0 + 0.3 * 20.0) / 0.5, 1e-9);
}

/// Of a drive M, the limiter carries M J2/(J1 + J2) while it holds: 1.5 30 N m at 1.75 s, for M = 100 N m/s (t - 1 s). Behind that the
/// slip has the rate 30/J2 - (M - 30)/J1.
#[test]
fn a_torque_limiter_breaks_away_at_its_static_torque() {
    let mut sim = started(&Brakes::new());
    sim.step_to(1.7499).unwrap();
    near(sim.limiter_locked(), 1.0, 0.0);
    near(sim.limiter_torque(), 74.99 * 0.6, 1e-9);
    sim.step_to(1.8).unwrap();
    near(sim.limiter_torque(), 30.0, 1e-12);
    let slip = (30.0 / 0.3 + 30.0 / 0.2) * 0.05 - 50.0 / 0.2 * (0.8 * 0.8 - 0.75 * 0.75);
    near(sim.limiter_slip(), slip, 1e-8);
    near(sim.limiter_lost(), -30.0 * slip, 1e-6);
}

//! What both programs run: assembly, each method of integration, conditions, an iteration, and the solution by rank.

use plm::inverse::{Gains, Inverse, Wanted};
use plm::runtime::Vector;
use plm::{
    Adams, Cause, Dop853, Dopri5, Fault, Gauss, Mechanism, Method, Moment, MoreauJean, RadauIia5, Real, Rk4,
    Ros34Pw2, Scalar, SemiImplicitEuler, Vern9,
};

plm::mechanism! {
    /// The double pendulum of the manual, section 2.2.
    pub DoublePendulum {
        gravity: 9.81 m/s^2;
        ground { port o0: (0, 0) m; }
        body arm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port o0: (-0.5, 0) m;
            port p12: (0.5, 0) m;
            start angle: 45 deg, locked;
        }
        body forearm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port p12: (-1, 0) m;
            start angle: 0 deg, locked;
        }
        revolute shoulder(ground.o0, arm.o0) { damping: 1 N*m/(rev/min); }
        revolute elbow(arm.p12, forearm.p12) { damping: 1 N*m/(rev/min); }
    }
}

plm::mechanism! {
    /// A loop with a slider, a spring, an input, a state and every output.
    pub Press {
        gravity: 9.81 m/s^2;
        param stiff: N/m = 200 N/m;
        input push: N = 5 N;
        state level: N = 0;
        rate level = (push - level) / 0.1 s;
        ground { port o: (0, 0) m; port rail: (0, 0) m, axis: 5 deg; }
        body crank { mass: 0.2 kg; inertia: 0.001 kg*m^2; port o: (-0.1, 0) m; port pin: (0.1, 0) m; start angle: 60 deg, locked; }
        body rod { mass: 0.6 kg; inertia: 0.018 kg*m^2; port pin: (-0.3, 0) m; port wrist: (0.3, 0) m; start angle: -17 deg; }
        body slider { mass: 0.5 kg; inertia: 0.001 kg*m^2; port wrist: (0, 0) m; start x: 0.67 m; }
        revolute drive(ground.o, crank.o) { damping: 0.01 N*m*s/rad; }
        revolute crank_pin(crank.pin, rod.pin) { branch: right; }
        revolute wrist_pin(rod.wrist, slider.wrist);
        prismatic guide(ground.rail, slider.wrist) { stiffness: stiff; free_length: 0.5 m; }
        force load(slider.wrist) { x: -level*exp(-t/1 s) - sqrt(1 + abs(slider.vx/1 m*1 s))*1 N; }
        output drive.force, guide.force, crank.angle in deg;
    }
}

plm::mechanism! {
    /// Two bars whose bodies and outputs are read by index.
    pub Row {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        repeat i in 0..2 {
            body bar[i] { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start x: (0.5 + i)*1 m; }
            output bar[i].b.position;
        }
        revolute pin[0](ground.o, bar[0].a);
        revolute pin[1](bar[0].b, bar[1].a);
    }
}

plm::mechanism! {
    /// A chain whose code has loops.
    pub Rope {
        code: rolled;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        repeat i in 0..14 {
            body bar[i] {
                mass: 0.1 kg + i*0.01 kg; inertia: 1e-4 kg*m^2;
                port a: (-0.05, 0) m; port b: (0.05, 0) m; start x: (0.05 + 0.1*i)*1 m;
            }
        }
        revolute pin[0](ground.o, bar[0].a);
        repeat i in 1..14 { revolute pin[i](bar[i - 1].b, bar[i].a) { damping: 1e-3 N*m*s/rad; } }
        output pin[0].force, pin[5].force;
    }
}

plm::mechanism! {
    /// A block between two forces that jump in its middle and end at a known time, and a table that bends.
    pub Shuttle {
        ground { port o: (0, 0) m; }
        body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0.1 m; }
        prismatic rail(ground.o, block.o);
        force back(block.o) { x: if block.x < 0 m then 40 N else if t < 0.3 s then -20 N else -30 N; }
        force soft(block.o) { x: table(block.x, (-1 m, 3 N), (0.05 m, 0 N), (1 m, -1 N)); }
        require inside: block.x < 1 m;
    }
}

plm::mechanism! {
    /// A plate on the pins of three cranks that are geared: an angle and three slides by one iteration.
    pub Plate {
        formulation: loops;
        gravity: 9.81 m/s^2;
        ground { port a: (0, 0) m; port b: (1, 0) m; port c: (0.5, 0.9) m; }
        body crank[0] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.1 m; start angle: 20 deg, locked; start omega: 2 rad/s, locked; }
        body crank[1] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 1.1 m; start angle: 20 deg; }
        body crank[2] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.6 m; start y: 0.9 m; start angle: -20 deg; }
        body plate { mass: 2 kg; inertia: 0.3 kg*m^2; port a: (-0.4, -0.3) m, angle: 35 deg; port b: (0.4, -0.3) m, angle: 140 deg; port c: (0, 0.4) m, angle: 100 deg; start x: 0.5 m; start y: 0.3 m; }
        revolute o0(ground.a, crank[0].o);
        revolute o1(ground.b, crank[1].o);
        revolute o2(ground.c, crank[2].o);
        pin_slot slot[0](plate.a, crank[0].p) { stiffness: 100 N/m; }
        pin_slot slot[1](plate.b, crank[1].p);
        pin_slot slot[2](plate.c, crank[2].p);
        constraint gear: crank[1].angle - crank[0].angle = 0;
        constraint back: crank[2].angle + 1.5*crank[0].angle = 10 deg;
    }
}

plm::mechanism! {
    /// A crank that passes a dead point, where another angle becomes the independent coordinate, under a push that ends.
    pub Rocker {
        input turn: N*m = 0;
        ground { port o: (0, 0) m; port p: (0.8, 0) m; }
        body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 40 deg, locked; start omega: 3 rad/s, locked; }
        body coupler { mass: 1 kg; inertia: 0.02 kg*m^2; port b: (-0.2, 0) m; port c: (0.2, 0) m; }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0.45, 0) m; port p: (-0.45, 0) m; start angle: 120 deg; }
        revolute o(ground.o, crank.a) { drive: turn; }
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute p(ground.p, rocker.p);
        force push(crank.b) { y: if crank.angle < 60 deg then 2 N else 0 N; }
    }
}

plm::mechanism! {
    /// A block that sticks on an incline after a slide, a ball that bounces; a door whose pin rubs, a drawer whose guide rubs at both ends.
    pub Stand {
        gravity: 9.81 m/s^2;
        emit: step(moreau_jean);
        body block { mass: 1 kg; inertia: 1 kg*m^2; start vx: 0.4 m/s; }
        constraint level: block.angle = 0;
        unilateral floor: block.y >= 0.1*block.x;
        friction grip: rate(block.x + 0.1*block.y) within 0.3*reaction(floor) { static: 0.4*reaction(floor); }
        ground { port hinge: (-2, 0) m; port rail: (-4, 0) m, axis: 20 deg; }
        body door { mass: 1 kg; inertia: 0.1 kg*m^2; port hinge: (-0.5, 0) m; start x: -1.5 m; start omega: 1 rad/s; }
        revolute hinge(ground.hinge, door.hinge) { pin_diameter: 0.1 m; friction: 0.2; }
        body drawer { mass: 2 kg; inertia: 0.1 kg*m^2; port rail: (0, 0.1) m; start x: -4 m; }
        prismatic rail(ground.rail, drawer.rail) { friction: 0.2; guide_length: 0.3 m; }
        body ball { mass: 2 kg; inertia: 1 kg*m^2; start x: 3 m; start y: 0.5 m; }
        unilateral base: ball.y >= 0 m { restitution: 0.5; }
        output push = reaction(floor);
    }
}

/// Gives the bits of time and state at some moments of some runs.
///
/// # Errors
/// If the mechanism cannot be assembled or moved.
pub fn run(mut emit: impl FnMut(u64)) -> Result<(), Fault> {
    if cfg!(feature = "panic") {
        // One mechanism is enough to show that the proof can fail.
        return moments(Rocker::new(), Rk4::new(1e-2), &mut emit);
    }
    explicit::<f64>(&mut emit)?;
    explicit::<f32>(&mut emit)?;
    implicit(&mut emit)?;
    moments(Shuttle::new(), Dop853::default(), &mut emit)?;
    moments(Shuttle::new(), Rk4::new(1e-2), &mut emit)?;
    moments(Rocker::new(), Dop853::default(), &mut emit)?;
    torques(&mut emit)?;
    moments(Plate::new(), Rk4::new(1e-2), &mut emit)?;
    moments(Rope::new(), Rk4::new(1e-2), &mut emit)?;
    moments(Rope::new(), Ros34Pw2::new(1e-2), &mut emit)?;
    moments(Stand::new(), MoreauJean::new(1e-3), &mut emit)?;
    moments(Stand::<f32>::of(), MoreauJean::new(1e-3), &mut emit)?;
    let mut rope = Rope::new().start_with(Rk4::new(1e-2))?;
    rope.step(0.1)?;
    rope.outputs().iter().chain([&rope.kinetic_energy()]).for_each(|output| emit(output.to_bits()));
    Ok(())
}

/// Implicit methods, the highest order, conditions and iterations run in double precision alone: twice the code takes twice the time to link.
fn implicit(emit: &mut impl FnMut(u64)) -> Result<(), Fault> {
    let pendulum = DoublePendulum::new();
    moments(pendulum, Gauss::<_, 3>::new(1e-2), emit)?;
    moments(pendulum, RadauIia5::new(1e-4), emit)?;
    moments(pendulum, Vern9::new(1e-9), emit)?;
    moments(pendulum, Adams::new(1e-9), emit)?;
    moments(pendulum, Ros34Pw2::new(1e-3), emit)
}

/// Torques for a turn of the crank, and with feedback, in the precision of boards.
fn torques(emit: &mut impl FnMut(u64)) -> Result<(), Fault> {
    let not_found = || Fault::new(0.0, Cause::NotFinite);
    let rocker = Rocker::<f32>::of();
    let sim = rocker.start()?;
    let inverse = Inverse::new(&rocker, ["crank.angle"], ["turn"]).map_err(|_| not_found())?;
    let wanted = |t: f32| Wanted { place: [0.7 + 3.0 * t], velocity: [3.0], acceleration: [0.0] };
    let times = (0..8u8).map(|k| 0.02 * f32::from(k));
    let along = inverse.over(&sim, times, wanted, |_, [torque]| emit(torque.to_f64().to_bits()));
    along.map_err(|_| not_found())?;
    let [torque] = inverse.track(&sim, &wanted(0.0), Gains::critical(20.0)).map_err(|_| not_found())?;
    emit(torque.to_f64().to_bits());
    Ok(())
}

fn explicit<S: Real>(emit: &mut impl FnMut(u64)) -> Result<(), Fault> {
    let locked = DoublePendulum::<S>::of();
    moments(locked, SemiImplicitEuler::new(S::lit(1e-3)), emit)?;
    moments(locked, Rk4::new(S::lit(1e-3)), emit)?;
    let mut unlocked = locked;
    unlocked.start.arm.angle.locked = false;
    unlocked.start.forearm.angle.locked = false;
    moments(unlocked, Dop853::default(), emit)?;
    moments(unlocked, Dopri5::default(), emit)?;
    moments(Press::<S>::of(), Dop853::default(), emit)?;
    let mut press = Press::<S>::of().start_with(Rk4::new(S::lit(1e-3)))?;
    press.input.push = S::lit(7.0);
    press.step(S::lit(0.1))?;
    for output in press.outputs() {
        emit(output.to_f64().to_bits());
    }
    let mut row = Row::<S>::of().start()?;
    row.step(S::lit(0.1))?;
    for (body, place) in (0..3).filter_map(|i| Some((row.bar(i)?, row.bar_b_position(i)?))) {
        for number in [body.x, body.omega, place[0], place[1]] {
            emit(number.to_f64().to_bits());
        }
    }
    Ok(())
}

/// Half a second, with a look at the state every 50 ms; then the rate by rank where that ended.
fn moments<M: Mechanism>(
    mechanism: M,
    method: impl Method<M>,
    emit: &mut impl FnMut(u64),
) -> Result<(), Fault> {
    let mut emit_all = |time: M::S, numbers: &M::X| {
        emit(time.to_f64().to_bits());
        for index in 0..M::X::LEN {
            emit(numbers.at(index).to_f64().to_bits());
        }
    };
    let mut sim = mechanism.start_with(method)?;
    sim.count_states(true);
    sim.run(M::S::lit(0.5), M::S::lit(0.05), |state| emit_all(state.time(), state.x()))?;
    for time in [0.499, 0.55] {
        // Methods without dense output know nothing of the last step.
        if let Ok(state) = sim.at(M::S::lit(time)) {
            emit_all(state.time(), state.x());
        }
    }
    for (name, count) in sim.state_count() {
        emit_all(M::S::lit((name.len() as u64 + count) as f64), sim.state().x());
    }

    let state = sim.state();
    let mut rate = *state.x();
    mechanism.rate_by_rank(state.time(), &state.held(), state.x(), &mut rate)?;
    emit_all(state.time(), &rate);
    sim.reset()?;
    sim.step_to(M::S::lit(0.05))?;
    emit_all(sim.state().time(), sim.state().x());
    Ok(())
}

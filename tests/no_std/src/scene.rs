//! What both programs run: assembly, each method of integration, and the solution by rank, in both precisions.

use plm::runtime::Vector;
use plm::{Dop853, Dopri5, Fault, Mechanism, Method, Moment, Real, Rk4, Scalar, SemiImplicitEuler};

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

/// Gives the bits of time and state at some moments of some runs.
///
/// # Errors
/// If the mechanism cannot be assembled or moved.
pub fn run(mut emit: impl FnMut(u64)) -> Result<(), Fault> {
    by_every_method::<f64>(&mut emit)?;
    by_every_method::<f32>(&mut emit)
}

fn by_every_method<S: Real>(emit: &mut impl FnMut(u64)) -> Result<(), Fault> {
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
        [body.x, body.omega, place[0], place[1]].map(|number| emit(number.to_f64().to_bits()));
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

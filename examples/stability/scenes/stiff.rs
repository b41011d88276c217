//! Stiffness: of springs, and of Baumgarte's stabilisation.

use plm::{Fault, Mechanism, Method, Rk4};

plm::mechanism! {
    /// 1 kg flies at 1 m/s into a stop of 1e8 N/m, 0.1 m ahead, and back.
    pub EndStop {
        /// A spring that pushes back when `b` is beyond `a`.
        part stop(a: frame, b: frame) {
            param stiffness: N/m;
            let depth = max(b.x - a.x, 0);
            force on b from a: (-stiffness*depth, 0);
        }
        param stiffness: N/m = 1e8 N/m;
        ground { port o: (0, 0) m; }
        body ram {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port nose: (0, 0) m;
            start x: -0.1 m, locked;
            start vx: 1 m/s, locked;
        }
        prismatic guide(ground.o, ram.nose);
        stop wall(ground.o, ram.nose) { stiffness: stiffness; }
    }
}

plm::mechanism! {
    /// The same mass on the same spring in both directions, from 1 mm: w = 1e4 rad/s.
    pub Oscillator {
        emit: step(rk4);
        ground { port o: (0, 0) m; }
        body ram { mass: 1 kg; inertia: 0.01 kg*m^2; port nose: (0, 0) m; start x: 1 mm, locked; start vx: 0, locked; }
        prismatic guide(ground.o, ram.nose) { stiffness: 1e8 N/m; }
    }
}

plm::mechanism! {
    /// A point of 1 kg on a spring of 1 m that is nearly a rod, released horizontally: the pendulum A01 as it becomes stiff.
    pub SpringPendulum {
        param stiffness: N/m = 1e6 N/m;
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 1 kg*m^2; port hook: (0, 0) m; start x: -1 m, locked; }
        spring rod(ground.o, bob.hook) { stiffness: stiffness; free_length: 1 m; }
    }
}

plm::mechanism! {
    /// The pendulum A01 with Baumgarte's stabilisation, alpha = beta = 1/tau.
    pub Stabilised {
        param tau: s = 0.1 s;
        gravity: 9.81 m/s^2;
        stabilisation: baumgarte(tau);
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.09 kg*m^2;
            port o: (0, 0.9) m;
            start x: -0.9 m;
            start angle: -90 deg, locked;
        }
        revolute hinge(ground.o, bob.o);
    }
}

/// Speed after the bounce over the speed before it; the known value is -1.
pub fn bounce<I: Method<EndStop>>(method: I) -> Result<f64, Fault> {
    let mut sim = EndStop::new().start_with(method)?;
    sim.step(0.2)?;
    Ok(sim.ram().vx)
}

/// Growth of the amplitude of the oscillator over 1000 steps of Runge-Kutta 4 by themselves; infinite if it ends before. `Sim` would
/// end a run whose steps err by the amplitude.
pub fn growth_of_oscillation(h: f64) -> f64 {
    let run = || {
        let mut state = *Oscillator::new().start()?.state();
        let energy_of = |state: &<Oscillator as Mechanism>::State| {
            state.kinetic_energy() + 0.5 * 1e8 * state.ram().x.powi(2)
        };
        let energy = energy_of(&state);
        for _ in 0..1000 {
            state.step_rk4(h)?;
        }
        Ok::<f64, Fault>((energy_of(&state) / energy).sqrt())
    };
    run().unwrap_or(f64::INFINITY)
}

/// Residual of the hinge (m) after so many steps of Runge-Kutta 4 with h alpha = `h_alpha`, released at an angle from
/// hanging (rad); infinite if it ends before.
pub fn stabilised(h: f64, h_alpha: f64, angle: f64, steps: u32) -> f64 {
    let run = || {
        let mut mechanism = Stabilised { tau: h / h_alpha, ..Stabilised::new() };
        let start = &mut mechanism.start.bob;
        (start.x.value, start.y.value, start.angle.value) = (0.9 * angle.sin(), -0.9 * angle.cos(), angle);
        let mut sim = mechanism.start_with(Rk4::new(h))?;
        sim.step(f64::from(steps) * h)?;
        let [x, y] = sim.bob().point(0.0, 0.9);
        Ok::<f64, Fault>(x.hypot(y))
    };
    run().unwrap_or(f64::INFINITY)
}

/// The largest value between `low` and `high` for which `bounded` holds, if it holds up to some value, to 1e-4 of it.
pub fn limit(mut low: f64, mut high: f64, bounded: impl Fn(f64) -> bool) -> f64 {
    while high - low > 1e-4 * low {
        let middle = 0.5 * (low + high);
        if bounded(middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

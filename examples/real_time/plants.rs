//! The two mechanisms in the loop: a four-bar with a motor, and an arm on a hydraulic jack with thin lines, which are stiff.

use plm::Fault;

/// How a mechanism got through a period.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Made {
    /// By one step.
    Whole,
    /// By so many shorter ones: this refused the one.
    InParts(u32, Fault),
    /// Not at all: it stands where it was before, with what refused every step.
    Held(Fault),
}

plm::mechanism! {
    /// A crank-rocker; its motor turns the crank against a spring and a damper at the rocker.
    pub FourBar {
        gravity: 9.81 m/s^2;
        emit: step(rk4);
        /// Torque of the motor.
        input torque: N*m = 0;
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; }
        body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; }
        body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.4, 0) m; port p: (-0.4, 0) m; start angle: 100 deg; }
        revolute o(ground.o, crank.a) { drive: torque; damping: 0.5 N*m*s/rad; }
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute p(ground.p, rocker.p) { damping: 0.5 N*m*s/rad; }
        output crank.angle;
    }
}

plm::mechanism! {
    /// The arm of ConnectPlmHyd (the manual, section 3.2.1), at rest at first.
    pub Arm {
        gravity: 9.81 m/s^2;
        emit: step(rk4, linearly_implicit);
        /// Inner diameter of both lines.
        param bore: mm = 3 mm;
        /// Of the valve, from -1 (the rod goes in) to 1.
        input lever: 1 = 0;
        ground { port o0: (0, 0) m; port foot: (0, -0.25) m; }
        body arm {
            mass: 100 kg;
            inertia: 0.01 kg*m^2;
            port jack: (-0.5, 0) m;
            port o0: (-0.8, 0) m;
            start angle: 20 deg, locked;
        }
        revolute hinge(ground.o0, arm.o0);
        jack ram(ground.foot, arm.jack) { free_length: 0.22 m; }
        cylinder press(ram.slider) {
            piston_diameter: 50 mm;
            rod_diameter: 30 mm;
            stroke: 0.35 m;
            friction: 1000 N/(m/s);
            chamber1.oil.gas_content: 0.001;
            chamber2.oil.gas_content: 0.001;
            chamber1.pressure: 27.25875503088503 bar;
            chamber2.pressure: 5 bar;
        }
        oil_line line1(press.port1) { diameter: bore; inlet.oil.gas_content: 0.001; inlet.pressure: 27.25875503088503 bar; }
        oil_line line2(press.port2) { diameter: bore; inlet.oil.gas_content: 0.001; inlet.pressure: 5 bar; }
        servo_valve valve(pump.port, line1.port, line2.port, tank.port) {
            signal: lever;
            rated_drop: 0.5 bar;
            frequency: 20 Hz;
        }
        oil_source pump() { pressure: 80 bar; }
        oil_tank tank() { pressure: 5 bar; }
        output arm.angle in deg, ram.displacement, press.pressure1 in bar, press.pressure2 in bar, line1.pressure in bar, line2.pressure in bar;
    }
}

/// What a loop in real time needs of a mechanism: one step with an input held, and the quantity that goes out.
///
/// # Errors
/// If the mechanism cannot be assembled.
pub fn four_bar(period: f64) -> Result<impl FnMut(f64) -> (f64, Made), Fault> {
    let mut state = *FourBar::new().start()?.state();
    Ok(move |torque| {
        state.input.torque = torque;
        let made = step_by_parts(&mut state, period, four_bar::State::step_rk4);
        (state.crank().angle, made)
    })
}

/// The same of the arm, whose oil asks for the linearly implicit step.
///
/// # Errors
/// If the mechanism cannot be assembled.
pub fn arm(period: f64) -> Result<impl FnMut(f64) -> (f64, Made), Fault> {
    let mut state = *Arm::new().start()?.state();
    Ok(move |lever| {
        state.input.lever = lever;
        let made = step_by_parts(&mut state, period, arm::State::step_linearly_implicit);
        (state.arm().angle, made)
    })
}

/// A step over a period. Where it is refused, as after a jump of the input, two of half its length are tried, then four, up to 64: so
/// the longest time that it takes is known.
fn step_by_parts<S: Copy>(
    state: &mut S,
    period: f64,
    step: impl Fn(&mut S, f64) -> Result<(), Fault>,
) -> Made {
    let by_parts = |parts: u32| {
        let mut next = *state;
        (0..parts).try_for_each(|_| step(&mut next, period / f64::from(parts))).map(|()| next)
    };
    let refused = match by_parts(1) {
        Ok(next) => {
            *state = next;
            return Made::Whole;
        }
        Err(fault) => fault,
    };
    for parts in [2, 4, 8, 16, 32, 64] {
        if let Ok(next) = by_parts(parts) {
            *state = next;
            return Made::InParts(parts, refused);
        }
    }
    Made::Held(refused)
}

//! Runs of mechanisms from text with hostile numbers.

use std::hint::black_box;

use plm_dynamic::{Integrator, Mechanism};

use super::{Call, Hostile, Outcome, ended};

pub(super) const CALLS: &[Call] = &[
    Call { name: "dynamic::parameters", call: parameters },
    Call { name: "dynamic::starts", call: starts },
    Call { name: "dynamic::methods", call: methods },
    Call { name: "dynamic::while it runs", call: running },
];

/// A mass on a spring with a stop, a friction and a drive.
pub(super) const OSCILLATOR: &str = "pub Osc {
    param k: N/m = 40 N/m; param c: N*s/m = 1 N*s/m; param load: kg = 2 kg;
    input push: N = 0 N;
    ground { port o: (0, 0) m; }
    body b { mass: load; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0.1 m, locked; start vx: 0 m/s, locked; }
    prismatic rail(ground.o, b.o) { stiffness: k; damping: c; drive: push; }
    output b.x;
}";

/// A pendulum that strikes a wall and rubs at it, by numbers that are all parameters.
const STRIKER: &str = "pub Striker {
    param length: m = 1 m; param wall: m = 0.2 m; param e: 1 = 0.5; param rub: N*m = 0.1 N*m; param g: m/s^2 = 9.81 m/s^2;
    gravity: g;
    ground { port o: (0, 0) m; }
    body b { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0 m, length); start angle: 40 deg, locked; start omega: 0 rad/s, locked; }
    revolute r(ground.o, b.o);
    unilateral stop: b.x >= -wall { restitution: e; }
    friction brake: rate(b.angle) within rub;
    output b.x, b.angle;
}";

fn ran(own: &Mechanism, method: Integrator) -> Result<(), plm_dynamic::Error> {
    let mut run = own.start_with(method)?;
    run.step_to(0.05)?;
    black_box(run.row());
    Ok(())
}

fn machine(h: &mut Hostile) -> Result<Mechanism, plm_dynamic::Error> {
    Mechanism::from_text(if h.draw.chance(0.5) { OSCILLATOR } else { STRIKER })
}

fn method(h: &mut Hostile) -> Integrator {
    *h.draw.one_of(&[
        Integrator::Dop853(1e-6),
        Integrator::RadauIia5(1e-6),
        Integrator::Rk4(1e-2),
        Integrator::MoreauJean(1e-2),
    ])
}

fn parameters(h: &mut Hostile) -> Outcome {
    let (own, method) = (machine(h), method(h));
    let own = own.and_then(|mut own| {
        let names: Vec<String> = own.parameters().map(|(name, _)| name.to_owned()).collect();
        let name = h.draw.one_of(&names).clone();
        own.set_parameter(&name, h.within(0.1, 2.0))?;
        Ok(own)
    });
    ended(own.and_then(|own| ran(&own, method)))
}

fn starts(h: &mut Hostile) -> Outcome {
    let (own, method) = (machine(h), method(h));
    let own = own.and_then(|mut own| {
        let name = *h.draw.one_of(own.starts());
        own.set_start(name, h.number())?;
        own.set_time(h.number());
        Ok(own)
    });
    ended(own.and_then(|own| {
        let mut run = own.start_with(method)?;
        let time = run.time();
        run.step_to(time + 0.05)
    }))
}

fn methods(h: &mut Hostile) -> Outcome {
    let number = h.within(1e-6, 1e-2);
    // A step that is tiny takes as many steps as were asked for.
    let step = if number.abs() < 1e-5 { 1e-3 } else { number };
    let method = *h.draw.one_of(&[
        Integrator::Dop853(number),
        Integrator::Dopri5(number),
        Integrator::RadauIia5(number),
        Integrator::Rk4(step),
        Integrator::MoreauJean(step),
        Integrator::SemiImplicitEuler(step),
    ]);
    ended(machine(h).and_then(|own| ran(&own, method)))
}

fn running(h: &mut Hostile) -> Outcome {
    let method = method(h);
    let run = Mechanism::from_text(OSCILLATOR).and_then(|own| own.start_with(method));
    ended(run.and_then(|mut run| {
        for _ in 0..3 {
            run.set_input("push", h.number())?;
            let to = h.within(0.01, 0.1);
            // A long interval takes its time.
            if !(to.is_finite() && to > 1.0) {
                run.step_to(to)?;
            }
        }
        black_box(run.row());
        Ok(())
    }))
}

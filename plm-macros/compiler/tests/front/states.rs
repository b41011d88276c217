//! States and their rates.

use crate::support::{Values, assert_near, output, resolve};

#[test]
fn a_state_has_its_rate_wherever_it_is_asked_for() {
    // rate(double) holds rate(slow), which stands below it and reads an input: substituted when all are known.
    let model = resolve(
        "pub P {
            param tau: s = 0.5 s;
            input target: bar = 3 bar;
            state double: bar = 1 bar;
            rate double = 2*rate(slow);
            state slow: bar = 2 bar;
            rate slow = (target - slow)/tau;
            output change = rate(slow*double);
        }",
    );
    let values = Values::of(&model);
    let names: Vec<&str> = model.states.iter().map(|state| state.name.text.as_str()).collect();
    assert_eq!(names, ["double", "slow"]);
    let rates: Vec<f64> = model.states.iter().map(|state| values.at(&model, state.rate)).collect();
    assert_near(rates[1], 2e5, "slow");
    assert_near(rates[0], 4e5, "double");
    assert_near(output(&model, &values, "change")[0], 2e5 * 1e5 + 2e5 * 4e5, "product");
}

/// A chamber that a piston compresses, with its pressure as the state: storage and flow in a part of the user's own.
#[test]
fn parts_hold_states() {
    let model = resolve(
        "pub P {
            ground { port o: (0, 0) m; }
            body piston { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; }
            part chamber(a: frame, b: frame) {
                param area: m^2;
                param bulk: bar = 17000 bar;
                param dead: L = 0.05 L;
                input inflow: L/min = 0;
                state p: bar = 0;
                let gap = norm(b.position - a.position);
                rate p = bulk/(dead + area*gap)*(inflow - area*rate(gap));
                force on b from a: p*area/gap*(b.position - a.position);
                output pressure = p;
            }
            chamber left(ground.o, piston.p) { area: 10 cm^2; inflow: 20 L/min; }
            output left.pressure in bar;
        }",
    );
    let mut values = Values::of(&model);
    values.pose(&model, "piston", [0.3, 0.4, 0.0]);
    values.set(model.bodies[0].v[0], 1.0);
    let state = &model.states[0];
    assert_eq!((state.name.text.as_str(), state.unit.text.as_str()), ("left.p", "bar"));
    values.set(state.symbol, 5e5);
    let expected = 1.7e9 / (50e-6 + 1e-3 * 0.5) * (20e-3 / 60.0 - 1e-3 * 0.6);
    assert_near(values.at(&model, state.rate), expected, "rate of the pressure");
    let force = model.loads[0].force.map(|f| values.at(&model, f));
    assert_near(force[0], 5e5 * 1e-3 * 0.6, "force x");
    assert_near(force[1], 5e5 * 1e-3 * 0.8, "force y");
    assert_eq!(model.outputs[0].unit.text, "bar");
}

#[test]
fn states_may_be_repeated() {
    let model = resolve(
        "pub P { repeat i in 0..3 { state p[i]: 1 = i; rate p[i] = 1/1 s*(i + 1)*p[i]; } output p[2]; }",
    );
    let values = Values::of(&model);
    let rates: Vec<f64> = model.states.iter().map(|state| values.at(&model, state.rate)).collect();
    assert_eq!(rates, [0.0, 2.0, 6.0]);
    assert_eq!(model.outputs[0].name.text, "p[2]");
}

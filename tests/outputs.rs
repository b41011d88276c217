//! Outputs of a mechanism have pose and accelerations in common: they are worked out once for all of them.
//!
//! Operations are counted, not times: numbers of a [`Trace`] count a term for each operand that depends on the variable, here on a length
//! that moves every point.
#![allow(clippy::unwrap_used, missing_docs, unreachable_pub, reason = "tests")]

use plm::dynamic::Compiled;
use plm::runtime::Ports;
use plm::{By, Described, Mechanism, Moment, Term, Trace, Traced, with_trace};

/// Chains of bars with the pose and velocity of each, without and with the reaction of each pin: as code, and their text.
macro_rules! chains {
    ($(($module:ident, $reacting:ident, $bars:literal)),*) => {
        $(
            mod $module {
                plm::mechanism! { pub Chain {
                    param length: m = 1 m;
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    repeat i in 0..$bars {
                        body bar[i] {
                            mass: 0.1 kg; inertia: 0.001 kg*m^2;
                            port a: (-0.5*length, 0 m); port b: (0.5*length, 0 m);
                            start x: (i + 0.5)*length; start angle: 0.1 rad; start omega: 0.3 rad/s;
                        }
                        output bar[i].position, bar[i].velocity, bar[i].angle;
                    }
                    revolute pin[0](ground.o, bar[0].a);
                    repeat i in 1..$bars { revolute pin[i](bar[i-1].b, bar[i].a); }
                } }
            }
            mod $reacting {
                plm::mechanism! { pub Chain {
                    param length: m = 1 m;
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    repeat i in 0..$bars {
                        body bar[i] {
                            mass: 0.1 kg; inertia: 0.001 kg*m^2;
                            port a: (-0.5*length, 0 m); port b: (0.5*length, 0 m);
                            start x: (i + 0.5)*length; start angle: 0.1 rad; start omega: 0.3 rad/s;
                        }
                        output pin[i].force, bar[i].b.acceleration;
                    }
                    revolute pin[0](ground.o, bar[0].a);
                    repeat i in 1..$bars { revolute pin[i](bar[i-1].b, bar[i].a); }
                } }
            }
        )*
    };
}

chains! { (eight, eight_reacting, 8), (sixteen, sixteen_reacting, 16), (many, many_reacting, 32) }

/// Terms of the outputs, of all that is observed, and of the rate, at the start.
fn counted<'t, M>(mechanism: M, trace: &'t Trace<'t>) -> [usize; 3]
where
    M: Mechanism<S = Traced<'t>> + Ports + Described,
{
    let sim = mechanism.start().unwrap();
    let state = sim.state();
    let of = |work: &mut dyn FnMut()| {
        let before = trace.terms();
        work();
        trace.terms() - before
    };
    let mut outputs = 0;
    let declared = of(&mut || M::outputs(state, &mut |_| outputs += 1));
    let count = state.mechanism().observables().len();
    assert_eq!(outputs, count, "all that is observed is declared");
    let observed = of(&mut || {
        M::observe(state, 0..count, &mut |number| assert!(number.unwrap().value.is_finite()));
    });
    let mut rate = *state.x();
    let rates = of(&mut || {
        state.mechanism().rate(state.time(), &state.held(), state.x(), &mut rate);
    });
    [declared, observed, rates]
}

/// The counts of a compiled chain, and of the same from text.
macro_rules! both {
    ($chain:ty) => {{
        let mut memory: [Term; 0] = [];
        let trace = Trace::new(&mut memory, 1);
        let compiled =
            counted(with_trace(&<$chain>::new(), &[By::Parameter("length")], &trace).unwrap(), &trace);
        let text = Compiled::new("chain", <$chain>::DECLARATION).unwrap();
        let own = text.mechanism::<96, 96, 192, 1, 1>().unwrap();
        let mut memory: [Term; 0] = [];
        let trace = Trace::new(&mut memory, 1);
        let from_text = counted(with_trace(&own, &[By::Parameter("length")], &trace).unwrap(), &trace);
        [compiled, from_text]
    }};
}

/// The counts of chains of 8, 16 and 32 bars: from the second eight on, each bar adds as many, and all outputs take at most `share` of a
/// rate.
fn grows_linearly(chains: [[[usize; 3]; 2]; 3], share: f64) {
    for (way, name) in ["compiled", "from text"].into_iter().enumerate() {
        for (k, of) in ["outputs", "all that is observed"].into_iter().enumerate() {
            let [few, some, many] = chains.map(|chain| chain[way][k]);
            let (per_bar, later) = ((some - few) as f64 / 8.0, (many - some) as f64 / 16.0);
            assert!(few > 100, "{name}, {of}: {few} terms");
            assert!(
                later < 1.05 * per_bar,
                "{name}, {of}: {few}, {some}, {many}: {per_bar} then {later} per bar"
            );
            let rate = chains[2][way][2];
            assert!((many as f64) < share * rate as f64, "{name}, {of}: {many} terms, a rate {rate}");
        }
    }
}

#[test]
fn outputs_of_poses_grow_linearly_along_a_chain_and_cost_less_than_a_rate() {
    grows_linearly([both!(eight::Chain), both!(sixteen::Chain), both!(many::Chain)], 1.0);
}

/// The accelerations and reactions take the rate and the way back along the tree.
#[test]
fn outputs_of_reactions_grow_linearly_along_a_chain() {
    grows_linearly(
        [both!(eight_reacting::Chain), both!(sixteen_reacting::Chain), both!(many_reacting::Chain)],
        2.0,
    );
}

//! Rates of two stages side by side have the bits of one after the other.

use plm::runtime::charts::OfLoops;
use plm::runtime::lanes::Two;
use plm::runtime::method::{Formula, Rk4Formula};
use plm::runtime::{Constraints, Events, Health, Labels, Mechanism, Moment, Rate, Scalar, System, Vector};
use plm::{Rk4, Sim};

use crate::linkages::loops;
use crate::random::Random;
use crate::scenes::{s2, s5, s6};

/// A system whose stages come one by one.
struct OneByOne<'a, M>(&'a M);

impl<M: System> Rate for OneByOne<'_, M> {
    type S = M::S;
    type X = M::X;
    type U = M::U;
    const NQ: usize = M::NQ;

    fn rate(&self, t: M::S, u: &M::U, x: &M::X, dx: &mut M::X) -> Health<M::S> {
        self.0.rate(t, u, x, dx)
    }
}

impl<M: System> Constraints for OneByOne<'_, M> {}

impl<M: System> Events for OneByOne<'_, M> {
    type G = M::G;
}

impl<M: System> Labels for OneByOne<'_, M> {}

/// Runs, and compares each step with one whose stages come one by one.
fn same_bits<M: Mechanism<S = f64>>(sim: &mut Sim<M, Rk4<f64>>, (h, steps): (f64, usize)) {
    const { assert!(M::PAIRED == f64::REGISTERS.pays_in_pairs(true)) };
    for step in 0..steps {
        let (mechanism, t) = (*sim.state().mechanism(), sim.state().time());
        let (held, x) = (sim.state().held(), *sim.state().x());
        let [mut paired, mut single] = [x; 2];
        let of_pairs = Rk4Formula::plain_step(&mechanism, t, &held, &mut paired, h);
        let of_singles = Rk4Formula::plain_step(&OneByOne(&mechanism), t, &held, &mut single, h);
        for k in 0..M::X::LEN {
            assert_eq!(paired.at(k).to_bits(), single.at(k).to_bits(), "step {step}, state {k}");
        }
        assert_eq!(of_pairs.0.to_bits(), of_singles.0.to_bits(), "step {step}");
        sim.step(h).unwrap();
    }
}

#[test]
fn two_stages_have_the_bits_of_one_by_one() {
    same_bits(&mut s2::FourBar::new().start_with(Rk4::new(1e-3)).unwrap(), (1e-3, 500));
    same_bits(&mut s6::SliderCrank::new().start_with(Rk4::new(1e-3)).unwrap(), (1e-3, 500));
    same_bits(&mut s5::Andrews::new().start_with(Rk4::new(1e-5)).unwrap(), (1e-5, 500));
}

#[test]
fn two_stages_have_the_bits_of_one_by_one_in_every_chart() {
    let mut random = Random(2027);
    let mut charts = [0; 3];
    for _ in 0..40 {
        let [crank, coupler, rocker] = [0.2, 0.3, 0.3].map(|least| random.between(least, 1.3));
        let mechanism = loops::FourBar { crank, coupler, rocker, ..loops::FourBar::new() };
        let Ok(mut sim) = mechanism.start_with(Rk4::new(1e-3)) else { continue };
        for _ in 0..20 {
            if let OfLoops::InChart { chart, .. } = sim.state().held().of_loops {
                charts[chart] += 1;
            }
            same_bits(&mut sim, (1e-3, 2));
            if sim.step(0.05).is_err() {
                break;
            }
        }
    }
    assert!(charts.iter().all(|&steps| steps > 10), "seed 2027: {charts:?}");
}

#[test]
fn two_numbers_have_the_bits_of_each() {
    let mut random = Random(2028);
    let bits = |x: f64| x.to_bits();
    for case in 0..200 {
        let [a, b, c] = [(); 3].map(|()| [(); 2].map(|()| random.between(-3.0, 3.0)));
        let [x, y, z] = [a, b, c].map(Two);
        let turned = Two([1e6 * a[0], a[1]]);
        let found = [
            x + y,
            x - y,
            x * y,
            x / y,
            -x,
            x.mul_add(y, z),
            x.abs().sqrt(),
            x.atan2(y),
            x.exp(),
            x.min(y),
            x.max(y),
            Two::select(x.lt(y), z, x),
            Two::sin_cos_all([x, y, z]).0[1],
            Two::sin_cos_all([x, y, turned]).1[2],
        ];
        for (lane, found) in [0, 1].map(|lane| (lane, found.map(|two| two.0[lane]))) {
            let (x, y, z) = (a[lane], b[lane], c[lane]);
            let wanted = [
                x + y,
                x - y,
                x * y,
                x / y,
                -x,
                Scalar::mul_add(x, y, z),
                Scalar::sqrt(x.abs()),
                Scalar::atan2(x, y),
                Scalar::exp(x),
                Scalar::min(x, y),
                Scalar::max(x, y),
                if x < y { z } else { x },
                Scalar::sin_cos(y).0,
                Scalar::sin_cos(turned.0[lane]).1,
            ];
            assert_eq!(found.map(bits), wanted.map(bits), "seed 2028, case {case}, value {lane}");
        }
    }
}

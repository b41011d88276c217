//! The bits of compiled code by every method of the catalogue: trees, whose implicit methods solve augmented equations, loops in charts, and
//! absolute coordinates; also of a run that was saved and goes on.

use plm::Sim;
use plm::dynamic::{Dynamic, Small};
use plm::runtime::{Described, Linear, Method, methods};

use crate::emitted::{arm_on_jack, double_pendulum, driven_crank, four_bar, slider_crank};
use crate::from_text::from_text;
use crate::linearised::chain;
use crate::linearised::loom::Loom;
use crate::linearised::mill::Mill;
use crate::linearised::zoo::Zoo;

chain!(chain4, 4);
chain!(chain16, 16);

/// A mechanism with at most 16 bodies.
type Sixteen = Dynamic<f64, 48, 48, 112, 16>;

/// What is seen of a run: of each interval the bits of poses and outputs, or the fault that ends it.
#[derive(Debug, PartialEq)]
struct Seen {
    method: &'static str,
    bits: Vec<Vec<u64>>,
    fault: Option<String>,
    /// Steps, rejected ones, evaluations, matrices of derivatives, decompositions.
    counts: [u64; 5],
}

fn bits<M: Described<S = f64>>(state: &M::State) -> Vec<u64> {
    let mut all = Vec::new();
    M::poses(state, &mut |body| all.extend(body.components()));
    M::outputs(state, &mut |output| all.push(output));
    all.into_iter().map(f64::to_bits).collect()
}

fn seen<M: Described<S = f64>, I: Method<M>>(method: &'static str, sim: &mut Sim<M, I>, by: f64) -> Seen {
    let mut seen = Seen { method, bits: Vec::new(), fault: None, counts: [0; 5] };
    for _ in 0..3 {
        if let Err(fault) = sim.step(by) {
            seen.fault = Some(fault.to_string());
            break;
        }
        seen.bits.push(bits::<M>(sim.state()));
    }
    let stats = sim.stats();
    seen.counts = [stats.steps, stats.rejected, stats.evaluations, stats.jacobians, stats.factorisations]
        .map(u64::from);
    seen
}

macro_rules! seen_by_each {
    (($mechanism:ident, $h:ident)
     by_error { $($a:ident ($i:literal, $c:literal, $m:ty, $t:literal, $rtol:literal, $d:literal, $w:literal))* }
     of_length { $($b:ident ($j:literal, $k:literal, $n:ty, $u:literal, $e:literal, $x:literal))* }) => {
        vec![
            $(seen(stringify!($a), &mut $mechanism.start_with(<$m>::new(1e-7)).unwrap(), 10.0 * $h),)*
            $(seen(stringify!($b), &mut $mechanism.start_with(<$n>::new($h)).unwrap(), 3.0 * $h),)*
        ]
    };
}

/// A mechanism by every method: three intervals of three steps of `h`, s, and of ten times that where errors decide of steps.
fn by_each<M: Described<S = f64> + Linear>(mechanism: M, h: f64) -> Vec<Seen> {
    methods!(seen_by_each(mechanism, h))
}

/// With the stack that a run of many bodies takes without optimisation.
fn on_large_stack(work: impl FnOnce() + Send + 'static) {
    std::thread::Builder::new().stack_size(64 << 20).spawn(work).unwrap().join().unwrap();
}

macro_rules! same_bits {
    ($mechanism:expr, $room:ty, $h:expr) => {
        on_large_stack(|| {
            let (mechanism, h) = ($mechanism, $h);
            let compiled = by_each(mechanism, h);
            assert!(compiled.iter().all(|seen| !seen.bits.is_empty()), "{compiled:?}");
            let texts: Vec<$room> = from_text(&mechanism);
            for text in texts {
                for (own, other) in by_each(text, h).into_iter().zip(&compiled) {
                    assert_eq!(own, *other, "{}", other.method);
                }
            }
        })
    };
}

#[test]
fn small_trees() {
    same_bits!(double_pendulum::DoublePendulum::new(), Small, 1e-3);
    same_bits!(chain4::Chain::new(), Small, 1e-3);
    same_bits!(arm_on_jack::ArmOnJack::new(), Small, 1e-4);
}

#[test]
fn loops() {
    same_bits!(four_bar::FourBar::new(), Small, 1e-3);
    same_bits!(slider_crank::SliderCrank::new(), Small, 1e-3);
    same_bits!(Loom::new(), Small, 1e-4);
}

#[test]
fn absolute_coordinates() {
    same_bits!(driven_crank::DrivenCrank::new(), Small, 1e-3);
    same_bits!(Mill::new(), Small, 1e-3);
}

#[test]
fn a_chain_of_16() {
    same_bits!(chain16::Chain::new(), Sixteen, 1e-3);
}

#[test]
fn a_tree_of_every_joint() {
    same_bits!(Zoo::new(), Sixteen, 1e-4);
}

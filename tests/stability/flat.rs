//! Flat poses: the rank of phi_q falls, branches cross.

use crate::scenes::flat::{EqualBars, Folded, Ladder1, Ladder2, Ladder40, Parallelogram};
use crate::scenes::run::trace;
use crate::scenes::theory::ladder_period;

#[test]
fn probe() {
    macro_rules! go { ($l:ident, $n:expr, $up:ident) => {{
        let t = ladder_period($n);
        let now = std::time::Instant::now();
        let mut sim = $l::new().start().unwrap();
        let e0 = sim.kinetic_energy() + sim.gravity_energy();
        let tr = trace(&mut sim, t, t/100.0, |s| (s.kinetic_energy() + s.gravity_energy() - e0)/e0);
        println!("{} T={t} E0={e0} dE={:e} end={:?} angle err {:e} {:e} drift {:?} stats {:?} {:?}", $n, tr.largest(), tr.end, sim.up_0().angle + 1.5*std::f64::consts::PI, sim.$up().angle + 1.5*std::f64::consts::PI, sim.drift(), sim.stats(), now.elapsed());
        let tr = trace(&mut sim, 10.0, t/100.0, |s| (s.kinetic_energy() + s.gravity_energy() - e0)/e0);
        println!("10 s dE={:e} end={:?} {:?} {:?}", tr.largest(), tr.end, sim.stats(), now.elapsed());
    }}}
    go!(Ladder1, 1, up_1);
    go!(Ladder2, 2, up_2);
    go!(Ladder40, 40, up_40);
    let mut sim = Parallelogram::new().start().unwrap();
    let tr = trace(&mut sim, 20.0*std::f64::consts::PI, 0.1, |s| s.left().angle - s.time() - 0.5*std::f64::consts::PI);
    println!("para {:e} {:?} {:?}", tr.largest(), tr.end, sim.stats());
    let mut sim = Folded::new().start().unwrap();
    let tr = trace(&mut sim, 10.0, 0.01, |s| s.crank().angle + s.rod().angle);
    println!("folded {:e} {:?} {:?} {:?}", tr.largest(), tr.end, sim.stats(), sim.crank());
    let mut sim = EqualBars::new().start().unwrap();
    let tr = trace(&mut sim, 10.0, 0.01, |s| s.kinetic_energy() + s.gravity_energy() );
    println!("equal {:?} {:?} {:?} {:?}", tr.points.last(), tr.end, sim.stats(), sim.crank());
}

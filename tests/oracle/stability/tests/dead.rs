//! Dead points, branches over a whole turn, and a motion that ends.

use plm_runtime::Rk4;

use crate::scenes::dead::{assembling, crank_rocker, cranking, energy, quadrorhomb, rocking, triple_rocker};
use crate::scenes::theory::{QUADRORHOMB_FALL, dead_angle, quadrorhomb_limit};
use crate::text::{By as _, Named as _, deep};

#[test]
fn a_triple_rocker_passes_the_dead_points_of_its_crank() {
    let trace = rocking(&mut triple_rocker().begin().unwrap(), 60.0);
    assert!(trace.survived() && trace.largest(0) < 1e-5, "{:?} {:e}", trace.end, trace.largest(0));
    let signs = trace.rows.windows(2).filter(|pair| pair[0].1[3] * pair[1].1[3] < 0.0).count();
    assert!(signs >= 10, "{signs} dead points");
    // The crank turns back where coupler and rocker stretch to 1.1 m: cos = 0.2, 78.46 deg.
    let known = dead_angle(0.7, 1.0, 1.1);
    assert!((known.to_degrees() - 78.463).abs() < 5e-4);
    let reached = trace.largest(1);
    // Samples stand 5 ms apart at an acceleration of some rad/s^2: within 1e-4 of the peak.
    assert!((-1e-4..1e-6).contains(&(reached - known)), "{} deg", reached.to_degrees());
}

#[test]
fn a_crank_rocker_keeps_its_branch_over_all_angles_of_the_crank() {
    let trace = cranking(&mut crank_rocker().begin().unwrap(), 3);
    assert!(trace.survived() && trace.largest(0) < 1e-7, "{:?} {:e}", trace.end, trace.largest(0));
    let trace = cranking(&mut crank_rocker().by(Rk4::new(0.01)).unwrap(), 3);
    assert!(trace.survived() && trace.largest(0) < 1e-7, "{:?} {:e}", trace.end, trace.largest(0));
}

#[test]
fn assembly_finds_the_same_branch_at_all_angles_of_the_crank() {
    let found = assembling().unwrap();
    assert_eq!(found.len(), 361);
    let (degree, off) = found.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    assert!(off < 1e-12, "{off:e} rad at {degree} deg");
}

/// Where the crank can go no further both wings of the cell fold at once: they go through each other, and it swings back.
#[test]
fn quadrorhombs_fall_turns_where_its_cell_folds() {
    deep(|| {
        let mut sim = quadrorhomb(0.0).begin().unwrap();
        sim.step(QUADRORHOMB_FALL - 5e-4).unwrap();
        let left = quadrorhomb_limit() - sim.body_of("crank").angle.abs();
        assert!((0.0..0.1_f64.to_radians()).contains(&left), "{} deg", left.to_degrees());
        let above = sim.body_of("oa").angle > sim.body_of("ob").angle;
        for _ in 0..20 {
            sim.step(1e-3).unwrap();
            let crank = sim.body_of("crank").angle.abs();
            assert!(crank < quadrorhomb_limit(), "{} deg", crank.to_degrees());
            let (energy, kinetic) = (energy(&sim), sim.kinetic_energy());
            assert!(energy.abs() < 1e-8 * kinetic, "{energy:e} J of {kinetic}");
        }
        assert_eq!(sim.stats().change_points, 1);
        assert_ne!(sim.body_of("oa").angle > sim.body_of("ob").angle, above);
    });
}

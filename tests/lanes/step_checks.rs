//! Lanes with loops are looked at together where that changes nothing but what is remembered: at steps of their own, next to flat
//! poses, and where steps are divided.

use plm::runtime::charts::OfLoops;
use plm::{Batch, Moment, Rk4, SemiImplicitEuler};

use crate::random::Random;
use crate::standard::{s5, s6};
use crate::{agree, agree_with, unchanged};

macro_rules! nearly_flat {
    ($module:ident: $($formulation:tt)*) => {
        mod $module {
            plm::mechanism! {
                /// A parallelogram whose rocker is a little longer: it comes near to two flat poses a turn.
                pub NearlyFlat {
                    $($formulation)*
                    gravity: 9.81 m/s^2;
                    param longer: m = 0 m;
                    param damping: N*m*s/rad = 0.01 N*m*s/rad;
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body crank {
                        mass: 1 kg;
                        inertia: 0.04 kg*m^2;
                        port a: (0, 0) m;
                        port b: (0.5, 0) m;
                        start angle: 60 deg, locked;
                        start omega: 6 rad/s, locked;
                    }
                    body coupler {
                        mass: 1 kg;
                        inertia: 0.03 kg*m^2;
                        port b: (0, 0) m;
                        port c: (1, 0) m;
                        start x: 0.25 m;
                        start y: 0.43 m;
                    }
                    body rocker {
                        mass: 1 kg;
                        inertia: 0.02 kg*m^2;
                        port d: (0, 0) m;
                        port c: (0.5 m + longer, 0 m);
                        start x: 1 m;
                        start angle: 60 deg;
                    }
                    revolute pivot_a(ground.a, crank.a) { damping: damping; }
                    revolute pin_b(crank.b, coupler.b);
                    revolute pin_c(coupler.c, rocker.c);
                    revolute pivot_d(ground.d, rocker.d);
                }
            }
        }
    };
}

nearly_flat!(by_loop:);
nearly_flat!(by_rows: formulation: absolute;);

/// Eight of them, each as long or longer, as fast and as damped as chance says.
macro_rules! nearly_flat_ones {
    ($module:ident, $random:expr) => {
        std::array::from_fn(|_| {
            let mut mechanism = $module::NearlyFlat::new();
            mechanism.longer = 10.0_f64.powf($random.between(-6.0, -1.0));
            mechanism.damping = $random.between(0.0, 0.1);
            mechanism.start.crank.omega.value = $random.between(4.0, 12.0);
            mechanism
        })
    };
}

#[test]
fn lanes_are_looked_at_at_steps_of_their_own() {
    let (seed, mut random) = (41, Random(41));
    for case in 0..4 {
        println!("seed {seed}, case {case}");
        let mut crank = || {
            let mut mechanism = s6::SliderCrank::new();
            mechanism.start.crank.angle.value += random.between(-3.0, 3.0);
            mechanism.start.crank.omega.value = random.between(-60.0, 60.0);
            mechanism
        };
        let mechanisms: [s6::SliderCrank; 8] = std::array::from_fn(|_| crank());
        // Some start where others have run: in the midst of their boxes, and with other steps to the next look at a drift.
        let mut alone = mechanisms.map(|mechanism| mechanism.start_with(Rk4::new(1e-3)).unwrap());
        for _ in 0..3 {
            alone[2].step(7e-3).unwrap();
        }
        let mut batch = Batch::new(alone);
        assert!(batch.step(0.05).iter().all(Result::is_ok));
        let mut looks = batch.each_ref().map(|sim| match sim.state().held().of_loops {
            OfLoops::InChart { continuation, .. } => continuation.time.last.to_bits(),
            OfLoops::Free { .. } => 0,
        });
        looks.sort_unstable();
        assert!(looks.chunk_by(|a, b| a == b).count() > 3);
        agree_with(alone, Batch::new(alone), &[0.021, 0.1, 0.013, 0.2], unchanged);
    }
}

#[test]
fn lanes_next_to_flat_poses() {
    let (seed, mut random) = (42, Random(42));
    let (mut divided, mut whole, mut rescued, mut changed) = (0, 0, 0, 0);
    for case in 0..4 {
        println!("seed {seed}, case {case}");
        let mechanisms: [by_loop::NearlyFlat; 8] = nearly_flat_ones!(by_loop, random);
        for stats in agree(mechanisms, Rk4::new(2e-3), &[0.2, 0.3, 0.25], unchanged) {
            divided += usize::from(stats.rejected > 0);
            whole += usize::from(stats.rejected == 0);
            rescued += usize::from(stats.near_singular > 0);
            changed += usize::from(stats.charts > 0);
        }
        agree(mechanisms, SemiImplicitEuler::new(2e-3), &[0.2, 0.3], unchanged);
    }
    assert!(divided.min(whole).min(rescued).min(changed) > 0, "{divided} {whole} {rescued} {changed}");
}

#[test]
fn lanes_in_absolute_coordinates_next_to_flat_poses() {
    let (seed, mut random) = (44, Random(44));
    println!("seed {seed}");
    let mechanisms: [by_rows::NearlyFlat; 8] = nearly_flat_ones!(by_rows, random);
    let (mut divided, mut rescued) = (0, 0);
    for stats in agree(mechanisms, Rk4::new(2e-3), &[0.2, 0.15], unchanged) {
        divided += usize::from(stats.rejected > 0);
        rescued += usize::from(stats.near_singular > 0);
    }
    assert!(divided > rescued, "{divided} {rescued}");
}

#[test]
fn loops_of_several_dyads() {
    let (seed, mut random) = (43, Random(43));
    println!("seed {seed}");
    let mut one = || {
        let mut mechanism = s5::Andrews::new();
        mechanism.start.k1.angle.value += random.between(-0.2, 0.2);
        mechanism.start.k1.omega.value += random.between(-100.0, 100.0);
        mechanism
    };
    let mechanisms: [s5::Andrews; 8] = std::array::from_fn(|_| one());
    agree(mechanisms, Rk4::new(1e-5), &[0.004, 0.003], unchanged);
}

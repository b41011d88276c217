//! Random four-bars and slider-cranks in joint and in absolute coordinates: no chart, no sign may take another motion.

use plm::Dop853;

use crate::random::Random;

macro_rules! linkage {
    ($module:ident, $formulation:ident) => {
        pub(crate) mod $module {
            plm::mechanism! {
                pub FourBar {
                    formulation: $formulation;
                    gravity: 9.81 m/s^2;
                    param crank: m = 0.3 m;
                    param coupler: m = 0.9 m;
                    param rocker: m = 0.7 m;
                    param offset: m = 0 m;
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body one { mass: 1 kg; inertia: 0.05 kg*m^2; port a: (-crank/2, 0 m); port b: (crank/2, 0 m); start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
                    body two { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-coupler/2, offset); port c: (coupler/2, 0 m); start x: 0.5 m; start y: 0.4 m; start angle: 30 deg; }
                    body three { mass: 1.5 kg; inertia: 0.05 kg*m^2; port d: (-rocker/2, 0 m); port c: (rocker/2, 0 m); start x: 1 m; start y: 0.3 m; start angle: 95 deg; }
                    revolute p(ground.a, one.a);
                    revolute q(one.b, two.b);
                    revolute r(two.c, three.c);
                    revolute s(ground.d, three.d);
                }
            }
        }
    };
}
linkage!(loops, loops);
linkage!(absolute, absolute);

#[test]
fn random_four_bars_move_alike_in_both_formulations() {
    let mut random = Random(2026);
    let (mut assembled, mut charts, mut rocked) = (0, 0, 0);
    for case in 0..120 {
        let [crank, coupler, rocker] = [0.2, 0.3, 0.3].map(|least| random.between(least, 1.3));
        let offset = random.between(-0.2, 0.2);
        let speed = random.between(-8.0, 8.0);
        let mut one = loops::FourBar { crank, coupler, rocker, offset, ..loops::FourBar::new() };
        let mut other = absolute::FourBar { crank, coupler, rocker, offset, ..absolute::FourBar::new() };
        one.start.one.omega.value = speed;
        other.start.one.omega.value = speed;
        let (one, other) = (one.start_with(Dop853::new(1e-11)), other.start_with(Dop853::new(1e-11)));
        let (Ok(mut one), Ok(mut other)) = (one, other) else { continue };
        assembled += 1;
        let energy = one.kinetic_energy() + one.gravity_energy();
        for _ in 0..10 {
            let what = format!(
                "seed 2026, case {case}: {crank} {coupler} {rocker} {offset} {speed}, {} s",
                one.time()
            );
            one.step(0.15).unwrap_or_else(|fault| panic!("{what}: {fault}"));
            other.step(0.15).unwrap_or_else(|fault| panic!("{what}: {fault}"));
            let poses = [(one.one(), other.one()), (one.two(), other.two()), (one.three(), other.three())];
            for (found, wanted) in poses {
                let off = [found.x - wanted.x, found.y - wanted.y, found.angle - wanted.angle];
                assert!(off.iter().all(|off| off.abs() < 1e-6), "{what}: {off:?}, {:?}", one.stats());
            }
        }
        let lost = one.kinetic_energy() + one.gravity_energy() - energy;
        // An embedded error of two numbers can be small by luck: one step in some ten thousand is worse than its tolerance.
        assert!(lost.abs() < 1e-6, "case {case}: {lost:e} of {energy} J");
        charts += one.stats().charts;
        rocked += u64::from(one.stats().charts > 0);
    }
    println!("{assembled} linkages, {rocked} of which needed {charts} changes of chart");
    // A test of charts must have some.
    assert!(assembled >= 60 && rocked >= 20, "{assembled} {rocked}");
}

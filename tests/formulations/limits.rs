//! Dyads that come to their own limits, at which no bar of the loops before them can drive them: against absolute coordinates.

use plm::Dop853;

use super::formulations::all_move_alike;
use crate::scene::{By as _, Scene};

/// A mechanism in the formulation that is taken, and in absolute coordinates, over so many intervals of 50 ms; coordinates must change so often.
macro_rules! passes_limits {
    ($test:ident, $intervals:literal, $charts:literal, { $($item:tt)* }) => {
        mod $test {
            pub(super) mod least {
                scene! { pub Scene { $($item)* } }
            }
            pub(super) mod absolute {
                scene! { pub Scene { formulation: absolute; $($item)* } }
            }
        }

        #[test]
        fn $test() {
            passes(&$test::least::Scene::new(), &$test::absolute::Scene::new(), $intervals, $charts);
        }
    };
}

fn passes(least: &Scene, absolute: &Scene, intervals: u32, charts: u64) {
    let mut one = least.by(Dop853::new(1e-11)).unwrap();
    let mut other = absolute.by(Dop853::new(1e-11)).unwrap();
    // In one go, by the default.
    let mut whole = least.begin().unwrap();
    for _ in 0..intervals {
        one.step(0.05).unwrap();
        other.step(0.05).unwrap();
        all_move_alike(&one, &other, 1e-8);
    }
    whole.step(0.05 * f64::from(intervals)).unwrap();
    all_move_alike(&whole, &other, 1e-6);
    assert!(one.stats().charts >= charts, "{:?}", one.stats());
}

// A four-bar of which the coupler leads a link and an arm to a third pivot.
passes_limits!(an_arm_at_the_end_of_a_six_bar, 20, 3, {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) m; port d: (1, 0) m; port g: (1.8, 0.2) m; }
    body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 5 rad/s, locked; }
    body coupler { mass: 0.9 kg; inertia: 0.06 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; port e: (0, 0.3) m; start angle: 30 deg; }
    body rocker { mass: 0.7 kg; inertia: 0.03 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0) m; start x: 1 m; start angle: 95 deg; }
    body link { mass: 0.5 kg; inertia: 0.03 kg*m^2; port e: (-0.45, 0) m; port f: (0.45, 0) m; start x: 1 m; start y: 0.8 m; start angle: 0 deg; }
    body arm { mass: 0.5 kg; inertia: 0.03 kg*m^2; port g: (-0.35, 0) m; port f: (0.35, 0) m; start x: 1.8 m; start y: 0.5 m; start angle: 90 deg; }
    revolute p_a(ground.a, crank.a);
    revolute p_b(crank.b, coupler.b);
    revolute p_c(coupler.c, rocker.c);
    revolute p_d(ground.d, rocker.d);
    revolute p_e(coupler.e, link.e);
    revolute p_f(link.f, arm.f);
    revolute p_g(ground.g, arm.g);
});

// Two chains of bars and slides that meet three times, with springs, dampers and a force that follows a body.
passes_limits!(two_chains_that_meet, 20, 1, {
    gravity: 9.81 m/s^2;
    ground { port p0: (-0.501, 0.17) m, axis: -1.314 rad; port p1: (0.326, 0.169) m, axis: -0.16 rad; port p2: (-0.758011172184113, -0.7458325038690079) m, axis: 0 rad; }
    body b0 { mass: 0.867 kg; inertia: 0.079 kg*m^2; port p0: (-0.037, 0.075) m, angle: 0.915 rad; port p1: (0.415, -0.334) m, angle: 1.722 rad; start x: -0.582794540566022 m; start y: 0.18742564585871604 m; start angle: -2.239 rad; start omega: -2.261 rad/s; }
    body b1 { mass: 1.078 kg; inertia: 0.291 kg*m^2; port p0: (0.532, 0.496) m, angle: -1.978 rad; port p1: (-0.772, -0.403) m, angle: -0.733 rad; port p2: (-0.403, -0.112) m, angle: 0.972 rad; port p3: (-0.055, 0.338) m, angle: 0.658 rad; start x: -0.48220647031083624 m; start y: -0.619810647295221 m; start angle: 1.461 rad; start omega: -3.522 rad/s; }
    body b2 { mass: 2.924 kg; inertia: 0.333 kg*m^2; port p0: (0.748, -0.024) m, angle: 0.918 rad; port p1: (0.323, -0.268) m, angle: 1.98 rad; port p2: (0.708, -0.288) m, angle: 0 rad; start x: 0.057887403150613526 m; start y: -2.145361200220812 m; start angle: 1.907 rad; start omega: -1.167 rad/s; }
    body b3 { mass: 3.212 kg; inertia: 0.322 kg*m^2; port p0: (0.185, -0.466) m, angle: -0.162 rad; port p1: (0.091, 0.223) m, angle: -1.542 rad; port p2: (-0.009285413967920264, -1.3955344662726807) m, angle: 0 rad; start x: 0.6787975368606436 m; start y: -1.899329520348449 m; start angle: 4.049 rad; start omega: 3.711 rad/s; }
    body b4 { mass: 3.432 kg; inertia: 0.381 kg*m^2; port p0: (-0.454, -0.255) m, angle: -0.524 rad; port p1: (0.661, -0.14) m, angle: 1.316 rad; start x: 0.4608884600224194 m; start y: 0.6719374745957795 m; start angle: 0.797 rad; start omega: 1.864 rad/s; }
    body b5 { mass: 3.823 kg; inertia: 0.308 kg*m^2; port p0: (0.714, 0.432) m, angle: 0.294 rad; port p1: (-2.4224252061702396, 0.8428035060728534) m, angle: 0 rad; start x: 1.496458679798795 m; start y: 0.359698354862923 m; start angle: 1.63 rad; start omega: -3.403 rad/s; }
    revolute j0(ground.p0, b0.p0) { damping: 1.644 N*m*s/rad; drive: 1.107 N*m; }
    prismatic j1(b0.p1, b1.p0);
    revolute j2(b1.p1, b2.p0);
    prismatic j3(b2.p1, b3.p0) { damping: 0.794 N*s/m; drive: -0.054 N; }
    revolute j4(ground.p1, b4.p0) { damping: 0.296 N*m*s/rad; }
    revolute j5(b4.p1, b5.p0) { stiffness: 14.941 N*m/rad; damping: 0.606 N*m*s/rad; }
    revolute j6(b3.p1, b5.p1);
    revolute j7(b1.p2, b3.p2);
    pin_slot j8(b1.p3, ground.p2);
    force f0(b2.p2) { axes: body; x: 1.093 N*sin(2.411 rad/s*t); y: -8.099 N; torque: -0.601 N*m; }
});

// A body in a slot leads a bar, and another one by a slot of its own.
passes_limits!(a_slot_that_leads_a_slot, 20, 1, {
    ground { port p0: (-0.391, 0.157) m, axis: 1.395 rad; port p1: (0.31548413258118996, -0.2858855560048513) m, axis: 0 rad; port p2: (-0.9958850187551803, 0.19663962673708713) m, axis: 0 rad; port p3: (3.515, -1.693) m, axis: 0 rad; }
    body b0 { mass: 4.213 kg; inertia: 0.256 kg*m^2; port p0: (-0.219, -0.228) m, angle: 1.191 rad; port p1: (-0.331, -0.229) m, angle: -0.701 rad; port p2: (0.096, 0.268) m, angle: -1.396 rad; start x: -0.5870930145157027 m; start y: 0.14056923614817876 m; start angle: 1.235 rad; start omega: -2.829 rad/s; }
    body b1 { mass: 3.229 kg; inertia: 0.091 kg*m^2; port p0: (0.133, -0.475) m, angle: 1.732 rad; port p1: (0.221, 0.075) m, angle: 0.653 rad; port p2: (0.036, 0.316) m, angle: 0 rad; start x: 0.2887122835614011 m; start y: -0.05404667207883333 m; start angle: -1.783 rad; start omega: -3.475 rad/s; }
    body b2 { mass: 3.971 kg; inertia: 0.111 kg*m^2; port p0: (-0.66, 0.224) m, angle: 0.764 rad; port p1: (-0.514, 0.054) m, angle: -1.739 rad; start x: -1.1156609885875133 m; start y: -0.3061184831435234 m; start angle: -1.7 rad; start omega: 3.982 rad/s; }
    pin_slot j0(ground.p0, b0.p0) { damping: 0.997 N*s/m; }
    pin_slot j1(b0.p1, b1.p0);
    revolute j2(b0.p2, b2.p0) { stiffness: 10.18 N*m/rad; damping: 0.952 N*m*s/rad; }
    revolute j3(b1.p1, ground.p1);
    revolute j4(b2.p1, ground.p2);
    spring s0(ground.p3, b1.p2) { stiffness: 71.163 N/m; damping: 0.647 N*s/m; free_length: 0.443 m; }
});

// A bar on a slot, which springs throw about faster than any step that was planned at its slow start.
passes_limits!(a_bar_that_springs_throw_about, 20, 1, {
    gravity: 9.81 m/s^2;
    ground { port p0: (-0.871, 0.365) m, axis: -0.275 rad; port p1: (-0.713911099182861, 1.3314034260277572) m, axis: 0 rad; port p2: (4.707, 1.736) m, axis: 0 rad; port p3: (4.898, 2.763) m, axis: 0 rad; }
    body b0 { mass: 2.778 kg; inertia: 0.472 kg*m^2; port p0: (-0.412, -0.068) m, angle: 0.342 rad; port p1: (-0.317, -0.025) m, angle: 0.295 rad; port p2: (-0.143, -0.152) m, angle: 0 rad; port p3: (0.788, -0.321) m, angle: 0 rad; start x: -0.8449663176648923 m; start y: 0.7868024829289049 m; start angle: 1.28 rad; start omega: -3.297 rad/s; }
    body b1 { mass: 0.778 kg; inertia: 0.119 kg*m^2; port p0: (-0.407, -0.478) m, angle: 0.627 rad; port p1: (-0.569, 0.385) m, angle: -0.264 rad; start x: -0.34727529803385115 m; start y: 0.7504006813562507 m; start angle: -0.413 rad; start omega: -2.762 rad/s; }
    pin_slot j0(ground.p0, b0.p0) { stiffness: 11.043 N/m; }
    revolute j1(b0.p1, b1.p0) { stiffness: 13.138 N*m/rad; damping: 1.411 N*m*s/rad; drive: 0.637 N*m; }
    revolute j2(b1.p1, ground.p1);
    spring s0(ground.p2, b0.p2) { stiffness: 67.187 N/m; damping: 2.052 N*s/m; free_length: 1.573 m; }
    spring s1(ground.p3, b0.p3) { stiffness: 27.851 N/m; damping: 1.444 N*s/m; free_length: 1.328 m; }
});

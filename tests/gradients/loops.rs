//! Derivatives through assembly and loops.

use plm::{By, mechanism, with_derivatives};

use super::are_slopes;

mechanism! {
    pub FourBar {
        param base: m = 0.4 m;
        param short: m = 0.1 m;
        param long: m = 0.35 m;
        param swing: m = 0.25 m;
        ground { port left: (0, 0) m; port right: (base, 0 m); }
        body crank {
            mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 0) m; port pin: (short, 0 m);
            start angle: 0.7 rad, locked;
        }
        body coupler {
            mass: 1 kg; inertia: 0.01 kg*m^2; port pin: (0, 0) m; port end: (long, 0 m); start x: 0.08 m; start y: 0.06 m;
            start angle: 0.5 rad;
        }
        body rocker {
            mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 0) m; port end: (swing, 0 m); start x: 0.4 m;
            start angle: 1.9 rad;
        }
        revolute main(ground.left, crank.pivot);
        revolute pin(crank.pin, coupler.pin);
        revolute end(coupler.end, rocker.end);
        revolute side(ground.right, rocker.pivot);
    }
}

/// The angle of the rocker by the law of cosines.
pub fn rocker([base, short, long, swing, crank]: [f64; 5]) -> f64 {
    let (x, y) = (short * crank.cos() - base, short * crank.sin());
    let d = x.hypot(y);
    y.atan2(x) - ((swing * swing + d * d - long * long) / (2.0 * swing * d)).acos()
}

#[test]
fn of_a_rocker_by_all_lengths_and_the_crank() {
    let by = [
        By::Parameter("base"),
        By::Parameter("short"),
        By::Parameter("long"),
        By::Parameter("swing"),
        By::Start("crank.angle"),
    ];
    let sim = with_derivatives(&FourBar::new(), by).unwrap().start().unwrap();
    let at = [0.4, 0.1, 0.35, 0.25, 0.7];
    let found = sim.rocker().angle;
    assert!((found.value - rocker(at)).abs() < 1e-12, "{found:?} {}", rocker(at));
    are_slopes(found.tangents, rocker, at, 1e-9);
}

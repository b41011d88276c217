//! Base inertia parameters against those that are known.

use plm::optimise::base_parameters;

use super::mechanism;

const ARMS: &str = "pub Arms {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.4, 0) m; port elbow: (0.6, 0) m; start x: 0.4 m; }
    body fore { mass: 1 kg; inertia: 0.05 kg*m^2; port elbow: (-0.3, 0) m; start x: 1.3 m; start angle: 0.2 rad; }
    revolute shoulder(ground.o, arm.o);
    revolute elbow(arm.elbow, fore.elbow);
}";

/// With two revolute joints and gravity there are six (W. Khalil, E. Dombre, Modeling, Identification and Control of Robots, 2002, ch. 9): the
/// first moments and the moments of inertia about the joints, J_O = J + 2 c h_x + c^2 m and h_O = h + c m, where the mass of the
/// second arm counts at the end of the first one, 1 m from its joint.
#[test]
fn of_two_arms() {
    let base = base_parameters(&mechanism(ARMS), [0.0, -9.81]).unwrap();
    assert_eq!(base.combinations.len(), 6, "{base}");
    assert!(base.without_effect.is_empty(), "{base}");
    let factor = |of: &str, name: &str| {
        let combination = base.combinations.iter().find(|own| own[0].0 == of).unwrap();
        combination.iter().find(|own| own.0 == name).map_or(0.0, |own| own.1)
    };
    let known = [
        ("arm.moment.x", "arm.mass", 0.4),
        ("arm.inertia", "arm.mass", 0.4 * 0.4 - 2.0 * 0.4 * 0.4),
        ("fore.moment.x", "fore.mass", 0.3),
        ("fore.inertia", "fore.mass", 0.3 * 0.3 - 2.0 * 0.3 * 0.3),
        ("arm.moment.x", "fore.mass", 1.0),
        ("arm.inertia", "fore.mass", 1.0 - 2.0 * 0.4),
        ("arm.moment.y", "fore.mass", 0.0),
        ("fore.moment.x", "arm.mass", 0.0),
    ];
    for (of, name, known) in known {
        assert!((factor(of, name) - known).abs() < 1e-7, "{of} {name}: {} is not {known}", factor(of, name));
    }
}

/// A bar on a pivot has one without gravity, a four-bar eight.
#[test]
fn of_loops_and_of_one_bar() {
    let bar = "pub Bar {
        ground { port o: (0, 0) m; }
        body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.4, 0) m; }
        revolute pivot(ground.o, bar.o);
    }";
    let base = base_parameters(&mechanism(bar), [0.0, 0.0]).unwrap();
    assert_eq!(base.to_string(), "bar.inertia + 0.800000 bar.moment.x + 0.160000 bar.mass\n");
    assert_eq!(base.without_effect, ["bar.moment.y"]);
    let base = base_parameters(&mechanism(super::identify::FOUR_BAR), [0.0, -9.81]).unwrap();
    // Of twelve the masses of crank and rocker have no effect, and a point mass at a pin may belong to either bar: at the end of the
    // coupler 0.25 h_x + 0.25^2 J of the rocker are m + 0.35 h_x + 0.35^2 J of the coupler.
    assert_eq!(base.combinations.len(), 8, "{base}");
    assert_eq!(base.without_effect, ["crank.mass", "rocker.mass"]);
    let lines = base.to_string();
    assert!(lines.contains("coupler.inertia + 0.490000 rocker.moment.x\n"), "{base}");
    assert!(lines.contains("coupler.moment.x + 1.400000 rocker.moment.x\n"), "{base}");
    assert!(lines.contains("rocker.inertia - 0.250000 rocker.moment.x\n"), "{base}");
    assert!(lines.contains("crank.moment.x + 0.400000 rocker.moment.x + 0.100000 coupler.mass\n"), "{base}");
}

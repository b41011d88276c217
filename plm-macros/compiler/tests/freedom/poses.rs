//! Poses and directions that only look as if they took a freedom away, or gave one.

use plm_compiler::token::Sources;
use plm_compiler::{Oracle, compile};

/// A declaration that is right, and of which nothing is said.
fn compiled(items: &str) -> Oracle {
    let mut sources = Sources::new();
    sources.add_text("declaration", &format!("pub Scene {{ {items} }}"));
    let expansion = compile(&mut sources);
    let told: Vec<String> = expansion.diagnostics.sorted().iter().map(|d| d.render(&sources)).collect();
    assert!(told.is_empty(), "{}", told.concat());
    expansion.oracle.unwrap()
}

/// Two cranks on an edge of the length of their ground: along the ground all three lie in one line.
fn parallelogram(degrees: f64) -> Oracle {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let starts =
        [(0.0, 0.0), (cos, sin), (2.0, 0.0)].map(|(x, y)| format!("start x: {x:?} m; start y: {y:?} m;"));
    let crank = "mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (1, 0) m";
    // At the flat pose itself a row is redundant, and the start is a change point.
    let flat = if degrees == 0.0 { "allow(W0001, W0010);" } else { "" };
    compiled(&format!(
        "formulation: loops; {flat}
        ground {{ port a: (0, 0) m; port d: (2, 0) m; }}
        body left {{ {crank}; {} start angle: {degrees:?} deg, locked; }}
        body top {{ mass: 1 kg; inertia: 0.1 kg*m^2; port l: (0, 0) m; port r: (2, 0) m; {} }}
        body right {{ {crank}; {} start angle: {degrees:?} deg; }}
        revolute a(ground.a, left.o); revolute b(left.p, top.l);
        revolute c(top.r, right.p); revolute d(ground.d, right.o);",
        starts[0], starts[1], starts[2],
    ))
}

/// In its flat pose the rank of `phi_q` is less by one than beside it, which is a property of the pose and not of the mechanism.
#[test]
fn a_parallelogram_has_one_freedom_wherever_it_starts() {
    for degrees in [60.0, 1.0, 0.01, 1e-4, 0.0] {
        assert_eq!(parallelogram(degrees).reduced_states(), Some(2), "from {degrees} deg");
    }
}

/// A third crank of the same length says nothing new: its loop has one unknown and two rows. Absolute coordinates are not needed for that.
#[test]
fn a_third_parallel_crank_takes_no_freedom() {
    let (sin, cos) = 40_f64.to_radians().sin_cos();
    let crank = |k: i32| {
        format!(
            "body c{k} {{ mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; port p: (1, 0) m;
                start x: {k} m; start angle: 40 deg{}; }}
            revolute foot{k}(ground.p{k}, c{k}.o); revolute head{k}(c{k}.p, top.p{k});",
            if k == 0 { ", locked" } else { "" }
        )
    };
    let ports = [0, 1, 2].map(|k| format!("port p{k}: ({k}, 0) m;")).concat();
    let oracle = compiled(&format!(
        "allow(W0001); formulation: loops; ground {{ {ports} }}
        body top {{ mass: 1 kg; inertia: 0.1 kg*m^2; {ports} start x: {cos:?} m; start y: {sin:?} m; }}
        {} {} {}",
        crank(0),
        crank(1),
        crank(2)
    ));
    assert_eq!(oracle.reduced_states(), Some(2));
    let turning = [0.0, 0.0, 1.0];
    let feet = [0.0, 1.0, 2.0].map(|x| [x, 0.0, 40_f64.to_radians()]);
    let q = [&[cos, sin, 0.0], &feet[0][..], &feet[1], &feet[2]].concat();
    let v = [&[-sin, cos, 0.0], &turning[..], &turning, &turning].concat();
    let x = [q, v].concat();
    let charts = oracle.charts(0.0, &x);
    assert!(charts.iter().any(|chart| chart.measure > 0.5), "{charts:?}");
    for chart in charts.iter().filter(|chart| chart.measure > 0.1) {
        // Nothing pulls: the platform goes round at constant speed.
        assert!(chart.acceleration.iter().all(|a| a.abs() < 1e-12), "{chart:?}");
        assert!(chart.pose.iter().zip(&x).all(|(a, b)| (a - b).abs() < 1e-12), "{chart:?}");
    }
}

/// A bar between blocks on two rails 0.3 m apart: it cannot turn, so that its angle and no rail's slide follows from the other.
#[test]
fn slides_on_parallel_rails_do_not_determine_each_other() {
    let oracle = compiled(
        "formulation: loops;
        gravity: 9.81 m/s^2;
        ground { port low: (0, 0) m, axis: 20 deg; port high: (-0.3*sin(20 deg)*1 m, 0.3*cos(20 deg)*1 m), axis: 20 deg; }
        body first { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start angle: 20 deg; }
        body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; port q: (0.5, 0) m; start angle: 57 deg; }
        body second { mass: 3 kg; inertia: 0.1 kg*m^2; port q: (0, 0) m; start x: 0.28 m; start y: 0.42 m; start angle: 20 deg; }
        prismatic low(ground.low, first.p); prismatic high(ground.high, second.q);
        revolute p(first.p, bar.p); revolute q(bar.q, second.q);",
    );
    assert_eq!(oracle.reduced_states(), Some(2));
    // The bar of 0.5 m rises by 0.3 m from rail to rail: 3, 4, 5.
    let (axis, rise) = (20_f64.to_radians(), 0.6_f64.asin());
    let (sin, cos) = axis.sin_cos();
    let at = |along: f64, across: f64| [along * cos - across * sin, along * sin + across * cos];
    let pose = |[x, y]: [f64; 2], angle: f64| [x, y, angle];
    let q = [pose(at(0.2, 0.0), axis), pose(at(0.2, 0.0), axis + rise), pose(at(0.6, 0.3), axis)].concat();
    let v = [at(0.7, 0.0), at(0.7, 0.0), at(0.7, 0.0)].map(|v| pose(v, 0.0)).concat();
    let x = [q, v].concat();
    let charts = oracle.charts(0.0, &x);
    assert!(!charts.is_empty());
    for chart in charts {
        // All slide down together.
        let down = -9.81 * sin;
        assert!((chart.acceleration[0] - down).abs() < 1e-12, "{chart:?}");
        let apart = chart.pose.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-12 && chart.measure > 0.1, "{chart:?}");
    }
}

/// A hinge whose rows ask along the axis of either body: they say the same where both axes are parallel.
const HINGE: &str = "joint hinge(a: frame, b: frame) {
        pair: revolute;
        let between = b.position - a.position;
        constraint first: dot(between, a.axis) = 0;
        constraint second: dot(between, b.axis) = 0;
        output force = reaction(first, second);
    }";

/// From the tips inwards each joint costs a system of its own, whose determinant must not depend on the pose: there it would
/// vanish. Then the equations of all bodies are solved at once, by rank where they have to be.
#[test]
fn reactions_in_directions_that_turn_are_not_found_body_by_body() {
    for (joint, body_by_body) in [("revolute", true), ("hinge", false)] {
        let oracle = compiled(&format!(
            "gravity: 9.81 m/s^2; {HINGE}
            ground {{ port o: (0, 0) m; }}
            body arm {{ mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; start angle: 40 deg, locked; }}
            {joint} pin(ground.o, arm.o); output pin.force;"
        ));
        // A tree all the same: the pair says how it moves.
        assert_eq!(oracle.reduced_states(), Some(2), "{joint}");
        let x = [0.5, 0.0, 0.0, 0.0, 0.5, 1.0];
        let found = oracle.accelerations(0.0, &x);
        assert_eq!(found.is_some(), body_by_body, "{joint}: {found:?}");
        // m g r / (J + m r^2) about the pin, and towards it w^2 r.
        let turning = -9.81 * 0.5 * 2.0 / (0.1 + 2.0 * 0.25);
        let known = [-0.5, 0.5 * turning, turning];
        for (found, known) in found.unwrap_or(known.to_vec()).iter().zip(known) {
            assert!((found - known).abs() < 1e-12, "{joint}: {found} instead of {known}");
        }
    }
}

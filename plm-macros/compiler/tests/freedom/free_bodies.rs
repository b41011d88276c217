//! Rows that give the place of a body which no joint holds: rolling wheels, cams, rails.

use plm_compiler::compile;
use plm_compiler::token::Sources;

/// A wheel that rolls on a line, with a rod that swings on it; a body on a curved rail; one on a slanted rail.
const SCENES: [(&str, usize, &str); 3] = [
    (
        "a wheel that rolls",
        2,
        "body w { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0.1, 0) m; }
         body rod { mass: 0.5 kg; inertia: 0.1 kg*m^2; port p: (-0.3, 0) m; start angle: 20 deg; }
         revolute pin(w.p, rod.p);
         constraint on: w.y - 0.2 m = 0; constraint roll: w.x + 0.2 m*w.angle = 0;",
    ),
    (
        "a cam that lifts a body",
        2,
        "body w { mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; start x: 0.3 m; }
         revolute pin(ground.o, w.p);
         body f { mass: 0.5 kg; inertia: 0.1 kg*m^2; port p: (0, 0) m; }
         constraint cam: f.y - 0.1 m*sin(w.angle) = 0; constraint guide: f.x - 0.3*f.y = 0.2 m;",
    ),
    (
        "a body on a slanted rail",
        2,
        "body w { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0, 0) m; }
         constraint on: w.y - 0.5*w.x - 0.2 m = 0 m;",
    ),
];

/// In joint coordinates and in absolute ones, from the same pose: the same accelerations.
#[test]
fn rows_hold_free_bodies_in_every_formulation() {
    for (name, freedom, items) in SCENES {
        let mut sources = Sources::new();
        let ground = "gravity: 9.81 m/s^2; ground { port o: (0, 0) m; }";
        sources.add_text("declaration", &format!("pub R {{ {ground} {items} }}"));
        let expansion = compile(&mut sources);
        let told: Vec<String> = expansion.diagnostics.sorted().iter().map(|d| d.render(&sources)).collect();
        assert!(told.is_empty(), "{name}: {}", told.concat());
        let oracle = expansion.oracle.unwrap();
        assert_eq!(oracle.reduced_states(), Some(2 * freedom), "{name}");
        let bodies = oracle.states() / 2;
        // Somewhere: the first chart that can say so gives the pose that goes with it.
        let anywhere: Vec<f64> = (0..2 * bodies).map(|k| 0.3 + 0.17 * ((7 * k) % 5) as f64).collect();
        let charts = oracle.charts(0.0, &anywhere);
        let x = charts[0].pose.clone();
        let gap = [oracle.phi(0.0, &x), oracle.phi_dot(0.0, &x)].concat();
        assert!(gap.iter().all(|gap| gap.abs() < 1e-14), "{name}: open by {gap:?}");
        let absolute = oracle.dynamics(0.0, &x);
        let expected = &absolute[bodies..2 * bodies];
        let found = oracle.accelerations(0.0, &x).unwrap();
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{name}: {found} instead of {expected}");
        }
    }
}

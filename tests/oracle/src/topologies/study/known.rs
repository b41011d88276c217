//! Two linkages whose straight lines are known in closed form, rated as the six-bars are.

use plm_dynamic::Error;

use super::chains::Point;
use super::straight::{Portion, portion_of};
use super::trace::{SAMPLES, path, trace};

/// Chebyshev's lambda, with crank 100 mm, pivots 200 mm, rocker 250 mm, coupler 250 + 250 mm (P. L. Chebyshev, Théorie des
/// mécanismes connus sous le nom de parallélogrammes, 1854).
const LAMBDA: &str = "pub Lambda {
    ground { port o: (0, 0) mm; port c: (200, 0) mm; }
    body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) mm; port a: (100, 0) mm; start angle: 0 deg; }
    body coupler { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (-250, 0) mm; port b: (0, 0) mm; start angle: 78 deg; }
    body rocker { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) mm; port b: (250, 0) mm; start x: 200 mm; start angle: 102 deg; }
    revolute main(ground.o, crank.o);
    revolute pin(crank.a, coupler.a);
    revolute middle(coupler.b, rocker.b);
    revolute pivot(ground.c, rocker.c);
    constraint turn: crank.angle = 2*pi*t/(1 s);
}";
const OF_LAMBDA: Point = Point { body: 1, at: [250, 0] };

/// Peaucellier's cell, with long bars 500 mm, short bars 250 mm, crank 170 mm (C.-N. Peaucellier, letter to the Nouvelles annales de
/// mathématiques, 1864).
const PEAUCELLIER: &str = "pub Peaucellier {
    ground { port o: (0, 0) mm; port q: (170, 0) mm; }
    body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port q: (0, 0) mm; port c: (170, 0) mm; start x: 170 mm; }
    body upper { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) mm; port a: (500, 0) mm; start angle: 24 deg; }
    body lower { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) mm; port b: (500, 0) mm; start angle: -24 deg; }
    body near_upper { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) mm; port a: (250, 0) mm; start angle: 60 deg; }
    body near_lower { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) mm; port b: (250, 0) mm; start angle: -60 deg; }
    body far_upper { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) mm; port d: (250, 0) mm; start angle: -60 deg; }
    body far_lower { mass: 1 kg; inertia: 0.01 kg*m^2; port b: (0, 0) mm; port d: (250, 0) mm; start angle: 60 deg; }
    revolute q(ground.q, crank.q);
    revolute o_upper(ground.o, upper.o);
    revolute o_lower(ground.o, lower.o);
    revolute c_upper(crank.c, near_upper.c);
    revolute c_lower(crank.c, near_lower.c);
    revolute a_near(upper.a, near_upper.a);
    revolute a_far(upper.a, far_upper.a);
    revolute b_near(lower.b, near_lower.b);
    revolute b_far(lower.b, far_lower.b);
    revolute d(far_upper.d, far_lower.d);
    constraint turn: crank.angle = 60 deg*sin(2*pi*t/(1 s));
}";
const OF_PEAUCELLIER: Point = Point { body: 5, at: [250, 0] };

/// A rating beside what it must be.
#[derive(Clone, Copy, Debug)]
pub struct Known {
    pub name: &'static str,
    pub rated: Portion,
    /// Length and deviation in closed form, m.
    pub length: f64,
    pub deviation: f64,
    /// The most by which the deviation can be off, m, since the path has samples.
    pub within: f64,
}

impl Known {
    pub fn holds(&self) -> bool {
        (self.rated.length - self.length).abs() < 1e-12
            && (self.rated.deviation - self.deviation).abs() <= self.within
    }
}

/// Both linkages.
///
/// # Errors
/// As [`trace`].
pub fn all() -> Result<[Known; 2], Error> {
    let lambda = path(&trace(LAMBDA)?, OF_LAMBDA);
    let peaucellier = path(&trace(PEAUCELLIER)?, OF_PEAUCELLIER);
    // Half a turn, 90 to 270 deg. With u the cosine of the crank's angle, y^2 = (2 - u)^2 (20 + 4 u)/(5 - 4 u) r^2: 16 r^2 at the ends and
    // in the middle, 1029/64 r^2 at u = -5/8. Half the height of the bow is the deviation.
    let bow = 0.1 * (1029_f64.sqrt() / 8.0 - 4.0);
    Ok([
        Known {
            name: "Chebyshev's lambda",
            rated: portion_of(&lambda, SAMPLES / 4, SAMPLES / 2 + 1),
            length: 0.4,
            deviation: 0.5 * bow,
            within: 1e-3 * bow,
        },
        // D runs on x = (L^2 - l^2)/(2 r), where the line from O turns by half as much as the crank.
        Known {
            name: "Peaucellier's cell",
            rated: portion_of(&peaucellier, 0, SAMPLES),
            length: (0.5 * 0.5 - 0.25 * 0.25) / 0.17 * 30_f64.to_radians().tan(),
            deviation: 0.0,
            within: 1e-12,
        },
    ])
}

//! The Peaucellier-Lipkin linkage: the first that turns a circle into a line, exactly.
//!
//! Source: C.-N. Peaucellier, letter to the Nouvelles annales de mathématiques, 1864; L. Lipkin, 1870. Of the cell
//! `OC OD = L^2 - l^2`; C runs on a circle through O, and so D on the line `x = (L^2 - l^2)/(2 r)`. The lengths are our own:
//!
//! | long bars L | short bars l | crank r |
//! |---|---|---|
//! | 500 mm | 250 mm | 170 mm |

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// Peaucellier's cell, whose crank is swung to and fro.
    pub Peaucellier {
        param swing: rad = 60 deg;
        param period: s = 4 s;
        let long = rod(1 kg, 0.5 m);
        let short = rod(0.5 kg, 0.25 m);
        ground { port o: (0, 0) mm; port q: (170, 0) mm; }
        body crank { mass: 1 kg; inertia: rod(1 kg, 0.17 m); port q: (0, 0) mm; port c: (170, 0) mm; start x: 170 mm; }
        body upper { mass: 1 kg; inertia: long; port o: (0, 0) mm; port a: (500, 0) mm; start angle: 24 deg; }
        body lower { mass: 1 kg; inertia: long; port o: (0, 0) mm; port b: (500, 0) mm; start angle: -24 deg; }
        body near_upper { mass: 0.5 kg; inertia: short; port c: (0, 0) mm; port a: (250, 0) mm; start angle: 60 deg; }
        body near_lower { mass: 0.5 kg; inertia: short; port c: (0, 0) mm; port b: (250, 0) mm; start angle: -60 deg; }
        body far_upper { mass: 0.5 kg; inertia: short; port a: (0, 0) mm; port d: (250, 0) mm; start angle: -60 deg; }
        body far_lower { mass: 0.5 kg; inertia: short; port b: (0, 0) mm; port d: (250, 0) mm; start angle: 60 deg; }
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
        constraint drive: crank.angle = swing*sin(2*pi*t/period);
        output far_upper.d.position;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Peaucellier::new()).until(4.0).every(0.02).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Peaucellier::new()).until(4.0).every(0.02).with(options)
}

//! Linkages that pass through poses where their bars lie in one line: the rank of phi_q falls there, and the branches of
//! the motion cross.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt::Write as _;

use plm_oracle::Look;
use plm_run::AnySim;
use plm_runtime::{Described, Moment};

use super::run::{Trace, gap, trace};
use super::theory::{self, wrapped};
use crate::text::{By, Given as _, Large, Named as _, Scene, large, scene};

/// S4 (the N-four-bar mechanism of the IFToMM benchmarks, problem A02): N windows of uprights and tops of 1 m and 1 kg, with more items.
///
/// The uprights start upright with the tops at 1 m/s. At the flat pose the mobility rises from 1 to N + 1.
fn declaration(windows: usize, items: &str) -> String {
    let (mut ports, mut feet) = (String::new(), String::new());
    for k in 0..=windows {
        let _ = write!(ports, " port f{k}: ({k}, 0) m;");
        let _ = writeln!(feet, "    revolute foot[{k}](ground.f{k}, up[{k}].low);");
    }
    format!(
        "pub Ladder {{
    {items}
    gravity: 9.81 m/s^2;
    ground {{{ports} }}
    repeat i in 0..={windows} {{
        body up[i] {{
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port low: (-0.5, 0) m;
            port high: (0.5, 0) m;
            start x: i*1 m;
            start y: 0.5 m;
            start angle: 90 deg;
            start vx: 0.5 m/s;
            start omega: -1 rad/s;
        }}
    }}
    repeat i in 1..={windows} {{
        body top[i] {{
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port a: (-0.5, 0) m;
            port b: (0.5, 0) m;
            start x: (i - 0.5)*1 m;
            start y: 1 m;
            start vx: 1 m/s;
        }}
        revolute left[i](up[i - 1].high, top[i].a);
        revolute right[i](top[i].b, up[i].high);
    }}
{feet}}}
"
    )
}

/// A ladder of one or two windows.
pub fn ladder(windows: usize) -> Scene {
    scene(&declaration(windows, ""))
}

/// A ladder of more windows.
pub fn long_ladder(windows: usize) -> Large {
    large(&declaration(windows, ""))
}

/// A ladder of five windows whose tops start at a speed, m/s.
pub fn ladder_at(speed: f64) -> Large {
    let ups = (0..=5).fold(long_ladder(5), |ladder, k| {
        ladder.with_start(&format!("up[{k}].vx"), 0.5 * speed).with_start(&format!("up[{k}].omega"), -speed)
    });
    (1..=5).fold(ups, |ladder, k| ladder.with_start(&format!("top[{k}].vx"), speed))
}

/// Two windows in absolute coordinates, with Baumgarte's stabilisation so slow that there is none.
pub fn adrift() -> Scene {
    scene(&declaration(2, "formulation: absolute; stabilisation: baumgarte(1e9 s);"))
}

/// What is read of a ladder.
pub trait Ladder {
    /// How many windows it has.
    fn windows(&self) -> usize;
    /// Angle of the first upright, rad.
    fn upright(&self) -> f64;
    /// Speed of the first top while the uprights stand upright, m/s.
    fn speed(&self) -> f64;
    /// The gap at the ends of the first and the last top, m.
    fn apart(&self) -> f64;
    /// Difference of the first and the last upright, and angle of the first and last top, rad: other branches have it.
    fn askew(&self) -> f64;
    /// Energy, J.
    fn energy(&self) -> f64;
}

impl<M: Described<S = f64, State = T> + Look, T: Moment<M = M>> Ladder for T {
    fn windows(&self) -> usize {
        self.mechanism().tables().bodies.len() / 2
    }

    fn upright(&self) -> f64 {
        self.body_of("up[0]").angle
    }

    fn speed(&self) -> f64 {
        self.body_of("top[1]").vx
    }

    fn apart(&self) -> f64 {
        let last = self.windows();
        let (first, up) = (self.body_of("up[0]"), self.body_of(&format!("up[{last}]")));
        let left = gap(first.point(0.5, 0.0), self.body_of("top[1]").point(-0.5, 0.0));
        left.max(gap(up.point(0.5, 0.0), self.body_of(&format!("top[{last}]")).point(0.5, 0.0)))
    }

    fn askew(&self) -> f64 {
        let last = self.windows();
        let lean = (self.body_of("up[0]").angle - self.body_of(&format!("up[{last}]")).angle).abs();
        lean.max(self.body_of("top[1]").angle.abs()).max(self.body_of(&format!("top[{last}]")).angle.abs())
    }

    fn energy(&self) -> f64 {
        let [kinetic, gravity] = M::energies(self);
        kinetic + gravity
    }
}

/// Energy (relative change), gap (m), askewness (rad) and angle from upright (rad) of a ladder over so many turns.
pub fn turning<M: By<S = f64, State: Ladder>>(sim: &mut AnySim<M>, turns: u32, samples: u32) -> Trace<4> {
    let turn = theory::ladder_period(sim.state().windows() as u32, sim.state().speed());
    let energy = sim.state().energy();
    trace(sim, f64::from(turns) * turn, turn / f64::from(samples), |s| {
        [s.energy() / energy - 1.0, s.apart(), s.askew(), s.upright() - FRAC_PI_2]
    })
}

pub fn parallelogram() -> Scene {
    scene(include_str!("../declared/parallelogram.plm"))
}

pub fn folded() -> Scene {
    scene(include_str!("../declared/folded.plm"))
}

pub fn equal_bars() -> Scene {
    scene(include_str!("../declared/equal_bars.plm"))
}

/// Energy (relative change), angle between the bars and angle from that of a turn at constant speed, rad.
pub fn turning_parallelogram(sim: &mut AnySim<Scene>, turns: u32) -> Trace<3> {
    let energy = sim.kinetic_energy();
    trace(sim, f64::from(turns) * TAU, TAU / 100.0, |s| {
        let askew =
            (s.body_of("left").angle - s.body_of("right").angle).abs().max(s.body_of("top").angle.abs());
        [s.kinetic_energy() / energy - 1.0, askew, s.body_of("left").angle - (FRAC_PI_2 + s.time())]
    })
}

/// Energy (J), angle of the rod from the mirror image of the crank (rad), gap at the pin (m).
pub fn folding(sim: &mut AnySim<Scene>, until: f64) -> Trace<3> {
    trace(sim, until, 0.01, |s| {
        let (crank, rod) = (s.body_of("crank"), s.body_of("rod"));
        let open = gap(crank.point(0.5, 0.0), rod.point(-0.5, 0.0));
        [s.kinetic_energy() + s.gravity_energy(), wrapped(crank.angle + rod.angle), open]
    })
}

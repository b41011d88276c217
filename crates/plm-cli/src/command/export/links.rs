//! `plm export --dxf` and `--svg`: the links of a mechanism in true size, over its motion.

use std::path::PathBuf;

use plm_compiler::Assembled;
use plm_dynamic::{Mechanism, OnRun, Run};
use plm_import::{Cutting, Drawing, Links, PlaceOf, to_links};
use plm_runtime::{Described, Method, Sim};

use crate::command::Failure;
use crate::command::words::Words;

/// Poses of a motion at which it is asked which links meet.
const POSES: u32 = 360;

/// Links that are wanted.
pub(super) struct Wanted {
    pub(super) folder: PathBuf,
    drawing: Drawing,
    cutting: Cutting,
    /// The end of the motion, s; without one the start alone is looked at.
    until: Option<f64>,
}

impl Wanted {
    /// Takes `--dxf` and `--svg`, with their own options.
    pub(super) fn asked(words: &mut Words) -> Result<Vec<Wanted>, Failure> {
        let folders = [("--dxf", Drawing::Dxf), ("--svg", Drawing::Svg)]
            .map(|(option, drawing)| words.value(option).map(|folder| (folder, drawing)));
        let mut given = Vec::new();
        let mut size = |option: &'static str, default: f64, least: f64| -> Result<f64, Failure> {
            let Some(text) = words.value(option) else { return Ok(default) };
            given.push(option);
            let number = text.parse().ok().filter(|number: &f64| number.is_finite() && *number >= least);
            let number = number.ok_or_else(|| format!("{option} is a number from {least}, not `{text}`"))?;
            Ok(number)
        };
        let usual = Cutting::default();
        // A tenth of a millimetre is less than any pin has.
        let cutting = Cutting {
            hole: 1e-3 * size("--hole", 1e3 * usual.hole, 0.1)?,
            width: 1e-3 * size("--width", 1e3 * usual.width, 0.1)?,
            kerf: 1e-3 * size("--kerf", 1e3 * usual.kerf, 0.0)?,
        };
        let until = size("--until", 0.0, 0.0)?;
        if cutting.kerf >= cutting.hole {
            return Err("--kerf is wider than the holes are".into());
        }
        let wanted: Vec<Wanted> = folders
            .into_iter()
            .flatten()
            .map(|(folder, drawing)| Wanted {
                folder: folder.into(),
                drawing,
                cutting,
                until: (until > 0.0).then_some(until),
            })
            .collect();
        match given.first() {
            Some(option) if wanted.is_empty() => Err(format!("{option} is of --dxf and --svg").into()),
            _ => Ok(wanted),
        }
    }

    /// The drawings and tables, and why the motion ends early if it does.
    pub(super) fn links(
        &self,
        mechanism: &Assembled,
        text: (&str, &str),
        place: PlaceOf,
    ) -> Result<(Links, Option<String>), Failure> {
        let start: Vec<[f64; 3]> = mechanism.bodies.iter().map(|body| body.pose).collect();
        let mut motion = vec![start];
        let ended = match self.until {
            None => None,
            Some(until) => {
                let mut run =
                    Mechanism::from_named_text(text.0, text.1).map_err(|error| error.to_string())?.start()?;
                follow(&mut run, until, &mut motion)
            }
        };
        Ok((to_links(mechanism, &motion, self.drawing, &self.cutting, place), ended))
    }
}

/// Adds the poses of a run; says why it ends early if it does.
fn follow(run: &mut Run, until: f64, motion: &mut Vec<Vec<[f64; 3]>>) -> Option<String> {
    let start = run.time();
    for k in 1..=POSES {
        let time = start + (until - start) * f64::from(k) / f64::from(POSES);
        if let Err(why) = run.step_to(time) {
            return Some(format!("the motion is that until {} s: {why}", run.time()));
        }
        motion.push(run.then(Poses));
    }
    None
}

/// The present poses.
struct Poses;

impl OnRun for Poses {
    type Output = Vec<[f64; 3]>;

    fn on<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Vec<[f64; 3]> {
        let mut poses = Vec::new();
        M::poses(sim.state(), &mut |pose| poses.push([pose.x, pose.y, pose.angle]));
        poses
    }
}

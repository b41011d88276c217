//! The program of a mechanism, and which formulation it takes.

use super::absolute::Absolute;
use super::function::Function;
use super::outputs;
use super::reduced::{self, Assembled, Known, Reduced};
use crate::collect::MapEach;
use crate::derive::{Equations, feeds_back};
use crate::model::{Formulation, Model, Output, Stabilisation};
use crate::numeric::{Assembly, Reach, Scene, add_switches, assemble, freedom, varied};

/// Values of parameters that are tried until the joints close.
const VARIATIONS: u64 = 8;

/// All computations, function by function.
pub(crate) struct Program {
    /// Absolute coordinates and multipliers: assembly, reactions and the fallback need them whatever is taken.
    pub(crate) absolute: Absolute,
    /// Joint coordinates, if they are taken; else why not, in words that go on "absolute coordinates, because …".
    pub(crate) reduced: Result<Reduced, String>,
}

impl Program {
    /// A program; of absolute coordinates that are taken, with what implicit methods need.
    pub(crate) fn new(
        model: &Model,
        equations: &Equations,
        mut absolute: Absolute,
        reduced: Result<Reduced, String>,
    ) -> Program {
        if reduced.is_err() {
            absolute.linearise(model, equations);
        }
        Program { absolute, reduced }
    }

    /// Joint coordinates, if they are taken.
    pub(crate) fn reduced(&self) -> Option<&Reduced> {
        self.reduced.as_ref().ok()
    }

    /// The right-hand side that a run begins with, where no chart is flat.
    pub(crate) fn rate(&self) -> &Function {
        let first = self.reduced().and_then(Reduced::first);
        first.map_or(&self.absolute.dynamics, |chart| &chart.rate)
    }

    /// Adds outputs that can be read and take no part in a step.
    pub(crate) fn observe(&mut self, outputs: &[Output], equations: &Equations) {
        self.absolute.outputs.user.extend(outputs::user(outputs, equations));
    }
}

/// Joint coordinates of a scene, if they are to be taken; `start` is needed only where rows close loops.
///
/// # Errors
/// Why absolute coordinates are taken instead.
pub(crate) fn reduce(scene: &Scene, start: Option<&Assembly>) -> Result<Reduced, String> {
    let &Scene { model, equations, absolute, length, .. } = scene;
    if let Some((Formulation::Absolute, _)) = model.formulation {
        return Err("it is ordered".to_owned());
    }
    if let Stabilisation::Baumgarte(_) = model.stabilisation {
        return Err("Baumgarte's method is ordered".to_owned());
    }
    if feeds_back(model) {
        return Err("forces or rates read accelerations or reactions".to_owned());
    }
    let assembled = || {
        let start = start.filter(|start| start.is_closed())?;
        let mut values = scene.moving(&start.q, &start.v);
        add_switches(model, &mut values);
        Some(Assembled { length, freedom: freedom(scene, start), values })
    };
    // With other values of the parameters, dimensions do not make rows say what others say.
    let freedom_elsewhere = || {
        (1..=VARIATIONS).find_map(|seed| {
            let elsewhere = Scene::new(model, equations, absolute, varied(model, seed)?);
            let start = assemble(&elsewhere, Reach::Near);
            start.is_closed().then(|| freedom(&elsewhere, &start))
        })
    };
    let lambda = absolute.multipliers();
    let known =
        Known { length, lambda: &lambda, assembled: &assembled, freedom_elsewhere: &freedom_elsewhere };
    let reduced = reduced::formulate(model, equations, known)?;
    if model.formulation.is_some() { Ok(reduced) } else { cheaper(reduced, absolute) }
}

/// Joint coordinates, but for those whose loops are iterated only if they have fewer operations than absolute coordinates:
/// iterations can take more.
fn cheaper(reduced: Reduced, absolute: &Absolute) -> Result<Reduced, String> {
    let Some(chart) = reduced.first().filter(|_| reduced.iterates()) else { return Ok(reduced) };
    let [iterated, absolute] = [&chart.rate, &absolute.dynamics].map_each(|form| form.tape().count().total());
    if iterated < absolute {
        return Ok(reduced);
    }
    let groups = chart.groups.join("; ");
    Err(format!("its loops need {groups}: {iterated} operations, and absolute coordinates {absolute}"))
}

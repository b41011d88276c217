//! How everything moves with the coordinates of a chart.

use plm_cas::{Expr, Rotation};

use crate::formulate::reduced::charts::Scheme;
use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::memory::Memory;
use crate::model::Model;

/// Solves the groups of a scheme, one after the other. Coordinates that are angles or centres keep the symbols of their
/// bodies; displacements get their own.
pub(crate) fn kinematics<'a>(
    model: &Model,
    coordinates: &'a Coordinates,
    scheme: &Scheme,
    memory: &Memory,
    length: Expr,
) -> Motion<'a> {
    let mut motion = Motion::still(model, coordinates, length);
    let paced = scheme.independent.len() == 1 && !coordinates.moves_with(model.time);
    for (place, &unknown) in scheme.independent.iter().enumerate() {
        let (value, rate) = symbols(model, coordinates.unknowns[unknown]);
        motion.pace = paced.then_some(rate);
        (motion.value[unknown], motion.rate[unknown]) = (value, rate);
        for coefficients in &mut motion.coefficient {
            coefficients.push(Expr::ZERO);
        }
        motion.coefficient[unknown][place] = Expr::ONE;
        motion.independent.push(unknown);
        if let Unknown::Angle { orientation, .. } = coordinates.unknowns[unknown] {
            motion.rotation[orientation] = Rotation::by(value);
            motion.omega[orientation] = rate;
            motion.turning[orientation] = if paced { Expr::ONE } else { rate };
        }
    }
    for group in &scheme.groups {
        let place = motion.solutions.len();
        group.solve(&mut motion, (memory, place));
    }
    motion.pose_bodies(model);
    motion.substitute_absolute_angles(model);
    motion
}

fn symbols(model: &Model, unknown: Unknown) -> (Expr, Expr) {
    match unknown {
        Unknown::Angle { body, .. } => (model.bodies[body].q[2], model.bodies[body].v[2]),
        Unknown::Centre { body, axis } => (model.bodies[body].q[axis], model.bodies[body].v[axis]),
        Unknown::Displacement { part } => {
            let name = &model.parts[part].name.text;
            (Expr::symbol(format!("s_{name}")), Expr::symbol(format!("v_{name}")))
        }
    }
}

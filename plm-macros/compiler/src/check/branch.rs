//! Mirror images that joints ask for and that cannot be had.

use crate::collect::MapEach;
use crate::derive::Equations;
use crate::diag::{Code, Diagnostics};
use crate::model::Model;
use crate::numeric::{self, Assembly, Scene};

/// A joint that asks for a branch must tell one.
pub(crate) fn check_branches(model: &Model, equations: &Equations, diagnostics: &mut Diagnostics) {
    for (part, joint) in model.parts.iter().enumerate() {
        let Some((_, span)) = joint.branch else { continue };
        if equations.branches.iter().all(|branch| branch.part != part) {
            let message = format!("`{}` tells no mirror images apart", joint.name.text);
            diagnostics.error(Code::UnknownField, span, message).note(
                "a revolute does that is rigid and joins two bodies, each of which has another joint or its G elsewhere",
            );
        }
    }
}

/// Reports the first joint whose image was not found.
pub(super) fn not_found(scene: &Scene, found: &Assembly, diagnostics: &mut Diagnostics) {
    let asked = numeric::asked(scene);
    let Some(wrong) = asked.iter().find(|asked| !asked.is_met(&found.q)) else { return };
    let joint = &scene.model.parts[wrong.part];
    let Some((turn, span)) = joint.branch else { return };
    let [first, second] = wrong.bodies.map_each(|body| &scene.model.bodies[body].name.text);
    let (asked, found) = (turn.name(), turn.other().name());
    let pin = &joint.name.text;
    let message = format!(
        "at `{pin}`, `{second}` turns {found} from `{first}`; no pose was found where it turns {asked}"
    );
    let which = format!(
        "which image is which: on the way along `{first}` to `{pin}` and on along `{second}` one turns to the {found} here; a \
         picture is in the book (Assembly, Branches)"
    );
    diagnostics.error(Code::OtherBranch, span, message).note(which).help(
        "put the start angles of the loop near to the pose that is meant, or take away locks that forbid it",
    );
}

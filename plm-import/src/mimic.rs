//! Joints that follow others: `<mimic>` of URDF and of SDF.

use std::collections::BTreeMap;

use crate::notice::Notices;
use crate::spatial::{Coupling, Spatial};
use crate::xml::Element;

/// Adds what the `<mimic>` within `element` says of the joint with this number: `multiplier · (q − reference) + offset`.
pub(crate) fn read(
    element: &Element,
    joint: usize,
    joints: &BTreeMap<String, usize>,
    spatial: &mut Spatial,
    notices: &mut Notices,
) {
    let Some(mimic) = element.child("mimic") else { return };
    let name = mimic.get("joint").unwrap_or_default();
    let Some(&of) = joints.get(name) else {
        notices.error(&mimic.place, format!("<mimic>: there is no joint `{name}`"));
        return;
    };
    let mut value = |tag: &str| mimic.number(tag, notices).or_else(|| mimic.child_number(tag, notices));
    let multiplier = value("multiplier").unwrap_or(1.0);
    let offset = value("offset").unwrap_or_default() - multiplier * value("reference").unwrap_or_default();
    let own = element.get("name").or_else(|| spatial.joints.get(joint).map(|joint| joint.name.as_str()));
    spatial.couplings.push(Coupling {
        name: format!("{}_follows", own.unwrap_or("joint")),
        place: mimic.place.clone(),
        joint,
        of: Some(of),
        coefficients: [offset, multiplier, 0.0, 0.0, 0.0],
    });
}

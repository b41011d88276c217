//! Joints that follow others: `<mimic>` of URDF and of SDF.

use crate::notice::Notices;
use crate::spatial::{Coupling, Spatial};
use crate::xml::Element;

/// Adds the coupling of the `<mimic>` within `element` to the joint with this number: `multiplier · (q − reference) + offset`.
/// `number_of` gives the number of a joint by its name.
pub(crate) fn read(
    element: &Element,
    joint: usize,
    number_of: impl Fn(&str) -> Option<usize>,
    spatial: &mut Spatial,
    notices: &mut Notices,
) {
    let Some(mimic) = element.child("mimic").or_else(|| element.child("drake:mimic")) else { return };
    let name = mimic.get("joint").unwrap_or_default();
    let Some(of) = number_of(name) else {
        notices.error(&mimic.place, format!("<mimic>: there is no joint `{name}`"));
        return;
    };
    let mut value = |tag: &str| mimic.number(tag, notices).or_else(|| mimic.child_number(tag, notices));
    let multiplier = value("multiplier").unwrap_or(1.0);
    let offset = value("offset").unwrap_or_default() - multiplier * value("reference").unwrap_or_default();
    spatial.couplings.push(Coupling {
        name: format!("{}_follows", spatial.joints[joint].name),
        place: mimic.place.clone(),
        joint,
        of: Some(of),
        coefficients: [offset, multiplier, 0.0, 0.0, 0.0],
    });
}

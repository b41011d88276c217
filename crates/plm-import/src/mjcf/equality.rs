//! `<equality>`: loops that are closed, and joints that follow others.

use super::Reader;
use super::compiler::Effect;
use crate::notice::Told;
use crate::space::Pose;
use crate::spatial::{Coupling, Joint, Kind};
use crate::xml::Element;

impl Reader<'_> {
    pub(super) fn equality(&mut self, element: &Element) {
        let element = self.defaults.styled(element, None, self.notices);
        if !self.compiler.has(Effect::Equality) {
            return;
        }
        if element.get("active") == Some("false") {
            self.notices.warn(&element.place, format!("{} is not active: it is left out", element.shown()));
            return;
        }
        match element.name.as_str() {
            "connect" => self.connect(&element),
            "weld" => self.weld(&element),
            "joint" => self.follow(&element),
            _ => self.notices.error(&element.place, format!("{} is not taken", element.shown())),
        }
    }

    fn name(&self, element: &Element) -> String {
        element
            .get("name")
            .map_or_else(|| format!("{}_{}", element.name, self.spatial.joints.len() + 1), str::to_owned)
    }

    /// The link that an attribute names; without it the world.
    fn end(&mut self, element: &Element, attribute: &str) -> Result<Option<usize>, Told> {
        let Some(name) = element.get(attribute) else { return Ok(None) };
        let found = self.bodies.get(name).copied();
        if found.is_none() && name != "world" {
            self.notices.error(&element.place, format!("{}: there is no body `{name}`", element.shown()));
            return Err(Told);
        }
        Ok(found)
    }

    fn pose(&self, link: Option<usize>) -> Pose {
        link.map_or(Pose::HERE, |link| self.spatial.links[link].pose)
    }

    fn connect(&mut self, element: &Element) {
        let name = self.name(element);
        let mut joint =
            Joint::new(&name, &element.place, Kind::Point, [None, None], [0.0; 3], [0.0, 0.0, 1.0]);
        if element.get("site1").is_some() {
            let mut ends = [(None, [0.0; 3]); 2];
            for (end, attribute) in ends.iter_mut().zip(["site1", "site2"]) {
                let name = element.get(attribute).unwrap_or_default();
                let Some((link, site)) = self.sites.get(name) else {
                    self.notices
                        .error(&element.place, format!("{}: there is no site `{name}`", element.shown()));
                    return;
                };
                *end = (*link, self.pose(*link).of(site).at);
            }
            [(joint.parent, joint.at), (joint.child, joint.at_child)] = ends;
        } else {
            let (Ok(parent), Ok(child)) = (self.end(element, "body1"), self.end(element, "body2")) else {
                return;
            };
            let anchor = element.exactly("anchor", self.notices).unwrap_or_default();
            (joint.parent, joint.child) = (parent, child);
            joint.at = self.pose(parent).point(anchor);
            joint.at_child = joint.at;
        }
        self.spatial.joints.push(joint);
    }

    fn weld(&mut self, element: &Element) {
        let relative = element.numbers("relpose", self.notices).unwrap_or_default();
        if relative.iter().skip(3).any(|part| *part != 0.0) || element.get("site1").is_some() {
            self.notices.error(
                &element.place,
                format!(
                    "{}: a weld is taken in the pose that is drawn, without relpose and sites",
                    element.shown()
                ),
            );
            return;
        }
        let (Ok(parent), Ok(child)) = (self.end(element, "body1"), self.end(element, "body2")) else {
            return;
        };
        let name = self.name(element);
        let at = self.pose(child).at;
        self.spatial.joints.push(Joint::fixed(&name, &element.place, [parent, child], at));
    }

    /// `<joint>`: a joint follows another one, or is fixed.
    fn follow(&mut self, element: &Element) {
        let mut numbers = [None; 2];
        for (number, attribute) in numbers.iter_mut().zip(["joint1", "joint2"]) {
            let Some(name) = element.get(attribute) else { continue };
            *number = self.joints.get(name).copied();
            if number.is_none() {
                self.notices
                    .error(&element.place, format!("{}: there is no joint `{name}`", element.shown()));
                return;
            }
        }
        let [Some(joint), of] = numbers else { return };
        let mut coefficients = [0.0, 1.0, 0.0, 0.0, 0.0];
        for (coefficient, given) in
            coefficients.iter_mut().zip(element.numbers("polycoef", self.notices).unwrap_or_default())
        {
            *coefficient = given;
        }
        // The polynomial is in what the joints have moved from their references.
        let drawn = |joint: usize| self.spatial.joints[joint].drawn;
        let mut coefficients = of.map_or(coefficients, |of| shifted(coefficients, drawn(of)));
        coefficients[0] += drawn(joint);
        let name = self.name(element);
        self.spatial.couplings.push(Coupling { name, place: element.place.clone(), joint, of, coefficients });
    }
}

/// The polynomial in x that another one is in x − x0 (D. E. Knuth, The Art of Computer Programming 2, 3rd ed., 4.6.4: the scheme of Horner
/// and Shaw).
fn shifted(mut coefficients: [f64; 5], x0: f64) -> [f64; 5] {
    for first in 0..4 {
        for k in (first..4).rev() {
            coefficients[k] -= x0 * coefficients[k + 1];
        }
    }
    coefficients
}

#[cfg(test)]
mod tests {
    use super::shifted;

    #[test]
    fn a_shifted_polynomial_has_the_same_values() {
        let (of_difference, x0) = ([0.5, -2.0, 0.25, 3.0, -1.5], 0.75);
        let at = |coefficients: [f64; 5], x: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
        for x in [-1.0, 0.0, 0.5, 2.0] {
            assert_eq!(at(shifted(of_difference, x0), x), at(of_difference, x - x0));
        }
    }
}

//! `<body>` with its joints, geoms and sites.

use super::Reader;
use super::compiler::{Effect, FromGeoms};
use crate::space::{Matrix, Pose, add, dot, scaled, sub, tensor, turned, unit};
use crate::spatial::{Inertial, Joint, Kind, Link};
use crate::xml::Element;

/// Surroundings of an element: link, its pose, the pose of frames around it within the link, and the class of the bodies around it.
#[derive(Clone)]
struct Around {
    link: Option<usize>,
    pose: Pose,
    frame: Pose,
    class: Option<String>,
}

impl Reader<'_> {
    pub(super) fn world(&mut self, world: &Element) {
        let around = Around {
            link: None,
            pose: Pose::HERE,
            frame: Pose::HERE,
            class: world.get("childclass").map(str::to_owned),
        };
        self.children(world, &around, &mut Vec::new());
    }

    /// Reads what stands within a body; masses of its geoms come to `parts`.
    fn children(&mut self, element: &Element, around: &Around, parts: &mut Vec<Inertial>) {
        for child in &element.children {
            match child.name.as_str() {
                "body" => self.body(child, around),
                "frame" => {
                    for lost in all(child, &["joint", "freejoint", "inertial"]) {
                        let message = format!("{} within a frame is not taken", lost.shown());
                        self.notices.error(&lost.place, message);
                    }
                    let class = child.get("childclass").map(str::to_owned).or(around.class.clone());
                    let frame = around.frame.of(&self.placed(child));
                    self.children(child, &Around { frame, class, ..around.clone() }, parts);
                }
                "site" => self.site(child, around),
                "geom" => self.shape(child, around, parts),
                // They are read with the body.
                "joint" | "freejoint" | "inertial" | "light" | "camera" => {}
                "composite" | "flexcomp" | "replicate" | "attach" => {
                    self.notices.error(&child.place, format!("{} is not taken", child.shown()));
                }
                _ => self.notices.warn(&child.place, format!("{} is not taken", child.shown())),
            }
        }
    }

    fn touches(&mut self, geom: &Element, link: Option<usize>) {
        let mut number = |name| geom.number(name, self.notices).unwrap_or(1.0);
        if number("contype") == 0.0 && number("conaffinity") == 0.0 {
            return;
        }
        self.touching.push(geom.place.clone());
        if let Some(link) = link.filter(|_| self.compiler.has(Effect::Contact)) {
            self.spatial.links[link].touches = true;
        }
    }

    fn body(&mut self, element: &Element, around: &Around) {
        let pose = around.pose.of(&around.frame.of(&self.placed(element)));
        let class = element.get("childclass").map(str::to_owned).or(around.class.clone());
        let number = self.spatial.links.len();
        let name = element.get("name").map_or_else(|| format!("body_{}", number + 1), str::to_owned);
        if element.number("gravcomp", self.notices).is_some_and(|share| share != 0.0) {
            self.notices.error(&element.place, format!("{}: gravcomp is not taken", element.shown()));
        }
        let joints = all(element, &["joint", "freejoint"]);
        // Several joints of a body are joints of bodies without mass between.
        let links: Vec<usize> = (number..number + joints.len().max(1)).collect();
        for k in 1..links.len() {
            self.push_link(&format!("{name}_{k}"), element, pose);
        }
        self.push_link(&name, element, pose);
        let link = number + links.len() - 1;
        self.bodies.insert(name.clone(), link);
        let inner = Around { link: Some(link), pose, frame: Pose::HERE, class };
        let mut parent = around.link;
        for (joint, child) in joints.iter().zip(&links) {
            self.joint(joint, &inner, parent, *child);
            parent = Some(*child);
        }
        if joints.is_empty() {
            let pair = [around.link, Some(link)];
            self.spatial.joints.push(Joint::fixed(&format!("{name}_weld"), &element.place, pair, pose.at));
        }
        let mut parts = Vec::new();
        self.children(element, &inner, &mut parts);
        let inertial = match (element.child("inertial"), self.compiler.from_geoms) {
            (Some(given), FromGeoms::Never | FromGeoms::Else) => self.inertial(given),
            (None, FromGeoms::Never) => None,
            _ => sum(&parts),
        };
        self.spatial.links[link].inertial = inertial;
    }

    fn push_link(&mut self, name: &str, element: &Element, pose: Pose) {
        let (name, place) = (name.to_owned(), element.place.clone());
        self.spatial.links.push(Link {
            name,
            place,
            pose,
            inertial: None,
            shapes: Vec::new(),
            points: Vec::new(),
            touches: false,
        });
    }

    /// The shape of a geom, and its mass.
    fn shape(&mut self, element: &Element, around: &Around, parts: &mut Vec<Inertial>) {
        let geom = self.defaults.styled(element, around.class.as_deref(), self.notices);
        self.touches(&geom, around.link);
        let Some(link) = around.link else { return };
        let Some((mut shape, inertial)) = self.geom(&geom) else { return };
        shape.pose = around.frame.of(&shape.pose);
        parts.extend(inertial.map(|own| Inertial {
            mass: own.mass,
            centre: shape.pose.at,
            tensor: tensor(&shape.pose.turn, &own.tensor),
        }));
        self.spatial.links[link].shapes.push(shape);
    }

    fn inertial(&mut self, element: &Element) -> Option<Inertial> {
        let mass = element.number("mass", self.notices)?;
        let pose = self.placed(element);
        let entries = element.exactly("fullinertia", self.notices).unwrap_or_else(|| {
            let [x, y, z] = element.exactly("diaginertia", self.notices).unwrap_or_default();
            [x, y, z, 0.0, 0.0, 0.0]
        });
        Inertial::new(mass, &pose, entries)
    }

    fn joint(&mut self, element: &Element, around: &Around, parent: Option<usize>, child: usize) {
        let styled = self.defaults.styled(element, around.class.as_deref(), self.notices);
        let kind = match styled.get("type") {
            _ if element.name == "freejoint" => Kind::Free,
            None | Some("hinge") => Kind::Revolute,
            Some("slide") => Kind::Prismatic,
            Some("free") => Kind::Free,
            Some(other) => {
                self.notices
                    .error(&element.place, format!("{}: a {other} joint is not planar", element.shown()));
                return;
            }
        };
        let number = self.spatial.joints.len();
        let name = styled.get("name").map_or_else(|| format!("joint_{}", number + 1), str::to_owned);
        let at = styled.exactly("pos", self.notices).unwrap_or_default();
        let axis = styled.exactly("axis", self.notices).unwrap_or([0.0, 0.0, 1.0]);
        let Some(axis) = unit(turned(&around.pose.turn, axis)) else {
            self.notices.error(&element.place, format!("{}: its axis has no direction", element.shown()));
            return;
        };
        if kind == Kind::Free {
            self.notices.warn(
                &element.place,
                format!("{}: its body moves freely in the plane, and not out of it", element.shown()),
            );
        }
        let pair = [parent, Some(child)];
        let mut joint = Joint::new(&name, &element.place, kind, pair, around.pose.point(at), axis);
        self.act(&styled, &mut joint);
        self.joints.insert(name, number);
        self.spatial.joints.push(joint);
    }

    /// Spring, damper, friction, rotor and limits of a joint.
    fn act(&mut self, styled: &Element, joint: &mut Joint) {
        let angle = if joint.kind == Kind::Revolute { self.compiler.angle } else { 1.0 };
        // Polynomials in newer versions: the first coefficient is that of the linear law.
        let mut linear = |name| {
            let numbers = styled.numbers(name, self.notices).unwrap_or_default();
            if numbers.iter().skip(1).any(|higher| *higher != 0.0) {
                self.notices.error(&styled.place, format!("{}: {name} is not linear", styled.shown()));
            }
            numbers.first().copied().unwrap_or_default()
        };
        let (damping, stiffness) = (linear("damping"), linear("stiffness"));
        let mut number = |name| styled.number(name, self.notices).unwrap_or_default();
        joint.drawn = number("ref") * angle;
        joint.start = joint.drawn;
        joint.rest = number("springref") * angle;
        joint.armature = number("armature");
        if self.compiler.has(Effect::Spring) {
            joint.stiffness = stiffness;
        }
        if self.compiler.has(Effect::Damper) {
            joint.damping = damping;
        }
        if self.compiler.has(Effect::Friction) {
            joint.friction = number("frictionloss");
        }
        let range = self.range(styled, "range", "limited");
        if let Some([lower, upper]) = range.filter(|_| self.compiler.has(Effect::Limit)) {
            (joint.lower, joint.upper) = (Some(lower * angle), Some(upper * angle));
        }
    }

    fn site(&mut self, element: &Element, around: &Around) {
        let site = self.defaults.styled(element, around.class.as_deref(), self.notices);
        let Some(name) = site.get("name") else { return };
        let pose = around.frame.of(&self.placed(&site));
        self.sites.insert(name.to_owned(), (around.link, pose));
        if let Some(link) = around.link {
            self.spatial.links[link].points.push((name.to_owned(), pose));
        }
    }
}

/// The children with these tags.
fn all<'a>(element: &'a Element, names: &[&str]) -> Vec<&'a Element> {
    element.children.iter().filter(|child| names.contains(&child.name.as_str())).collect()
}

/// One mass for several (Steiner's theorem); none of none.
fn sum(parts: &[Inertial]) -> Option<Inertial> {
    let mass: f64 = parts.iter().map(|part| part.mass).sum();
    if mass <= 0.0 {
        return None;
    }
    let centre = parts.iter().fold([0.0; 3], |at, part| add(at, scaled(part.centre, part.mass / mass)));
    let mut tensor: Matrix = [[0.0; 3]; 3];
    for part in parts {
        let d = sub(part.centre, centre);
        for i in 0..3 {
            for j in 0..3 {
                let steiner = if i == j { dot(d, d) } else { 0.0 } - d[i] * d[j];
                tensor[i][j] += part.tensor[i][j] + part.mass * steiner;
            }
        }
    }
    Some(Inertial { mass, centre, tensor })
}

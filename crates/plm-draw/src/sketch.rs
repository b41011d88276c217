//! Sketches: the places of ports as far as the text alone tells them, so that half a mechanism has a picture.
//!
//! Nothing is assembled. Places in absolute axes and in drawings are exact. A body that is written in its own axes has the angle of its
//! start, and stands where the first pin holds it whose other port has a place, or where its start puts its origin.

use std::collections::BTreeMap;

use crate::names::{GROUND, PortName};
use crate::picture::{Picture, Placed, Point, turned};
use crate::sheet::{Axes, Handle, Joint, Sheet};

/// A text as it is drawn before it is a mechanism.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sketch {
    /// Ports that have a place.
    pub picture: Picture,
    /// Those of them whose place is a guess, because assembly may move their body.
    pub guessed: Vec<PortName>,
    /// Parts of pairs of ports, in the order of the text.
    pub parts: Vec<SketchPart>,
}

/// A part between two ports.
#[derive(Clone, Debug, PartialEq)]
pub struct SketchPart {
    /// Its name.
    pub name: String,
    /// The part of the library that it is.
    pub kind: String,
    /// The ports that it joins.
    pub ports: [PortName; 2],
    /// Does it hold both at one place?
    pub is_pin: bool,
}

impl Sheet<'_> {
    /// The text as it is drawn before it is a mechanism.
    pub fn sketch(&self) -> Sketch {
        let handles = self.handles();
        let parts: Vec<SketchPart> = self.joints().into_iter().filter_map(part).collect();
        let mut bodies = Bodies::of(self, &handles);
        while bodies.place_one(&parts) {}
        let placed = |handle: &Handle<'_>| bodies.port(&handle.name);
        let ports: Vec<Placed> = handles.iter().filter_map(placed).collect();
        let is_guessed = |placed: &&Placed| bodies.is_guessed(&placed.name.owner);
        let guessed = ports.iter().filter(is_guessed).map(|placed| placed.name.clone()).collect();
        Sketch { picture: Picture { ports }, guessed, parts }
    }
}

fn part(joint: Joint) -> Option<SketchPart> {
    let is_pin = joint.is_pin();
    let ports = joint.ports.try_into().ok()?;
    Some(SketchPart { name: joint.name, kind: joint.kind, ports, is_pin })
}

/// A body with the places of its ports in the axes in which they are written.
#[derive(Debug)]
struct Outline {
    ports: Vec<(PortName, Point)>,
    /// Its axes from the absolute ones, rad.
    angle: f64,
    /// From the axes of the ports to the absolute ones, rad.
    turn: f64,
    /// The origin of these axes.
    origin: Option<Point>,
    is_guessed: bool,
}

/// The ground and all bodies by name.
struct Bodies(BTreeMap<String, Outline>);

impl Bodies {
    fn of(sheet: &Sheet<'_>, handles: &[Handle<'_>]) -> Bodies {
        let mut bodies: BTreeMap<String, Outline> = BTreeMap::new();
        for handle in handles {
            let Some(at) = handle.place.at() else { continue };
            let outline =
                bodies.entry(handle.name.owner.clone()).or_insert_with(|| Outline::of(sheet, handle));
            outline.ports.push((handle.name.clone(), at));
        }
        Bodies(bodies)
    }

    fn port(&self, name: &PortName) -> Option<Placed> {
        let outline = self.0.get(&name.owner)?;
        let origin = outline.origin?;
        let (_, own) = outline.ports.iter().find(|(other, _)| other == name)?;
        let [x, y] = turned(*own, outline.turn);
        Some(Placed { name: name.clone(), at: [origin[0] + x, origin[1] + y], angle: outline.angle })
    }

    fn is_guessed(&self, owner: &str) -> bool {
        self.0.get(owner).is_some_and(|outline| outline.is_guessed)
    }

    /// Places a body that has no place by a pin whose other port has one; false where there is none.
    fn place_one(&mut self, parts: &[SketchPart]) -> bool {
        for SketchPart { ports: [one, other], .. } in parts.iter().filter(|part| part.is_pin) {
            for (own, held) in [(one, other), (other, one)] {
                let Some(at) = self.port(held).map(|placed| placed.at) else { continue };
                let Some(outline) = self.0.get_mut(&own.owner).filter(|of| of.origin.is_none()) else {
                    continue;
                };
                let Some((_, place)) = outline.ports.iter().find(|(name, _)| name == own) else { continue };
                let [x, y] = turned(*place, outline.turn);
                outline.origin = Some([at[0] - x, at[1] - y]);
                return true;
            }
        }
        false
    }
}

impl Outline {
    /// Without ports, of the body of a port.
    fn of(sheet: &Sheet<'_>, handle: &Handle<'_>) -> Outline {
        let start = |name: &str, zero: &str| {
            let start = handle.body?.starts.iter().find(|start| start.coordinate.text == name)?;
            sheet.literal(&start.value, zero).map(|literal| literal.si())
        };
        let (angle, turn, origin) = match handle.axes {
            Axes::Absolute => (0.0, 0.0, Some([0.0; 2])),
            Axes::Drawing(angle) => (angle, 0.0, Some([0.0; 2])),
            Axes::Own => {
                let angle = start("angle", "rad").unwrap_or_default();
                (angle, angle, start("x", "m").zip(start("y", "m")).map(|(x, y)| [x, y]))
            }
        };
        let is_guessed = handle.axes == Axes::Own && handle.name.owner != GROUND;
        Outline { ports: Vec::new(), angle, turn, origin, is_guessed }
    }
}

//! Schematic drawings of mechanisms as SVG and PNG: bodies, joints, force elements and the ground in the signs that mechanics uses.

mod block;
mod body;
mod canvas;
mod drawing;
mod drives;
mod element;
mod joint;
mod label;
mod letters;
mod look;
mod mark;
mod paper;
mod png;
mod shape;
mod stage;
mod symbol;
mod wheel;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use self::drawing::Drawing;
use self::stage::Stage;
use crate::svg::write_file;
use crate::{Error, Mechanism};

pub use block::{Block, Side};
pub use symbol::Symbol;

/// Width of a picture, in pixels.
const WIDTH: f64 = 600.0;

/// A sense that counts as positive.
#[derive(Clone, Debug, PartialEq)]
pub enum Sense {
    /// Along a direction, rad from the absolute x axis.
    Along(f64, String),
    /// Counter-clockwise.
    Turn(String),
}

/// A drawing of a mechanism at one pose, 600 pixels wide.
///
/// ```
/// use plm_view::{Body, Frame, GroundPort, Mechanism, Part, Port, Sketch};
///
/// let (x, y, angle) = (0.0, 0.0, 0.0);
/// let ground = GroundPort { name: "o".into(), x, y, angle, depth: 0.0, moves: false };
/// let port = Port { name: "top".into(), x: -0.5, y, angle };
/// let bar = Body { name: "bar".into(), mass: 1.0, inertia: 0.1, depth: 0.0, ports: vec![port], contour: None, holes: [].into() };
/// let frame = |argument: &str, body| Frame { argument: argument.into(), body, port: Some(0) };
/// let frames = vec![frame("a", None), frame("b", Some(0))];
/// let [name, kind, pair] = ["pin", "revolute", "revolute"].map(String::from);
/// let pin = Part { name, kind, pair: Some(pair), frames, sizes: [].into(), shapes: [].into() };
/// let pendulum = Mechanism { bodies: vec![bar], ground: vec![ground], parts: vec![pin], ..Mechanism::default() };
///
/// let svg = Sketch::new(pendulum, [[0.5, 0.0, 0.0]]).titled("Pendulum").with_gravity([0.0, -9.81]).to_svg();
/// assert!(svg.starts_with("<svg") && svg.contains(">pin</text>"));
/// ```
#[derive(Clone, Debug)]
pub struct Sketch {
    mechanism: Mechanism,
    /// Place of G and angle of each body: m, m, rad.
    poses: Vec<[f64; 3]>,
    title: String,
    gravity: [f64; 2],
    /// Names of bodies and parts that are drawn in full; all if it is empty.
    focus: BTreeSet<String>,
    /// Parts whose senses are drawn.
    signs: BTreeSet<String>,
    senses: BTreeMap<String, Vec<Sense>>,
}

impl Sketch {
    /// A drawing of a mechanism whose bodies have these poses: place of G and angle, m, m, rad, one for each body.
    pub fn new(mechanism: Mechanism, poses: impl IntoIterator<Item = [f64; 3]>) -> Self {
        Self {
            title: mechanism.name.clone(),
            mechanism,
            poses: poses.into_iter().collect(),
            gravity: [0.0; 2],
            focus: BTreeSet::new(),
            signs: BTreeSet::new(),
            senses: BTreeMap::new(),
        }
    }

    /// Sets the title.
    #[must_use]
    pub fn titled(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Adds an arrow for gravity, m/s^2 along the absolute axes; none if it is zero.
    #[must_use]
    pub fn with_gravity(mut self, gravity: [f64; 2]) -> Self {
        self.gravity = gravity;
        self
    }

    /// Fades bodies and parts of other names.
    #[must_use]
    pub fn focused_on<'n>(mut self, names: impl IntoIterator<Item = &'n str>) -> Self {
        self.focus = names.into_iter().map(str::to_owned).collect();
        self
    }

    /// Adds the positive senses of angles, displacements, forces and measured quantities, of parts by name.
    #[must_use]
    pub fn with_signs<'n>(mut self, parts: impl IntoIterator<Item = &'n str>) -> Self {
        self.signs = parts.into_iter().map(str::to_owned).collect();
        self
    }

    /// Sets the senses of the part of that name: those of a `force`, which are along the absolute axes without.
    #[must_use]
    pub fn with_senses(mut self, part: impl Into<String>, senses: impl IntoIterator<Item = Sense>) -> Self {
        self.senses.insert(part.into(), senses.into_iter().collect());
        self
    }

    /// The drawing as SVG text, the same for the same mechanism and pose. What has no finite place is left out.
    pub fn to_svg(&self) -> String {
        self.drawing().to_svg()
    }

    /// The drawing as a PNG file, 1200 pixels wide, in the light colours; the same for the same mechanism and pose.
    ///
    /// Letters beyond those of Latin-1 are question marks.
    pub fn to_png(&self) -> Vec<u8> {
        self.drawing().to_png()
    }

    fn drawing(&self) -> Drawing {
        let mut stage = Stage::new(self);
        stage.draw_rails();
        stage.draw_bodies();
        stage.draw_elements();
        stage.draw_joints();
        stage.draw_names();
        stage.finish()
    }

    /// Writes the drawing to a file, and makes the folders above it where they are missing.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        write_file(path.as_ref(), Ok(self.to_svg().into_bytes()))
    }
}

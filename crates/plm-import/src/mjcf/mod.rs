//! MJCF: the format of MuJoCo (mujoco.readthedocs.io, XML reference).

mod actuator;
mod body;
mod compiler;
mod defaults;
mod equality;
mod geom;
mod include;

use std::collections::BTreeMap;

use self::compiler::{Compiler, Effect};
use self::defaults::Defaults;
use crate::notice::{Notices, Place};
use crate::space::Pose;
use crate::spatial::Spatial;
use crate::xml::Element;

pub(crate) use self::include::included;

/// A reader of one model.
struct Reader<'a> {
    compiler: Compiler,
    defaults: Defaults<'a>,
    spatial: Spatial,
    joints: BTreeMap<String, usize>,
    bodies: BTreeMap<String, usize>,
    /// Sites: the link (none is the world), and the place in its axes.
    sites: BTreeMap<String, (Option<usize>, Pose)>,
    /// Geoms that can touch others.
    touching: Vec<Place>,
    notices: &'a mut Notices,
}

/// Sections that are read elsewhere, or say nothing of the motion.
const WITHOUT_NOTICE: &[&str] = &[
    "asset",
    "visual",
    "statistic",
    "size",
    "custom",
    "compiler",
    "option",
    "default",
    "worldbody",
    "equality",
    "actuator",
];

/// The mechanism of a `<mujoco>`.
pub(crate) fn read(root: &Element, notices: &mut Notices) -> Option<Spatial> {
    let compiler = Compiler::new(root, notices);
    let defaults = Defaults::new(root, notices);
    let spatial = Spatial::new(root.get("model").unwrap_or("model"), &root.place, compiler.gravity);
    let (joints, bodies, sites) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
    let mut reader =
        Reader { compiler, defaults, spatial, joints, bodies, sites, touching: Vec::new(), notices };
    for world in root.all("worldbody") {
        reader.world(world);
    }
    reader.scale_masses();
    for equality in root.all("equality").flat_map(|equality| &equality.children) {
        reader.equality(equality);
    }
    for actuator in root.all("actuator").flat_map(|actuator| &actuator.children) {
        reader.actuator(actuator);
    }
    for element in &root.children {
        reader.section(element);
    }
    if reader.compiler.has(Effect::Contact) {
        for place in &reader.touching {
            reader.notices.warn(place, "contacts of this geom are left out");
        }
    }
    (!reader.notices.has_errors()).then_some(reader.spatial)
}

impl Reader<'_> {
    /// The pose of `pos` and an orientation.
    fn placed(&mut self, element: &Element) -> Pose {
        let at = element.exactly("pos", self.notices).unwrap_or_default();
        Pose { turn: self.compiler.rotation(element, self.notices), at }
    }

    /// A range that holds: its attribute `limited` says so, or `autolimits` of the compiler where there is none.
    fn range(&mut self, element: &Element, range: &str, limited: &str) -> Option<[f64; 2]> {
        let given = element.exactly(range, self.notices);
        let is_limited = match element.get(limited) {
            Some("true") => true,
            Some("false") => false,
            _ => self.compiler.auto_limits,
        };
        given.filter(|_| is_limited)
    }

    /// A section of the file that is not taken.
    fn section(&mut self, section: &Element) {
        match section.name.as_str() {
            name if WITHOUT_NOTICE.contains(&name) => {}
            "contact" => {
                for pair in section.all("pair") {
                    self.notices.warn(&pair.place, format!("{}: contacts are left out", pair.shown()));
                }
            }
            "tendon" => {
                for tendon in &section.children {
                    let acts = |name| {
                        tendon
                            .get(name)
                            .is_some_and(|text| text.split_whitespace().any(|word| word.parse() != Ok(0.0)))
                    };
                    let is_bounded = tendon.get("range").is_some() && tendon.get("limited") != Some("false");
                    if is_bounded
                        || ["stiffness", "damping", "frictionloss", "armature"].into_iter().any(acts)
                    {
                        self.notices.error(
                            &tendon.place,
                            format!("{}: tendons are not taken, and this one acts", tendon.shown()),
                        );
                    } else {
                        self.notices
                            .warn(&tendon.place, format!("{}: tendons are not taken", tendon.shown()));
                    }
                }
            }
            "deformable" => self.notices.error(&section.place, "<deformable>: what deforms is not taken"),
            _ => {
                for element in &section.children {
                    self.notices.warn(
                        &element.place,
                        format!("{} of <{}> is not taken", element.shown(), section.name),
                    );
                }
            }
        }
    }

    /// Scales masses so that they sum to `settotalmass`, inertias with them.
    fn scale_masses(&mut self) {
        let Some(wanted) = self.compiler.total_mass else { return };
        let links = || self.spatial.links.iter().filter_map(|link| link.inertial);
        let total: f64 = links().map(|inertial| inertial.mass).sum();
        for inertial in self.spatial.links.iter_mut().filter_map(|link| link.inertial.as_mut()) {
            inertial.mass *= wanted / total;
            inertial.tensor = inertial.tensor.map(|row| row.map(|entry| entry * wanted / total));
        }
    }
}

//! `<compiler>` and `<option>`: units, conventions and effects of the rest of the file.

use crate::notice::Notices;
use crate::space::{
    IDENTITY, Matrix, Vector, about, columns, cross, dot, norm, product, quaternion, scaled, sub, unit,
};
use crate::xml::Element;

/// Settings of `<compiler>` and `<option>`.
#[derive(Debug)]
pub(super) struct Compiler {
    /// Radians in the unit of the file.
    pub(super) angle: f64,
    /// Axes of `euler`, in their order; capital letters are axes that stand.
    euler: String,
    /// A range is a limit where `limited` says nothing.
    pub(super) auto_limits: bool,
    /// Inertia from geoms: always, never, or where there is no `<inertial>`.
    pub(super) from_geoms: FromGeoms,
    /// Groups of geoms that have a mass.
    pub(super) groups: [f64; 2],
    pub(super) total_mass: Option<f64>,
    pub(super) gravity: Vector,
    /// Effects that `<flag>` switches off.
    disabled: Vec<Effect>,
}

/// Source of the inertia of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FromGeoms {
    Always,
    Never,
    Else,
}

/// Effects that a file can switch off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effect {
    Contact,
    Limit,
    Friction,
    Equality,
    Spring,
    Damper,
    Actuation,
}

impl Effect {
    const ALL: [Effect; 7] = [
        Effect::Contact,
        Effect::Limit,
        Effect::Friction,
        Effect::Equality,
        Effect::Spring,
        Effect::Damper,
        Effect::Actuation,
    ];

    /// The flags each of which switches it off.
    fn flags(self) -> [&'static str; 2] {
        match self {
            Effect::Contact => ["contact", "constraint"],
            Effect::Limit => ["limit", "constraint"],
            Effect::Friction => ["frictionloss", "constraint"],
            Effect::Equality => ["equality", "constraint"],
            Effect::Spring => ["spring", "passive"],
            Effect::Damper => ["damper", "passive"],
            Effect::Actuation => ["actuation"; 2],
        }
    }
}

impl Compiler {
    pub(super) fn new(root: &Element, notices: &mut Notices) -> Compiler {
        let mut made = Compiler {
            angle: std::f64::consts::PI / 180.0,
            euler: "xyz".to_owned(),
            auto_limits: true,
            from_geoms: FromGeoms::Else,
            groups: [f64::NEG_INFINITY, f64::INFINITY],
            total_mass: None,
            gravity: [0.0, 0.0, -9.81],
            disabled: Vec::new(),
        };
        for compiler in root.all("compiler") {
            made.compiler(compiler, notices);
        }
        for option in root.all("option") {
            made.option(option, notices);
        }
        made
    }

    fn compiler(&mut self, compiler: &Element, notices: &mut Notices) {
        match compiler.get("angle") {
            Some("radian") => self.angle = 1.0,
            Some("degree") => self.angle = std::f64::consts::PI / 180.0,
            _ => {}
        }
        if let Some(order) = compiler.get("eulerseq") {
            order.clone_into(&mut self.euler);
        }
        self.auto_limits &= compiler.get("autolimits") != Some("false");
        match compiler.get("inertiafromgeom") {
            Some("true") => self.from_geoms = FromGeoms::Always,
            Some("false") => self.from_geoms = FromGeoms::Never,
            _ => {}
        }
        if let Some(groups) = compiler.exactly("inertiagrouprange", notices) {
            self.groups = groups;
        }
        self.total_mass =
            compiler.number("settotalmass", notices).filter(|mass| *mass > 0.0).or(self.total_mass);
        if compiler.get("coordinate") == Some("global") {
            notices.error(&compiler.place, "<compiler>: global coordinates are not taken");
        }
        for name in ["boundmass", "boundinertia"] {
            if compiler.number(name, notices).is_some_and(|bound| bound > 0.0) {
                notices.error(&compiler.place, format!("<compiler>: {name} is not taken"));
            }
        }
    }

    fn option(&mut self, option: &Element, notices: &mut Notices) {
        if let Some(gravity) = option.exactly("gravity", notices) {
            self.gravity = gravity;
        }
        for name in ["density", "viscosity"] {
            if option.number(name, notices).is_some_and(|value| value > 0.0) {
                notices.error(&option.place, format!("<option>: {name}: forces of a fluid are not taken"));
            }
        }
        for flag in option.all("flag") {
            let is_off = |name: &str| flag.get(name) == Some("disable");
            if is_off("gravity") {
                self.gravity = [0.0; 3];
            }
            self.disabled.extend(
                Effect::ALL.into_iter().filter(|effect| effect.flags().iter().any(|flag| is_off(flag))),
            );
        }
    }

    /// Is an effect switched on?
    pub(super) fn has(&self, effect: Effect) -> bool {
        !self.disabled.contains(&effect)
    }

    /// The rotation that an element has by one of the five ways of MJCF.
    pub(super) fn rotation(&self, element: &Element, notices: &mut Notices) -> Matrix {
        let turn = if let Some(quat) = element.exactly("quat", notices) {
            quaternion(quat)
        } else if let Some([x, y, z, angle]) = element.exactly("axisangle", notices) {
            unit([x, y, z]).map(|axis| about(axis, angle * self.angle))
        } else if let Some(angles) = element.exactly("euler", notices) {
            self.euler(angles)
        } else if let Some([a, b, c, d, e, f]) = element.exactly("xyaxes", notices) {
            unit([a, b, c]).and_then(|x| {
                let y = unit(sub([d, e, f], scaled(x, dot(x, [d, e, f]))))?;
                Some(columns(x, y, cross(x, y)))
            })
        } else if let Some(z) = element.exactly("zaxis", notices) {
            from_z(z)
        } else {
            Some(IDENTITY)
        };
        turn.unwrap_or_else(|| {
            notices.error(&element.place, format!("{}: its orientation has no direction", element.shown()));
            IDENTITY
        })
    }

    fn euler(&self, angles: [f64; 3]) -> Option<Matrix> {
        let mut turn = IDENTITY;
        for (letter, angle) in self.euler.chars().zip(angles) {
            let k = "xyz".find(letter.to_ascii_lowercase())?;
            let step = about(IDENTITY[k], angle * self.angle);
            turn = if letter.is_lowercase() { product(&turn, &step) } else { product(&step, &turn) };
        }
        Some(turn)
    }
}

/// The least rotation of the z axis to a vector.
pub(super) fn from_z(z: Vector) -> Option<Matrix> {
    let z = unit(z)?;
    let axis = cross([0.0, 0.0, 1.0], z);
    let angle = norm(axis).atan2(z[2]);
    Some(about(unit(axis).unwrap_or([1.0, 0.0, 0.0]), angle))
}

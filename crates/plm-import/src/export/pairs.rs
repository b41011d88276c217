//! Kinematic pairs of a declaration, with what acts in them.

use plm_compiler::model::FrameRef;
use plm_compiler::span::Span;
use plm_compiler::{Affine, FieldValue, InputTerm};

use super::counts;

/// Text for a drive that no actuator can represent.
const NO_LAW: &str = "is not a multiple of one input, clamped or not, which a motor is; of a revolute it may be affine in one input, the angle and \
                      the speed, which a servo is";

/// Kinds of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Weld,
    Prismatic,
    /// A slide with a hinge after it.
    PinSlot,
    Revolute,
}

impl Kind {
    /// The pair that a part of this definition is.
    pub(super) fn named(kind: &str) -> Option<Kind> {
        match kind {
            "weld" => Some(Kind::Weld),
            "prismatic" => Some(Kind::Prismatic),
            "pin_slot" => Some(Kind::PinSlot),
            "revolute" => Some(Kind::Revolute),
            _ => None,
        }
    }
}

/// Springs, dampers, friction, limits and drive along a coordinate, SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Acting {
    pub(super) stiffness: f64,
    /// The coordinate at which the spring is free.
    pub(super) rest: f64,
    pub(super) damping: f64,
    /// Dry friction, N m or N.
    pub(super) friction: f64,
    pub(super) lower: Option<f64>,
    pub(super) upper: Option<f64>,
    /// Inertia that rotates with the coordinate, kg m^2.
    pub(super) armature: f64,
    /// A force or torque that an input sets.
    pub(super) drive: Option<Law>,
}

/// The force or torque of a drive, by its input.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Law {
    /// A multiple of the input.
    Motor(InputTerm),
    /// Affine in the input, the coordinate and its rate.
    Servo(Servo),
}

/// `gain * input + constant + by_angle * angle + by_speed * speed`, SI.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Servo {
    pub(super) input: String,
    pub(super) gain: f64,
    pub(super) constant: f64,
    pub(super) by_angle: f64,
    pub(super) by_speed: f64,
}

impl Law {
    pub(super) fn input(&self) -> &str {
        match self {
            Law::Motor(InputTerm { input, .. }) | Law::Servo(Servo { input, .. }) => input,
        }
    }
}

/// A pair of two frames.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub(super) name: String,
    /// The part that it is.
    pub(super) part: usize,
    pub(super) span: Span,
    pub(super) kind: Kind,
    pub(super) frames: [FrameRef; 2],
    /// The angle of the hinge where both bodies have the same, rad.
    pub(super) offset: f64,
    pub(super) slide: Acting,
    pub(super) hinge: Acting,
    /// Fields that the formats do not have, and why.
    pub(super) missing: Vec<(String, &'static str)>,
}

impl Pair {
    /// A pair in which nothing acts.
    pub(super) fn new(
        name: &str,
        (part, span): (usize, Span),
        kind: Kind,
        frames: [FrameRef; 2],
        offset: f64,
    ) -> Pair {
        let (slide, hinge) = Default::default();
        Pair { name: name.to_owned(), part, span, kind, frames, offset, slide, hinge, missing: Vec::new() }
    }

    /// The factor of the angle of its hinge in a sum of angles of bodies; none where the sum reads others.
    pub(super) fn factor_in(&self, angles: &[(usize, f64)]) -> Option<f64> {
        let of = |body: Option<usize>| {
            let own = angles.iter().find(|(other, _)| Some(*other) == body);
            own.map_or(0.0, |(_, factor)| *factor)
        };
        let [first, second] = self.frames.map(|frame| frame.body);
        let factor = if second.is_some() { of(second) } else { -of(first) };
        let is_opposite = first.is_none() || second.is_none() || is_close(of(first), -factor);
        let are_own = angles.iter().all(|(body, _)| [first, second].contains(&Some(*body)));
        (is_opposite && are_own).then_some(factor)
    }

    /// A servo of its hinge.
    fn servo(&self, law: &Affine) -> Option<Law> {
        let (input, gain) = law.input.clone()?;
        let by_angle = self.factor_in(&law.angles)?;
        let by_speed = self.factor_in(&law.speeds)?;
        let constant = law.constant - by_angle * self.offset;
        Some(Law::Servo(Servo { input, gain, constant, by_angle, by_speed }))
    }

    /// Does nothing act in it?
    pub(super) fn is_plain(&self) -> bool {
        self.slide == Acting::default() && self.hinge == Acting::default()
    }

    /// Sets a field of the declaration.
    pub(super) fn set(&mut self, field: &str, value: &FieldValue) {
        if let Err(why) = self.try_to_set(field, value) {
            self.missing.push((field.to_owned(), why));
        }
    }

    /// Sets a field.
    ///
    /// # Errors
    /// The formats have nothing of the kind: why, after the name of the field.
    fn try_to_set(&mut self, field: &str, value: &FieldValue) -> Result<(), &'static str> {
        let law = match value {
            FieldValue::Input(term) => Some(Law::Motor(term.clone())),
            FieldValue::Affine(law) if self.kind == Kind::Revolute => self.servo(law),
            _ => None,
        };
        let Some((acting, field)) = self.place_of(field) else {
            // Sizes of pictures, and the mirror image, which the start shows.
            let is_drawn = ["pin_diameter", "branch"].contains(&field);
            return if is_drawn || !counts(value) { Ok(()) } else { Err("has no counterpart in the format") };
        };
        match (field, value) {
            ("drive", value) if counts(value) => acting.drive = Some(law.ok_or(NO_LAW)?),
            ("drive", _) => {}
            (_, FieldValue::Input(..) | FieldValue::Affine(..) | FieldValue::Other) => {
                return Err("is no number");
            }
            ("stiffness", FieldValue::Number(number)) => acting.stiffness = *number,
            ("rest", FieldValue::Number(number)) => acting.rest = *number,
            ("damping", FieldValue::Number(number)) => acting.damping = *number,
            ("friction", FieldValue::Number(number)) => acting.friction = *number,
            ("lower", FieldValue::Number(number)) => acting.lower = Some(*number),
            (_, FieldValue::Number(number)) => acting.upper = Some(*number),
        }
        Ok(())
    }

    /// The coordinate that a field belongs to, and its name there.
    fn place_of(&mut self, field: &str) -> Option<(&mut Acting, &'static str)> {
        let (slide, hinge) = (&mut self.slide, &mut self.hinge);
        match (self.kind, field) {
            (Kind::Revolute, "stiffness") | (Kind::PinSlot, "rotary_stiffness") => Some((hinge, "stiffness")),
            (Kind::Revolute, "damping") | (Kind::PinSlot, "rotary_damping") => Some((hinge, "damping")),
            (Kind::Revolute | Kind::PinSlot, "rest") => Some((hinge, "rest")),
            (Kind::Revolute, "seal_friction") => Some((hinge, "friction")),
            (Kind::Revolute, "lower_limit") => Some((hinge, "lower")),
            (Kind::Revolute, "upper_limit") => Some((hinge, "upper")),
            (Kind::Revolute, "drive") => Some((hinge, "drive")),
            (Kind::Prismatic | Kind::PinSlot, "stiffness") => Some((slide, "stiffness")),
            (Kind::Prismatic | Kind::PinSlot, "damping") => Some((slide, "damping")),
            (Kind::Prismatic | Kind::PinSlot, "free_length") => Some((slide, "rest")),
            (Kind::Prismatic, "seal_friction") => Some((slide, "friction")),
            (Kind::Prismatic | Kind::PinSlot, "lower_limit") => Some((slide, "lower")),
            (Kind::Prismatic | Kind::PinSlot, "upper_limit") => Some((slide, "upper")),
            (Kind::Prismatic, "drive") => Some((slide, "drive")),
            _ => None,
        }
    }
}

/// Are two factors the same but for rounding?
fn is_close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

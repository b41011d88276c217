//! Kinematic pairs of a declaration, with what acts in them.

use plm_compiler::model::FrameRef;
use plm_compiler::span::Span;
use plm_compiler::{FieldValue, InputTerm};

use super::counts;

/// Kinds of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Weld,
    Prismatic,
    /// A slide with a hinge behind it.
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
    /// A force or torque that an input sets.
    pub(super) drive: Option<InputTerm>,
}

/// A pair of two frames.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub(super) name: String,
    pub(super) span: Span,
    pub(super) kind: Kind,
    pub(super) frames: [FrameRef; 2],
    pub(super) slide: Acting,
    pub(super) hinge: Acting,
}

impl Pair {
    /// A pair in which nothing acts.
    pub(super) fn new(name: &str, span: Span, kind: Kind, frames: [FrameRef; 2]) -> Pair {
        let (slide, hinge) = Default::default();
        Pair { name: name.to_owned(), span, kind, frames, slide, hinge }
    }

    /// Does nothing act in it?
    pub(super) fn is_plain(&self) -> bool {
        self.slide == Acting::default() && self.hinge == Acting::default()
    }

    /// Sets a field of the declaration.
    ///
    /// # Errors
    /// The formats have nothing of the kind: why, behind the name of the field.
    pub(super) fn set(&mut self, field: &str, value: &FieldValue) -> Result<(), String> {
        let Some((acting, field)) = self.place_of(field) else {
            // Sizes of pictures, and the mirror image, which the start shows.
            let is_drawn = ["pin_diameter", "branch"].contains(&field);
            return if is_drawn || !counts(value) {
                Ok(())
            } else {
                Err("has no counterpart in the format".to_owned())
            };
        };
        match (field, value) {
            ("drive", FieldValue::Input(term)) => acting.drive = Some(term.clone()),
            ("drive", value) if counts(value) => {
                return Err("is not a multiple of one input, clamped or not, which a motor is".to_owned());
            }
            ("drive", _) => {}
            (_, FieldValue::Input(..) | FieldValue::Other) => return Err("is no number".to_owned()),
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

//! The rule of bars: an end of a body with two ports on one of its own axes goes, and the other end stays.
//!
//! Such a body is a bar where pins alone hold it. The length and the angle of the bar follow. Numbers that say the same go with them: the centre in the middle, the length in its
//! moment of inertia, the start of its origin. A zero is structure and stays.

use std::f64::consts::TAU;

use plm_compiler::syntax::ast::{Expr, ExprKind};

use std::ops::Range;

use super::locus::{Locus, around};
use super::{Changes, FINE};
use crate::names::PortName;
use crate::number::Literal;
use crate::picture::{Picture, Point, between, turned};
use crate::refusal::Refusal;
use crate::sheet::{Axes, Handle, Place, Sheet, field};

/// Numbers are the same where they differ by so much of a length.
const SAME: f64 = 1e-9;

/// A bar and the end of it that goes.
#[derive(Clone, Debug)]
pub(crate) struct Bar {
    /// The end that stays.
    pub(crate) other: PortName,
    /// Is its angle prescribed, or that of a name or a formula?
    is_held: bool,
    /// The axis of the body on which both ends lie.
    axis: usize,
    /// The numbers of the end that goes, and of the other one, on that axis.
    pub(crate) own: Literal,
    end: Literal,
    /// The number of the start of its angle.
    pub(crate) angle: Option<Literal>,
    /// Those of the start of its origin.
    origin: [Option<Literal>; 2],
    /// Its centre in the middle.
    middle: Option<Literal>,
    /// Numbers of its moment of inertia that are its length.
    lengths: Vec<Literal>,
}

impl Bar {
    /// The bar whose end a port is, if it is one.
    pub(crate) fn of(sheet: &Sheet<'_>, handles: &[Handle<'_>], handle: &Handle<'_>) -> Option<Bar> {
        let body = handle.body.filter(|_| handle.axes == Axes::Own)?;
        // A slot or a weld would hold it to its pose.
        let joints = sheet.joints();
        if joints.iter().any(|of| of.is_on(&handle.name.owner) && of.kind != "revolute" && !of.is_load()) {
            return None;
        }
        let mut ends = handles.iter().filter(|of| of.name.owner == handle.name.owner);
        let (first, second) = (ends.next()?, ends.next()?);
        let other = if first.name == handle.name { second } else { first };
        if ends.next().is_some() {
            return None;
        }
        let (own, end, axis) = on_axis(handle, other)?;
        let before = own.si() - end.si();
        if before == 0.0 {
            return None;
        }
        let written = |name: &str| body.starts.iter().find(|start| start.coordinate.text == name);
        let start =
            |name: &str| sheet.number(&written(name)?.value, if name == "angle" { "rad" } else { "m" });
        let middle = field(body, "centre").and_then(|centre| sheet.pair(centre));
        let middle = middle.map(|(numbers, ..)| numbers).filter(|numbers| numbers[1 - axis].is_zero());
        let middle = middle.map(|numbers| numbers[axis].clone());
        let middle = middle.filter(|of| near(of.si(), 0.5 * (own.si() + end.si()), before));
        let lengths = field(body, "inertia").map_or_else(Vec::new, |of| lengths_in(sheet, of, before));
        let other = other.name.clone();
        let (angle, origin) = (start("angle"), [start("x"), start("y")]);
        let is_free = written("angle").is_none() || angle.as_ref().is_some_and(|angle| !angle.is_locked);
        let is_held = handle.is_driven || !is_free;
        Some(Bar { other, is_held, axis, own, end, angle, origin, middle, lengths })
    }

    /// The numbers of the bar with its end at a point.
    pub(crate) fn put(
        &self,
        picture: &Picture,
        to: Point,
        grid: f64,
        changes: &mut Changes,
    ) -> Result<(), Refusal> {
        let end = picture.port(&self.other).ok_or_else(|| Refusal::NotShown(self.other.clone()))?;
        let along = between(end.at, to);
        let length = along[0].hypot(along[1]);
        let step = FINE * grid;
        // It would be written as 0.
        if length < step {
            return Err(Refusal::NoLength);
        }
        let (own, stays) = (self.own.si(), self.end.si());
        let sign = (own - stays).signum();
        let is_centred = near(own, -stays, own - stays);
        let stays = if is_centred { -0.5 * sign * length } else { stays };
        changes.put(&self.own, stays + sign * length, step);
        if is_centred {
            changes.put(&self.end, stays, step);
        }
        if let Some(middle) = &self.middle {
            changes.put(middle, stays + 0.5 * sign * length, step);
        }
        for same in &self.lengths {
            changes.put(same, length, step);
        }
        let mut turn = (sign * along[1]).atan2(sign * along[0]);
        if self.axis == 1 {
            turn -= 0.25 * TAU;
        }
        if self.is_held {
            turn = end.angle;
        }
        if let Some(angle) = self.angle.as_ref().filter(|_| !self.is_held) {
            let near = turn + ((angle.si() - turn) / TAU).round() * TAU;
            changes.put(angle, near, step / length);
            turn = near;
        }
        let mut local = [0.0; 2];
        local[self.axis] = stays;
        let arm = turned(local, turn);
        for ((start, end), arm) in self.origin.iter().zip(end.at).zip(arm) {
            if let Some(start) = start {
                changes.put(start, end - arm, step);
            }
        }
        Ok(())
    }

    /// Lines and circles on which its end at `at` stays, with the other one at `end`.
    pub(super) fn loci(&self, end: Point, at: Point) -> Vec<(Range<usize>, Locus)> {
        let none = || Literal {
            is_locked: self.is_held,
            range: self.own.range.end..self.own.range.end,
            ..self.own.clone()
        };
        let angle = self
            .angle
            .as_ref()
            .map_or_else(none, |angle| Literal { is_locked: self.is_held, ..angle.clone() });
        around(end, at, [&self.own, &angle])
    }

    /// The number that says the length alone, where the other end is the origin.
    pub(crate) fn length(&self) -> Option<Literal> {
        self.end.is_zero().then(|| self.own.clone())
    }

    /// The number that says the length alone, with a token for it: where the other end is the origin.
    pub(crate) fn length_token(&self, token: Option<&str>) -> Option<(Literal, String)> {
        let token = token.filter(|_| self.end.is_zero())?;
        let sign = if self.own.value < 0.0 { "-" } else { "" };
        Some((self.own.clone(), format!("{sign}{token}")))
    }

    /// The direction from the end that stays to the other one, from the x axis of the body.
    pub(crate) fn ahead(&self) -> f64 {
        let turn = if self.axis == 1 { 0.25 * TAU } else { 0.0 };
        if self.own.si() < self.end.si() { turn + 0.5 * TAU } else { turn }
    }
}

/// The numbers of two ports on the axis that both lie on, and which it is.
fn on_axis(own: &Handle<'_>, other: &Handle<'_>) -> Option<(Literal, Literal, usize)> {
    let (Place::Numbers { numbers: own, .. }, Place::Numbers { numbers: other, .. }) =
        (&own.place, &other.place)
    else {
        return None;
    };
    let axis = (0..2).find(|axis| own[1 - axis].is_zero() && other[1 - axis].is_zero())?;
    Some((own[axis].clone(), other[axis].clone(), axis))
}

fn near(one: f64, other: f64, size: f64) -> bool {
    (one - other).abs() < SAME * size.abs()
}

/// Arguments of a moment of inertia that are the length of the bar: `rod(1 kg, 25 cm)`.
fn lengths_in(sheet: &Sheet<'_>, inertia: &Expr, length: f64) -> Vec<Literal> {
    let ExprKind::Call(_, arguments) = &inertia.kind else { return Vec::new() };
    let literals = arguments.iter().filter_map(|argument| sheet.literal(argument, "m"));
    let is_length = |of: &Literal| of.unit.dimension.same(plm_compiler::units::Dimension::LENGTH);
    literals.filter(|of| is_length(of) && near(of.si(), length.abs(), length)).collect()
}

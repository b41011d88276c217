//! Rules: which numbers a pin has when it is dragged.
//!
//! A pin is all ports that joints hold at one place. Each of its ports has a rule, and each rule writes numbers that close the pose on
//! the screen: a mechanism of pins can be assembled, whatever is dragged.

mod bar;
mod free;
mod through;

use std::ops::Range;

use crate::names::PortName;
use crate::number::{Change, Literal};
use crate::picture::{Picture, Placed, Point, between, on_ray};
use crate::refusal::Refusal;
use crate::sheet::{Handle, Joint, Place, Sheet};
pub(crate) use bar::Bar;

/// Numbers are written to this part of the grid, so that turned axes and lengths are as exact as the hand.
pub(crate) const FINE: f64 = 0.01;

/// A pin that goes less than this part of the grid stays.
const STAYS: f64 = 1e-6;

/// A pin that is dragged.
#[derive(Clone, Debug, PartialEq)]
pub struct Drag {
    /// A port of the pin.
    pub port: PortName,
    /// The place to which it is to go.
    pub to: Point,
    /// The step of the picture, m.
    pub grid: f64,
    /// Do bars keep their poses, and their ports go?
    pub free: bool,
}

/// A rule for the numbers of a port.
#[derive(Clone, Debug)]
pub(crate) enum Rule {
    /// A point of a drawing that has a name: its two numbers, once for all bodies.
    Through,
    /// The end of a bar: its length and its angle.
    Bar(Box<Bar>),
    /// The port goes in the axes of its body, which stays.
    Free,
}

/// A pin with what becomes of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Dragged {
    /// The numbers, in a fixed order: that of the ports in the text.
    pub changes: Vec<Change>,
    /// The place to which the pin goes.
    pub to: Point,
    /// Ports elsewhere that have the same numbers, and go too.
    pub also: Vec<PortName>,
    /// Parts at the pin that hold it to more than a place, so that the numbers may not close them: slides, slots.
    pub open: Vec<String>,
}

impl Rule {
    /// The rule of a port.
    fn of(sheet: &Sheet<'_>, handles: &[Handle<'_>], handle: &Handle<'_>, free: bool) -> Rule {
        if let Place::Numbers { through: Some(_), .. } = &handle.place {
            return Rule::Through;
        }
        let bar = if free { None } else { Bar::of(sheet, handles, handle) };
        bar.map_or(Rule::Free, |bar| Rule::Bar(Box::new(bar)))
    }
}

/// A port of a pin, in the text and in the picture.
struct Member<'s, 'p> {
    handle: Handle<'s>,
    placed: &'p Placed,
    rule: Rule,
}

/// The numbers that a drag changes.
///
/// # Errors
/// A port of the pin stands where an expression says, or is not shown; prescribed angles hold it.
pub(crate) fn drag(sheet: &Sheet<'_>, picture: &Picture, drag: &Drag) -> Result<Dragged, Refusal> {
    let handles = sheet.handles();
    let mut members = Vec::new();
    for name in sheet.pin(&drag.port) {
        let found = handles.iter().find(|handle| handle.name == name);
        let handle = found.ok_or_else(|| Refusal::Unknown(name.to_string()))?.clone();
        let placed = picture.port(&name).ok_or_else(|| Refusal::NotShown(name.clone()))?;
        if let Place::Expression(text) = handle.place {
            return Err(Refusal::Expression { port: name, text });
        }
        let rule = Rule::of(sheet, &handles, &handle, drag.free);
        members.push(Member { handle, placed, rule });
    }
    let to = held(picture, &members, drag)?;
    let mut changes = Changes::default();
    for Member { handle, placed, rule } in &members {
        match rule {
            Rule::Through => through::put(handle, placed, to, drag.grid, &mut changes),
            Rule::Bar(bar) => bar.put(picture, to, drag.grid, &mut changes)?,
            Rule::Free => free::put(handle, placed, to, drag.grid, &mut changes),
        }
    }
    let joints = sheet.joints();
    let holds = |joint: &&Joint| {
        let is_here = members.iter().any(|member| joint.ports.contains(&member.handle.name));
        is_here && !joint.is_pin() && !joint.is_load()
    };
    let open = joints.iter().filter(holds).map(|joint| joint.name.clone()).collect();
    // A pin that stays changes nothing: starts are proposals, and need not be what assembly makes of them.
    let stays = members.iter().all(|Member { placed, .. }| {
        let [dx, dy] = between(placed.at, to);
        dx.hypot(dy) <= STAYS * drag.grid
    });
    let stay = |change: Change| if stays { Change::written(&change.literal, None) } else { change };
    let changes: Vec<Change> = changes.all.into_iter().map(stay).collect();
    let is_changed = |handle: &&Handle<'_>| match &handle.place {
        Place::Numbers { numbers, .. } => {
            numbers.iter().any(|own| changes.iter().any(|of| of.is_new() && of.literal.range == own.range))
        }
        Place::Expression(_) => false,
    };
    let elsewhere = |handle: &&Handle<'_>| !members.iter().any(|member| member.handle.name == handle.name);
    let of_bars =
        |handle: &&Handle<'_>| !members.iter().any(|member| member.handle.name.owner == handle.name.owner);
    let also = handles.iter().filter(is_changed).filter(elsewhere).filter(of_bars);
    let also = also.map(|handle| handle.name.clone()).collect();
    Ok(Dragged { changes, to, also, open })
}

/// The place to which a pin can go: a bar whose angle is prescribed keeps it.
fn held(picture: &Picture, members: &[Member<'_, '_>], drag: &Drag) -> Result<Point, Refusal> {
    let mut to = drag.to;
    let mut is_held = false;
    for member in members {
        let Rule::Bar(bar) = &member.rule else { continue };
        if !bar.is_driven {
            continue;
        }
        let end = picture.port(&bar.other).ok_or_else(|| Refusal::NotShown(bar.other.clone()))?;
        if is_held || end.at == member.placed.at {
            return Err(Refusal::Held(drag.port.clone()));
        }
        to = on_ray(end.at, member.placed.at, to);
        is_held = true;
    }
    Ok(to)
}

/// Numbers that change, each once.
#[derive(Default)]
pub(crate) struct Changes {
    all: Vec<Change>,
}

impl Changes {
    /// A number that is to be `si`, to a step, unless it has been told already.
    pub(crate) fn put(&mut self, literal: &Literal, si: f64, step: f64) {
        if !self.has(&literal.range) {
            self.all.push(Change::new(literal, si, step));
        }
    }

    fn has(&self, range: &Range<usize>) -> bool {
        self.all.iter().any(|change| change.literal.range == *range)
    }
}

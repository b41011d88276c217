//! Rules: which numbers a pin has when it is dragged.
//!
//! A pin is all ports that joints hold at one place. Each of its ports has a rule, and each rule writes numbers that close the pose on
//! the screen: a mechanism of pins can be assembled, whatever is dragged.

mod bar;
mod free;
mod locus;

use std::ops::Range;

use crate::branch::Dyad;
use crate::names::PortName;
use crate::number::{Change, Literal};
use crate::picture::{Picture, Placed, Point, between, turned};
use crate::refusal::Refusal;
use crate::sheet::{Axes, Handle, Joint, Place, Polar, Sheet};
pub(crate) use bar::Bar;
pub(crate) use free::turn as turn_of_axes;
use locus::Locus;

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
    /// A point of a drawing that stands at a length and an angle from another one: both, once for all bodies.
    Polar(Box<Polar>),
    /// The end of a bar: its length and its angle.
    Bar(Box<Bar>),
    /// The port goes in the axes of its body, which stays; a point of a drawing that has a name, once for all bodies.
    Free(Box<[Literal; 2]>),
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
    /// Bars that have come into line, or meet on the other side.
    pub told: Vec<String>,
}

impl Rule {
    /// The rule of a port.
    fn of(
        sheet: &Sheet<'_>,
        handles: &[Handle<'_>],
        handle: &Handle<'_>,
        free: bool,
    ) -> Result<Rule, Refusal> {
        match &handle.place {
            Place::Numbers { numbers, through, .. } => {
                let bar = if free || through.is_some() { None } else { Bar::of(sheet, handles, handle) };
                Ok(bar.map_or_else(|| Rule::Free(numbers.clone()), |bar| Rule::Bar(Box::new(bar))))
            }
            Place::Polar { polar, .. } => Ok(Rule::Polar(polar.clone())),
            Place::Expression(text) => {
                Err(Refusal::Expression { port: handle.name.clone(), text: text.clone() })
            }
        }
    }
}

/// A port of a pin, in the text and in the picture.
#[derive(Clone, Debug)]
struct Member {
    axes: Axes,
    placed: Placed,
    rule: Rule,
}

/// A pin that a hand holds: all that the text and the picture say of it, so that a move is numbers alone.
#[derive(Clone, Debug)]
pub struct Held {
    port: PortName,
    free: bool,
    members: Vec<Member>,
    picture: Picture,
    open: Vec<String>,
    /// Bars whose assembly may flip.
    dyads: Vec<Dyad>,
    /// All ports of the pin.
    pin: Vec<PortName>,
    /// Ports of other bodies, with where their numbers stand.
    elsewhere: Vec<(PortName, [Range<usize>; 2])>,
}

impl Held {
    /// Takes the pin of a port. Where `free` holds, bars keep their poses, and their ports go.
    ///
    /// # Errors
    /// A port of the pin stands where an expression says, or is not shown.
    pub fn take(sheet: &Sheet<'_>, picture: &Picture, port: &PortName, free: bool) -> Result<Held, Refusal> {
        let handles = sheet.handles();
        let (mut members, pin) = (Vec::new(), sheet.pin(port));
        for name in &pin {
            let found = handles.iter().find(|handle| handle.name == *name);
            let handle = found.ok_or_else(|| Refusal::Unknown(name.to_string()))?;
            let placed = picture.port(name).ok_or_else(|| Refusal::NotShown(name.clone()))?.clone();
            let rule = Rule::of(sheet, &handles, handle, free)?;
            members.push(Member { axes: handle.axes, placed, rule });
        }
        let joints = sheet.joints();
        let holds = |joint: &&Joint| {
            pin.iter().any(|name| joint.ports.contains(name)) && !joint.is_pin() && !joint.is_load()
        };
        let open = joints.iter().filter(holds).map(|joint| joint.name.clone()).collect();
        let others = handles.iter().filter(|handle| !pin.iter().any(|name| name.owner == handle.name.owner));
        let elsewhere = others.filter_map(|handle| match &handle.place {
            Place::Numbers { numbers, .. } => {
                Some((handle.name.clone(), numbers.each_ref().map(|number| number.range.clone())))
            }
            Place::Polar { polar, .. } => {
                Some((handle.name.clone(), polar.numbers().map(|number| number.range.clone())))
            }
            Place::Expression(_) => None,
        });
        let elsewhere = elsewhere.collect();
        let dyads = Dyad::all(sheet, &handles);
        let (port, picture) = (port.clone(), picture.clone());
        Ok(Held { port, free, members, picture, open, dyads, pin, elsewhere })
    }

    /// Is it the pin of this port in the same picture, so that it need not be taken again?
    pub fn is_of(&self, picture: &Picture, port: &PortName, free: bool) -> bool {
        self.port == *port && self.free == free && self.picture == *picture
    }

    /// The numbers with the pin at a point.
    ///
    /// # Errors
    /// Prescribed angles hold the pin, or a bar would have no length.
    pub(crate) fn changes(&self, to: Point, grid: f64) -> Result<Dragged, Refusal> {
        let to = self.held(to)?;
        let mut changes = Changes::default();
        for Member { axes, placed, rule } in &self.members {
            match rule {
                Rule::Bar(bar) => bar.put(&self.picture, to, grid, &mut changes)?,
                // The point of a drawing is two numbers in the axes of the first body that names it: those of the pointer, where
                // the bodies stand as they were drawn.
                Rule::Free(numbers) => free::put((numbers, *axes), placed, to, grid, &mut changes),
                Rule::Polar(polar) => free::put_polar((polar, *axes), placed, to, grid, &mut changes)?,
            }
        }
        // A pin that stays changes nothing: starts are proposals, and need not be what assembly makes of them.
        let stays = self.members.iter().all(|Member { placed, .. }| {
            let [dx, dy] = between(placed.at, to);
            dx.hypot(dy) <= STAYS * grid
        });
        let stay = |change: Change| if stays { Change::written(&change.literal, None) } else { change };
        let changes: Vec<Change> = changes.all.into_iter().map(stay).collect();
        let is_changed =
            |range: &Range<usize>| changes.iter().any(|of| of.is_new() && of.literal.range == *range);
        let also = self.elsewhere.iter().filter(|(_, ranges)| ranges.iter().any(is_changed));
        let also = also.map(|(name, _)| name.clone()).collect();
        let told = self.dyads.iter().filter_map(|dyad| dyad.told(&self.picture, &self.pin, to)).collect();
        Ok(Dragged { changes, to, also, open: self.open.clone(), told })
    }

    /// The place to which the pin can go: where prescribed angles and locked dimensions let it.
    fn held(&self, to: Point) -> Result<Point, Refusal> {
        let held = || Refusal::Held(self.port.clone());
        let mut loci: Vec<(Range<usize>, Locus)> = Vec::new();
        for member in &self.members {
            for (range, locus) in self.loci(member)? {
                // The numbers of a point are those of all bodies that name it.
                if !loci.iter().any(|(known, _)| *known == range) {
                    loci.push((range, locus));
                }
            }
        }
        match &loci[..] {
            [] => Ok(to),
            [(_, locus)] => locus.nearest(to).ok_or_else(held),
            _ => Err(held()),
        }
    }

    /// Lines and circles on which a port of the pin stays, with the numbers that say so.
    fn loci(&self, Member { axes, placed, rule }: &Member) -> Result<Vec<(Range<usize>, Locus)>, Refusal> {
        let turn = turn_of_axes(*axes, placed.angle);
        match rule {
            Rule::Free(numbers) => Ok(locus::of_numbers(numbers, placed.at, turn)),
            Rule::Polar(polar) => {
                let [x, y] = turned(between(polar.at(), polar.base), turn);
                let base = [placed.at[0] + x, placed.at[1] + y];
                Ok(locus::around(base, placed.at, polar.numbers()))
            }
            Rule::Bar(bar) => {
                let end =
                    self.picture.port(&bar.other).ok_or_else(|| Refusal::NotShown(bar.other.clone()))?;
                Ok(bar.loci(end.at, placed.at))
            }
        }
    }

    /// Does a name hold a number of the pin?
    pub(crate) fn has_locks(&self) -> bool {
        self.members.iter().any(|member| match &member.rule {
            Rule::Free(numbers) => numbers.iter().any(|number| number.is_locked),
            Rule::Polar(polar) => polar.numbers().iter().any(|number| number.is_locked),
            Rule::Bar(bar) => bar.own.is_locked,
        })
    }
}

/// The numbers that a drag changes.
///
/// # Errors
/// A port of the pin stands where an expression says, or is not shown; prescribed angles hold it.
pub(crate) fn drag(sheet: &Sheet<'_>, picture: &Picture, drag: &Drag) -> Result<Dragged, Refusal> {
    Held::take(sheet, picture, &drag.port, drag.free)?.changes(drag.to, drag.grid)
}

/// Numbers that change, each once.
#[derive(Default)]
pub(crate) struct Changes {
    all: Vec<Change>,
}

impl Changes {
    /// A number that is to be `si`, to a step, unless it has been told already.
    pub(crate) fn put(&mut self, literal: &Literal, si: f64, step: f64) {
        if !literal.is_locked && !self.has(&literal.range) {
            self.all.push(Change::new(literal, si, step));
        }
    }

    fn has(&self, range: &Range<usize>) -> bool {
        self.all.iter().any(|change| change.literal.range == *range)
    }
}

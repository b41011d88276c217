//! Gestures: what a hand does to a picture, and what becomes of it.

use crate::edit::Edit;
use crate::names::PortName;
use crate::picture::Point;
use crate::rules::Drag;
use crate::start::{Ahead, StartAt};
use crate::typed;

/// A deed of a hand.
#[derive(Clone, Debug, PartialEq)]
pub enum Gesture {
    /// A pin is dragged.
    Drag(Drag),
    /// Numbers are typed for a pin.
    Typed(typed::Typed),
    /// A bar from one end to another.
    Bar {
        /// Its ends.
        ends: [End; 2],
        /// The step of the picture, m.
        grid: f64,
    },
    /// A port is pinned to the ground where it stands.
    Ground {
        /// The port.
        port: PortName,
        /// The step of the picture, m.
        grid: f64,
    },
    /// The ground gets a port, to which parts can be joined.
    GroundPoint {
        /// Its place.
        at: Point,
        /// The step of the picture, m.
        grid: f64,
    },
    /// A pin is dropped on another one: they are one from then on.
    Merge {
        /// The pin that is dropped.
        drag: Drag,
        /// A port of the other one.
        onto: PortName,
    },
    /// A body turns.
    Motor {
        /// The body.
        body: String,
    },
    /// A tool joins two ports.
    Join {
        /// The word of the tool.
        tool: String,
        /// The ports.
        ports: [PortName; 2],
        /// The step of the picture, m.
        grid: f64,
    },
    /// A port is guided along a line of the ground.
    Slide {
        /// The port.
        port: PortName,
        /// A point of the line, beside the place of the port.
        toward: Point,
        /// The step of the picture, m.
        grid: f64,
    },
    /// A port slides in a slot along the bar that another body is.
    Groove {
        /// The port.
        port: PortName,
        /// The body with the slot.
        body: String,
        /// The step of the picture, m.
        grid: f64,
    },
    /// A body gets a port more; at a port of another one, or on the ground, it is pinned there.
    Port {
        /// The body.
        body: String,
        /// The place.
        end: End,
        /// The step of the picture, m.
        grid: f64,
    },
    /// The pin of two bars goes to its mirror image.
    Mirror {
        /// A port of the pin.
        port: PortName,
        /// The step of the picture, m.
        grid: f64,
    },
    /// A body again, beside itself.
    Copy {
        /// The body.
        body: String,
        /// How far, m.
        by: Point,
        /// The step of the picture, m.
        grid: f64,
    },
    /// A dimension of a port becomes a parameter, which no hand moves.
    Lock {
        /// The port.
        port: PortName,
        /// Which dimension.
        dimension: typed::Dimension,
    },
    /// A dimension that is locked is a number of the place again.
    Unlock {
        /// The port.
        port: PortName,
        /// Which dimension.
        dimension: typed::Dimension,
    },
    /// A parameter or an input has another value.
    Set {
        /// Its name.
        name: String,
        /// The value, SI.
        value: f64,
    },
    /// Bodies begin elsewhere; no other coordinate is locked then.
    Start {
        /// The coordinates that say where.
        starts: Vec<StartAt>,
        /// Bodies with prescribed angles, which begin further on.
        ahead: Vec<Ahead>,
        /// The step of the picture, m.
        grid: f64,
    },
    /// A thing is taken away.
    Delete {
        /// Its name.
        name: String,
    },
    /// The pin of a port is opened: its joints are taken away.
    Unpin {
        /// The port.
        port: PortName,
    },
    /// A port is taken away.
    DeletePort {
        /// The port.
        port: PortName,
    },
    /// A thing has another name.
    Rename {
        /// Its name.
        from: String,
        /// Its new one.
        to: String,
    },
    /// A port has another name.
    RenamePort {
        /// The port.
        from: PortName,
        /// Its new name.
        to: String,
    },
}

/// A place that is drawn to: an end of a bar, a port.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// A point of its own.
    Point(Point),
    /// A point where it is pinned to the ground.
    Ground(Point),
    /// A port, to which it is pinned.
    Port(PortName),
}

/// The edits and values of a gesture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawn {
    /// Edits of the text, disjoint, in the order of their places.
    pub edits: Vec<Edit>,
    /// Values of the numbers that a drag changes, SI, in the order of the parameters of the lifted text.
    pub values: Vec<f64>,
    /// The place to which a dragged pin goes.
    pub to: Option<Point>,
    /// Ports elsewhere that have the same numbers, and go too.
    pub also: Vec<PortName>,
    /// Parts at the pin that the numbers may not close: slides, slots.
    pub open: Vec<String>,
    /// Warnings for the hand: bars at a dead point, an assembly that has flipped.
    pub told: Vec<String>,
    /// Names of what is new.
    pub made: Vec<String>,
}

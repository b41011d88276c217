//! A part without a place in the plane, drawn as a box: its sign, its ports and signals, and the positive senses of its flows and forces.

use std::path::Path;

use super::WIDTH;
use super::drawing::Drawing;
use super::paper::{Paper, Point};
use super::symbol::Symbol;
use crate::Error;
use crate::svg::{text_width, wrap, write_file};

/// Middle and half of the sides of the box, in pixels.
const MIDDLE: Point = [0.5 * WIDTH, 0.0];
const HALF: Point = [86.0, 46.0];
/// Length of the line of a port.
const LEAD: f64 = 46.0;
/// From the line of a port to its arrow.
const ASIDE: f64 = 13.0;

/// A side of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left: inputs by custom.
    Left,
    /// Right: outputs.
    Right,
    /// Above.
    Top,
    /// Below.
    Bottom,
}

/// Positive sense at a port.
#[derive(Clone, Debug, PartialEq)]
enum Arrow {
    Inward(String),
    Outward(String),
    /// Counter-clockwise.
    Turn(String),
}

/// Port or signal at a side of a box.
#[derive(Clone, Debug, PartialEq)]
struct Pin {
    side: Side,
    name: String,
    is_signal: bool,
    arrow: Option<Arrow>,
}

/// A box with named ports and signals, 600 pixels wide.
///
/// ```
/// use plm_view::{Block, Side, Symbol};
///
/// let orifice = Block::new("orifice", Symbol::Orifice)
///     .port(Side::Left, "a")
///     .inward("flow")
///     .port(Side::Right, "b")
///     .outward("flow")
///     .noting("flow > 0 from a to b");
/// assert!(orifice.to_svg().contains(">flow &gt; 0 from a to b</text>"));
/// ```
#[derive(Clone, Debug)]
pub struct Block {
    name: String,
    symbol: Symbol,
    pins: Vec<Pin>,
    note: String,
}

impl Block {
    /// A box without ports.
    pub fn new(name: impl Into<String>, symbol: Symbol) -> Self {
        Self { name: name.into(), symbol, pins: Vec::new(), note: String::new() }
    }

    /// Adds a port.
    #[must_use]
    pub fn port(self, side: Side, name: impl Into<String>) -> Self {
        self.pin(side, name.into(), false)
    }

    /// Adds a signal that it reads.
    #[must_use]
    pub fn input(self, name: impl Into<String>) -> Self {
        self.pin(Side::Left, name.into(), true)
    }

    /// Adds a signal that it gives.
    #[must_use]
    pub fn output(self, name: impl Into<String>) -> Self {
        self.pin(Side::Right, name.into(), true)
    }

    /// Adds an arrow into the box at its last port.
    #[must_use]
    pub fn inward(self, text: impl Into<String>) -> Self {
        self.arrow(Arrow::Inward(text.into()))
    }

    /// Adds an arrow out of the box at its last port.
    #[must_use]
    pub fn outward(self, text: impl Into<String>) -> Self {
        self.arrow(Arrow::Outward(text.into()))
    }

    /// Adds a counter-clockwise turn at its last port.
    #[must_use]
    pub fn turning(self, text: impl Into<String>) -> Self {
        self.arrow(Arrow::Turn(text.into()))
    }

    /// Sets the text below.
    #[must_use]
    pub fn noting(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    /// Name of the part.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Names of all ports and signals, in the order in which they were given.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.pins.iter().map(|pin| pin.name.as_str())
    }

    /// Texts of all arrows.
    pub fn senses(&self) -> impl Iterator<Item = &str> {
        self.pins.iter().filter_map(|pin| match pin.arrow.as_ref()? {
            Arrow::Inward(text) | Arrow::Outward(text) | Arrow::Turn(text) => Some(text.as_str()),
        })
    }

    fn pin(mut self, side: Side, name: String, is_signal: bool) -> Self {
        self.pins.push(Pin { side, name, is_signal, arrow: None });
        self
    }

    fn arrow(mut self, arrow: Arrow) -> Self {
        if let Some(pin) = self.pins.last_mut() {
            pin.arrow = Some(arrow);
        }
        self
    }

    /// The drawing as SVG text, the same for the same box.
    pub fn to_svg(&self) -> String {
        let mut paper = Paper::default();
        let corner = |x: f64, y: f64| [MIDDLE[0] + x * HALF[0], MIDDLE[1] + y * HALF[1]];
        paper.polygon("", &[corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)]);
        self.symbol.draw(&mut paper, MIDDLE);
        for side in [Side::Left, Side::Right, Side::Top, Side::Bottom] {
            let here: Vec<&Pin> = self.pins.iter().filter(|pin| pin.side == side).collect();
            for (k, pin) in here.iter().enumerate() {
                let part = (k as f64 + 0.5) / here.len() as f64;
                draw_pin(pin, 2.0 * part - 1.0, &mut paper);
            }
        }
        let rows = paper.dots.iter().map(|dot| dot[1]);
        let (top, bottom) = rows.fold((0.0_f64, 0.0_f64), |(low, high), y| (low.min(y), high.max(y)));
        let top = top - 30.0;
        paper.text("title", [14.0, top + 18.0], &self.name);
        let mut bottom = bottom + 12.0;
        for line in wrap(&self.note, 13.0, WIDTH) {
            paper.text("name", [MIDDLE[0], bottom + 6.0], &line);
            bottom += 20.0;
        }
        Drawing { title: self.name.clone(), marks: paper.marks, width: WIDTH, rows: [top, bottom] }.to_svg()
    }

    /// Writes the drawing to a file, and makes the folders above it where they are missing.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        write_file(path.as_ref(), Ok(self.to_svg().into_bytes()))
    }
}

/// A port or signal that is so far along its side, from -1 to 1.
fn draw_pin(pin: &Pin, along: f64, paper: &mut Paper) {
    let (out, side) = match pin.side {
        Side::Left => ([-1.0, 0.0], [0.0, 1.0]),
        Side::Right => ([1.0, 0.0], [0.0, 1.0]),
        Side::Top => ([0.0, -1.0], [1.0, 0.0]),
        Side::Bottom => ([0.0, 1.0], [1.0, 0.0]),
    };
    // A place by its distance from the box and its distance above the line, or right of one that is upright.
    let up = if out[0] == 0.0 { [1.0, 0.0] } else { [0.0, -1.0] };
    let at = |distance: f64, aside: f64| {
        [0, 1].map(|k| MIDDLE[k] + HALF[k] * (out[k] + along * side[k]) + distance * out[k] + aside * up[k])
    };
    if pin.is_signal {
        let ends = if pin.side == Side::Left { [LEAD, 0.0] } else { [0.0, LEAD] };
        paper.arrow("flow", at(ends[0], 0.0), at(ends[1], 0.0));
    } else {
        paper.line("rail", &[at(0.0, 0.0), at(LEAD, 0.0)]);
        paper.circle("black", at(LEAD, 0.0), 4.0);
    }
    let name = 0.5 * text_width(&pin.name, 13.0);
    paper.text("name", at(LEAD + if out[0] == 0.0 { 14.0 } else { name + 9.0 }, 0.0), &pin.name);
    let Some(arrow) = &pin.arrow else { return };
    let (ends, text) = match arrow {
        Arrow::Inward(text) => ([LEAD - 6.0, 6.0], text),
        Arrow::Outward(text) => ([6.0, LEAD - 6.0], text),
        Arrow::Turn(text) => ([0.5 * LEAD; 2], text),
    };
    if matches!(arrow, Arrow::Turn(_)) {
        paper.turn("force", at(0.5 * LEAD, 0.0), ASIDE, [-0.6, 3.7]);
    } else {
        paper.arrow("force", at(ends[0], ASIDE), at(ends[1], ASIDE));
    }
    let room = if out[0] == 0.0 { 0.5 * text_width(text, 13.0) + 6.0 } else { 11.0 };
    // A long text beside the box begins there.
    let half = 0.5 * text_width(text, 13.0);
    let middle = if out[0] != 0.0 && half > 0.5 * LEAD { half + 4.0 } else { 0.5 * LEAD };
    paper.text("sign", at(middle, ASIDE + room), text);
}

//! Descriptions of mechanisms by number: for drawing, recording, coupling and setting mechanisms without their names.
//!
//! Names, units and connections are constants of a type that the compiler wrote, [`Described::TABLES`]; those of any mechanism are
//! [`Described::tables`]. Values that depend on parameters are functions of the mechanism. Unused parts of it are not compiled.

pub mod by_number;
pub mod pulls;
mod tables;
mod words;

pub use tables::{Body, Frame, GroundPort, Hole, Motion, Part, Quantity, Reads, Report, Shape, Tables};
pub use words::mechanism_in_words;

use crate::body::BodyState;
use crate::mechanism::{Mechanism, Moment};
use crate::ports::Ports;
use crate::scalar::Scalar;
use crate::system::Rate;
use crate::vector::Vector;

/// Numbers of a body before those of its ports: mass, inertia, depth.
const OF_BODY: usize = 3;
/// Numbers of a port: x, y, angle.
const OF_PORT: usize = 3;

/// Place and angle of a port.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<S> {
    /// From the centre of gravity in the axes of the body, of ports of the ground from the origin; m.
    pub x: S,
    /// Its y coordinate, m.
    pub y: S,
    /// Of its x axis against that of the body, or the absolute one; rad.
    pub angle: S,
}

impl<S: Scalar> Place<S> {
    /// (x, y, angle) of a place; not numbers where there is none.
    pub fn components(place: Option<Self>) -> [S; 3] {
        place.map_or([S::lit(f64::NAN); 3], |Place { x, y, angle }| [x, y, angle])
    }
}

/// The numbers that a mechanism computes with.
type Number<M> = <M as Rate>::S;

/// A mechanism that describes its bodies, parts, parameters and quantities by number.
///
/// Numbers count from 0 in the order of [`tables`](Self::tables); beyond the last there is nothing (`None`). All is in SI.
///
/// ```
/// use plm_runtime::Described;
///
/// /// The mass of all bodies, kg.
/// fn mass<M: Described<S = f64>>(mechanism: &M) -> f64 {
///     (0..mechanism.tables().bodies.len()).filter_map(|body| mechanism.mass(body)).sum()
/// }
/// ```
pub trait Described: Mechanism + Ports {
    /// Names, units and connections.
    const TABLES: &'static Tables;
    /// Names and SI units of the quantities that [`observed`](Self::observed) gives: outputs, and observed quantities.
    const OBSERVED: &'static [(&'static str, &'static str)];

    /// The declaration in the language of `mechanism!`, as it was written.
    const DECLARATION: &'static str;
    /// Files that it names, and where they were when it was compiled.
    const FILES: &'static [(&'static str, &'static str)];

    /// Shapes of parts for pictures, in the order of the parts.
    const SHAPES: &'static [Shape] = &[];
    /// Holes of the contours of bodies, in the order of the bodies.
    const HOLES: &'static [Hole] = &[];

    /// Steps by themselves that it orders, as it names them: `rk4`, which is `State::step_rk4`.
    const STEPS: &'static [&'static str] = &[];

    /// Names, units, and who joins whom: [`TABLES`](Self::TABLES), or those of a mechanism whose type has none, as one from text.
    #[inline]
    fn tables(&self) -> &'static Tables {
        Self::TABLES
    }

    /// Names and SI units of the quantities that [`observed`](Self::observed) gives.
    #[inline]
    fn observables(&self) -> &'static [(&'static str, &'static str)] {
        Self::OBSERVED
    }

    /// The declaration in the language of `mechanism!`, as it was written.
    #[inline]
    fn declaration(&self) -> &'static str {
        Self::DECLARATION
    }

    /// Files that it names, and their paths.
    #[inline]
    fn files(&self) -> &'static [(&'static str, &'static str)] {
        Self::FILES
    }

    /// Shapes of parts for pictures, in the order of the parts.
    #[inline]
    fn shapes(&self) -> &'static [Shape] {
        Self::SHAPES
    }

    /// Holes of the contours of bodies, in the order of the bodies.
    #[inline]
    fn holes(&self) -> &'static [Hole] {
        Self::HOLES
    }

    /// The number with this index among all that the tables point at.
    #[doc(hidden)]
    fn figure(&self, t: Number<Self>, index: usize) -> Option<Number<Self>>;

    /// A parameter, to be read.
    fn parameter(&self, index: usize) -> Option<Number<Self>>;

    /// A parameter, to be set.
    fn parameter_mut(&mut self, index: usize) -> Option<&mut Number<Self>>;

    /// Gives `each` the pose and velocity of every body.
    fn poses(state: &Self::State, each: &mut impl FnMut(BodyState<Number<Self>>));

    /// A quantity of [`observables`](Self::observables), worked out when it is asked for.
    fn observed(state: &Self::State, index: usize) -> Option<Number<Self>>;

    /// Gives `each` the quantities of these numbers in their order, as [`observed`](Self::observed) does; what they have in common, as the
    /// pose and the accelerations, is worked out once.
    fn observe(
        state: &Self::State,
        quantities: impl IntoIterator<Item = usize>,
        each: &mut impl FnMut(Option<Number<Self>>),
    ) {
        for index in quantities {
            each(Self::observed(state, index));
        }
    }

    /// Mass of a body, kg; `None` if it was declared without.
    fn mass(&self, body: usize) -> Option<Number<Self>> {
        self.declared(self.tables().bodies.get(body)?.first)
    }

    /// Moment of inertia of a body about its centre of gravity, kg m^2; `None` if it was declared without.
    fn inertia(&self, body: usize) -> Option<Number<Self>> {
        self.declared(self.tables().bodies.get(body)?.first + 1)
    }

    /// Depth of a body for pictures, m; 0 where none was declared.
    fn depth(&self, body: usize) -> Option<Number<Self>> {
        self.constant(self.tables().bodies.get(body)?.first + 2)
    }

    /// A port of a body, from its centre of gravity in its axes.
    fn port(&self, body: usize, port: usize) -> Option<Place<Number<Self>>> {
        let Body { ports, first, .. } = self.tables().bodies.get(body)?;
        ports.get(port)?;
        self.place(Number::<Self>::lit(0.0), first + OF_BODY + OF_PORT * port)
    }

    /// A point of the contour of a body, from its centre of gravity in its axes, m.
    fn contour(&self, body: usize, point: usize) -> Option<[Number<Self>; 2]> {
        let Body { ports, contour, first, .. } = *self.tables().bodies.get(body)?;
        self.point(contour, first + OF_BODY + OF_PORT * ports.len(), point)
    }

    /// A port of the ground at the time `t`, s; from the origin, absolute axes.
    fn ground(&self, t: Number<Self>, port: usize) -> Option<Place<Number<Self>>> {
        self.place(t, self.tables().ground.get(port)?.first)
    }

    /// Depth of a port of the ground for pictures, m; 0 where none was declared.
    fn ground_depth(&self, port: usize) -> Option<Number<Self>> {
        self.constant(self.tables().ground.get(port)?.first + OF_PORT)
    }

    /// A size of a part for pictures, m; 0 where none was given.
    fn size(&self, part: usize, size: usize) -> Option<Number<Self>> {
        let Part { sizes, first, .. } = self.tables().parts.get(part)?;
        sizes.get(size)?;
        self.constant(first + size)
    }

    /// A point of a shape of [`shapes`](Self::shapes), in the axes of its frame; m, or in the measure of symbols.
    fn shape_point(&self, shape: usize, point: usize) -> Option<[Number<Self>; 2]> {
        let Shape { points, first, .. } = *self.shapes().get(shape)?;
        self.point(points, first, point)
    }

    /// A point of a hole of [`holes`](Self::holes), from the centre of gravity of its body in its axes, m.
    fn hole_point(&self, hole: usize, point: usize) -> Option<[Number<Self>; 2]> {
        let Hole { points, first, .. } = *self.holes().get(hole)?;
        self.point(points, first, point)
    }

    /// Sets a parameter; false if there is none with this index. A run checks it before its next step.
    fn set_parameter(&mut self, index: usize, value: Number<Self>) -> bool {
        self.parameter_mut(index).map(|parameter| *parameter = value).is_some()
    }

    /// The pose and velocity of a body.
    fn pose(state: &Self::State, body: usize) -> Option<BodyState<Number<Self>>> {
        let (mut at, mut found) = (0, None);
        Self::poses(state, &mut |pose| {
            if at == body {
                found = Some(pose);
            }
            at += 1;
        });
        found
    }

    /// A first-order state.
    fn state(state: &Self::State, index: usize) -> Option<Number<Self>> {
        let states = state.mechanism().tables().states.len();
        let first = <Self as Rate>::X::LEN.checked_sub(states)?;
        (index < states).then(|| state.x().at(first + index))
    }

    /// A number that the time does not change.
    #[doc(hidden)]
    fn constant(&self, index: usize) -> Option<Number<Self>> {
        self.figure(Number::<Self>::lit(0.0), index)
    }

    /// A number that the time does not change, if it was declared: the others are no numbers in the tables.
    #[doc(hidden)]
    fn declared(&self, index: usize) -> Option<Number<Self>> {
        self.constant(index).filter(|number| !number.to_f64().is_nan())
    }

    /// One of so many points of the tables, the first of which begins at an index.
    #[doc(hidden)]
    fn point(&self, points: usize, first: usize, point: usize) -> Option<[Number<Self>; 2]> {
        let at = first + 2 * point;
        if point < points { Some([self.constant(at)?, self.constant(at + 1)?]) } else { None }
    }

    /// Three numbers of the tables.
    #[doc(hidden)]
    fn place(&self, t: Number<Self>, first: usize) -> Option<Place<Number<Self>>> {
        let [x, y, angle] = [0, 1, 2].map(|k| self.figure(t, first + k));
        Some(Place { x: x?, y: y?, angle: angle? })
    }
}

//! Reading a mechanism and setting it by number, for programs that do not know its names.

use core::fmt;

use super::{Described, Part, Place, Quantity};
use crate::mechanism::Moment;
use crate::method::Method;
use crate::sim::Sim;
use crate::start::follow_where;
use crate::statics::Statics;

/// Declared output, with its unit, of each observed quantity of that name; `None` for a quantity that is shown in SI.
pub fn shown<M: Described>(of: &M) -> impl Iterator<Item = Option<(usize, &'static Quantity)>> + use<M> {
    // Both lists are in the order of the declaration.
    let mut declared = of.tables().outputs.iter().enumerate().peekable();
    of.observables().iter().map(move |(name, _)| declared.next_if(|(_, output)| output.name == *name))
}

/// Gives `each` the numbers of a moment: the time (s); x, y, angle, vx, vy, omega of each body; x, y, angle of each port of the
/// ground; all observed quantities, outputs in their declared units and the others in SI.
pub fn moment<M: Described<S = f64>>(state: &M::State, each: &mut impl FnMut(f64)) {
    each(state.time());
    M::poses(state, &mut |pose| pose.components().into_iter().for_each(&mut *each));
    for port in 0..state.mechanism().tables().ground.len() {
        let place = Place::components(state.mechanism().ground(state.time(), port));
        place.into_iter().for_each(&mut *each);
    }
    all_shown::<M>(state, each);
}

/// Gives `each` all observed quantities, outputs in their declared units and the others in SI.
pub fn all_shown<M: Described<S = f64>>(state: &M::State, each: &mut impl FnMut(f64)) {
    let mut outputs = shown(state.mechanism());
    M::observe(state, 0..state.mechanism().observables().len(), &mut |value| {
        let value = value.unwrap_or(f64::NAN);
        // As the output itself is made, to the bit.
        each(outputs.next().flatten().map_or(value, |(_, output)| value / output.factor));
    });
}

/// Gives `each` what parameters change of bodies and ground, SI: of each body mass, moment of inertia, depth, place and angle of each
/// port, the number of points of its contour, and these; of each port of the ground x, y and angle at time 0, and depth; the sizes of
/// [`SizeNames`], 0 where none was given; of each shape of a part, then of each hole of a body, the number of its points, and these.
pub fn shape<M: Described<S = f64>>(of: &M, each: &mut impl FnMut(f64)) {
    let number = |number: Option<f64>| number.unwrap_or(f64::NAN);
    for (k, body) in of.tables().bodies.iter().enumerate() {
        [of.mass(k), of.inertia(k), of.depth(k)].map(number).into_iter().for_each(&mut *each);
        for port in 0..body.ports.len() {
            Place::components(of.port(k, port)).into_iter().for_each(&mut *each);
        }
        points(body.contour, |point| of.contour(k, point), each);
    }
    for k in 0..of.tables().ground.len() {
        Place::components(of.ground(0.0, k)).into_iter().for_each(&mut *each);
        each(number(of.ground_depth(k)));
    }
    for (k, part) in of.tables().parts.iter().enumerate() {
        (0..part.sizes.len()).map(|size| number(of.size(k, size))).for_each(&mut *each);
    }
    for (k, shape) in of.shapes().iter().enumerate() {
        points(shape.points, |point| of.shape_point(k, point), each);
    }
    for (k, hole) in of.holes().iter().enumerate() {
        points(hole.points, |point| of.hole_point(k, point), each);
    }
}

/// Gives `each` the number of points, and these.
fn points(count: usize, at: impl Fn(usize) -> Option<[f64; 2]>, each: &mut impl FnMut(f64)) {
    each(count as f64);
    (0..count).flat_map(|point| at(point).unwrap_or([f64::NAN; 2])).for_each(each);
}

/// The parts that have sizes, a line each: the name of the part, and those of its sizes, with blanks between.
pub struct SizeNames(&'static [Part]);

impl SizeNames {
    /// Those of a mechanism.
    pub fn of<M: Described>(mechanism: &M) -> Self {
        Self(mechanism.tables().parts)
    }
}

impl fmt::Display for SizeNames {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sized = self.0.iter().filter(|part| !part.sizes.is_empty());
        for (k, part) in sized.enumerate() {
            write!(f, "{}{}", if k > 0 { "\n" } else { "" }, part.name)?;
            part.sizes.iter().try_for_each(|size| write!(f, " {size}"))?;
        }
        Ok(())
    }
}

/// Sets a parameter, SI, and the start values that are made of it; those that were set by hand stay. False if there is none
/// with this index.
pub fn set_parameter<M: Described<S = f64> + Statics>(mechanism: &mut M, index: usize, value: f64) -> bool {
    let before = mechanism.declared_starts();
    let is_known = mechanism.set_parameter(index, value);
    let after = mechanism.declared_starts();
    // Where one value was placed by hand, the others go on as they were declared.
    follow_where(mechanism.starts_mut(), before, after, |_| true);
    is_known
}

/// Sets a parameter in a run that goes on, SI.
pub fn set_running_parameter<M, I>(sim: &mut Sim<M, I>, index: usize, value: f64)
where
    M: Described<S = f64> + Statics,
    I: Method<M>,
{
    let state = sim.state();
    let (mut mechanism, held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
    set_parameter(&mut mechanism, index, value);
    **sim = Moment::new(mechanism, held, time, x);
}

/// Sets all parameters of a run that goes on to those of a mechanism.
pub fn set_parameters<M, I>(sim: &mut Sim<M, I>, mechanism: &M)
where
    M: Described<S = f64> + Statics,
    I: Method<M>,
{
    for (index, value) in parameters(mechanism).enumerate() {
        if sim.state().mechanism().parameter(index) != Some(value) {
            set_running_parameter(sim, index, value);
        }
    }
}

/// All parameters, SI.
pub fn parameters<M: Described<S = f64>>(mechanism: &M) -> impl Iterator<Item = f64> {
    (0..).map_while(|index| mechanism.parameter(index))
}

/// An input of a run, SI.
pub fn input<M: Described<S = f64>>(state: &M::State, index: usize) -> Option<f64> {
    M::input(M::inputs(&mut state.held()), index).copied()
}

/// Sets an input of a run, SI; false if there is none with this index.
pub fn set_input<M, I>(sim: &mut Sim<M, I>, index: usize, value: f64) -> bool
where
    M: Described<S = f64>,
    I: Method<M>,
{
    let state = sim.state();
    let (mechanism, mut held, time, x) = (*state.mechanism(), state.held(), state.time(), *state.x());
    let Some(input) = M::input(M::inputs(&mut held), index) else { return false };
    *input = value;
    **sim = Moment::new(mechanism, held, time, x);
    true
}

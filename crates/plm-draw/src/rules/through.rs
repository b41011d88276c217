//! Through a name: a point of a drawing is two numbers for all bodies that meet there.
//!
//! They are those of the free rule, in the axes of the first body that names the point. Where all bodies stand as they were drawn these
//! are the absolute axes, and the numbers are those of the pointer.

use super::{Changes, free};
use crate::picture::{Placed, Point};
use crate::sheet::Handle;

/// The numbers of the point of a port.
pub(super) fn put(handle: &Handle<'_>, placed: &Placed, to: Point, grid: f64, changes: &mut Changes) {
    free::put(handle, placed, to, grid, changes);
}

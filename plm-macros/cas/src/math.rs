//! The one place that names the functions of `plm-math`: the same bits on every host and every target.

pub(crate) use plm_math::f64::{acos, asin, atan2, cos, exp, floor, ln, max, min, sin, sqrt};

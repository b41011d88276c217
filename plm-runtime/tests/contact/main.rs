//! Friction and unilateral contact of systems that are written by hand, against closed forms and quadratures.

mod bodies;
mod friction;
mod impacts;
mod laws;
mod support;

//! Structure of a mechanism before any algebra: its loops, the order in which they can be solved, and from
//! which coordinates.
//!
//! Plain indices in, plain indices out. Everything here is structure, that is, true for almost all dimensions: whether
//! the dimensions at hand are an exception (parallel cranks, a bar of length zero) is for a numerical rank to say.

mod blocks;
mod cycles;
mod independent;
mod influence;
mod matching;
#[cfg(test)]
mod scenes;
mod strong;

pub(crate) use blocks::{Block, Equation};
pub(crate) use cycles::{Forest, shortest_cycle_basis, spanning_forest};
pub(crate) use independent::{Choice, independent_sets};
pub(crate) use influence::{Influence, structural_rank};

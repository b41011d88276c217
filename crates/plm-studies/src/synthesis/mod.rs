//! Dimensions of planar mechanisms from what they have to do, and the questions of kinematics as calls.
//!
//! `plm` has all of it behind the feature `synthesis`, as `plm::synthesis`.

pub mod balance;
mod descent;
mod four_bar;
pub mod function;
pub mod kinematics;
pub mod motion;
mod numbers;
pub mod path;
mod random;
mod roots;
pub mod six_bar;
pub mod tolerance;

pub use four_bar::{Class, Defect, Demands, FourBar, Image, Limits, LinkMass, Point, Pose};

//! The benchmark scenes that are assembled here.

#[path = "../support/scenes.rs"]
#[allow(unused_macros, unused_imports)] // Others use the others.
mod shared;

use shared::{double_pendulum, four_bar};

double_pendulum!(s1: output shoulder.force, elbow.force;);
double_pendulum!(s1_baumgarte: stabilisation: baumgarte; output shoulder.force, elbow.force;);
four_bar!(s2: output drive.force;);

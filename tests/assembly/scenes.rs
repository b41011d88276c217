//! The benchmark scenes that are assembled here.

#[path = "../support/scenes.rs"]
#[allow(unused_macros, unused_imports)] // Others use the others.
mod shared;

use shared::{double_pendulum, four_bar};

double_pendulum!([scene] s1: output shoulder.force, elbow.force;);
double_pendulum!([scene] s1_baumgarte: stabilisation: baumgarte; output shoulder.force, elbow.force;);
four_bar!([scene] s2: output drive.force;);
// Single precision and the branches of loops are asked of compiled mechanisms alone.
four_bar!(s2_compiled: output drive.force;);

//! The benchmark scenes as the compiler takes them, and with Baumgarte's method.

#[path = "scenes.rs"]
mod shared;

pub(crate) use shared::{andrews, double_pendulum, four_bar, slider_crank};

double_pendulum!(s1: output shoulder.force, elbow.force;);
double_pendulum!(s1_baumgarte: stabilisation: baumgarte; output shoulder.force, elbow.force;);
four_bar!(s2: output drive.force;);
four_bar!(s2_baumgarte: stabilisation: baumgarte; output drive.force;);
slider_crank!(s6: output drive.force;);
slider_crank!(s6_baumgarte: stabilisation: baumgarte; output drive.force;);
andrews!(s5: output r1.force, r2.force, r4.force;);

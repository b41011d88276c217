//! The benchmark scenes as the compiler takes them, and with Baumgarte's method.

#[path = "../support/scenes.rs"]
mod shared;

pub(crate) use shared::{andrews, double_pendulum, four_bar, slider_crank};

double_pendulum!([scene] s1: output shoulder.force, elbow.force;);
double_pendulum!([scene] s1_baumgarte: stabilisation: baumgarte; output shoulder.force, elbow.force;);
four_bar!([scene] s2: output drive.force;);
four_bar!([scene] s2_baumgarte: stabilisation: baumgarte; output drive.force;);
slider_crank!([scene] s6: output drive.force;);
slider_crank!([scene] s6_baumgarte: stabilisation: baumgarte; output drive.force;);
andrews!([scene] s5: output r1.force, r2.force, r4.force;);

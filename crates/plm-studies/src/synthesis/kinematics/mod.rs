//! Questions of kinematics: mobility, instant centres and centrodes, images of dyads and of coupled loops, limits of a slider-crank,
//! workspace and dead points of any mechanism, singular poses of a five-bar. Limits, dead points, transmission angle and mechanical advantage of a four-bar are functions of
//! [`FourBar`](crate::synthesis::FourBar).

mod at_pose;
mod continuation;
mod five_bar;
mod images;
mod instant;
mod loops;
mod mobility;
mod reach;
mod slider_crank;

pub use self::at_pose::{MobilityAt, mobility_at};
pub use self::five_bar::{FiveBar, FiveBarPose, Singularity};
pub use self::images::{Build, NoImages, images};
pub use self::instant::{Centre, centrodes, instant_centre, kennedy};
pub use self::loops::{Loop, LoopImages, NoLoopImages, loop_images};
pub use self::mobility::{Joint, Link, Mobility, gruebler, mobility};
pub use self::reach::{DeadPoint, NoReach, Reach, dead_points, workspace};
pub use self::slider_crank::{SliderCrank, SliderPose};

//! A drawing of any mechanism.

use plm_runtime::described::Place;
use plm_runtime::{AsMoment, Described, Moment, Scalar};
use plm_view::{Mechanism, Sketch, mechanism};

/// A schematic drawing of a mechanism at a moment: of a `Sim` or of a state. [`Sketch::with_gravity`] sets the gravity.
///
/// ```
/// # plm::mechanism! {
/// #     pub Pendulum {
/// #         gravity: 9.81 m/s^2;
/// #         ground { port o: (0, 0) m; }
/// #         body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 30 deg, locked; }
/// #         revolute hinge(ground.o, bob.pivot);
/// #     }
/// # }
/// fn main() -> Result<(), Box<dyn std::error::Error>> {
///     let sim = Pendulum::new().start()?;
///     let path = std::env::temp_dir().join("plm-view-sketch/pendulum.svg");
///     plm::view::sketch(&sim).with_gravity([0.0, -9.81]).write_svg(&path)?;
///     assert!(std::fs::read_to_string(&path)?.contains(">hinge</text>"));
///     # std::fs::remove_dir_all(path.parent().unwrap())?;
///     Ok(())
/// }
/// ```
pub fn sketch<T: Moment<M: Described<State = T>>>(of: &impl AsMoment<State = T>) -> Sketch {
    let state = of.as_moment();
    let (mut poses, time) = (Vec::new(), state.time());
    T::M::poses(state, &mut |pose| poses.push([pose.x, pose.y, pose.angle].map(Scalar::to_f64)));
    let mut mechanism: Mechanism = mechanism(state.mechanism());
    for (k, port) in mechanism.ground.iter_mut().enumerate() {
        [port.x, port.y, port.angle] =
            Place::components(state.mechanism().ground(time, k)).map(Scalar::to_f64);
    }
    Sketch::new(mechanism, poses)
}

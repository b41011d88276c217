//! Natural modes of the demos.

use plm::{Dop853, linearise};

use crate::demos::connect_plm_hyd::{self, ConnectPlmHyd};

/// On its stop the arm with its jack is lightly damped and oscillatory: -1.5 +- 2002i and -1.5 +- 4668i 1/s in an
/// independent model with oil that holds no gas. It is these that decide the method, not the domain.
#[test]
fn the_arm_on_its_stop_rings() {
    let mut sim = connect_plm_hyd::on_the_stop().unwrap().start_with(Dop853::new(1e-9)).unwrap();
    sim.step(4.0).unwrap();
    let there = ConnectPlmHyd { gas: 0.0, start: sim.starts(), ..sim.mechanism };
    let modes = linearise(there.start().unwrap().state()).unwrap().modes();
    let found: Vec<_> = modes.iter().map(|mode| mode.eigenvalue).filter(|of| of.im > 1000.0).collect();
    let known = [(-1.5, 2002.0), (-1.5, 4668.0)];
    assert_eq!(found.len(), known.len(), "{modes:?}");
    for (found, (re, im)) in found.iter().zip(known) {
        assert!(
            (found.re - re).abs() < 0.1 && (found.im - im).abs() < 0.01 * im,
            "{found} and {re} +- {im}i"
        );
    }
    assert!(modes.iter().all(|mode| mode.eigenvalue.re < 1.0), "{modes:?}");
}

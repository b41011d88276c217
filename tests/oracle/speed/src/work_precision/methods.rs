//! The methods of the charts: one line each.

use plm::runtime::{Linear, Ports};
use plm::{Adams, Dop853, Dopri5, Gauss, Mechanism, RadauIia5, Rk4, Vern9};
use plm_peers::Setting::{Step, Tolerance};

use crate::measure::{Formulation, Line};

/// Every method in one formulation.
pub fn every<M: Mechanism<S = f64> + Linear + Ports>(formulation: &Formulation<M>) -> Vec<Line> {
    vec![
        formulation.line(0, "DOP853", Tolerance, Dop853::new),
        formulation.line(1, "DOPRI5", Tolerance, Dopri5::new),
        formulation.line(2, "RK4", Step, Rk4::new),
        formulation.line(3, "Gauss 4", Step, Gauss::<M, 2>::new),
        formulation.line(4, "Gauss 6", Step, Gauss::<M, 3>::new),
        formulation.line(5, "Radau IIA 5", Tolerance, RadauIia5::new),
        formulation.line(6, "Verner 9(8)", Tolerance, Vern9::new),
        formulation.line(7, "Adams", Tolerance, Adams::new),
    ]
}

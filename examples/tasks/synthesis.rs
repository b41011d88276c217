//! Which four-bar turns the dial of a pressure into that of a flow, its square root, and how far is it off?
use std::error::Error;

use nalgebra::{Matrix3, Vector3};

use super::{Answer, Answers};

plm::mechanism! {
    /// A four-bar linkage on a base of 100 mm.
    pub Dials {
        param crank = 60 mm;
        param coupler = 150 mm;
        param rocker = 70 mm;
        param angle = 100 deg;
        ground { port pressure: (0, 0) mm; port flow: (100, 0) mm; }
        body input { port axle: (0, 0) mm; port pin: (crank, 0 mm); start angle: 100 deg; }
        body link { port pin: (0, 0) mm; port wrist: (coupler, 0 mm); }
        body pointer { port axle: (0, 0) mm; port wrist: (rocker, 0 mm); start x: 100 mm; start angle: 50 deg; }
        revolute pressure(ground.pressure, input.axle);
        revolute pin(input.pin, link.pin);
        revolute wrist(link.wrist, pointer.wrist);
        revolute flow(ground.flow, pointer.axle);
        constraint dial: input.angle = angle;
    }
}

/// Angles of both dials, rad, for a pressure between 1/4 and 1 of its greatest: 60 deg each.
fn dials(pressure: f64) -> [f64; 2] {
    [70.0 + 80.0 * (pressure - 0.25), 20.0 + 120.0 * (pressure.sqrt() - 0.5)].map(f64::to_radians)
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    // Chebyshev's spacing, and Freudenstein's equation k1 cos b - k2 cos a + k3 = cos(a - b) at the three points.
    let points = [-0.75_f64, 0.0, 0.75].map(|at| 0.625 + 0.375 * at / 0.75_f64.sqrt());
    let [first, second, third] = points.map(dials);
    let row = |[a, b]: [f64; 2]| [b.cos(), -a.cos(), 1.0];
    let known = Vector3::from([first, second, third].map(|[a, b]| (a - b).cos()));
    let ratios = Matrix3::from([row(first), row(second), row(third)]).transpose();
    let k = ratios.try_inverse().ok_or("no such linkage")? * known;
    let (base, crank, rocker) = (0.1, 0.1 / k[0], 0.1 / k[1]);
    let coupler = (base * base + crank * crank + rocker * rocker - 2.0 * crank * rocker * k[2]).sqrt();

    let error = |pressure: f64| -> Result<f64, plm::Fault> {
        let [angle, pointer] = dials(pressure);
        let sim = Dials { crank, coupler, rocker, angle, ..Dials::new() }.start()?;
        Ok((sim.pointer().angle - pointer).abs().to_degrees())
    };
    let largest = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    let at_points = points.into_iter().map(error).collect::<Result<Vec<_>, _>>()?;
    let between =
        (25..=100).map(|percent| error(f64::from(percent) / 100.0)).collect::<Result<Vec<_>, _>>()?;
    Ok(vec![
        Answer::new("length of the crank", crank * 1e3, "mm"),
        Answer::new("length of the coupler", coupler * 1e3, "mm"),
        Answer::new("length of the pointer", rocker * 1e3, "mm"),
        Answer::new("error at the three points", largest(&at_points), "deg"),
        Answer::new("greatest error between", largest(&between), "deg"),
    ])
}

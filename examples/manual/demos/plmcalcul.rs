//! PLMCALCUL, section 4.8: points in relative and absolute axes.
//!
//! ```text
//!      y0 |        yr \   . p      the relative axes stand at (1, 0.5) m
//!         |            \ .  /xr    and are turned by 30 deg, counter-clockwise
//!         |             o
//!         o_________ x0
//! ```
//!
//! Reading: the manual's formula for flag 0 (relative to absolute) holds -theta, that for flag 1 +theta, so that it enters
//! the same axes as -30 deg in case 1 and as 30 deg in case 2. Here `angle` is that of the relative axes in the absolute
//! ones in both: flag 0 is `to_absolute(p, origin, -theta)`, flag 1 is `to_relative(p, origin, theta)`.

use plm::{Fault, to_absolute, to_relative};

use super::sheet::Reading::Rounded;
use super::sheet::Sheet;

plm::mechanism! {
    /// A plate that is fixed at the place of the relative axes.
    pub Plmcalcul {
        let origin = (1, 0.5) m;
        let turn = 30 deg;
        ground { port place: origin, axis: turn; }
        body plate { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; port p: (0.2, 0.1) m; }
        weld fixed(ground.place, plate.o);
        output case_1 = to_absolute((0.2, 0.1) m, origin, turn);
        output case_2 = to_relative((1.5, 0.75) m, origin, turn);
        output plate.p.position;
    }
}

/// Both cases as the declaration works them out, and the same at run time with the manual's own inputs.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMCALCUL");
    let sim = Plmcalcul::new().start()?;
    let ([xa, ya], [xr, yr]) = (sim.case_1(), sim.case_2());
    sheet.manual("case 1 Xa", xa, "m", 1.12321, Rounded(1e-5));
    sheet.manual("case 1 Ya", ya, "m", 0.686_603, Rounded(1e-6));
    sheet.manual("case 2 Xr", xr, "m", 0.558_013, Rounded(1e-6));
    sheet.manual("case 2 Yr", yr, "m", -0.03349, Rounded(1e-5));

    let (theta0, theta1) = ((-30_f64).to_radians(), 30_f64.to_radians());
    let [x, y] = to_absolute([0.2, 0.1], [1.0, 0.5], -theta0);
    sheet.theory("case 1 in Rust: Xa", x, "m", xa, 1e-14);
    sheet.theory("case 1 in Rust: Ya", y, "m", ya, 1e-14);
    let [x, y] = to_relative([1.5, 0.75], [1.0, 0.5], theta1);
    sheet.theory("case 2 in Rust: Xr", x, "m", xr, 1e-14);
    sheet.theory("case 2 in Rust: Yr", y, "m", yr, 1e-14);
    let [x, y] = sim.plate_p_position();
    sheet.theory("the same point of a body: x", x, "m", xa, 1e-14);
    sheet.theory("the same point of a body: y", y, "m", ya, 1e-14);
    Ok(sheet)
}

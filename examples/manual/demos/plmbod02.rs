//! PLMBOD02, section 4.3.5: one pendulum in relative and in absolute coordinates, four examples.
//!
//! ```text
//!          y1 \    . G = O1, port 2    0.5 m, drawn at 20 deg, 100 kg
//!              \ .    /x1
//!       y0 |  .
//!          o_____ x0
//!         ///
//! ```
//!
//! Reading: the manual calls "absolute starting angular position" the angle that orients the body; by its examples it is
//! the angle of the body's axes in the drawing (`drawing_angle`). Table 15's "initial absolute angular position" is
//! `start angle`, which is locked in all four. Angles of frame and beam are those of figure 91; the manual prints no number.

use plm::{BodyState, Dop853, Fault};

use super::balance::{self, Ledger, RTOL};
use super::sheet::Sheet;

plm::mechanism! {
    /// Example 1: ports in the body's own axes.
    pub Relative {
        gravity: 9.81 m/s^2;
        ground { port o0: (0, 0) m; }
        body beam {
            mass: 100 kg;
            inertia: 0.01 kg*m^2;
            port p1: (-0.5, 0) m;
            port p2: (0, 0) m;
            start x: 0.5*cos(20 deg)*1 m;
            start y: 0.5*sin(20 deg)*1 m;
            start angle: 45 deg, locked;
        }
        revolute pivot(ground.o0, beam.p1);
    }
}

plm::mechanism! {
    /// Examples 2, 3 and 4: ports as they are drawn.
    pub Drawn {
        gravity: 9.81 m/s^2;
        /// The manual's "absolute starting angular position".
        param drawing: deg = 20 deg;
        let tip = (0.5*cos(20 deg), 0.5*sin(20 deg)) m;
        ground { port o0: (0, 0) m; }
        body beam {
            mass: 100 kg;
            inertia: 0.01 kg*m^2;
            coordinates: absolute;
            drawing_angle: drawing;
            centre: tip;
            port p1: (0, 0) m;
            port p2: tip;
            start angle: 45 deg, locked;
        }
        revolute pivot(ground.o0, beam.p1);
    }
}

/// The four examples of figure 91, and a fall from the last.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("PLMBOD02");
    show(&mut sheet, 1, &Relative::new().start()?.beam(), [45.0, 45.0]);
    for (example, drawing, start, expected) in
        [(2, 0.0, 0.0, [0.0, 20.0]), (3, 20.0, 0.0, [0.0, 0.0]), (4, 20.0, 45.0_f64, [45.0, 45.0])]
    {
        let mut drawn = Drawn { drawing: f64::to_radians(drawing), ..Drawn::new() };
        drawn.start.beam.angle.value = start.to_radians();
        show(&mut sheet, example, &drawn.start()?.beam(), expected);
    }
    let mut sim = Drawn::new().start_with(Dop853::new(RTOL))?;
    let balance = balance::run(&mut sim, (2000, 1e-3), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        loads: s.load_power(),
        ..Ledger::default()
    })?;
    sheet.balance(balance);
    Ok(sheet)
}

/// The angle of the body's axes, and that of the beam, which goes from the pivot at the origin to G.
fn show(sheet: &mut Sheet, example: u32, beam: &BodyState<f64>, [frame, drawn]: [f64; 2]) {
    let along = f64::atan2(beam.y, beam.x);
    sheet.theory(&format!("example {example}: frame"), beam.angle.to_degrees(), "deg", frame, 1e-9);
    sheet.theory(&format!("example {example}: beam"), along.to_degrees(), "deg", drawn, 1e-9);
}

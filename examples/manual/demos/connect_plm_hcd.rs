//! ConnectPlmHCD, section 3.2.2: the arm of ConnectPlmHyd, its cylinder put together from pistons, volumes and an end stop.
//!
//! ```text
//!      rod of the jack ====[ piston 9 ]====[ piston 9' ]====[ end stop 18 ]
//!                           chamber 17      chamber 16
//!                              |                |
//!                           line 1           line 2      as in ConnectPlmHyd
//! ```
//!
//! Readings: the results "are the same" only if the jack has the friction of 1000 N/(m/s) too, which Table 5 leaves out:
//! with the 1 bar of the valve the piston comes to rest 2.1 mm further in without it. The manual prints no other number.

use plm::{Dop853, Fault, Stabilise};

use super::balance::{self, Ledger, RTOL};
use super::connect_plm_hyd::{self, ConnectPlmHyd};
use super::sheet::Sheet;

plm::mechanism! {
    /// The arm of the manual, section 3.2.2.
    pub ConnectPlmHcd {
        /// Friction of the jack: 0 in Table 5.
        param friction: N/(m/s) = 0;
        /// Pressure drop at which the valve lets 20 L/min through: not in the manual.
        param rated_drop: bar = 1 bar;
        /// Share of undissolved gas in the oil: not in the manual.
        param gas: 1 = 0;

        gravity: 9.81 m/s^2;
        ground { port o0: (0, 0) m; port foot: (0, -0.25) m; }
        body arm {
            mass: 100 kg;
            inertia: 0.01 kg*m^2;
            port tip: (0.2, 0) m;
            port jack: (-0.5, 0) m;
            port o0: (-0.8, 0) m;
            start angle: 20 deg, locked;
        }
        revolute hinge(ground.o0, arm.o0);
        jack ram(ground.foot, arm.jack) { free_length: 0.22 m; piston_diameter: 0.05 m; rod_diameter: 0.07 m; }

        chamber cap() { dead_volume: 50 cm^3; oil.gas_content: gas; }
        chamber ring() { dead_volume: 50 cm^3; oil.gas_content: gas; pressure: 5 bar, locked; }
        piston bap12(ram.slider, cap.port) { diameter: 50 mm; }
        piston bap11(ram.slider, ring.port) {
            diameter: 50 mm;
            rod_diameter: 30 mm;
            length: 350 mm;
            opens: backwards;
        }
        slider_ground barrel();
        end_stop stops(barrel.slider, ram.slider) {
            gap1: 350 mm;
            gap2: 0 mm;
            stiffness: 1e8 N/m;
            damping: 1000 N/(m/s);
        }
        slider_spring drag(barrel.slider, ram.slider) { damping: friction; }

        oil_line line1(cap.port) { inlet.oil.gas_content: gas; }
        oil_line line2(ring.port) { inlet.oil.gas_content: gas; inlet.pressure: 5 bar; }
        servo_valve valve(pump.port, line1.port, line2.port, tank.port) {
            signal: -0.2*command.value;
            rated_drop: rated_drop;
            frequency: 20 Hz;
        }
        oil_source pump() { pressure: 30 bar; }
        oil_tank tank() { pressure: 5 bar; }
        ramps command() {
            duration1: 0.5 s;
            duration2: 0.5 s; end2: 1;
            duration3: 0.5 s; start3: 1; end3: 1;
            duration4: 1 s; start4: 1;
        }

        let squeezing = cap.pressure*cap.compressed + ring.pressure*ring.compressed
            + line1.pressure*line1.compressed + line2.pressure*line2.compressed;
        state squeezed: J = 0;
        rate squeezed = squeezing;
        let elastic = stops.energy + line1.energy + line2.energy;
        output stored = squeezed + elastic, absorbed = squeezing + rate(elastic);
        output supplied = pump.flow*30 bar - tank.flow*5 bar;
        output lost = valve.lost + line1.lost + line2.lost + drag.lost + stops.lost;
        output command.value, arm.alpha, ram.displacement, ram.force, cap.pressure in bar, ring.pressure in bar;
    }
}

/// The manual's stabilising run.
pub fn at_rest(arm: &ConnectPlmHcd) -> Result<ConnectPlmHcd, Fault> {
    Ok(arm.stabilise()?.mechanism)
}

/// The run of 4 s with and without friction, beside that of ConnectPlmHyd.
pub fn sheet() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("ConnectPlmHCD");
    let mut hyd = connect_plm_hyd::at_rest(&ConnectPlmHyd::new())?.start_with(Dop853::new(RTOL))?;
    let mut same = at_rest(&ConnectPlmHcd { friction: 1000.0, ..ConnectPlmHcd::new() })?
        .start_with(Dop853::new(RTOL))?;
    let mut free = at_rest(&ConnectPlmHcd::new())?.start_with(Dop853::new(RTOL))?;
    sheet.theory("F jack", free.ram_force(), "N", hyd.press_force(), 1e-6);
    sheet.theory("p1", free.cap_pressure() / 1e5, "bar", hyd.press_pressure1() / 1e5, 1e-9);
    let balance = balance::run(&mut free, (6_000, 2.5e-4), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        springs: s.stored(),
        absorbed: s.absorbed(),
        supplied: s.supplied(),
        lost: s.lost(),
        loads: s.load_power(),
    })?;
    hyd.step(4.0)?;
    same.step(4.0)?;
    free.step(2.5)?;
    let [hyd, same, free] = [hyd.ram_displacement(), same.ram_displacement(), free.ram_displacement()];
    sheet.theory("final displacement with the friction of HJO20", same, "m", hyd, 1e-9);
    sheet.model("final displacement without friction", free, "m", 0.0166, 1e-4);
    sheet.balance(balance);
    Ok(sheet)
}

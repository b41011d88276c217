//! An arm on a hydraulic jack with servo-valve, lines and end stops (the manual, section 3.2.1), at rest at first.

plm::mechanism! {
    /// The arm, its jack and the oil.
    pub Arm {
        gravity: 9.81 m/s^2;
        emit: step(rk4);
        ground { port o0: (0, 0) m; port foot: (0, -0.25) m; }
        body arm {
            mass: 100 kg;
            inertia: 0.01 kg*m^2;
            port jack: (-0.5, 0) m;
            port o0: (-0.8, 0) m;
            start angle: 20 deg, locked;
        }
        revolute hinge(ground.o0, arm.o0);
        jack ram(ground.foot, arm.jack) { free_length: 0.22 m; }
        cylinder press(ram.slider) {
            piston_diameter: 50 mm;
            rod_diameter: 30 mm;
            stroke: 0.35 m;
            friction: 1000 N/(m/s);
            chamber1.oil.gas_content: 0.001;
            chamber2.oil.gas_content: 0.001;
            chamber1.pressure: 27.25875503088503 bar;
            chamber2.pressure: 5 bar;
        }
        oil_line line1(press.port1) { inlet.oil.gas_content: 0.001; inlet.pressure: 27.25875503088503 bar; }
        oil_line line2(press.port2) { inlet.oil.gas_content: 0.001; inlet.pressure: 5 bar; }
        servo_valve valve(pump.port, line1.port, line2.port, tank.port) {
            signal: -0.2*command.value;
            rated_drop: 0.5 bar;
            frequency: 20 Hz;
        }
        oil_source pump() { pressure: 30 bar; }
        oil_tank tank() { pressure: 5 bar; }
        ramps command() { duration1: 0.02 s; duration2: 0.05 s; end2: 1; duration3: 1 s; start3: 1; end3: 1; }
    }
}

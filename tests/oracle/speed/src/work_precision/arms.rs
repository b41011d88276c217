//! The manual's hydraulic arms (sections 3.2.1 and 3.3) with the valve that reaches the end stops.
//!
//! They begin at rest: the pressures are those of the equilibrium.

/// A servo-hydraulic jack with its valve and lines.
macro_rules! arms {
    ($module:ident: $($formulation:tt)*) => {
        pub mod $module {
            plm::parts! {
                pub(crate) hydraulics {
                    /// Source, tank, valve, two lines and cylinder of the manual's Table 4.
                    part actuator(rod: slider) {
                        input signal: 1 = 0;
                        param start_pressure: Pa;
                        cylinder press(rod) {
                            piston_diameter: 50 mm;
                            rod_diameter: 30 mm;
                            stroke: 0.35 m;
                            friction: 1000 N/(m/s);
                            chamber1.oil.gas_content: 0.001;
                            chamber2.oil.gas_content: 0.001;
                            chamber1.pressure: start_pressure;
                            chamber2.pressure: 5 bar;
                        }
                        oil_line line1(press.port1) { inlet.oil.gas_content: 0.001; inlet.pressure: start_pressure; }
                        oil_line line2(press.port2) { inlet.oil.gas_content: 0.001; inlet.pressure: 5 bar; }
                        servo_valve valve(pump.port, line1.port, line2.port, tank.port) {
                            signal: signal;
                            rated_drop: 0.5 bar;
                            frequency: 20 Hz;
                        }
                        oil_source pump() { pressure: 30 bar; }
                        oil_tank tank() { pressure: 5 bar; }
                        output pressure1 = press.pressure1;
                        output pressure2 = press.pressure2;
                    }
                }
            }

            plm::mechanism! {
                use hydraulics;
                /// One arm, section 3.2.1.
                pub Arm {
                    $($formulation)*
                    gravity: 9.81 m/s^2;
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
                    actuator left(ram.slider) { signal: -0.2*command.value; start_pressure: 27.25875503088503 bar; }
                    ramps command() {
                        duration1: 0.5 s;
                        duration2: 0.5 s; end2: 1;
                        duration3: 0.5 s; start3: 1; end3: 1;
                        duration4: 1 s; start4: 1;
                    }
                    output arm.angle, left.pressure1, left.pressure2;
                }
            }

            plm::mechanism! {
                use hydraulics;
                /// Two arms, section 3.3.
                pub Arms {
                    $($formulation)*
                    gravity: 9.81 m/s^2;
                    ground { port o0: (0, 0) m; port foot: (0, -0.25) m; }
                    body arm {
                        mass: 100 kg;
                        inertia: 0.01 kg*m^2;
                        port o0: (-0.4, 0) m;
                        port rail: (-0.2, 0) m;
                        port jack: (-0.1, 0) m;
                        start angle: 20 deg, locked;
                    }
                    body beam {
                        mass: 100 kg;
                        inertia: 0.01 kg*m^2;
                        port foot: (-0.5, 0) m;
                        port tip: (0.5, 0) m;
                        start x: 0.9 m, locked;
                        start angle: 20 deg;
                    }
                    revolute hinge(ground.o0, arm.o0);
                    prismatic guide(arm.rail, beam.foot);
                    jack ram(ground.foot, arm.jack) { free_length: 0.22 m; }
                    actuator left(ram.slider) { signal: -0.2*lower.value; start_pressure: 44.03251889491723 bar; }
                    actuator right(guide.slider) { signal: 0.1*extend.value; start_pressure: 4.908798294872963 bar; }
                    ramps lower() {
                        duration1: 0.5 s;
                        duration2: 0.5 s; end2: 1;
                        duration3: 0.5 s; start3: 1; end3: 1;
                        duration4: 1 s; start4: 1;
                    }
                    ramps extend() {
                        duration1: 0.5 s;
                        duration2: 0.5 s; end2: 1;
                        duration3: 0.5 s; start3: 1; end3: 1;
                        duration4: 0.5 s; start4: 1;
                    }
                    output arm.angle, guide.displacement, left.pressure1, right.pressure1;
                }
            }
        }
    };
}
arms!(arms_tree: formulation: tree;);
arms!(arms_absolute: formulation: absolute;);

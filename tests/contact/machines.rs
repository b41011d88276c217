//! Mechanisms of several scenes.

/// A slider-crank with these items beside its joints, in a formulation, from an angular velocity of the crank, rad/s.
macro_rules! slider_crank {
    ($name:ident, $formulation:ident, $omega:literal, $($rows:tt)*) => {
        mechanism! {
            pub $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                param mu = 0.2;
                ground { port o: (0, 0) m; port rail: (0, 0) m, axis: 0 deg; }
                body crank {
                    mass: 1 kg; inertia: 0.01 kg*m^2;
                    port o: (0, 0) m; port a: (0.1, 0) m;
                    start angle: 40 deg, locked;
                    start omega: $omega rad/s, locked;
                }
                body rod {
                    mass: 0.5 kg; inertia: 0.004 kg*m^2;
                    port a: (-0.15, 0) m; port b: (0.15, 0) m;
                    start x: 0.2 m; start angle: -12 deg;
                }
                body slider { mass: 2 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; start x: 0.36 m; }
                revolute o(ground.o, crank.o);
                revolute a(crank.a, rod.a);
                revolute b(rod.b, slider.b);
                prismatic rail(ground.rail, slider.b);
                $($rows)*
            }
        }
    };
}

pub(crate) use slider_crank;

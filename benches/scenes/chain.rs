//! S3: a chain of uniform bars that hangs from one end, horizontal at rest, 1 m and 1 kg in all.

/// Declares the chain of so many bars as a mechanism.
macro_rules! chain {
    ($name:ident, $bars:tt) => {
        plm::mechanism! {
            /// Uniform bars in a row, released horizontally.
            pub $name {
                gravity: 9.81 m/s^2;
                ground { port o: (0, 0) m; }
                repeat i in 0..$bars {
                    body bar[i] {
                        mass: 1 kg / $bars;
                        inertia: 1 kg*m^2 / (12 * $bars^3);
                        port a: (-0.5 / $bars, 0) m;
                        port b: (0.5 / $bars, 0) m;
                        start x: (i + 0.5) / $bars * 1 m;
                    }
                }
                revolute pin[0](ground.o, bar[0].a);
                repeat i in 1..$bars {
                    revolute pin[i](bar[i-1].b, bar[i].a);
                }
            }
        }
    };
}

pub(crate) use chain;

//! Bodies without mass in driven mechanisms.

/// Mechanisms whose bodies have the mass and the inertia that are written, or none.
macro_rules! driven {
    ($module:ident $($mass:tt)*) => {
        mod $module {
            scene! {
                /// A four-bar linkage: its loop is a dyad.
                pub FourBar {
                    gravity: 9.81 m/s^2;
                    param speed: rad/s = 3 rad/s;
                    ground { port o: (0, 0) m; port r: (0.4, 0) m; }
                    body crank { $($mass)* port o: (-0.05, 0) m; port pin: (0.05, 0) m; start angle: 60 deg; }
                    body coupler { $($mass)* port a: (-0.2, 0) m; port b: (0.2, 0) m; port tip: (0.02, 0.1) m; }
                    body rocker { $($mass)* port a: (0.15, 0) m; port r: (-0.15, 0) m; start angle: 90 deg; }
                    revolute drive(ground.o, crank.o);
                    revolute pin(crank.pin, coupler.a);
                    revolute knee(coupler.b, rocker.a);
                    revolute pivot(ground.r, rocker.r);
                    spring cord(ground.r, coupler.tip) { stiffness: 100 N/m; free_length: 0.1 m; }
                    constraint turns: crank.angle = 60 deg + speed*t + 0.2 rad*sin(5 rad/s*t);
                    output coupler.tip.position, coupler.tip.velocity, ratio = rocker.omega/crank.omega, cord.force;
                    output tip_acceleration = coupler.tip.acceleration, rocker.alpha;
                }
            }
            scene! {
                /// A plate on three legs: its loops are solved by Newton's iteration.
                pub Plate {
                    ground { port a: (0, 0) m; port b: (1, 0) m; port c: (0.5, 0.9) m; }
                    body crank[0] { $($mass)* port o: (-0.1, 0) m; port e: (0.1, 0) m; start angle: 20 deg; }
                    body crank[1] { $($mass)* port o: (-0.1, 0) m; port e: (0.1, 0) m; start angle: 20 deg; }
                    body crank[2] { $($mass)* port o: (-0.1, 0) m; port e: (0.1, 0) m; start angle: -20 deg; }
                    body plate {
                        $($mass)*
                        port a: (-0.4, -0.3) m, angle: 35 deg;
                        port b: (0.4, -0.3) m, angle: 140 deg;
                        port c: (0, 0.4) m, angle: 100 deg;
                        start x: 0.5 m;
                        start y: 0.3 m;
                    }
                    revolute o[0](ground.a, crank[0].o);
                    revolute o[1](ground.b, crank[1].o);
                    revolute o[2](ground.c, crank[2].o);
                    pin_slot slot[0](plate.a, crank[0].e);
                    pin_slot slot[1](plate.b, crank[1].e);
                    pin_slot slot[2](plate.c, crank[2].e);
                    constraint first: crank[0].angle = 0.4 rad*sin(3 rad/s*t);
                    constraint second: crank[1].angle = 0.3 rad*cos(2 rad/s*t);
                    constraint third: crank[2].angle = 0.2 rad*sin(4 rad/s*t) - 0.1 rad;
                    output plate.position, plate.velocity, plate.angle, plate.omega;
                    output plate.acceleration, plate.alpha;
                }
            }
            scene! {
                /// A pendulum with a mass on a crank that is driven.
                pub Hanging {
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    body crank { $($mass)* port o: (0, 0) m; port pin: (0.1, 0) m; }
                    body bob { mass: 0.5 kg; inertia: 0.01 kg*m^2; port pin: (0, 0.2) m; start angle: 20 deg, locked; }
                    revolute drive(ground.o, crank.o);
                    revolute pin(crank.pin, bob.pin) { damping: 0.01 N*m*s/rad; }
                    constraint turns: crank.angle = 1 rad*(1 - cos(7 rad/s*t));
                    output bob.position, bob.velocity, pin.angle, bob.x, bob.y, bob.omega;
                    output bob.alpha, pin.force;
                }
            }
        }
    };
}

pub(crate) use driven;

//! The scenes. Each is a macro, so that it can be declared once for every formulation: what is handed over after the name of
//! the module stands among the items of the mechanism.
//!
//! SI units; uniform bars have J = m L^2 / 12. The outputs are what is measured, in the order of the references.

#[path = "../../../../support/scenes.rs"]
mod shared;

use shared::{andrews, double_pendulum, four_bar, slider_crank};

// S1: two bars, released at 45 and 0 deg.
double_pendulum!(s1_tree: formulation: tree; output arm.position, forearm.position;);
double_pendulum!(s1_absolute: formulation: absolute; output arm.position, forearm.position;);

// S2: crank at 60 deg, elbow up, at rest.
four_bar!(s2_loops: formulation: loops; output crank.position, coupler.position, rocker.position;);
four_bar!(s2_absolute: formulation: absolute; output crank.position, coupler.position, rocker.position;);

/// S3: sixteen bars of 1/16 m and 1/16 kg in a row, horizontal at rest.
macro_rules! chain {
    ($module:ident: $($formulation:tt)*) => {
        pub mod $module {
            plm::mechanism! {
                /// Chain of sixteen uniform bars.
                pub Chain {
                    $($formulation)*
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    repeat i in 0..16 {
                        body bar[i] {
                            mass: 1 kg / 16;
                            inertia: 1 kg*m^2 / (12 * 16^3);
                            port a: (-0.5 / 16, 0) m;
                            port b: (0.5 / 16, 0) m;
                            start x: (i + 0.5) / 16 * 1 m;
                        }
                        output bar[i].position;
                    }
                    revolute pin[0](ground.o, bar[0].a);
                    repeat i in 1..16 {
                        revolute pin[i](bar[i-1].b, bar[i].a);
                    }
                }
            }
        }
    };
}
chain!(s3_tree: formulation: tree;);
chain!(s3_absolute: formulation: absolute;);

/// S4: two windows of uprights and tops of 1 m and 1 kg; the tops start at 1 m/s (problem A02 of the IFToMM benchmarks).
macro_rules! ladder {
    ($module:ident: $($formulation:tt)*) => {
        pub mod $module {
            plm::mechanism! {
                /// Ladder of two four-bars.
                pub Ladder {
                    $($formulation)*
                    gravity: 9.81 m/s^2;
                    ground { port f0: (0, 0) m; port f1: (1, 0) m; port f2: (2, 0) m; }
                    repeat i in 0..=2 {
                        body up[i] {
                            mass: 1 kg;
                            inertia: 1 kg*m^2/12;
                            port low: (-0.5, 0) m;
                            port high: (0.5, 0) m;
                            start x: i*1 m;
                            start angle: 90 deg;
                            start vx: 0.5 m/s;
                            start omega: -1 rad/s;
                        }
                        output up[i].position;
                    }
                    repeat i in 1..=2 {
                        body top[i] {
                            mass: 1 kg;
                            inertia: 1 kg*m^2/12;
                            port a: (-0.5, 0) m;
                            port b: (0.5, 0) m;
                            start x: (i - 0.5)*1 m;
                            start y: 1 m;
                            start vx: 1 m/s;
                        }
                        revolute left[i](up[i - 1].high, top[i].a);
                        revolute right[i](top[i].b, up[i].high);
                        output top[i].position;
                    }
                    revolute foot[0](ground.f0, up[0].low);
                    revolute foot[1](ground.f1, up[1].low);
                    revolute foot[2](ground.f2, up[2].low);
                }
            }
        }
    };
}
ladder!(s4_loops: formulation: loops;);
ladder!(s4_absolute: formulation: absolute;);

// S6: crank at 60 deg at rest, 1 N m on it.
slider_crank!(s6_loops: formulation: loops; output crank.position, rod.position, slider.position;);
slider_crank!(s6_absolute: formulation: absolute; output crank.position, rod.position, slider.position;);

/// A01 of the IFToMM benchmarks: 1 kg at 1 m, released horizontally on the left. An equal mass at the pivot, which does not
/// move, makes it a body with an inertia.
macro_rules! pendulum {
    ($module:ident: $($formulation:tt)*) => {
        pub mod $module {
            plm::mechanism! {
                /// Simple pendulum of 1 m.
                pub Pendulum {
                    $($formulation)*
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    body bob {
                        mass: 2 kg;
                        inertia: 0.5 kg*m^2;
                        port pivot: (0, 0.5) m;
                        port tip: (0, -0.5) m;
                        start angle: -90 deg, locked;
                    }
                    revolute hinge(ground.o, bob.pivot);
                    output tip = bob.tip.position;
                }
            }
        }
    };
}
pendulum!(a01_tree: formulation: tree;);
pendulum!(a01_absolute: formulation: absolute;);

/// S5: Andrews' squeezing mechanism (W. Schiehlen, Multibody Systems Handbook, Springer 1990; F. Mazzia, C. Magherini, Test
/// Set for Initial Value Problem Solvers).
macro_rules! squeezing {
    ($module:ident: $($formulation:tt)*) => {
        andrews! {
            $module: $($formulation)*
            output beta = k1.angle;
            output Theta = k2.angle - k1.angle;
            output gamma = k3.angle;
            output Phi = k4.angle - k5.angle;
            output delta = k5.angle;
            output Omega = k6.angle - k7.angle;
            output epsilon = k7.angle;
        }
    };
}
squeezing!(s5_loops: formulation: loops;);
squeezing!(s5_absolute: formulation: absolute;);
/// The car axis of the IVP test set, with K = M eps^2 / 2 = 5e-4 kg at both ends of a rod of 1 m, springs of 1 N/m and
/// gravity 1 m/s^2. The left wheel stands at the origin, the right one moves on a circle of 1 m about it, and the left end
/// of the rod keeps to the normal of the line through the wheels.
macro_rules! car_axis {
    ($module:ident: $($formulation:tt)*) => {
        pub mod $module {
            plm::mechanism! {
                /// Car axis on a bumpy road.
                pub CarAxis {
                    $($formulation)*
                    gravity: 1 m/s^2;
                    let bump = 0.1*sin(10 rad/s * t);
                    ground {
                        port left: (0, 0) m, axis: asin(bump) + 90 deg;
                        port right: (sqrt(1 - bump^2)*1 m, bump*1 m);
                    }
                    body rod {
                        mass: 1e-3 kg;
                        inertia: 2.5e-4 kg*m^2;
                        port left: (-0.5, 0) m;
                        port right: (0.5, 0) m;
                        start x: 0.5 m;
                        start y: 0.5 m, locked;
                        start angle: 0, locked;
                        start vx: -0.5 m/s;
                        start vy: 0, locked;
                        start omega: 0, locked;
                    }
                    pin_slot upright(ground.left, rod.left);
                    spring left(ground.left, rod.left) { stiffness: 1 N/m; free_length: 0.5 m; }
                    spring right(ground.right, rod.right) { stiffness: 1 N/m; free_length: 0.5 m; }
                    output rod.left.position, rod.right.position;
                }
            }
        }
    };
}
car_axis!(car_axis_absolute: formulation: absolute;);

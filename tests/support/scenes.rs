//! Benchmark scenes, declared as a user would.
//!
//! SI units, angles absolute from +x, uniform bars have `J = m L^2 / 12`. What is handed over after the name of the module
//! stands among the items of the mechanism: its outputs, and settings such as `formulation: absolute;`. What is handed over in brackets
//! before that name declares it in place of `plm::mechanism!`.

/// S1: double pendulum of two bars, released at 45 and 0 deg.
macro_rules! double_pendulum {
    ($module:ident: $($item:tt)*) => {
        double_pendulum!([plm::mechanism] $module: $($item)*);
    };
    ([$($declare:tt)+] $module:ident: $($item:tt)*) => {
        pub mod $module {
            $($declare)+! {
                /// Double pendulum without damping.
                pub DoublePendulum {
                    gravity: 9.81 m/s^2;
                    ground { port o0: (0, 0) m; }
                    body arm {
                        mass: 10 kg;
                        inertia: 0.01 kg*m^2;
                        port o0: (-0.5, 0) m;
                        port p12: (0.5, 0) m;
                        start angle: 45 deg, locked;
                    }
                    body forearm {
                        mass: 10 kg;
                        inertia: 0.01 kg*m^2;
                        port p12: (-1, 0) m;
                        start angle: 0 deg, locked;
                    }
                    revolute shoulder(ground.o0, arm.o0);
                    revolute elbow(arm.p12, forearm.p12);
                    $($item)*
                }
            }
        }
    };
}
pub(crate) use double_pendulum;

/// S2: four-bar linkage, crank at 60 deg, elbow up.
macro_rules! four_bar {
    ($module:ident: $($item:tt)*) => {
        four_bar!([plm::mechanism] $module: $($item)*);
    };
    ([$($declare:tt)+] $module:ident: $($item:tt)*) => {
        pub mod $module {
            $($declare)+! {
                /// Four-bar linkage: ground 1 m, crank 0.3 m, coupler 0.9 m, rocker 0.7 m.
                pub FourBar {
                    gravity: 9.81 m/s^2;
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body crank {
                        mass: 0.3 kg;
                        inertia: 0.00225 kg*m^2;
                        port a: (-0.15, 0) m;
                        port b: (0.15, 0) m;
                        start angle: 60 deg, locked;
                    }
                    body coupler {
                        mass: 0.9 kg;
                        inertia: 0.06075 kg*m^2;
                        port b: (-0.45, 0) m;
                        port c: (0.45, 0) m;
                        start angle: 30 deg;
                    }
                    body rocker {
                        mass: 0.7 kg;
                        inertia: 0.7 kg * (0.7 m)^2 / 12;
                        port d: (-0.35, 0) m;
                        port c: (0.35, 0) m;
                        start x: 1 m;
                        start angle: 95 deg;
                    }
                    revolute drive(ground.a, crank.a);
                    revolute crank_coupler(crank.b, coupler.b);
                    revolute coupler_rocker(coupler.c, rocker.c);
                    revolute pivot(ground.d, rocker.d);
                    $($item)*
                }
            }
        }
    };
}
pub(crate) use four_bar;

/// S6: slider-crank with a torque on the crank.
macro_rules! slider_crank {
    ($module:ident: $($item:tt)*) => {
        slider_crank!([plm::mechanism] $module: $($item)*);
    };
    ([$($declare:tt)+] $module:ident: $($item:tt)*) => {
        pub mod $module {
            $($declare)+! {
                /// Slider-crank: crank 0.2 m, rod 0.6 m, slider on y = 0, 1 N m on the crank.
                pub SliderCrank {
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    body crank {
                        mass: 0.2 kg;
                        inertia: 0.2 kg * (0.2 m)^2 / 12;
                        port o: (-0.1, 0) m;
                        port pin: (0.1, 0) m;
                        start angle: 60 deg, locked;
                    }
                    body rod {
                        mass: 0.6 kg;
                        inertia: 0.018 kg*m^2;
                        port pin: (-0.3, 0) m;
                        port wrist: (0.3, 0) m;
                        start angle: -17 deg;
                    }
                    body slider {
                        mass: 0.5 kg;
                        inertia: 0.001 kg*m^2;
                        port wrist: (0, 0) m;
                        start x: 0.67 m;
                    }
                    revolute drive(ground.o, crank.o) { drive: 1 N*m; }
                    revolute crank_pin(crank.pin, rod.pin);
                    revolute wrist_pin(rod.wrist, slider.wrist);
                    prismatic guide(ground.o, slider.wrist);
                    $($item)*
                }
            }
        }
    };
}
pub(crate) use slider_crank;

/// S5: Andrews' squeezing mechanism (IVP test set; W. Schiehlen, Multibody Systems Handbook, 1990).
macro_rules! andrews {
    ($module:ident: $($item:tt)*) => {
        andrews!([plm::mechanism] $module: $($item)*);
    };
    ([$($declare:tt)+] $module:ident: $($item:tt)*) => {
        pub mod $module {
            $($declare)+! {
                /// Andrews' squeezing mechanism: seven bodies, ten revolutes, a spring and a driving torque.
                pub Andrews {
                    ground { port a: (0.0, 0.0) m; port b: (-0.03635, 0.03273) m; port c: (-0.06934, -0.00227) m; port d: (0.014, 0.072) m; }
                    body k1 {
                        mass: 0.04325 kg;
                        inertia: 2.194e-06 kg*m^2;
                        port a: (-0.00092, 0.0) m;
                        port b: (0.00608, 0.0) m;
                        start x: 0.0009182485980307614 m; start y: -5.674074562905483e-05 m;
                        start angle: -0.06171389001427645 rad, locked;
                    }
                    body k2 {
                        mass: 0.00365 kg;
                        inertia: 4.41e-07 kg*m^2;
                        port a: (0.0115, 0.0) m;
                        port b: (-0.0165, 0.0) m;
                        start x: -0.0044914333599330725 m; start y: 0.0002775362557942899 m;
                        start angle: -0.06171389001427645 rad;
                    }
                    body k3 {
                        mass: 0.02373 kg;
                        inertia: 5.255e-06 kg*m^2;
                        port a: (-0.01043, -0.01626) m;
                        port b: (-0.01043, 0.01874) m;
                        port c: (0.00957, 0.00074) m;
                        start x: -0.018742186670315457 m; start y: 0.020485106789073934 m;
                        start angle: 0.45527981916307037 rad;
                    }
                    body k4 {
                        mass: 0.00706 kg;
                        inertia: 5.667e-07 kg*m^2;
                        port a: (0.0, -0.01421) m;
                        port b: (0.0, 0.00579) m;
                        start x: -0.030222939830158887 m; start y: 0.012071182356663938 m;
                        start angle: 0.7100333697097284 rad;
                    }
                    body k5 {
                        mass: 0.0705 kg;
                        inertia: 1.169e-05 kg*m^2;
                        port a: (0.01692, -0.00916) m;
                        port b: (-0.02308, -0.00916) m;
                        start x: -0.05323682815570414 m; start y: 0.016631847966616306 m;
                        start angle: 0.48736497954384256 rad;
                    }
                    body k6 {
                        mass: 0.00706 kg;
                        inertia: 5.667e-07 kg*m^2;
                        port a: (0.01421, 0.0) m;
                        port b: (-0.00579, 0.0) m;
                        start x: -0.028543268536783597 m; start y: -0.010722254707252287 m;
                        start angle: 1.0078790543839353 rad;
                    }
                    body k7 {
                        mass: 0.05498 kg;
                        inertia: 1.912e-05 kg*m^2;
                        port a: (-0.01228, -0.03551) m;
                        port b: (-0.01228, 0.00449) m;
                        start x: -0.06100930166728716 m; start y: 0.007807597198208284 m;
                        start angle: 1.2305474445498212 rad;
                    }
                    revolute r1(ground.a, k1.a);
                    revolute r2(k1.b, k2.a);
                    revolute r3(k2.b, k3.a);
                    revolute r4(ground.b, k3.b);
                    revolute r5(k2.b, k4.a);
                    revolute r6(k4.b, k5.a);
                    revolute r7(ground.c, k5.b);
                    revolute r8(k2.b, k6.a);
                    revolute r9(k6.b, k7.a);
                    revolute r10(ground.c, k7.b);
                    force motor(k1.a) { torque: 0.033 N*m; }
                    spring squeeze(ground.d, k3.c) { stiffness: 4530 N/m; free_length: 0.07785 m; }
                    $($item)*
                }
            }
        }
    };
}
pub(crate) use andrews;

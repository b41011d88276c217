//! S5: Andrews' squeezing mechanism (W. Schiehlen, Multibody Systems Handbook, Springer 1990; F. Mazzia, C. Magherini, Test
//! Set for Initial Value Problem Solvers).

/// Declares it; see `scenes.rs`.
macro_rules! andrews {
    ($module:ident: $($rung:tt)*) => {
        pub mod $module {
            plm::mechanism! {
                /// Seven bodies, ten revolutes, a spring and a driving torque.
                pub Andrews {
                    $($rung)*
                    ground {
                        port a: (0, 0) m;
                        port b: (-0.03635, 0.03273) m;
                        port c: (-0.06934, -0.00227) m;
                        port d: (0.014, 0.072) m;
                    }
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
                    output beta = k1.angle;
                    output Theta = k2.angle - k1.angle;
                    output gamma = k3.angle;
                    output Phi = k4.angle - k5.angle;
                    output delta = k5.angle;
                    output Omega = k6.angle - k7.angle;
                    output epsilon = k7.angle;
                }
            }
        }
    };
}
andrews!(s5_loops: rung: loops;);
andrews!(s5_absolute: rung: absolute;);

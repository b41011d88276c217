//! Mechanisms whose implicit methods solve linearised equations, or take a matrix of derivatives that is emitted entry by entry.

/// A chain that holds a bit of everything: revolutes with springs, a slide, a slot, welds, a body that hangs on nothing, a
/// spring from end to end, a drag by the place and velocity of a body, a pivot that moves, first-order states.
pub mod zoo {
    plm::mechanism! {
        pub Zoo {
            gravity: 9.81 m/s^2;
            param stiffness: N/m = 40 N/m;
            input push: N = 2 N;
            ground { port o: (0.1 m*sin(3 rad/s*t), 0.05 m*cos(2 rad/s*t)); port rail: (0.3, 1) m, angle: 20 deg; }
            repeat i in 0..9 {
                body bar[i] {
                    mass: 0.3 kg + i*0.1 kg; inertia: 0.01 kg*m^2;
                    port a: (-0.2, 0.01) m; port b: (0.15, 0.02) m;
                    start angle: 20 deg + i*25 deg, locked; start omega: 1 rad/s - i*0.7 rad/s, locked;
                }
            }
            body shoe { mass: 0.5 kg; inertia: 0.02 kg*m^2; port in: (0.05, 0) m, angle: 30 deg; port out: (0, 0.1) m, angle: -35 deg; }
            body tip { mass: 0.2 kg; inertia: 0.01 kg*m^2; port in: (0.1, 0) m; port seam: (0, 0.1) m, angle: 40 deg; start angle: 1 rad, locked; start omega: 2 rad/s, locked; }
            body cap { mass: 0.1 kg; inertia: 0.001 kg*m^2; port seam: (0.02, 0.03) m, angle: 10 deg; }
            body block { mass: 1 kg; inertia: 0.01 kg*m^2; port rail: (0, 0) m; port pin: (0, -0.05) m; }
            body load { mass: 0.4 kg; inertia: 0.01 kg*m^2; port pin: (0.1, 0.1) m; start angle: 2 rad, locked; }
            body bird { mass: 0.3 kg; inertia: 0.01 kg*m^2; port hook: (0.05, 0.02) m; start x: 2 m, locked; start vy: 1 m/s, locked; start omega: 3 rad/s, locked; }
            revolute pin[0](ground.o, bar[0].a) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; }
            repeat i in 1..9 { revolute pin[i](bar[i].a, bar[i-1].b) { stiffness: 2 N*m/rad; damping: 0.05 N*m*s/rad; } }
            prismatic sleeve(bar[4].b, shoe.in) { stiffness: 200 N/m; damping: 3 N*s/m; }
            pin_slot slot(shoe.out, tip.in) { stiffness: 150 N/m; }
            weld seam(tip.seam, cap.seam);
            prismatic rail(block.rail, ground.rail) { stiffness: stiffness; drive: filtered; }
            revolute bell(load.pin, block.pin);
            spring leash(bar[8].b, bird.hook) { stiffness: 50 N/m; damping: 0.4 N*s/m; free_length: 0.4 m; }
            force drag(cap.seam) { x: -0.3 N*s/m*cap.vx - 2 N/m*cap.y; y: -0.1 N*s^2/m^2*cap.vy*abs(cap.vy); }
            state filtered: N = 3 N;
            rate filtered = (push - filtered + 1 N/m*tip.x)/0.2 s;
        }
    }
}

/// Loops with a slide, a spring across, a drive by the time and a first-order state, in absolute coordinates.
pub mod mill {
    plm::mechanism! {
        pub Mill {
            gravity: 9.81 m/s^2;
            formulation: absolute;
            ground { port o: (0, 0) m; port p: (1.5 m, 0.02 m*sin(5 rad/s*t)); port rail: (2, 0.4) m, angle: 10 deg; }
            body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.2, 0) m; port b: (0.2, 0) m; start angle: 60 deg, locked; start omega: 4 rad/s, locked; }
            body rod { mass: 2 kg; inertia: 0.2 kg*m^2; port a: (-0.6, 0) m; port b: (0.6, 0) m; port c: (0.1, 0.3) m; }
            body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port a: (-0.4, 0) m; port b: (0.4, 0) m; start angle: 95 deg; }
            body link { mass: 0.5 kg; inertia: 0.03 kg*m^2; port a: (-0.4, 0) m; port b: (0.4, 0) m; }
            body slide { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; }
            revolute r1(ground.o, crank.a) { drive: filtered; }
            revolute r2(crank.b, rod.a);
            revolute r3(rod.b, rocker.b) { damping: 0.2 N*m*s/rad; }
            revolute r4(ground.p, rocker.a) { stiffness: 3 N*m/rad; }
            revolute r5(rod.c, link.a);
            revolute r6(link.b, slide.a);
            prismatic rail(slide.a, ground.rail) { stiffness: 200 N/m; damping: 5 N*s/m; }
            spring across(crank.b, rocker.b) { stiffness: 80 N/m; damping: 1 N*s/m; free_length: 0.5 m; }
            state filtered: N*m = 1 N*m;
            rate filtered = (2 N*m - filtered - 0.1 N*m*s*crank.omega)/0.3 s;
        }
    }
}

/// A loop with a chain of lags, whose matrix of derivatives is emitted entry by entry.
pub mod loom {
    plm::mechanism! {
        pub Loom {
                gravity: 9.81 m/s^2;
                ground { port o: (0, 0) m; port p: (0.8, 0) m; }
                body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: 40 deg, locked; start omega: 5 rad/s, locked; }
                body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (-0.2, 0) m; port c: (0.2, 0) m; }
                body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.45, 0) m; port p: (-0.45, 0) m; start angle: 120 deg; }
                revolute o(ground.o, crank.a) { drive: s3; }
                revolute b(crank.b, coupler.b);
                revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
                revolute p(ground.p, rocker.p) { stiffness: 2 N*m/rad; }
                state s1: N*m = 0.5 N*m; rate s1 = (1 N*m*cos(3 rad/s*t) - s1)/0.01 s;
                state s2: N*m = 0.5 N*m; rate s2 = (s1 - s2)/0.01 s;
                state s3: N*m = 0.5 N*m; rate s3 = (s2 - s3 - 0.1 N*m*s/rad*rocker.omega)/0.01 s;
        }
    }
}

/// A chain of so many bars, with springs and dampers in its hinges.
macro_rules! chain {
    ($module:ident, $bars:tt) => {
        mod $module {
            plm::mechanism! {
                pub Chain {
                    gravity: 9.81 m/s^2;
                    ground { port o: (0, 0) m; }
                    repeat i in 0..$bars {
                        body bar[i] {
                            mass: 1 kg / $bars; inertia: 1 kg*m^2 / (12 * $bars^3);
                            port a: (-0.5 / $bars, 0) m; port b: (0.5 / $bars, 0) m;
                            start x: (i + 0.5) / $bars * 1 m;
                        }
                    }
                    revolute pin[0](ground.o, bar[0].a) { damping: 1e-3 N*m*s/rad; }
                    repeat i in 1..$bars {
                        revolute pin[i](bar[i-1].b, bar[i].a) { stiffness: 0.1 N*m/rad; damping: 1e-3 N*m*s/rad; }
                    }
                }
            }
        }
    };
}
pub(crate) use chain;

//! Mechanisms that need more than straight-line code now and then.

plm::mechanism! {
    /// A pendulum with a parameter, an input and a state of its own.
    pub Driven {
        gravity: 9.81 m/s^2;
        param mass: kg = 1 kg;
        param damping: N*m*s/rad = 0.1 N*m*s/rad;
        input torque: N*m = 0 N*m;
        ground { port o: (0, 0) m; }
        body bob {
            mass: mass;
            inertia: 0.1 kg*m^2;
            port pivot: (-0.5, 0) m;
            start angle: 30 deg, locked;
        }
        revolute hinge(ground.o, bob.pivot) { damping: damping; drive: torque; }
    }
}

plm::mechanism! {
    /// A mass that is pushed between two times of its own.
    pub Pulsed {
        param from: s = 0.1 s;
        param until: s = 0.2 s;
        ground { port o: (0, 0) m; }
        body mass { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; }
        force push(mass.o) { x: if t < from then 0 N else if t < until then 3 N else 0 N; }
    }
}

/// Four bars without gravity; the crank starts at 60 deg with 1 rad/s.
macro_rules! four_bars {
    ($module:ident, $formulation:ident, $crank:literal, $coupler:literal, $rocker:literal) => {
        pub mod $module {
            plm::mechanism! {
                pub FourBars {
                    formulation: $formulation;
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body crank {
                        mass: 1 kg;
                        inertia: 0.04 kg*m^2;
                        port a: (0, 0) m;
                        port b: ($crank, 0) m;
                        start angle: 60 deg, locked;
                        start omega: 1 rad/s, locked;
                    }
                    body coupler {
                        mass: 1 kg;
                        inertia: 0.03 kg*m^2;
                        port b: (0, 0) m;
                        port c: ($coupler, 0) m;
                        start x: 0.35 m;
                        start y: 0.6 m;
                        start angle: -10 deg;
                    }
                    body rocker {
                        mass: 1 kg;
                        inertia: 0.02 kg*m^2;
                        port d: (0, 0) m;
                        port c: ($rocker, 0) m;
                        start x: 1 m;
                        start angle: 80 deg;
                    }
                    revolute pivot_a(ground.a, crank.a);
                    revolute pin_b(crank.b, coupler.b);
                    revolute pin_c(coupler.c, rocker.c);
                    revolute pivot_d(ground.d, rocker.d);
                }
            }
        }
    };
}

// No bar turns fully: each is dead now and then, and its chart is left.
four_bars!(triple_rocker, loops, 0.7, 0.6, 0.5);
four_bars!(triple_rocker_absolute, absolute, 0.7, 0.6, 0.5);
// It lies in one line twice a turn, where elimination without pivoting fails.
four_bars!(parallelogram, absolute, 0.5, 1, 0.5);
four_bars!(parallelogram_in_loops, loops, 0.5, 1, 0.5);

plm::mechanism! {
    /// A pendulum that a torque brings back beyond an angle; it may not come back too fast.
    pub Struck {
        gravity: 9.81 m/s^2;
        param reach: rad = 2 rad;
        param stop: rad = -1.9 rad;
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.1 kg*m^2;
            port pivot: (-0.5, 0) m;
            start angle: -40 deg, locked;
        }
        revolute hinge(ground.o, bob.pivot) {
            damping: 0.02 N*m*s/rad;
            drive: if bob.angle > stop then 0 N*m else 30 N*m;
        }
        require near: bob.omega < reach/1 s;
    }
}

/// Four bars with a torque between two angles of the crank, in joint and in absolute coordinates.
macro_rules! struck_bars {
    ($module:ident, $formulation:ident) => {
        pub mod $module {
            plm::mechanism! {
                pub FourBars {
                    formulation: $formulation;
                    param at: rad = 1 rad;
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body crank {
                        mass: 1 kg;
                        inertia: 0.04 kg*m^2;
                        port a: (0, 0) m;
                        port b: (0.3, 0) m;
                        start angle: 60 deg, locked;
                        start omega: 3 rad/s, locked;
                    }
                    body coupler {
                        mass: 1 kg;
                        inertia: 0.03 kg*m^2;
                        port b: (0, 0) m;
                        port c: (0.9, 0) m;
                        start x: 0.35 m;
                        start y: 0.6 m;
                        start angle: 10 deg;
                    }
                    body rocker {
                        mass: 1 kg;
                        inertia: 0.02 kg*m^2;
                        port d: (0, 0) m;
                        port c: (0.7, 0) m;
                        start x: 1 m;
                        start angle: 80 deg;
                    }
                    revolute pivot_a(ground.a, crank.a);
                    revolute pin_b(crank.b, coupler.b);
                    revolute pin_c(coupler.c, rocker.c);
                    revolute pivot_d(ground.d, rocker.d) {
                        drive: if crank.angle < at then 0 N*m else if crank.angle < at + 2 rad then 0.2 N*m else 0 N*m;
                    }
                }
            }
        }
    };
}

struck_bars!(struck_in_loops, loops);
struck_bars!(struck_absolute, absolute);

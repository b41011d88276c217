//! Rows of contact whose runs from text have the bits of compiled code.

use crate::machines::slider_crank;

scene! {
    pub Ball {
        gravity: 9.81 m/s^2;
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; }
        unilateral floor: ball.y >= 0 m { restitution: 0.5; }
        output push = reaction(floor);
    }
}

scene! {
    pub Oscillator {
        part spring_to_origin(on: body) {
            force on on: (-(100 N/m)*on.x, 0 N);
        }
        param kinetic: N = 0.981 N;
        param adhesion: N = 0.981 N;
        param belt: m/s = 0 m/s;
        body mass { mass: 1 kg; inertia: 1 kg*m^2; start x: 0.1 m; }
        constraint level: mass.angle = 0;
        constraint height: mass.y = 0;
        spring_to_origin spring(mass);
        friction slip: rate(mass.x - belt*t) within kinetic { static: adhesion; }
        output drag = reaction(slip);
    }
}

scene! {
    /// A ball that is thrown down five stairs, each 0.3 m deep and 0.2 m high.
    pub Stairs {
        allow(W0002);
        gravity: 9.81 m/s^2;
        param e = 0.6;
        discrete strikes: 1 = 0;
        body ball { mass: 0.1 kg; inertia: 1e-4 kg*m^2; start y: 0.5 m; start vx: 0.4 m/s; }
        repeat k in 0..5 {
            unilateral tread[k]: ball.y >= -0.2 m*k {
                restitution: e;
                when: ball.x >= 0.3 m*k and ball.x < 0.3 m*(k + 1);
            }
        }
        unilateral ground: ball.y >= -1 m { restitution: e; when: ball.x >= 1.5 m; }
        output strikes;
        when ball.vy > 0 m/s { strikes = strikes + 1; }
    }
}

scene! {
    /// A ball that bounces, and is pushed from a known time on, and between two others.
    pub Timed {
        part pusher(on: body) {
            input force: N = 0 N;
            force on on: (force, 0 N);
        }
        allow(W0002);
        gravity: 9.81 m/s^2;
        body ball { mass: 2 kg; inertia: 1 kg*m^2; start y: 0.3 m; }
        unilateral floor: ball.y >= 0 m { restitution: 0.8; }
        pusher late(ball) { force: if t > 1.5 s then 3 N else 0 N; }
        pusher between(ball) { force: if t > 0.9 s and t < 1.1 s then 5 N else 0 N; }
    }
}

scene! {
    /// A dog that locks two discs where they meet.
    pub Dog {
        allow(W0002);
        discrete locked: 1 = 0;
        body first { mass: 1 kg; inertia: 0.2 kg*m^2; start omega: 4 rad/s; start angle: -1 rad; }
        body second { mass: 1 kg; inertia: 0.6 kg*m^2; start omega: 1 rad/s; }
        constraint lock: first.angle = second.angle { when: locked > 0.5; }
        when first.angle > second.angle { locked = 1; }
        when t > 2 s { locked = 0; }
        when t > 3 s { second.omega = 0 rad/s; }
        output moment = reaction(lock), locked;
    }
}

macro_rules! released {
    ($name:ident, $formulation:ident) => {
        scene! {
            /// A pendulum that is let go on its way up, with a damper in its hinge.
            pub $name {
                formulation: $formulation;
                gravity: 9.81 m/s^2;
                param damping: N*m*s = 0;
                discrete holds: 1 = 1;
                ground { port pivot: (0, 0) m; }
                body bob {
                    mass: 2 kg; inertia: 0.5 kg*m^2; port pivot: (0, 1) m;
                    start angle: -60 deg;
                    start x: -0.8660 m; start y: -0.5000 m;
                }
                revolute hinge(ground.pivot, bob.pivot) { damping: damping; when: holds > 0.5; }
                when bob.angle > 30 deg { holds = 0; }
                output holds, hinge.force, hinge.torque;
            }
        }
    };
}

released!(Released, tree);

macro_rules! hung {
    ($name:ident, $formulation:ident) => {
        scene! {
            /// A bob on a hook, and a rod that two joints with a condition make the last side of a triangle.
            pub $name {
                allow(W0002);
                formulation: $formulation;
                gravity: 9.81 m/s^2;
                discrete holds: 1 = 1;
                ground { port pivot: (0, 0) m; port o: (2, 0) m; port d: (2.5, 0) m; }
                body bob {
                    mass: 2 kg; inertia: 0.5 kg*m^2; port pivot: (0, 1) m;
                    start angle: -60 deg, locked; start omega: 1.5 rad/s, locked;
                    start x: 0.2 m;
                }
                body crank {
                    mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; port a: (0.3, 0) m;
                    start angle: 40 deg;
                }
                body rod {
                    mass: 1 kg; inertia: 0.01 kg*m^2; port a: (-0.2, 0) m; port d: (0.2, 0) m;
                    start x: 2.3 m; start angle: -20 deg;
                }
                revolute hook(ground.pivot, bob.pivot) { when: holds > 0.5; }
                revolute o(ground.o, crank.o);
                revolute a(crank.a, rod.a) { when: t < 1 s; }
                revolute d(rod.d, ground.d) { when: t < 1 s; }
                when bob.angle > 30 deg { holds = 0; }
                output hook.force, holds;
            }
        }
    };
}

hung!(HungInBodies, absolute);

macro_rules! by_law {
    ($name:ident, $law:ident) => {
        scene! {
            pub $name {
                impacts: $law;
                param e = 0.5;
                param friction = 0.5;
                param upper_angle: rad = 20 deg;
                param lower_angle: rad = 30 deg;
                ground { port pivot: (0, 0) m; }
                body first { mass: 1 kg; inertia: 1 kg*m^2; start vx: 1 m/s; }
                body second { mass: 1 kg; inertia: 1 kg*m^2; }
                body third { mass: 1 kg; inertia: 1 kg*m^2; }
                unilateral left: second.x - first.x >= 0 m { restitution: e; }
                unilateral right: third.x - second.x >= 0 m { restitution: e; }
                // Rods of 1 m, their angles from the vertical.
                body upper {
                    mass: 1 kg; inertia: 1/12*(1 kg*m^2);
                    port top: (0, 0.5) m; port low: (0, -0.5) m;
                    start angle: upper_angle, locked;
                    start omega: -0.1 rad/s, locked;
                }
                body lower {
                    mass: 1 kg; inertia: 1/12*(1 kg*m^2);
                    port top: (0, 0.5) m; port tip: (0, -0.5) m;
                    start angle: lower_angle, locked;
                    start omega: -0.2 rad/s, locked;
                }
                revolute hinge(ground.pivot, upper.top);
                revolute elbow(upper.low, lower.top);
                unilateral floor: lower.tip.y + (1 m)*(cos(upper_angle) + cos(lower_angle)) >= 0 m { restitution: e; }
                friction slip: rate(lower.tip.x) within friction*reaction(floor);
            }
        }
    };
}

by_law!(Newton, newton);
by_law!(Sequential, sequential);

/// A four-bar linkage whose rocker strikes a buffer and rubs in its bearing.
macro_rules! four_bar {
    ($name:ident, $formulation:ident) => {
        scene! {
            pub $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                ground { port a: (0, 0) m; port d: (4, 0) m; }
                body crank {
                    mass: 1 kg; inertia: 0.2 kg*m^2;
                    port a: (-1, 0) m; port b: (1, 0) m;
                    start angle: 60 deg, locked;
                    start x: 0.5 m;
                    start y: 0.9 m;
                }
                body coupler {
                    mass: 2 kg; inertia: 0.6 kg*m^2;
                    port b: (-2, 0) m; port c: (2, 0) m;
                    start x: 3 m; start y: 2.6 m; start angle: 20 deg;
                }
                body rocker {
                    mass: 1.5 kg; inertia: 0.4 kg*m^2;
                    port c: (1.5, 0) m; port d: (-1.5, 0) m;
                    start x: 4.5 m; start y: 1.4 m; start angle: 80 deg;
                }
                revolute a(ground.a, crank.a);
                revolute b(crank.b, coupler.b);
                revolute c(coupler.c, rocker.c);
                revolute d(ground.d, rocker.d);
                unilateral buffer: rocker.c.x - 3 m >= 0 m { restitution: 0.4; }
                friction bearing: rate(rocker.angle) within 0.8 N*m;
                output push = reaction(buffer);
                output drag = reaction(bearing);
                output joint = b.force.x;
            }
        }
    };
}

four_bar!(FourBarInCharts, loops);

slider_crank!(InThreePins, loops, 30,
    friction rub: rate(slider.x) within mu*norm(rail.force);
    friction at_o: rate(crank.angle) within mu*(0.01 m)*norm(o.force);
    friction at_a: rate(rod.angle - crank.angle) within mu*(0.01 m)*norm(a.force);
    friction at_b: rate(rod.angle) within mu*(0.01 m)*norm(b.force);
    output lost = reaction(rub)*slider.vx + reaction(at_o)*crank.omega + reaction(at_a)*(rod.omega - crank.omega) + reaction(at_b)*rod.omega;);

macro_rules! rubbing {
    ($name:ident, $formulation:ident) => {
        crate::machines::slider_crank!($name, $formulation, 60,
            // Coefficient of friction times the radius of a pin.
            param arm: m = 3 mm;
            friction in_o: rate(crank.angle) within arm*norm(o.force);
            friction in_a: rate(rod.angle - crank.angle) within arm*norm(a.force);
            // Two reactions bound this one, one of which bounds another one too.
            friction in_b: rate(rod.angle - slider.angle) within arm*norm(b.force) + (1 mm)*norm(o.force);
            friction on_rail: rate(slider.x) within mu*norm(rail.force);
            output carries_o = norm(o.force), carries_a = norm(a.force), carries_b = norm(b.force), carries_rail = norm(rail.force););
    };
}

rubbing!(RubbingInAbsolute, absolute);

macro_rules! linkage {
    ($name:ident, $formulation:ident) => {
        scene! {
            /// A slider-crank whose rod moves a rocker, beside a yoke on a wheel that is driven.
            pub $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                param mu = 0.1;
                param arm: m = 4 mm;
                ground { port o: (0, 0) m; port rail: (0, 0) m, axis: 0 deg; port e: (0.35, 0.3) m; port w: (-1, 0) m; port guide: (-1, 0.5) m, axis: 0 deg; }
                body crank {
                    mass: 1 kg; inertia: 0.01 kg*m^2;
                    port o: (0, 0) m; port a: (0.1, 0) m;
                    start angle: 40 deg, locked; start omega: 6 rad/s, locked;
                }
                body rod {
                    mass: 0.5 kg; inertia: 0.004 kg*m^2;
                    port a: (-0.15, 0) m; port b: (0.15, 0) m; port c: (0, 0.05) m;
                    start x: 0.22 m; start y: 0.03 m; start angle: -12 deg;
                }
                body slider { mass: 2 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; start x: 0.37 m; }
                body link {
                    mass: 0.3 kg; inertia: 0.002 kg*m^2; port c: (-0.1, 0) m; port d: (0.1, 0) m;
                    start x: 0.23 m; start y: 0.18 m; start angle: 94 deg;
                }
                body rocker {
                    mass: 0.4 kg; inertia: 0.003 kg*m^2; port d: (-0.07, 0) m; port e: (0.06, 0.01) m;
                    start x: 0.29 m; start y: 0.29 m;
                }
                revolute o(ground.o, crank.o);
                revolute a(crank.a, rod.a);
                revolute b(slider.b, rod.b);
                prismatic rail(ground.rail, slider.b);
                revolute c(rod.c, link.c);
                revolute d(rocker.d, link.d);
                revolute e(ground.e, rocker.e);
                body wheel {
                    mass: 1 kg; inertia: 0.02 kg*m^2; port w: (0.01, 0) m; port pin: (0.1, 0.02) m;
                    start x: -1 m;
                }
                body yoke { mass: 0.7 kg; inertia: 0.01 kg*m^2; port guide: (0.05, 0) m; port slot: (0, -0.4) m, axis: 80 deg; start x: -1 m; start y: 0.4 m; }
                revolute w(ground.w, wheel.w);
                prismatic guide(ground.guide, yoke.guide);
                pin_slot slot(yoke.slot, wheel.pin);
                constraint drive: wheel.angle = 0.3 rad + 2 rad/s*t;
                friction on_rail: rate(slider.x) within mu*norm(rail.force);
                friction in_a: rate(rod.angle - crank.angle) within arm*norm(a.force);
                friction in_b: rate(rod.angle) within 0.5*arm*norm(b.force);
                friction in_c: rate(link.angle - rod.angle) within arm*norm(c.force);
                friction in_e: rate(rocker.angle) within arm*norm(e.force);
                friction on_guide: rate(guide.displacement) within mu*norm(guide.force);
                friction on_slot: rate(slot.displacement) within 0.2*mu*norm(slot.force);
                output drags = reaction(on_rail) + reaction(on_guide) + reaction(on_slot);
                output torques = reaction(in_a) + reaction(in_b) + reaction(in_c) + reaction(in_e);
                output first = crank.angle, second = rocker.angle, third = link.x;
            }
        }
    };
}

linkage!(LinkageInCharts, loops);

macro_rules! collar {
    ($name:ident, $formulation:ident) => {
        scene! {
            /// A collar on an arm, with a bob that hangs from it; some frictions are bounded by two reactions.
            pub $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                param mu = 0.1;
                param arm: m = 4 mm;
                ground { port o: (0, 0) m; }
                body bar {
                    mass: 1 kg; inertia: 0.1 kg*m^2;
                    port o: (-0.3, 0) m; port guide: (0, 0.02) m, axis: 5 deg;
                    start angle: -20 deg, locked; start omega: 3 rad/s, locked;
                }
                body collar {
                    mass: 0.4 kg; inertia: 0.001 kg*m^2; port guide: (0, 0.01) m; port p: (0.02, -0.03) m;
                    start vx: 0.2 m/s;
                }
                body bob { mass: 0.5 kg; inertia: 0.003 kg*m^2; port p: (0, 0.2) m; start omega: -2 rad/s, locked; start angle: 30 deg, locked; }
                revolute o(ground.o, bar.o);
                prismatic guide(bar.guide, collar.guide) { stiffness: 40 N/m; }
                revolute p(collar.p, bob.p) { damping: 0.01 N*m*s/rad; }
                friction in_o: rate(bar.angle) within arm*norm(o.force);
                friction on_guide: rate(guide.displacement) within mu*norm(guide.force) + 0.05*mu*norm(p.force);
                friction in_p: rate(bob.angle - bar.angle) within arm*norm(p.force) + 0.3*arm*norm(o.force);
                friction slow: rate(bob.x) within 0.05 N;
                output drags = reaction(on_guide);
                output torques = reaction(in_o) + reaction(in_p);
                output first = bar.angle, second = collar.x, third = bob.angle;
            }
        }
    };
}

collar!(CollarInAbsolute, absolute);

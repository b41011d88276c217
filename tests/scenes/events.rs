//! Events that set states: mechanisms whose runs from text have the bits of compiled code.

scene! {
    pub Ball {
        gravity: 9.81 m/s^2;
        param loss = 0.5;
        discrete bounces: 1 = 0;
        state warmth: 1 = 0;
        rate warmth = (if bounces > 1.5 then 3 else 1)/(1 s);
        allow(W0002);
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; }
        when ball.y < 0 m {
            ball.vy = -loss*ball.vy;
            bounces = bounces + 1;
        }
        output bounces, warmth;
    }
}

scene! {
    /// A thermostat, and a counter that samples it ten times a second.
    pub Oven {
        allow(W0002);
        body none { mass: 1 kg; inertia: 1 kg*m^2; }
        param low: K = 290 K;
        param high: K = 300 K;
        discrete on: 1 = 0;
        discrete next: s = 0.1 s;
        discrete samples: 1 = 0;
        discrete last: K = 0 K;
        discrete full: 1 = 0;
        state heat: K = 295 K;
        rate heat = (280 K - heat)/(1 s) + (if on > 0.5 then 40 K/s else 0 K/s);
        when heat < low { on = 1; }
        when heat > high { on = 0; }
        when t > next { next = next + 0.1 s; samples = samples + 1; last = heat; }
        when samples >= 7 and on > 0.5 { full = full + samples; samples = 0; }
        output on, samples, full, last, heat;
    }
}

macro_rules! chain {
    ($name:ident, $formulation:ident) => {
        scene! {
            pub $name {
                formulation: $formulation;
                ground { port o: (0, 0) m; }
                body first {
                    mass: 2 kg; inertia: 0.3 kg*m^2;
                    port o: (-0.5, 0) m; port a: (0.5, 0) m;
                    start angle: 20 deg, locked; start omega: 1 rad/s, locked;
                }
                body second {
                    mass: 1 kg; inertia: 0.2 kg*m^2;
                    port a: (-0.4, 0) m;
                    start angle: 80 deg, locked; start omega: 2 rad/s, locked;
                }
                revolute o(ground.o, first.o);
                revolute a(first.a, second.a);
                when t > 0.25 s { first.omega = 0 rad/s; }
            }
        }
    };
}

chain!(InTree, tree);
chain!(InAbsolute, absolute);

scene! {
    pub FourBar {
        ground { port a: (0, 0) m; port d: (0.4, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (-0.05, 0) m; port b: (0.05, 0) m; start angle: 60 deg, locked; start omega: 4 rad/s, locked; }
        body coupler { mass: 1 kg; inertia: 0.02 kg*m^2; port b: (-0.2, 0) m; port c: (0.2, 0) m; start x: 0.2 m; start y: 0.1 m; }
        body rocker { mass: 1 kg; inertia: 0.02 kg*m^2; port d: (-0.15, 0) m; port c: (0.15, 0) m; start x: 0.4 m; start y: 0.15 m; start angle: 90 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(rocker.d, ground.d);
        when crank.angle > 400 deg { crank.omega = 2 rad/s; }
    }
}

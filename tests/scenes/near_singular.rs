//! Loops that steps of a fixed length would tear open.

scene! {
    /// A four-bar whose three moving links can only rock: 0.7, 0.6 and 0.5 m over 1 m of ground.
    pub TripleRocker {
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body crank { mass: 0.7 kg; inertia: 0.7 kg * (0.7 m)^2 / 12; port a: (-0.35, 0) m; port b: (0.35, 0) m; start angle: 50 deg, locked; start omega: 6 rad/s, locked; }
        body coupler { mass: 0.6 kg; inertia: 0.6 kg * (0.6 m)^2 / 12; port b: (-0.3, 0) m; port c: (0.3, 0) m; start x: 0.7 m; start y: 0.5 m; start angle: -10 deg; }
        body rocker { mass: 0.5 kg; inertia: 0.5 kg * (0.5 m)^2 / 12; port d: (-0.25, 0) m; port c: (0.25, 0) m; start x: 1 m; start y: 0.2 m; start angle: 100 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(ground.d, rocker.d);
    }
}

scene! {
    /// A kite that folds flat, with a spring that has a state; in absolute coordinates.
    pub Kite {
        formulation: absolute;
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.25, 0) m; port b: (0.25, 0) m; start angle: 80 deg, locked; start omega: -5 rad/s, locked; }
        body coupler { mass: 1 kg; inertia: 0.02 kg*m^2; port b: (-0.25, 0) m; port c: (0.25, 0) m; start angle: -30 deg; }
        body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (-0.5, 0) m; port c: (0.5, 0) m; start angle: 150 deg; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(ground.d, rocker.d);
        state lag: rad = 0;
        rate lag = (crank.angle - lag)/(0.1 s);
        output lag;
    }
}

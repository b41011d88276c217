//! Events as a run begins.

scene! {
    /// Nothing but the start sets anything.
    pub Thrown {
        allow(W0002);
        gravity: 9.81 m/s^2;
        body ball { mass: 1 kg; inertia: 0.1 kg*m^2; start y: 2 m; start vx: 1 m/s; }
        discrete home: m = 0 m;
        when start { home = ball.y; ball.vy = 3 m/s; }
        when start { ball.vx = 2*ball.vx + ball.vy; }
        output home, ball.velocity, ball.position;
    }
}

scene! {
    /// A relay that is on, a wheel beyond some teeth, a swing that is pushed from where it closes.
    pub Started {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; port side: (2, 0) m; }
        body wheel { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; start angle: 100 deg; }
        body swing { mass: 1 kg; inertia: 0.2 kg*m^2; port a: (-1, 0) m; start x: 3 m; start angle: -60 deg; }
        revolute axle(ground.o, wheel.a);
        revolute pin(ground.side, swing.a);
        force push(wheel.a) { torque: -1 N*m; }
        ratchet pawl(ground.o, wheel.a) { teeth: 24; }
        hysteresis relay() { signal: wheel.angle; low: -2; high: 1; }
        delay late() { signal: swing.angle; period: 0.1 s; }
        discrete home: m = 0 m;
        when start { swing.omega = 2 rad/s; home = swing.y; }
        when swing.omega < 0 rad/s { home = swing.y; }
        output pawl.torque, relay.value, late.value, home;
    }
}

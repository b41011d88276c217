//! A four-bar whose rocker moves between two limits, one with restitution, driven against them in turn.

plm::mechanism! {
    /// The four-bar and its limits.
    pub Limits {
        gravity: 9.81 m/s^2;
        emit: step(moreau_jean);
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank {
            mass: 1 kg;
            inertia: 0.02 kg*m^2;
            port a: (-0.15, 0) m;
            port b: (0.15, 0) m;
            start angle: 60 deg, locked;
            start omega: 5 rad/s, locked;
        }
        body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; }
        body rocker {
            mass: 1.5 kg;
            inertia: 0.1 kg*m^2;
            port c: (0.4, 0) m;
            port p: (-0.4, 0) m;
            start angle: 100 deg;
        }
        revolute o(ground.o, crank.a) { drive: 6 N*m*cos(3 rad/s*t); }
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
        revolute p(ground.p, rocker.p);
        unilateral low: rocker.angle >= 85 deg { restitution: 0.4; }
        unilateral high: rocker.angle <= 110 deg;
    }
}

//! Mechanisms with contact, for steps of Moreau and Jean: a four-bar between two limits, a rack with backlash, a ratchet.

plm::mechanism! {
    /// A four-bar whose rocker is driven against two limits, of which one gives back a part of the speed.
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
        revolute o(ground.o, crank.a) { drive: 8 N*m*cos(3 rad/s*t); }
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
        revolute p(ground.p, rocker.p);
        unilateral low: rocker.angle >= 85 deg;
        unilateral high: rocker.angle <= 110 deg { restitution: 0.4; }
    }
}

plm::mechanism! {
    /// A pinion that takes a rack to and fro, whose flanks have play and bounce.
    pub Rack {
        gravity: 9.81 m/s^2;
        emit: step(moreau_jean);
        ground { port o: (0, 0) m; port rail: (0, -0.05) m; }
        body pinion { mass: 0.5 kg; inertia: 6e-4 kg*m^2; port hub: (0, 0) m; }
        body bar { mass: 2 kg; inertia: 0.02 kg*m^2; port line: (0, 0) m; start y: -0.05 m; }
        revolute axle(ground.o, pinion.hub) { drive: 0.3 N*m*cos(6 rad/s*t); damping: 1e-3 N*m*s/rad; }
        prismatic guide(ground.rail, bar.line) { damping: 4 N*s/m; }
        rack teeth(pinion.hub, bar.line) { radius: 50 mm; backlash: 0.2 mm; restitution: 0.3; }
    }
}

plm::mechanism! {
    /// A wheel that is driven to and fro, and a pawl that lets it turn one way alone.
    pub Ratchet {
        gravity: 9.81 m/s^2;
        emit: step(moreau_jean);
        ground { port axle: (0, 0) m; }
        body wheel { mass: 1 kg; inertia: 0.02 kg*m^2; port hub: (0, 0) m; start angle: 5 deg; }
        revolute axle(ground.axle, wheel.hub) { drive: 0.5 N*m*cos(4 rad/s*t); damping: 0.02 N*m*s/rad; }
        ratchet pawl(ground.axle, wheel.hub) { teeth: 12; restitution: 0.2; }
    }
}

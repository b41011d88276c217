//! The line of a jack has no direction where its points meet at the start.

plm::mechanism! {
    pub Lift {
        gravity: 9.81 m/s^2;
        ground {
            port o: (0, 0) m;
            port low: (0.5, 0) m;
        }
        body beam {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port o: (0, 0) m;
            port tip: (0.5, 0) m;
            start angle: 0, locked;
        }
        revolute hinge(ground.o, beam.o);
        jack lift(ground.low, beam.tip) { drive: 100 N; }
    }
}

fn main() {}

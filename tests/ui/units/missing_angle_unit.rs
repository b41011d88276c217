//! Is it degrees or radians?

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
            start angle: 45, locked;
        }
        revolute hinge(ground.o, bob.a);
    }
}

fn main() {}

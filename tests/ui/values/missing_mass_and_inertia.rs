//! Bodies without mass and without inertia.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
        }
        body rider {
            mass: 1 kg;
            port a: (0, 1) m;
        }
        revolute hinge(ground.o, bob.a);
        revolute knee(bob.a, rider.a);
    }
}

fn main() {}

//! A parameter that the part does not have.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
        }
        revolute hinge(ground.o, bob.a) { dampng: 1 N*m*s/rad; }
    }
}

fn main() {}

//! A force per length where a damping coefficient belongs.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m;
            port a: (0, 1) m;
        }
        revolute hinge(ground.o, bob.a) { damping: 1 N/m; }
    }
}

fn main() {}

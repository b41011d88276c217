//! A port that does not exist.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port p11: (0, 1) m;
            port p12: (0, -1) m;
        }
        revolute hinge(ground.o, bob.p13);
    }
}

fn main() {}

//! A joint that does not exist.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
        }
        revolut hinge(ground.o, bob.a);
    }
}

fn main() {}

//! A function that does not exist.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
        }
        revolute hinge(ground.o, bob.a) { drive: 3 N*m*sinus(bob.angle); }
    }
}

fn main() {}

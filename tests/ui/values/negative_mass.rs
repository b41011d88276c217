//! A mass below zero, an inertia of zero.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: -1 kg;
            inertia: 0;
            port a: (0, 1) m;
        }
        revolute hinge(ground.o, bob.a);
    }
}

fn main() {}

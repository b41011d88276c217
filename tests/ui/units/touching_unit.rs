//! A unit that touches its number.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 0.5m);
        }
        revolute hinge(ground.o, bob.a);
    }
}

fn main() {}

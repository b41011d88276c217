//! The name of a unit as the name of a parameter.

plm::mechanism! {
    pub Pendulum {
        param m: kg = 1 kg;
        ground { port o: (0, 0) m; }
        body bob {
            mass: m;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
        }
        revolute hinge(ground.o, bob.a);
    }
}

fn main() {}

//! A sum of a length and a time.

plm::mechanism! {
    pub Pendulum {
        param length: m = 1 m;
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, length + 2 s);
        }
        revolute hinge(ground.o, bob.a);
    }
}

fn main() {}

//! Three mistakes of three kinds are three errors.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 10;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
        }
        revolut hinge(ground.o, bob.a);
        let height = bob.y + ;
    }
}

fn main() {}

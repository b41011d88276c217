//! Units that the table does not hold.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kgs;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) meter;
        }
        revolute hinge(ground.o, bob.a) { drive: 3 Nm; }
    }
}

fn main() {}

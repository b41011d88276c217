//! Quantities without units; 0 needs none.

plm::mechanism! {
    pub Pendulum {
        gravity: 9.81;
        ground { port o: 0; }
        body bob {
            mass: 10;
            inertia: 0.01 kg*m^2;
            port a: (0, 1);
        }
        revolute hinge(ground.o, bob.a);
    }
}

fn main() {}

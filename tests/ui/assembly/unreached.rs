//! A body that nothing holds or reaches is only strange; here strange is denied.
#![deny(warnings)]

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
        }
        body rider {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
        }
        revolute hinge(ground.o, bob.a);
    }
}

fn main() {}

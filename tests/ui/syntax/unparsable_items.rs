//! Reading goes on after what cannot be read.

plm::mechanism! {
    pub Pendulum {
        gravity 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        bdy bob { mass: 1 kg; }
        body arm {
            mass: 1 kg
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m
        }
        revolute hinge(ground.o arm.a);
        constraint x: arm.x == 0;
    }
}

fn main() {}

//! A body where a frame belongs, and one frame too few.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
            port b: (0, -1) m;
        }
        revolute hinge(ground.o, bob);
        spring cord(bob.b) { stiffness: 10 N/m; }
    }
}

fn main() {}

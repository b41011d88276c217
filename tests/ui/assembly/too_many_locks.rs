//! The manual's example of section 4.4, figure 94: a pendulum with three locks.

plm::mechanism! {
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (-0.5, 0) m;
            start angle: 45 deg, locked;
            start x: 0.35 m, locked;
            start y: 0.35 m, locked;
        }
        revolute hinge(ground.o, bob.a);
    }
}

fn main() {}

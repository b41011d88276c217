//! Mistakes in shared parts: in their form where they are declared, in their content where they are used.

plm::parts! {
    pub(crate) magnets {
        part magnet(a: frame) {
            param strength: N*m^2;
            force on a: (0, strength/(a.y + 2 m));
        }
    }
}

plm::parts! {
    part nameless(a: frame) {}
    part other(a: frame) {}
}

plm::mechanism! {
    use magnets;
    pub Pendulum {
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
            port b: (0, -1) m;
        }
        revolute hinge(ground.o, bob.a);
        magnet lower(bob.b) { strength: 1 N*m^2; }
    }
}

fn main() {}

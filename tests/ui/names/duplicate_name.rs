//! Two bodies of one name.

plm::mechanism! {
    pub Rods {
        ground { port o: (0, 0) m; }
        body rod {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (-0.1, 0) m;
        }
        body rod {
            mass: 2 kg;
            inertia: 0.02 kg*m^2;
            port a: (-0.2, 0) m;
        }
        revolute bearing(ground.o, rod.a);
    }
}

fn main() {}

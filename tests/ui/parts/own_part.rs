//! A mistake inside a part of the user's own is shown there, once, with its first use.

plm::mechanism! {
    pub Pendulum {
        part magnet(a: frame) {
            param strength: N*m^2;
            let height = a.y + 2 m;
            force on a: (0, strength/height);
        }
        ground { port o: (0, 0) m; }
        body bob {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 1) m;
            port b: (0, -1) m;
        }
        revolute hinge(ground.o, bob.a);
        magnet lower(bob.b) { strength: 1 N*m^2; }
        magnet upper(bob.a) { strength: 2 N*m^2; }
    }
}

fn main() {}

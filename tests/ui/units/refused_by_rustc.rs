//! Of some numbers that units touch rustc's own lexer thinks first.

plm::mechanism! {
    pub Cylinder {
        param pressure: bar = 0bar;
        ground { port o: (0, 0) m; }
        body rod {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (0, 0) m;
        }
        revolute hinge(ground.o, rod.a);
    }
}

fn main() {}

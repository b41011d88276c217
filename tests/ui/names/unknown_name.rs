//! A name that is nearly one that exists.

plm::mechanism! {
    pub SliderCrank {
        ground { port o: (0, 0) m; }
        body crank {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (-0.1, 0) m;
        }
        revolute bearing(ground.o, crnk.a);
    }
}

fn main() {}

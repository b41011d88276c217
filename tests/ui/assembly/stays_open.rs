//! A four-bar linkage whose bars are too short to meet.

plm::mechanism! {
    pub FourBar {
        ground {
            port a: (0, 0) m;
            port d: (1, 0) m;
        }
        body crank {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port a: (-0.1, 0) m;
            port b: (0.1, 0) m;
        }
        body coupler {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port b: (-0.1, 0) m;
            port c: (0.1, 0) m;
        }
        body rocker {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            port c: (-0.1, 0) m;
            port d: (0.1, 0) m;
        }
        revolute pin_a(ground.a, crank.a);
        revolute pin_b(crank.b, coupler.b);
        revolute pin_c(coupler.c, rocker.c);
        revolute pin_d(rocker.d, ground.d);
    }
}

fn main() {}

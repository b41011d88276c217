//! A mass below zero and an inertia of zero; a mass that is zero by the default of its parameter.

mod literal {
    plm::mechanism! {
        pub Pendulum {
            ground { port o: (0, 0) m; }
            body bob {
                mass: -1 kg;
                inertia: 0;
                port a: (0, 1) m;
            }
            revolute hinge(ground.o, bob.a);
        }
    }
}

mod parameter {
    plm::mechanism! {
        pub Pendulum {
            param load: kg = -1 kg;
            ground { port o: (0, 0) m; }
            body bob {
                mass: load + 1 kg;
                inertia: 0.01 kg*m^2;
                port a: (0, 1) m;
            }
            revolute hinge(ground.o, bob.a);
        }
    }
}

fn main() {
    let _ = (literal::Pendulum::new(), parameter::Pendulum::new());
}

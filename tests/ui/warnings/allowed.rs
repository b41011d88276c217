//! What a declaration allows is not said, with all warnings denied; what another allows does not help this one.
#![deny(warnings)]

mod quiet {
    plm::mechanism! {
        pub Carriage {
            allow(W0001);
    
            ground {
                port left: (0, 0) m;
                port right: (1, 0) m;
            }
            body table {
                mass: 1 kg;
                inertia: 0.01 kg*m^2;
                port left: (0, 0) m;
                port right: (1, 0) m;
            }
            prismatic rail(ground.left, table.left);
            prismatic second_rail(ground.right, table.right);
        }
    }
}

mod loud {
    plm::mechanism! {
        pub Carriage {
            allow(W0002);
    
            ground {
                port left: (0, 0) m;
                port right: (1, 0) m;
            }
            body table {
                mass: 1 kg;
                inertia: 0.01 kg*m^2;
                port left: (0, 0) m;
                port right: (1, 0) m;
            }
            prismatic rail(ground.left, table.left);
            prismatic second_rail(ground.right, table.right);
        }
    }
}

fn main() {
    let _ = (quiet::Carriage::new(), loud::Carriage::new());
}

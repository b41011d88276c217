//! A second guide says what the first says already: a warning, here denied.
#![deny(warnings)]

plm::mechanism! {
    pub Carriage {
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

fn main() {}

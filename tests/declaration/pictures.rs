//! What pictures need is in the generated module, files included.

use plm::Described;

plm::mechanism! {
    pub Plate {
        ground { port o: (0, 0) m, depth: 0.2 m; }
        body plate {
            mass: 1 kg;
            inertia: 0.01 kg*m^2;
            centre: (0.1, 0.025) m;
            port o: (0, 0) m;
            contour: "tests/contours/plate.csv";
            depth: 1 cm;
        }
        revolute pin(ground.o, plate.o) { pin_diameter: 8 mm; }
    }
}

/// The file is a plate of 0.2 m by 0.05 m; seen from G, its corners stand alike.
#[test]
fn a_contour_file_is_read_from_the_folder_of_the_package() {
    let (plate, tables) = (Plate::new(), Plate::<f64>::TABLES);
    assert_eq!((tables.bodies[0].name, tables.bodies[0].contour), ("plate", 4));
    let corners = [[-0.1, -0.025], [0.1, -0.025], [0.1, 0.025], [-0.1, 0.025]];
    for (k, corner) in corners.into_iter().enumerate() {
        let point = plate.contour(0, k).unwrap();
        assert!((point[0] - corner[0]).abs() + (point[1] - corner[1]).abs() < 1e-15, "{point:?}");
    }
    assert_eq!((plate.depth(0), plate.ground_depth(0)), (Some(0.01), Some(0.2)));
    assert_eq!((tables.parts[0].sizes, plate.size(0, 0)), (&["pin_diameter"][..], Some(0.008)));
}

//! What pictures need is in the generated module, files included.

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
    let [(name, points)] = plate::CONTOURS;
    assert_eq!(name, "plate");
    let corners = [[-0.1, -0.025], [0.1, -0.025], [0.1, 0.025], [-0.1, 0.025]];
    assert_eq!(points.len(), corners.len());
    for (point, corner) in points.iter().zip(corners) {
        assert!((point[0] - corner[0]).abs() + (point[1] - corner[1]).abs() < 1e-15, "{point:?}");
    }
    assert_eq!(plate::DEPTHS, [("plate", 0.01), ("ground.o", 0.2)]);
    assert_eq!(plate::SIZES, [("pin.pin_diameter", 0.008)]);
}

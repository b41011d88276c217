//! `plm import` of DXF: areas of outlines against closed forms.

use std::f64::consts::PI;
use std::fs;

use super::{Said, folder, plm_in};

/// Groups of a file.
fn groups(pairs: &[(i32, &str)]) -> String {
    pairs.iter().map(|(code, value)| [&code.to_string(), "\n", value, "\n"].concat()).collect()
}

/// A drawing in mm with blocks and entities.
fn drawing(blocks: &str, entities: &str) -> String {
    let section = |name: &str, inner: &str| groups(&[(0, "SECTION"), (2, name)]) + inner + "0\nENDSEC\n";
    section("HEADER", &groups(&[(9, "$INSUNITS"), (70, "4")]))
        + &section("BLOCKS", blocks)
        + &section("ENTITIES", entities)
        + "0\nEOF\n"
}

/// A rectangle of 60 x 40 on the layer `OUT`.
fn plate() -> String {
    groups(&[
        (0, "LWPOLYLINE"),
        (8, "OUT"),
        (90, "4"),
        (70, "1"),
        (10, "0"),
        (20, "0"),
        (10, "60"),
        (20, "0"),
    ]) + &groups(&[(10, "60"), (20, "40"), (10, "0"), (20, "40")])
}

fn import(text: &[u8], words: &[&str]) -> Said {
    let folder = folder();
    fs::write(folder.join("a.dxf"), text).unwrap();
    plm_in(&folder, &[&["import", "a.dxf"], words].concat(), b"")
}

/// Corners of the outlines of an import, the contour first.
fn outlines(said: &Said) -> Vec<Vec<[f64; 2]>> {
    assert_eq!(said.code, 0, "{said:?}");
    let pair = |text: &str| {
        let (x, y) = text.split_once(')').unwrap().0.split_once(", ").unwrap();
        [x, y].map(|part| part.parse().unwrap())
    };
    let (_, outlines) = said.output.split_once('\n').unwrap();
    let own = outlines.split(';').filter(|outline| outline.contains("mm"));
    own.map(|outline| outline.split('(').skip(1).filter(|text| text.contains(", ")).map(pair).collect())
        .collect()
}

fn area(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

/// The middle of the corners.
fn middle(points: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / points.len() as f64)
}

/// Corners lie on the curve, which has more area by a share of 6.6/n^2 for n corners of a circle.
fn is_nearly(found: f64, exact: f64) -> bool {
    found <= exact * (1.0 + 1e-7) && found > exact * (1.0 - 6.7 / 72.0 / 72.0)
}

#[test]
fn ellipses_and_splines_are_curves() {
    let ellipse = groups(&[
        (0, "ELLIPSE"),
        (10, "30"),
        (20, "20"),
        (11, "6"),
        (21, "8"),
        (40, "0.5"),
        (41, "0"),
        (42, "6.283185307179586"),
    ]);
    // Half of an ellipse, closed by a line from end to end; a parabola of degree 2 over a chord has two thirds of its box.
    let half = groups(&[
        (0, "ELLIPSE"),
        (10, "50"),
        (20, "10"),
        (11, "4"),
        (21, "0"),
        (40, "0.5"),
        (41, "0"),
        (42, "3.141592653589793"),
    ]) + &groups(&[(0, "LINE"), (10, "54"), (20, "10"), (11, "46"), (21, "10")]);
    let parabola = groups(&[
        (0, "SPLINE"),
        (70, "8"),
        (71, "2"),
        (40, "0"),
        (40, "0"),
        (40, "0"),
        (40, "1"),
        (40, "1"),
        (40, "1"),
    ]) + &groups(&[(10, "4"), (20, "30"), (10, "9"), (20, "36"), (10, "14"), (20, "30")])
        + &groups(&[(0, "LINE"), (10, "14"), (20, "30"), (11, "4"), (21, "30")]);
    let said = import(drawing("", &(plate() + &ellipse + &half + &parabola)).as_bytes(), &[]);
    let mut areas: Vec<f64> = outlines(&said).iter().map(|points| area(points)).collect();
    areas.sort_by(f64::total_cmp);
    let exact = [PI * 4.0 * 2.0 / 2.0, 10.0 * 3.0 * 2.0 / 3.0, PI * 10.0 * 5.0, 2400.0];
    assert_eq!(areas.len(), 4, "{said:?}");
    for (found, exact) in areas.iter().zip(exact) {
        assert!(is_nearly(*found, exact), "{found} for {exact}");
    }
}

/// A block with a slanted triangle: its place by base point, scale, turn and mirror, against the map of its corners.
#[test]
fn blocks_stand_where_they_are_inserted() {
    let corners = [[1.0, 0.0], [4.0, 0.0], [1.0, 2.0]];
    let triangle = groups(&[
        (0, "LWPOLYLINE"),
        (8, "0"),
        (90, "3"),
        (70, "1"),
        (10, "1"),
        (20, "0"),
        (10, "4"),
        (20, "0"),
        (10, "1"),
        (20, "2"),
    ]);
    let block = groups(&[(0, "BLOCK"), (8, "0"), (2, "T"), (10, "1"), (20, "1")]) + &triangle + "0\nENDBLK\n";
    for (x, y, turn, side) in [
        (1.0, 1.0, 0.0, 1.0),
        (2.0, 1.5, 90.0, 1.0),
        (-1.0, 1.0, 37.0, 1.0),
        (1.5, 1.0, 180.0, -1.0),
        (1.0, 1.0, 37.0, -1.0),
    ] {
        let numbers =
            [f64::copysign(30.0, side), 20.0, x, y, turn, side].map(|number: f64| number.to_string());
        let [at, up, x_scale, y_scale, angle, normal] = numbers.each_ref().map(String::as_str);
        let insert = groups(&[
            (0, "INSERT"),
            (8, "HOLES"),
            (2, "T"),
            (10, at),
            (20, up),
            (41, x_scale),
            (42, y_scale),
            (50, angle),
            (230, normal),
        ]);
        let said = import(drawing(&block, &(plate() + &insert)).as_bytes(), &[]);
        let found = outlines(&said);
        let (sin, cos) = f64::to_radians(turn).sin_cos();
        for [p, q] in corners {
            let [a, b] = [x * (p - 1.0), y * (q - 1.0)];
            let wanted = [side * (side * 30.0 + cos * a - sin * b), 20.0 + sin * a + cos * b];
            let away = |point: &[f64; 2]| (point[0] - wanted[0]).hypot(point[1] - wanted[1]);
            assert!(
                found[1].iter().any(|point| away(point) < 1e-5),
                "{x} {y} {turn} {side}: {wanted:?} {:?}",
                found[1]
            );
        }
    }
    // Three columns and two rows.
    let array = groups(&[
        (0, "INSERT"),
        (8, "HOLES"),
        (2, "T"),
        (10, "10"),
        (20, "10"),
        (70, "3"),
        (71, "2"),
        (44, "15"),
        (45, "20"),
    ]);
    let found = outlines(&import(drawing(&block, &(plate() + &array)).as_bytes(), &[]));
    let mut middles: Vec<[f64; 2]> = found[1..].iter().map(|points| middle(points)).collect();
    middles.sort_by(|a, b| a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0])));
    for (k, found) in middles.iter().enumerate() {
        let wanted = [11.0 + 15.0 * (k % 3) as f64, 10.0 - 1.0 / 3.0 + 20.0 * (k / 3) as f64];
        assert!((found[0] - wanted[0]).hypot(found[1] - wanted[1]) < 1e-5, "{found:?} for {wanted:?}");
    }
    assert_eq!(middles.len(), 6);
    let own = groups(&[(0, "BLOCK"), (2, "T"), (0, "INSERT"), (2, "T"), (10, "0"), (20, "0"), (0, "ENDBLK")]);
    let said = import(drawing(&own, &array).as_bytes(), &[]);
    assert!(said.code == 1 && said.errors.contains("it is within itself: the block `T`"), "{said:?}");
}

/// Entities from the back have their x the other way.
#[test]
fn mirrored_entities_are_seen_from_the_front() {
    let arc = groups(&[(0, "ARC"), (10, "-20"), (20, "20"), (40, "5"), (50, "0"), (51, "90"), (230, "-1.0")]);
    // From the back an arc from +x to +y is one from -x to +y.
    let lines = groups(&[(0, "LINE"), (10, "20"), (20, "25"), (11, "20"), (21, "20")])
        + &groups(&[(0, "LINE"), (10, "20"), (20, "20"), (11, "15"), (21, "20")]);
    let said = import(drawing("", &(plate() + &arc + &lines)).as_bytes(), &[]);
    let found = outlines(&said);
    assert!(is_nearly(area(&found[1]), PI * 25.0 / 4.0), "{said:?}");
    assert!(found[1].iter().all(|[x, y]| *x < 20.001 && *y > 19.999), "{said:?}");
}

#[test]
fn layers_parts_and_gaps_are_chosen() {
    let circle = |layer: &str, x: &str| groups(&[(0, "CIRCLE"), (8, layer), (10, x), (20, "20"), (40, "5")]);
    let axis = groups(&[(0, "LINE"), (8, "AXIS"), (10, "-5"), (20, "20"), (11, "65"), (21, "20")]);
    let two = drawing("", &(plate() + &circle("OUT", "20") + &circle("Other", "100") + &axis));
    let said = import(two.as_bytes(), &[]);
    assert!(said.code == 1 && said.output.is_empty(), "{said:?}");
    for told in [
        "warning: the outline is open at",
        "warning: part 1: 60 x 40 from (0, 0), 1 holes",
        "warning: part 2: 10 x 10 from (95, 15), 0 holes",
        "there are 2 parts side by side: `--part NUMBER` takes one of them; `--layer NAME` takes one of: AXIS, OUT, Other",
    ] {
        assert!(said.errors.contains(told), "{told}\n{said:?}");
    }
    assert_eq!(outlines(&import(two.as_bytes(), &["--part", "1"])).len(), 2);
    assert!(is_nearly(area(&outlines(&import(two.as_bytes(), &["--part", "2"]))[0]), PI * 25.0));
    assert_eq!(outlines(&import(two.as_bytes(), &["--layer", "out"])).len(), 2);
    let said = import(two.as_bytes(), &["--layer", "none"]);
    assert!(said.errors.contains("there is nothing on a layer `none`; layers: AXIS, OUT, Other"), "{said:?}");
    let side = |from: [&str; 2], to: [&str; 2]| {
        groups(&[(0, "LINE"), (10, from[0]), (20, from[1]), (11, to[0]), (21, to[1])])
    };
    let open = drawing(
        "",
        &(side(["0", "0"], ["10", "0"]) + &side(["10", "0.03"], ["5", "8"]) + &side(["5", "8"], ["0", "0"])),
    );
    let said = import(open.as_bytes(), &[]);
    assert!(
        said.code == 1 && said.errors.contains("the next end is 0.03 away: `--gap 0.0303` closes it"),
        "{said:?}"
    );
    assert!((area(&outlines(&import(open.as_bytes(), &["--gap", "0.0303"]))[0]) - 40.0).abs() < 0.2);
    for (words, told) in [(["--part", "0"], "--part wants"), (["--gap", "-1"], "--gap wants")] {
        let said = import(two.as_bytes(), &words);
        assert!(said.code == 2 && said.errors.contains(told), "{said:?}");
    }
}

/// Names in the code page of files before AutoCAD 2007; layers that are off are passed over.
#[test]
fn old_files_have_their_code_page() {
    let text = groups(&[
        (0, "SECTION"),
        (2, "HEADER"),
        (9, "$DWGCODEPAGE"),
        (3, "ANSI_1252"),
        (9, "$INSUNITS"),
        (70, "4"),
        (0, "ENDSEC"),
    ]) + &groups(&[
        (0, "SECTION"),
        (2, "TABLES"),
        (0, "LAYER"),
        (2, "AUS"),
        (70, "0"),
        (62, "-7"),
        (0, "ENDSEC"),
        (0, "SECTION"),
        (2, "ENTITIES"),
    ]) + &plate().replace("OUT", "Schl@ssel")
        + &groups(&[
            (0, "LINE"),
            (8, "AUS"),
            (10, "-500"),
            (20, "20"),
            (11, "650"),
            (21, "900"),
            (0, "ENDSEC"),
            (0, "EOF"),
        ]);
    let bytes: Vec<u8> = text.bytes().map(|byte| if byte == b'@' { 0xfc } else { byte }).collect();
    let said = import(&bytes, &["--layer", "Schlüssel"]);
    assert!(said.errors.is_empty() && (area(&outlines(&said)[0]) - 2400.0).abs() < 1e-9, "{said:?}");
    let said = import(b"AutoCAD Binary DXF\r\n\x1a\0", &[]);
    assert!(said.code == 2 && said.errors.contains("this DXF is binary"), "{said:?}");
}

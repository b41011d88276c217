//! A sheet as DXF (Autodesk, DXF Reference, R12): polylines with bulges, circles, and names on a layer of their own.

use std::fmt::Write;

use super::region::{Path, Point};
use super::sheet::Sheet;

/// The colours of layers, in turns: blue, red, green, magenta, cyan.
const COLOURS: [usize; 5] = [5, 1, 3, 6, 4];
const GREY: usize = 8;

/// Group codes with their values, two lines each.
#[derive(Default)]
struct Groups(String);

impl Groups {
    fn put(&mut self, code: u32, value: &str) {
        let _ = writeln!(self.0, "{code:3}\n{value}");
    }

    fn number(&mut self, code: u32, value: f64) {
        self.put(code, &super::number(value));
    }

    /// A place: its coordinates stand ten codes apart.
    fn place(&mut self, code: u32, [x, y]: Point) {
        for (k, part) in (0..).zip([x, y, 0.0]) {
            self.number(code + 10 * k, part);
        }
    }

    fn entity(&mut self, word: &str, layer: &str) {
        self.put(0, word);
        self.put(8, layer);
    }

    fn section(&mut self, name: &str, inside: impl FnOnce(&mut Groups)) {
        self.put(0, "SECTION");
        self.put(2, name);
        inside(self);
        self.put(0, "ENDSEC");
    }
}

pub(super) fn text(sheet: &Sheet) -> String {
    let mut groups = Groups::default();
    groups.section("HEADER", |groups| {
        groups.put(9, "$ACADVER");
        groups.put(1, "AC1009");
        // Millimetres.
        groups.put(9, "$INSUNITS");
        groups.put(70, "4");
        for (name, at) in ["$EXTMIN", "$EXTMAX"].into_iter().zip(sheet.bounds) {
            groups.put(9, name);
            groups.place(10, at);
        }
    });
    groups.section("TABLES", |groups| tables(groups, sheet));
    groups.section("ENTITIES", |groups| {
        for link in &sheet.links {
            let layer = super::layer_name(link.layer);
            link.paths.iter().for_each(|path| closed(groups, path, &layer));
            let (at, height) = link.text;
            groups.entity("TEXT", super::NAMES);
            groups.place(10, at);
            groups.number(40, height);
            groups.put(1, &ascii(&link.name));
            // In the middle of the place.
            groups.put(72, "1");
            groups.place(11, at);
            groups.put(73, "2");
        }
    });
    groups.put(0, "EOF");
    groups.0
}

/// The line type and the layers.
fn tables(groups: &mut Groups, sheet: &Sheet) {
    let table = |groups: &mut Groups, name: &str, rows: &[(String, usize)]| {
        groups.put(0, "TABLE");
        groups.put(2, name);
        groups.put(70, &rows.len().to_string());
        for (row, colour) in rows {
            groups.put(0, name);
            groups.put(2, row);
            groups.put(70, "0");
            if name == "LTYPE" {
                groups.put(3, "Solid line");
                groups.put(72, "65");
                groups.put(73, "0");
                groups.put(40, "0.0");
            } else {
                groups.put(62, &colour.to_string());
                groups.put(6, "CONTINUOUS");
            }
        }
        groups.put(0, "ENDTAB");
    };
    table(groups, "LTYPE", &[("CONTINUOUS".to_owned(), 0)]);
    let last = sheet.links.iter().map(|link| link.layer).max().unwrap_or_default();
    let layers = (1..=last).map(|layer| (super::layer_name(layer), COLOURS[(layer - 1) % COLOURS.len()]));
    let all: Vec<_> =
        [("0".to_owned(), 7)].into_iter().chain(layers).chain([(super::NAMES.to_owned(), GREY)]).collect();
    table(groups, "LAYER", &all);
}

fn closed(groups: &mut Groups, path: &Path, layer: &str) {
    match path {
        Path::Circle { at, radius } => {
            groups.entity("CIRCLE", layer);
            groups.place(10, *at);
            groups.number(40, *radius);
        }
        Path::Corners(corners) => {
            groups.entity("POLYLINE", layer);
            groups.put(66, "1");
            groups.place(10, [0.0; 2]);
            groups.put(70, "1");
            for (at, bulge) in corners {
                groups.entity("VERTEX", layer);
                groups.place(10, *at);
                groups.put(42, &format!("{bulge:.15}"));
            }
            groups.entity("SEQEND", layer);
        }
    }
}

/// Names of R12 are ASCII.
fn ascii(name: &str) -> String {
    name.chars().map(|letter| if letter.is_ascii() { letter } else { '_' }).collect()
}

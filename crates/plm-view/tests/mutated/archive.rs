//! Archives as lists of entries, and the good ones that all others are made of.

use std::io::{Cursor, Read, Write};
use std::sync::LazyLock;

use plm_view::{Body, GroundPort, Mechanism, Parameter, Port, Quantity, Recording, Results, Row};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

/// Name and contents of each entry.
#[derive(Clone)]
pub(crate) struct Archive(pub(crate) Vec<(String, Vec<u8>)>);

/// How entries stand in the file.
#[derive(Clone, Copy)]
pub(crate) enum Form {
    Stored,
    Deflated,
    /// With their lengths after them.
    Streamed,
}

impl Archive {
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let mut zip = ZipArchive::new(Cursor::new(bytes)).unwrap();
        let count = zip.len();
        let entry = |k| {
            let mut file = zip.by_index(k).unwrap();
            let (name, mut bytes) = (file.name().to_owned(), Vec::new());
            file.read_to_end(&mut bytes).unwrap();
            (name, bytes)
        };
        Self((0..count).map(entry).collect())
    }

    pub(crate) fn to_bytes(&self, form: Form) -> Vec<u8> {
        let options = SimpleFileOptions::default().compression_method(match form {
            Form::Stored => CompressionMethod::Stored,
            Form::Deflated | Form::Streamed => CompressionMethod::Deflated,
        });
        let Form::Streamed = form else {
            let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
            for (name, bytes) in &self.0 {
                // The writer refuses a name that is there already.
                if zip.start_file(name, options).is_ok() {
                    zip.write_all(bytes).unwrap();
                }
            }
            return zip.finish().unwrap().into_inner();
        };
        let mut zip = ZipWriter::new_stream(Vec::new());
        for (name, bytes) in &self.0 {
            if zip.start_file(name, options).is_ok() {
                zip.write_all(bytes).unwrap();
            }
        }
        zip.finish().unwrap().into_inner()
    }
}

/// Numbers that are finite whichever bytes of them are taken for a number of single precision.
fn dyadic(k: usize) -> f64 {
    (k % 64) as f64 / 8.0 - 3.0
}

fn quantity(name: &str) -> Quantity {
    Quantity {
        name: name.into(),
        doc: String::new(),
        unit: "mm".into(),
        factor: 1e-3,
        exponents: [1, 0, 0, 0, 0, 0, 0],
    }
}

fn mechanism(moves: bool) -> Mechanism {
    let port = Port { name: "a".into(), x: 0.5, y: 0.0, angle: 0.0 };
    let body = |name: &str| Body {
        name: name.into(),
        mass: 1.0,
        inertia: 0.5,
        depth: 0.0,
        ports: vec![port.clone()],
        contour: Some(vec![[0.0, 1.0], [1.0, 0.0], [0.0, 0.0]]),
        holes: Vec::new(),
    };
    Mechanism {
        name: "Press".into(),
        bodies: vec![body("arm"), body("rod")],
        ground: vec![GroundPort { name: "o".into(), x: 0.0, y: 0.0, angle: 0.0, depth: 0.0, moves }],
        parameters: vec![Parameter { quantity: quantity("length"), default: Some(0.35), value: 0.4 }],
        inputs: vec![quantity("lift")],
        ..Mechanism::default()
    }
}

fn run(mechanism: Mechanism, rows: usize) -> Recording {
    let (poses, ground) = (6 * mechanism.bodies.len(), 3 * usize::from(mechanism.ground_moves()));
    let mut run = Recording::of(mechanism, [("arm.angle", "deg"), ("ratio", ""), ("lift", "mm")]);
    for row in 0..rows {
        let numbers = |count: usize| (0..count).map(|k| dyadic(7 * row + k)).collect::<Vec<f64>>();
        let (poses, ground, values) = (numbers(poses), numbers(ground), numbers(3));
        if row == 2 {
            run.push_event(0.25, "hinge");
        }
        run.push_row(&Row { time: 0.125 * row as f64, poses: &poses, ground: &ground, values: &values });
    }
    run
}

/// Good files: of several runs, with and without a ground that moves, of no mechanism, and without rows.
pub(crate) fn seeds() -> Vec<Archive> {
    static SEEDS: LazyLock<Vec<Archive>> = LazyLock::new(|| {
        let mut table = Recording::new([("x", "m")]);
        // Many rows: with more columns they are many numbers.
        (0..700).for_each(|k| table.push(0.5 * f64::from(k), [dyadic(k as usize)]));
        let files: [Results; 4] = [
            Results::from(run(mechanism(true), 9)),
            [run(mechanism(false), 4), run(mechanism(true), 3)].into_iter().collect(),
            Results::from(table),
            Results::from(run(mechanism(false), 0)),
        ];
        files.map(|file| Archive::of(&file.to_bytes().unwrap())).to_vec()
    });
    SEEDS.clone()
}

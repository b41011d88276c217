//! Results files: back to the bit, whole or not, of others, and read by others.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

use plm_view::{
    Body, Fault, Frame, GroundPort, Mechanism, Operations, Parameter, Part, Port, Quantity, Recording,
    Report, Results, Row, Shape,
};
use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

fn scratch(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("results").join(name)
}

fn quantity(name: &str, unit: &str, factor: f64) -> Quantity {
    let doc = "With \"quotes\" and µ.".to_owned();
    Quantity { name: name.into(), doc, unit: unit.into(), factor, exponents: [1, 0, -2, 0, 0, 0, 0] }
}

/// Two bodies, one of them with a contour, on a ground that moves.
fn mechanism(mass: f64) -> Mechanism {
    let port = |name: &str, x: f64| Port { name: name.into(), x, y: -0.0, angle: 1.0 / 3.0 };
    let body = |name: &str, contour| Body {
        name: name.into(),
        mass,
        inertia: 0.1 + 0.2,
        depth: 0.0,
        ports: vec![port("a", -0.5), port("b", 0.5)],
        holes: if name == "arm" { vec![vec![[0.4, 0.3], [0.6, 0.3], [0.5, 0.6]]] } else { Vec::new() },
        contour,
    };
    Mechanism {
        name: "Press".into(),
        doc: "Two lines,\nthe second.".into(),
        report: Report {
            formulation: "joint coordinates".into(),
            reason: "the joints make a tree".into(),
            degrees_of_freedom: -1,
            operations: Operations { add: 11, mul: 22, div: 1, ..Operations::default() },
        },
        bodies: vec![body("arm", Some(vec![[0.0, 1e-300], [1.0, 0.1], [0.5, 2.0]])), body("rod", None)],
        ground: vec![GroundPort {
            name: "o".into(),
            x: 0.0,
            y: f64::NAN,
            angle: 0.0,
            depth: -0.01,
            moves: true,
        }],
        parts: vec![Part {
            name: "hinge".into(),
            kind: "revolute".into(),
            pair: Some("revolute".into()),
            frames: vec![
                Frame { argument: "a".into(), body: None, port: Some(0) },
                Frame { argument: "b".into(), body: Some(1), port: None },
            ],
            sizes: [("pin".to_owned(), 0.02)].into(),
            shapes: vec![Shape {
                look: "circle".into(),
                body: Some(1),
                port: None,
                towards: Some((None, Some(0))),
                symbol: true,
                points: vec![[0.0, 0.0], [2.5, 0.0]],
            }],
        }],
        parameters: vec![Parameter { quantity: quantity("mass", "kg", 1.0), default: None, value: mass }],
        inputs: vec![quantity("drive", "kN", 1000.0)],
        states: vec![],
    }
}

/// A run of some rows, with every kind of number among them.
fn run(name: &str, rows: usize) -> Recording {
    let mut run = Recording::of(mechanism(rows as f64), [("arm.angle", "deg"), ("ratio", "")]);
    run.about.name = name.into();
    run.about.method = "Dop853, relative tolerance 1e-9".into();
    let special =
        [f64::NAN, -f64::NAN, f64::from_bits(0x7ff8_dead_beef_0001), f64::INFINITY, -0.0, 5e-324, f64::MAX];
    for k in 0..rows {
        let number = |j: usize| special.get(k + j).copied().unwrap_or((k as f64 + 0.1 * j as f64).sin());
        let (poses, ground): (Vec<f64>, Vec<f64>) =
            ((0..12).map(number).collect(), (3..6).map(number).collect());
        let values = [number(1), number(2)];
        if k == 2 {
            run.push_event(0.2, "hinge");
        }
        run.push_row(&Row { time: 0.1 * k as f64, poses: &poses, ground: &ground, values: &values });
    }
    run.push_event(9.0, "after the last row");
    run.about.fault =
        Some(Fault { time: 0.1 * rows as f64, part: "hinge".into(), text: "it locks up".into() });
    run
}

/// All numbers of the first rows of a run, by their bits.
fn bits(run: &Recording, rows: usize) -> Vec<u64> {
    let of_row = |k: usize| {
        let poses = run.poses(k).iter().flatten().chain(run.ground(k).iter().flatten());
        let values = run.rows().nth(k).unwrap();
        poses.chain(values).chain([&run.times()[k]]).map(|number| number.to_bits()).collect::<Vec<u64>>()
    };
    (0..rows).flat_map(of_row).collect()
}

/// By its text, since NaN is not equal to itself.
fn told<T: std::fmt::Debug>(value: &T) -> String {
    format!("{value:?}")
}

#[test]
fn two_runs_come_back_to_the_bit() {
    let written: Results = [run("light", 12), run("heavy", 3)].into_iter().collect();
    let path = scratch("deep/two.npz");
    written.write(&path).unwrap();
    let read = Results::read(&path).unwrap();
    assert_eq!(read.made_by, concat!("plm ", env!("CARGO_PKG_VERSION")));
    assert_eq!(read.runs.len(), 2);
    for (read, written) in read.runs.iter().zip(&written.runs) {
        assert_eq!(told(&read.about), told(&written.about));
        assert_eq!(read.len(), written.len());
        assert_eq!(bits(read, read.len()), bits(written, written.len()));
    }
    assert_eq!(read.runs[0].about.events[0].row, Some(2));
    assert_eq!(read.runs[0].about.events[1].row, None);
    assert_eq!(read.to_bytes().unwrap(), written.to_bytes().unwrap(), "the same runs, the same bytes");
}

#[test]
fn runs_get_names_of_their_own_and_may_be_empty() {
    let written: Results = [run("a", 0), run("a", 1), run("", 2)].into_iter().collect();
    let (read, problems) = Results::from_bytes(&written.to_bytes().unwrap());
    assert!(problems.is_empty(), "{problems:?}");
    assert_eq!(
        read.runs.iter().map(|run| run.about.name.as_str()).collect::<Vec<_>>(),
        ["a", "a (2)", "run"]
    );
    assert_eq!(read.runs.iter().map(Recording::len).collect::<Vec<_>>(), [0, 1, 2]);
}

#[test]
fn a_table_without_a_mechanism_is_a_results_file_too() {
    let mut table = Recording::new(vec![("x", "m")]);
    table.push(0.0, [1.5]);
    table.push(0.5, vec![f64::NAN]);
    let path = scratch("table.npz");
    table.write(&path).unwrap();
    let read = Results::read(&path).unwrap();
    assert_eq!(read.runs[0].columns(), table.columns());
    assert_eq!(bits(&read.runs[0], 2), bits(&table, 2));
}

/// Names of the entries and where each ends.
fn boundaries(bytes: &[u8]) -> Vec<(String, usize)> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut ends = Vec::new();
    for k in 0..archive.len() {
        let file = archive.by_index(k).unwrap();
        ends.push((file.name().to_owned(), (file.data_start().unwrap() + file.compressed_size()) as usize));
    }
    ends
}

/// Cut off at every byte: never a panic, always an error, and all entries before the cut.
#[test]
fn of_a_file_that_is_cut_off_all_is_given_that_came_before() {
    let written: Results = [run("light", 9), run("heavy", 4)].into_iter().collect();
    let bytes = written.to_bytes().unwrap();
    let ends = boundaries(&bytes);
    let names: Vec<&str> = ends.iter().map(|(name, _)| name.as_str()).collect();
    let arrays = ["time", "poses", "ground", "values"];
    let of_runs = [0, 1].iter().flat_map(|run| arrays.map(|array| format!("{run}/{array}.npy")));
    assert_eq!(names, [vec!["plm.json".to_owned()], of_runs.collect()].concat());
    for cut in 0..bytes.len() {
        let (read, problems) = Results::from_bytes(&bytes[..cut]);
        assert!(!problems.is_empty(), "{cut}");
        let whole = |name: &str| ends.iter().any(|(known, end)| known == name && *end <= cut);
        if !whole("plm.json") {
            assert!(read.runs.is_empty(), "{cut}");
            continue;
        }
        for (k, (read, written)) in read.runs.iter().zip(&written.runs).enumerate() {
            assert_eq!(told(&read.about), told(&written.about));
            if whole(&format!("{k}/time.npy")) {
                assert_eq!(read.times(), written.times(), "{cut}");
            }
            let is_told =
                |name: &str| problems.iter().any(|problem| problem.starts_with(&format!("{k}/{name}.npy")));
            for name in &arrays {
                assert!(!(whole(&format!("{k}/{name}.npy")) && is_told(name)), "{cut}: {problems:?}");
            }
            // Of an array without its last bytes all numbers may have come.
            if !arrays.into_iter().any(is_told) {
                assert_eq!(bits(read, read.len()), bits(written, written.len()), "{cut}");
            }
        }
    }
}

/// Of an array that is cut off its first rows come, and gaps after them.
#[test]
fn rows_of_an_array_that_is_cut_off_are_given() {
    let mut written = Recording::new([("x", "m")]);
    for k in 0..4000_u32 {
        // Numbers that cannot be packed, so that a part of the file is a part of the rows.
        let noise = u64::from(k).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        written.push(f64::from(k), [f64::from_bits(noise >> 2)]);
    }
    let bytes = Results::from(written.clone()).to_bytes().unwrap();
    let (name, end) = boundaries(&bytes).pop().unwrap();
    assert_eq!(name, "0/values.npy");
    let (read, problems) = Results::from_bytes(&bytes[..end - 5000]);
    let read = &read.runs[0];
    let came = read.rows().take_while(|row| !row[0].is_nan()).count();
    assert!(came > 1000 && came < 4000, "{came}");
    assert_eq!(bits(read, came), bits(&written, came));
    assert_eq!(read.times(), written.times());
    assert!(problems.contains(&format!("0/values.npy is cut off after {came} of 4000 rows")), "{problems:?}");
}

/// One byte is another: it is found, or the file means the same.
#[test]
fn damage_is_found() {
    let written = Results::from(run("run", 9));
    let bytes = written.to_bytes().unwrap();
    for at in (0..bytes.len()).step_by(3) {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x24;
        let (read, problems) = Results::from_bytes(&damaged);
        let same = read.runs.len() == 1
            && told(&read.runs[0].about) == told(&written.runs[0].about)
            && read.runs[0].len() == 9
            && bits(&read.runs[0], 9) == bits(&written.runs[0], 9);
        assert!(same || !problems.is_empty(), "byte {at} of {}", bytes.len());
    }
}

fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

#[test]
fn files_of_others_are_told_from_results() {
    let problem = |bytes: &[u8]| {
        let (read, problems) = Results::from_bytes(bytes);
        assert!(read.runs.is_empty());
        problems.join("; ")
    };
    assert_eq!(problem(b"time (s),x (m)\n0,1\n"), "it is no results file: no zip archive");
    assert_eq!(problem(b""), "it is no results file: no zip archive");
    assert_eq!(problem(&archive(&[("word/document.xml", b"<xml/>")])), "plm.json is missing");
    let with = |json: &str| problem(&archive(&[("plm.json", json.as_bytes())]));
    assert_eq!(with("{\"runs\": []}"), "it is no results file: the format in plm.json is not `plm results`");
    assert_eq!(
        with("{\"format\": \"plm results\", \"version\": 2}"),
        "it is of version 2 of the format; 1 can be read"
    );
    assert!(with("{\"format\": ").starts_with("plm.json: EOF"), "{}", with("{"));
    let error = Results::read(scratch("nowhere.npz")).unwrap_err();
    assert!(error.to_string().starts_with("cannot read all of "), "{error}");
    assert!(error.whole().runs.is_empty() && error.path().ends_with("nowhere.npz"));
}

/// The bytes of an array of NumPy with this header.
fn npy(header: &str, data: &[u8]) -> Vec<u8> {
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), data].concat()
}

#[test]
fn arrays_of_other_kinds_are_refused_by_name_and_single_precision_is_read() {
    let head = r#"{"format": "plm results", "version": 1, "made_by": "hand", "more": 1, "runs": [{"name": "run",
        "mechanism": {"name": "", "doc": "", "report": {"formulation": "", "reason": "", "degrees_of_freedom": 0,
            "operations": {"add": 0, "mul": 0, "div": 0, "sqrt": 0, "sin_cos": 0, "other": 0}}, "bodies": [],
            "ground": [], "parts": [], "parameters": [], "inputs": [], "states": []},
        "method": "", "columns": [{"name": "x", "unit": "m"}], "events": [], "fault": null}]}"#;
    let float = |numbers: &[f32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>();
    let time = npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2,), }", &float(&[0.0, 0.5]));
    let poses = npy("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 0, 6), }", &[]);
    let read = |values: &[u8]| {
        let entries: [(&str, &[u8]); 4] = [
            ("plm.json", head.as_bytes()),
            ("0/time.npy", &time),
            ("0/poses.npy", &poses),
            ("0/values.npy", values),
        ];
        let (read, problems) = Results::from_bytes(&archive(&entries));
        (
            read.runs[0].times().to_vec(),
            read.runs[0].rows().map(<[f64]>::to_vec).collect::<Vec<_>>(),
            problems,
        )
    };
    let values = npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 1)}", &float(&[1.5, -2.5]));
    assert_eq!(read(&values), (vec![0.0, 0.5], vec![vec![1.5], vec![-2.5]], vec![]));
    for (values, expected) in [
        (
            npy("{'descr': '<i8', 'fortran_order': False, 'shape': (2, 1)}", &[0; 16]),
            "holds numbers of the kind '<i8'",
        ),
        (
            npy("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 1)}", &[0; 16]),
            "is not stored row by row",
        ),
        (npy("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}", &[0; 48]), "has the shape [2, 3]"),
        (b"PK".to_vec(), "is no array of NumPy"),
    ] {
        let (times, rows, problems) = read(&values);
        assert_eq!((times.len(), rows.len(), rows[0][0].is_nan()), (2, 2, true), "what is missing is a gap");
        assert!(
            problems.len() == 1 && problems[0].starts_with(&format!("0/values.npy {expected}")),
            "{problems:?}"
        );
    }
}

#[test]
fn rows_of_another_length_are_told_when_they_are_written() {
    let mut table = Recording::new([("x", "m"), ("y", "m")]);
    table.push(0.0, [1.0, 2.0]);
    table.push(0.1, [1.0]);
    table.push(0.2, [1.0, 2.0, 3.0]);
    assert!(table.rows().nth(1).unwrap()[1].is_nan());
    assert_eq!(table.rows().nth(2).unwrap(), [1.0, 2.0]);
    let error = table.write(scratch("uneven.npz")).unwrap_err();
    assert!(error.to_string().ends_with("row 1 has 1 numbers, and there are 2 columns"), "{error}");
    assert!(table.write_csv_to(Vec::new()).is_err());
}

/// What reads the file with NumPy or, where that is missing, with Python's own library, and prints every number.
const READER: &str = include_str!("results/read.py");

/// Python reads the same bits; by NumPy where it is installed.
#[test]
fn python_reads_the_file() {
    let written: Results = [run("light", 12), run("heavy", 3)].into_iter().collect();
    let path = scratch("python.npz");
    written.write(&path).unwrap();
    let Ok(output) = Command::new("python3").args(["-c", READER]).arg(Path::new(&path)).output() else {
        println!("skipped: there is no python3");
        return;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let mut lines = text.lines();
    let kind = lines.next().unwrap();
    if kind == "python" {
        println!("without NumPy, which is not installed (`pip install numpy`): by zipfile and struct");
    }
    let hex = |numbers: &mut dyn Iterator<Item = f64>| {
        numbers.flat_map(f64::to_le_bytes).map(|byte| format!("{byte:02x}")).collect::<Vec<String>>().concat()
    };
    for run in &written.runs {
        let rows = run.len();
        let poses = (0..rows).flat_map(|k| run.poses(k).iter().flatten().copied());
        let ground = (0..rows).flat_map(|k| run.ground(k).iter().flatten().copied());
        let mut expected = [
            format!("time [{rows}] {}", hex(&mut run.times().iter().copied())),
            format!("poses [{rows}, 2, 6] {}", hex(&mut { poses })),
            format!("ground [{rows}, 1, 3] {}", hex(&mut { ground })),
            format!("values [{rows}, 2] {}", hex(&mut run.rows().flatten().copied())),
        ]
        .into_iter();
        for line in lines.by_ref().take(4) {
            assert_eq!(line, expected.next().unwrap());
        }
    }
    assert_eq!(
        lines.next().unwrap(),
        "[{'argument': 'a', 'body': None, 'port': 0}, {'argument': 'b', 'body': 1, 'port': None}]"
    );
}

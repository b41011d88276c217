//! The table: its heading, its numbers to the bit, its errors.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::path::PathBuf;

use plm_view::Recording;

fn text(recording: &Recording) -> String {
    let mut bytes = Vec::new();
    recording.write_csv_to(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn scratch(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("csv").join(name)
}

#[test]
fn heading_holds_names_and_units() {
    let recording = Recording::new([("arm.angle", "deg"), ("elbow.torque", "N*m"), ("ratio", "")]);
    assert_eq!(text(&recording), "time (s),arm.angle (deg),elbow.torque (N*m),ratio\n");
}

#[test]
fn rows_stand_in_the_order_in_which_they_were_pushed() {
    let mut recording = Recording::new([("x", "m")]);
    recording.push(0.0, [1.5]);
    recording.push(0.001, [-2e-300]);
    assert_eq!(text(&recording), "time (s),x (m)\n0.0,1.5\n0.001,-2e-300\n");
}

#[test]
fn a_name_with_a_comma_is_quoted() {
    assert_eq!(text(&Recording::new([("force, x", "N")])), "time (s),\"force, x (N)\"\n");
}

#[test]
fn numbers_read_back_to_the_same_bits() {
    // Every exponent, with a mantissa that uses all its bits; then the special values.
    let mut numbers: Vec<f64> =
        (0..2047u64).map(|exponent| f64::from_bits(exponent << 52 | 0x000a_5a5a_5a5a_5a5b)).collect();
    numbers.extend([0.0, -0.0, f64::MAX, f64::MIN_POSITIVE, 5e-324, f64::INFINITY, f64::NEG_INFINITY]);
    let mut recording = Recording::new([("x", "m")]);
    for &number in &numbers {
        recording.push(-number, [number]);
    }

    let text = text(&recording);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let read: Vec<[f64; 2]> = reader.deserialize().map(Result::unwrap).collect();

    assert_eq!(read.len(), numbers.len());
    for (read, number) in read.iter().zip(&numbers) {
        assert_eq!(read[0].to_bits(), (-number).to_bits());
        assert_eq!(read[1].to_bits(), number.to_bits());
    }
}

#[test]
fn what_was_recorded_before_a_failure_is_written() {
    let mut recording = Recording::new([("x", "m")]);
    let run = |recording: &mut Recording| -> Result<(), &str> {
        recording.push(0.0, [1.0]);
        recording.push(0.1, [f64::NAN]);
        Err("the mechanism cannot be moved further")
    };
    assert!(run(&mut recording).is_err());

    let path = scratch("failed/run.csv");
    recording.write_csv(&path).unwrap();
    assert_eq!(std::fs::read_to_string(path).unwrap(), "time (s),x (m)\n0.0,1.0\n0.1,NaN\n");
}

#[test]
fn the_error_names_the_file() {
    let file = scratch("a-file");
    let recording = Recording::new([("x", "m")]);
    recording.write_csv(&file).unwrap();

    let below = file.join("x.csv");
    let error = recording.write_csv(&below).unwrap_err();
    assert_eq!(error.path(), below);
    assert!(error.to_string().starts_with(&format!("cannot write {}: ", below.display())), "{error}");
}

#[test]
fn a_writer_that_fails_is_an_error() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::Error::from(std::io::ErrorKind::StorageFull))
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let error = Recording::new([("x", "m")]).write_csv_to(Full).unwrap_err();
    assert_eq!(error.kind(), std::io::ErrorKind::StorageFull);
}

#[test]
fn a_table_is_read_back() {
    let mut recording = Recording::new([("force, x", "N"), ("ratio", ""), ("odd (name)", "m")]);
    recording.push(0.0, [1.5, f64::NAN, -0.0]);
    recording.push(1e-300, [f64::INFINITY, 0.1 + 0.2, 5e-324]);
    let path = scratch("back.csv");
    recording.write_csv(&path).unwrap();
    let read = Recording::read_csv(&path).unwrap();
    assert_eq!(read.columns(), recording.columns());
    assert_eq!(format!("{:?}", read.times()), format!("{:?}", recording.times()));
    let rows = |of: &Recording| of.rows().map(|row| format!("{row:?}")).collect::<Vec<_>>();
    assert_eq!(rows(&read), rows(&recording));
}

/// The rows before a line that is wrong or cut off are given.
#[test]
fn what_is_whole_of_a_table_is_read() {
    let path = scratch("cut.csv");
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    for (text, rows, problem) in [
        ("time (s),x (m)\n0,1\n0.1,2\n0.2", 2, "line 4: the file is cut off there"),
        ("time (s),x (m)\n0,1\n0.1,2\n0.2,0.30", 2, "line 4: the file is cut off there"),
        ("time (s),x (m)\n0,1\n0.1,2\n0.2\n", 2, "line 4: 1 numbers where the first line names 2 columns"),
        ("time (s),x (m)\r\n0,1\r\n0.1,2", 1, "line 3: the file is cut off there"),
        ("time (s),arm.ang", 0, "line 1: the file is cut off there"),
        ("time (s),x (m)\n0,1\n0.1,abc\n", 1, "line 3, column `x (m)`: `abc` is no number"),
        ("PK\u{3}\u{4}", 0, "its first column is not `time (s)`"),
        ("", 0, "its first column is not `time (s)`"),
    ] {
        std::fs::write(&path, text).unwrap();
        let error = Recording::read_csv(&path).unwrap_err();
        assert!(error.problems()[0].starts_with(problem), "{error}");
        assert_eq!(error.into_whole().len(), rows);
    }
    assert_eq!(Recording::read_csv(scratch("nowhere.csv")).unwrap_err().problems().len(), 1);
}

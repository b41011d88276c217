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

fn read(text: impl AsRef<[u8]>) -> Result<Recording, plm_view::Unread<Recording>> {
    let path = scratch("read.csv");
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    let _one_at_a_time = ONE.lock();
    std::fs::write(&path, text).unwrap();
    Recording::read_csv(&path)
}

static ONE: std::sync::Mutex<()> = std::sync::Mutex::new(());

/// The rows before a line that is wrong or cut off are given.
#[test]
fn what_is_right_of_a_table_is_read() {
    for (text, rows, problem) in [
        (
            "time (s),x (m)\n0,1\n0.1,2\n0.2",
            2,
            "line 4: found 1 field, expected 2 fields, as in line 1; the file is cut off there",
        ),
        ("time (s),x (m)\n0,1\n0.1,2\n0.2\n", 2, "line 4: found 1 field, expected 2 fields, as in line 1"),
        (
            "time (s),x (m)\r\n0,1\r\n0.1,-",
            1,
            "line 3, column 2 (`x (m)`): found `-`, expected a number, or `NaN` where there is none; the file is cut",
        ),
        ("time (s),x (m)\n0,1\n0.1,abc\n", 1, "line 3, column 2 (`x (m)`): found `abc`, expected a number"),
        (
            "time (s),x (m)\n0,1\n0.1,",
            1,
            "line 3, column 2 (`x (m)`): found nothing, expected a number, or `NaN` where there is none; the file is cut",
        ),
        ("time (s),x (m)\n0,1\n,2\n", 1, "line 3, column 1 (`time (s)`): found nothing, expected a number"),
        ("time (s),x (m),\n0,1,2\n", 0, "line 2: found 3 fields, expected 2 fields, as in line 1"),
        (",t,,x\n1,0,3,4\n5,1,6,7\n", 0, "line 1, column 1: found no heading of a column of numbers"),
        ("# a\n\nx,t\n\n# b\n1,0\n\n2,soon\n", 1, "line 8, column 2 (`t`): found `soon`, expected a number"),
        (
            "time (s);x (m)\n0,5;1.234,5\n",
            0,
            "line 2, column 2 (`x (m)`): found `1.234,5`, expected a number",
        ),
        ("time (s),x (m)\n0,5,1\n", 0, "line 2: found 3 fields, expected 2 fields, as in line 1"),
        ("time (s),x (m)\n0,\"1,5\"\n", 0, "line 2, column 2 (`x (m)`): found `1,5`, expected a number"),
        (
            "Time (fortnight),x\n0,1\n",
            0,
            "line 1, column 1: found `Time (fortnight)`, expected a time in one of s, ms, us, ns, min, h",
        ),
        (
            "\n0;1\n",
            0,
            "line 2: found `0`, `1`, expected a column of the time, such as `time (s)` or `t (ms)`",
        ),
        ("PK\u{3}\u{4}", 0, "line 1: found `PK\\u{3}\\u{4}`, expected a column of the time"),
        ("# nothing\n \n", 0, "found no line, expected headings, such as `time (s),arm.angle (deg)`"),
        ("", 0, "found no line, expected headings"),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.problems()[0].starts_with(problem), "{text:?}: {error}");
        assert_eq!(error.into_whole().len(), rows, "{text:?}");
    }
    let half: &[u8] = &[0xff, 0xfe, 0x00, 0xd8, b't', 0];
    assert_eq!(read(half).unwrap_err().problems(), ["line 1: found UTF-16 that is no text"]);
    assert_eq!(Recording::read_csv(scratch("nowhere.csv")).unwrap_err().problems().len(), 1);
}

/// Headings, separators, ends of lines and comments of spreadsheets, instruments and programs.
#[test]
fn tables_of_others_are_read() {
    for text in [
        "time (s),x (mm)\n0,1.5\n0.25,-2e-3\n",
        "time,x (mm)\n0,1.5\n0.25,-2e-3",
        "t,x (mm)\r\n0,1.5\r\n0.25,-2e-3\r\n",
        "t (s),x (mm)\r\n0,1.5\r\n0.25,-2e-3",
        "Time [s],x [mm]\n0,1.5\n0.25,-2e-3\n",
        "TIME(s),x [mm]\n0,1.5\n0.25,-2e-3\n",
        "t/s,x (mm)\n0,1.5\n0.25,-2e-3\n",
        "time (ms),x (mm)\n0,1.5\n250,-2e-3\n",
        "time_us,x (mm)\n0,1.5\n250000,-2e-3\n",
        "t [\u{b5}s],x (mm)\n0,1.5\n250000,-2e-3\n",
        "x (mm),t (min)\n1.5,0\n-2e-3,0.004166666666666667\n",
        "\u{feff}time;x (mm)\r\n0;1,5\r\n0,25;-2e-3\r\n",
        "time (s);x (mm)\n0;1.5\n0.25;-0,002\n",
        "time (s)\tx (mm)\n0\t1.5\n0.25\t-2e-3\n",
        // Excel in countries with a decimal comma, LabVIEW, DIAdem, pandas, NumPy.
        "sep=;\r\ntime (s);x (mm)\r\n0;1,5\r\n0,25;-2e-3\r\n",
        "\u{feff}\"SEP=,\"\r\ntime (s),x (mm)\r\n0,1.5\r\n0.25,-2e-3\r\n",
        "sep=|\ntime (s)|x (mm)\n0|1,5\n0,25|-2e-3\n",
        "Zeit [s];x [mm];;\r\n0;1,5;;\r\n0,25;-2e-3;;\r\n",
        "time (s),x (mm)\n0,1.5,,\n0.25,-2e-3,,\n",
        "Zeit in s\tx in mm\n0\t1,5\n0,25\t-0,002\n",
        "temps/ms\tx/mm\r0\t1,5\r250\t-0,002\r",
        "time(s),x(mm)\n0,1.5\n0.25,-2e-3\n",
        "time;x\ns;mm\n0;1,5\n0,25;-2e-3\n",
        "time,x\n[ms],[mm]\n0,1.5\n250,-2e-3\n",
        ",time (s),x (mm)\n0,0,1.5\n1,0.25,-2e-3\n",
        "index;t;x [mm]\n1;0;1,5\n2;0,25;-0,002\n",
        "Nr.\tt\tx (mm)\n1\t0\t1,5\n2\t0,25\t-0,002\n",
        "Rig;4\nDate;2026-11-28\n\nTime [s];x [mm]\n0;1,5\n0,25;-2e-3\n",
        "X_Value\tx (mm)\tComment\n0,000000\t1,500000\t\n0,250000\t-0,002000\t\n",
        "# time x\n# t,x (mm)\n0,1.5\n0.25,-2e-3\n",
        "# rig 4, second try\n\n\"time (s)\",\"x (mm)\"\n# begins\n0, 1.5\n\n   \n,\n0.25, -2e-3\n\n",
    ] {
        let read = read(text).unwrap_or_else(|error| panic!("{text:?}: {error}"));
        assert_eq!(read.columns(), Recording::new([("x", "mm")]).columns(), "{text:?}");
        assert_eq!(read.times(), [0.0, 0.25], "{text:?}");
        assert_eq!(read.rows().collect::<Vec<_>>(), [[1.5], [-2e-3]], "{text:?}");
    }
    let wide: Vec<u8> =
        "\u{feff}Zeit [s]\tx [mm]\r\n0\t1,5\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(read(wide).unwrap().rows().collect::<Vec<_>>(), [[1.5]]);
    let wide: Vec<u8> =
        "\u{feff}Zeit [s]\tx [mm]\r\n0\t1,5\r\n".encode_utf16().flat_map(u16::to_be_bytes).collect();
    assert_eq!(read(wide).unwrap().rows().collect::<Vec<_>>(), [[1.5]]);
    let gaps = read("t;x (m);y\n0;;1\n1;NA;2\n2;3;#NV\n").unwrap();
    let shown = format!("{:?}", gaps.rows().collect::<Vec<_>>());
    assert_eq!(shown, "[[NaN, 1.0], [NaN, 2.0], [3.0, NaN]]");
    let units =
        read("t,a.x(m),b[2],c[N*m],d (\u{b0}/s),e [m/s\u{b2}],f (Nm),g\ns,,,,,,,rad\n0,1,2,3,4,5,6,7\n")
            .unwrap();
    let columns = [
        ("a.x", "m"),
        ("b[2]", ""),
        ("c", "N*m"),
        ("d", "deg/s"),
        ("e", "m/s^2"),
        ("f", "N*m"),
        ("g", "rad"),
    ];
    assert_eq!(units.columns(), Recording::new(columns).columns());
    let read = read("t (ms),link[2],b (N/(m/s)),a [\u{b0}],f (x) (N)\n100,1,2,3,NaN\n").unwrap();
    assert_eq!(read.times(), [0.1]);
    let columns = [("link[2]", ""), ("b", "N/(m/s)"), ("a", "deg"), ("f (x)", "N")];
    assert_eq!(read.columns(), Recording::new(columns).columns());
}

/// Bytes of code page 1252, as Excel on Windows writes them: letters of names, signs of units, the ends of lines, comments.
#[test]
fn tables_of_code_page_1252_are_read() {
    let bytes = b"sep=;\r\n# Pr\xfcfstand \x80 5\r\nZeit (s);L\xe4nge [mm];Winkel [\xb0];Spiel (\xb5m);a (m/s\xb2);M (N\xb7m)\r\n0;1,5;2;3;4;5\r\n";
    let table = read(bytes).unwrap();
    let columns = [("L\u{e4}nge", "mm"), ("Winkel", "deg"), ("Spiel", "um"), ("a", "m/s^2"), ("M", "N*m")];
    assert_eq!(table.columns(), Recording::new(columns).columns());
    assert_eq!(table.rows().collect::<Vec<_>>(), [[1.5, 2.0, 3.0, 4.0, 5.0]]);
    assert_eq!(table.about.notices, ["line 2 is no UTF-8: the table is read as of code page 1252"]);
    // The Euro, dashes and quotes stand where Latin-1 has none.
    let marks = read(b"t,\x80 \x8a \x93 \x97 \x9f \xa0 \xff (N)\n0,1\n").unwrap();
    let names = Recording::new([("\u{20ac} \u{160} \u{201c} \u{2014} \u{178} \u{a0} \u{ff}", "N")]);
    assert_eq!(marks.columns(), names.columns());
    let with_returns = read(b"t\tWeg \x96 x (m)\r0\t1\r").unwrap();
    assert_eq!(with_returns.columns(), Recording::new([("Weg \u{2013} x", "m")]).columns());
    let mut utf = "time,Kraft \u{e4} (\u{b5}m)\n0,1\n".as_bytes().to_vec();
    assert!(read(&utf).unwrap().about.notices.is_empty());
    // A table that is cut off within a letter has what came before.
    utf.extend_from_slice(b"# \xc3");
    assert_eq!(read(&utf).unwrap().len(), 1);
}

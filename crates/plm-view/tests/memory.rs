//! What reading takes of memory is bounded. Each file is read in a process of its own, of which the system tells the most that
//! it had.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::fmt::Write as _;
use std::fs;
use std::io::{Cursor, Write};
use std::path::Path;
use std::process::Command;

use plm_view::{Recording, Results};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// What the allocator, the archive and the decompressor take besides, bytes.
const BESIDES: usize = 2 << 20;

/// A field of /proc/self/status, bytes; none where there is no such file.
fn status(field: &str) -> Option<usize> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(field))?;
    Some(1024 * line.trim_matches([':', ' ', '\t', 'k', 'B']).parse::<usize>().unwrap())
}

/// Where a process by itself finds the file, and how many bytes reading may take.
const FILE: &str = "PLM_MEMORY_FILE";
const MOST: &str = "PLM_MEMORY_MOST";

/// What such a process does: it reads the file, and tells by how much its memory has grown at most, and what was wrong.
#[test]
fn a_file_is_read_by_itself() {
    let Some(path) = std::env::var_os(FILE) else { return };
    let (bytes, most) = (fs::read(path).unwrap(), std::env::var(MOST).unwrap().parse().unwrap());
    let before = status("VmHWM").unwrap();
    let (read, problems) = Results::from_bytes_within(&bytes, most);
    println!("grown {}\n{}", status("VmHWM").unwrap() - before, problems.join("\n"));
    drop(read);
}

/// By how much the memory of a process grows at most that reads these bytes, and what was wrong with them; none where the
/// system does not tell.
fn taken(bytes: &[u8], most: usize) -> Option<(usize, Vec<String>)> {
    status("VmHWM")?;
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("memory.npz");
    fs::write(&path, bytes).unwrap();
    let mut this = Command::new(std::env::current_exe().unwrap());
    this.args(["--exact", "a_file_is_read_by_itself", "--nocapture"])
        .env(FILE, path)
        .env(MOST, most.to_string());
    let text = String::from_utf8(this.output().unwrap().stdout).unwrap();
    let (_, told) = text.split_once("grown ").unwrap_or_else(|| panic!("{text}"));
    let mut lines =
        told.lines().take_while(|line| !line.starts_with("test ")).filter(|line| !line.is_empty());
    let grown = lines.next().unwrap().parse().unwrap();
    Some((grown, lines.map(str::to_owned).collect()))
}

/// The bytes of an array of zeros, as a piece that is repeated.
fn zeros(zip: &mut ZipWriter<Cursor<Vec<u8>>>, name: &str, shape: &str, count: usize) {
    zip.start_file(name, SimpleFileOptions::default()).unwrap();
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({shape}), }}");
    zip.write_all(b"\x93NUMPY\x01\x00").unwrap();
    zip.write_all(&(header.len() as u16).to_le_bytes()).unwrap();
    zip.write_all(header.as_bytes()).unwrap();
    let piece = vec![0; 1 << 16];
    let mut left = 8 * count;
    while left > 0 {
        left -= zip.write(&piece[..left.min(piece.len())]).unwrap();
    }
}

/// The contents of plm.json for a run with these columns, and something more in its mechanism.
fn head(columns: usize, [parts, parameters, events]: [&str; 3]) -> String {
    let mut text = r#"{"format":"plm results","version":1,"made_by":"","runs":[{"name":"","mechanism":{"name":"","doc":"","report":
        {"formulation":"","reason":"","degrees_of_freedom":0,"operations":{"add":0,"mul":0,"div":0,"sqrt":0,"sin_cos":0,"other":0}},
        "bodies":[],"ground":[],"inputs":[],"states":[],"#
        .to_owned();
    write!(
        text,
        r#""parts":[{parts}],"parameters":[{parameters}]}},"method":"","fault":null,"events":[{events}],"#
    )
    .unwrap();
    let columns = vec![r#"{"name":"","unit":""}"#; columns].join(",");
    write!(text, r#""columns":[{columns}]}}]}}"#).unwrap();
    text
}

fn archive(head: &str, fill: impl FnOnce(&mut ZipWriter<Cursor<Vec<u8>>>)) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.start_file("plm.json", SimpleFileOptions::default()).unwrap();
    zip.write_all(head.as_bytes()).unwrap();
    fill(&mut zip);
    zip.finish().unwrap().into_inner()
}

/// Some kilobytes of a file stand for 24 MB of numbers.
fn packed_a_thousandfold() {
    let rows = 3_000_000;
    let bytes = archive(&head(1, [""; 3]), |zip| {
        zeros(zip, "0/time.npy", "2,", 2);
        zeros(zip, "0/values.npy", &format!("{rows}, 1"), rows);
    });
    assert!(bytes.len() < 100_000);
    let most = 4 << 20;
    let Some((grown, problems)) = taken(&bytes, most) else { return println!("skipped: no /proc") };
    println!("{} bytes that unpack to {}: {grown} taken of {most}", bytes.len(), 8 * rows);
    assert!(grown < most + BESIDES, "{grown}");
    assert!(problems[1].starts_with("0/values.npy takes more than 4194304 bytes"), "{problems:?}");
    // It is the bound that refuses it.
    let (grown, problems) = taken(&bytes, 16 * rows + (2 << 20)).unwrap();
    assert_eq!(problems[1..], ["0/values.npy has 3000000 rows where there are 2 times"]);
    assert!(grown > 8 * rows);
}

/// Numbers that are missing are gaps, which take memory too: 100 000 rows of 2000 columns are 1.6 GB.
fn gaps_of_a_large_table() {
    let bytes = archive(&head(2000, [""; 3]), |zip| zeros(zip, "0/time.npy", "100000,", 100_000));
    let most = 8 << 20;
    let Some((grown, problems)) = taken(&bytes, most) else { return };
    println!("gaps: {grown} taken of {most}");
    assert!(grown < most + BESIDES, "{grown}");
    assert!(problems[2].starts_with("what is missing of run 0 takes more than"), "{problems:?}");
}

/// The smallest things that plm.json can list, of each kind.
fn what_a_head_lists() {
    let keys = |count: usize| (0..count).map(|k| format!("\"{k:x}\":0")).collect::<Vec<_>>().join(",");
    let part = |frames: &str, sizes: &str| {
        format!(r#"{{"name":"","kind":"","pair":null,"frames":[{frames}],"sizes":{{{sizes}}}}}"#)
    };
    let many = |one: &str, count: usize| vec![one; count].join(",");
    let parameter = |more: &str| {
        format!(r#"{{"name":"","unit":"","factor":1,"default":null,"value":0,"more":[{more}]}}"#)
    };
    let zeros = many("0", 200_000);
    for (what, head) in [
        ("contour", head(0, [""; 3]).replace("\"bodies\":[]", &format!("\"bodies\":[{}]", contour(100_000)))),
        ("columns", head(50_000, [""; 3])),
        ("parts", head(0, [&many(&part("", ""), 20_000), "", ""])),
        ("frames", head(0, [&part(&many(r#"{"argument":"","body":null,"port":null}"#, 30_000), ""), "", ""])),
        ("sizes", head(0, [&part("", &keys(100_000)), "", ""])),
        ("parameters", head(0, ["", &many(&parameter(""), 20_000), ""])),
        ("unknown keys", head(0, ["", &parameter(&zeros), ""])),
        ("events", head(0, ["", "", &many(r#"{"time":0,"what":"","row":null}"#, 40_000)])),
        ("runs", head(0, [""; 3]).replace("}]}", &format!("}},{}]}}", vec![run(); 3000].join(",")))),
    ] {
        let bytes = archive(&head, |_| ());
        let Some((grown, problems)) = taken(&bytes, 64 << 20) else { return };
        assert!(
            problems.iter().all(|problem| problem.ends_with("npy is missing")),
            "{what}: {:?}",
            &problems[..1]
        );
        let times = grown as f64 / head.len() as f64;
        println!("{what}: {times:.1} times the length of plm.json, {}", head.len());
        assert!(grown < 16 * head.len() + BESIDES, "{what}: {times}");
        let (grown, problems) = taken(&bytes, 8 * head.len()).unwrap();
        assert!(problems[0].starts_with("plm.json takes more than"), "{what}: {problems:?}");
        assert!(grown < 8 * head.len() + BESIDES);
    }
}

/// A body with so many points.
fn contour(points: usize) -> String {
    let points = vec!["[0,0]"; points].join(",");
    format!(r#"{{"name":"","mass":0,"inertia":0,"depth":0,"ports":[],"contour":[{points}]}}"#)
}

/// A run that lists nothing.
fn run() -> String {
    let whole = head(0, [""; 3]);
    let (_, run) = whole.split_once("\"runs\":[").unwrap();
    run.strip_suffix("]}").unwrap().to_owned()
}

/// A file that is honest and fits is read, with room for one array twice.
fn what_fits_is_read() {
    let mut recording = Recording::new([("x", "m"), ("y", "m")]);
    (0..50_000).for_each(|k| recording.push(f64::from(k), [0.5, f64::from(k).sin()]));
    let bytes = Results::from(recording).to_bytes().unwrap();
    let [times, values] = [8 * 50_000, 16 * 50_000];
    let Some((grown, problems)) = taken(&bytes, times + 2 * values + 10_000) else { return };
    assert_eq!(problems, [""; 0]);
    assert!(grown < times + 2 * values + BESIDES, "{grown}");
}

#[test]
fn reading_takes_no_more_memory_than_is_said() {
    packed_a_thousandfold();
    gaps_of_a_large_table();
    what_a_head_lists();
    what_fits_is_read();
}

//! Studies in shards: the same bytes however they are cut and interrupted, and what is told of logs that are not whole.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use plm::study::{Gathered, Points, Ran, Shard, Spread, Study, linear};
use plm::{Fault, Sim};

use super::FourBar;

/// A folder for the test of this name, without what an earlier run has left there.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("study").join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn rocker([coupler, turned]: [f64; 2]) -> Result<[f64; 2], Fault> {
    let mut four_bar = FourBar { coupler, ..FourBar::new() };
    four_bar.start.crank.angle.value = turned;
    let mut sim = four_bar.start()?;
    let start = sim.rocker_angle();
    sim.step(0.2)?;
    Ok([start, sim.rocker_angle()])
}

/// 45 four-bars; 9 of them have a coupler that is too short.
fn four_bars() -> Points<2> {
    let couplers = vec![0.8, 0.7, 0.05, 0.9, 0.85];
    Points::grid([("coupler", "m", couplers), ("turned", "rad", linear(0.8, 1.2, 9))])
}

type Row<const P: usize> = fn([f64; P]) -> Result<[f64; 2], Fault>;

fn study() -> Study<Row<2>, 2, 2> {
    Study::new("four bars", four_bars(), [("start", "rad"), ("end", "rad")], rocker as Row<2>)
}

type Known = BTreeMap<[u64; 2], Result<[f64; 2], Fault>>;

/// The same for tests that ask again and again: each point is computed once.
fn known(point: [f64; 2]) -> Result<[f64; 2], Fault> {
    static KNOWN: Mutex<Known> = Mutex::new(BTreeMap::new());
    *KNOWN.lock().unwrap().entry(point.map(f64::to_bits)).or_insert_with(|| rocker(point))
}

/// All shards, the last first, and what they are merged into.
fn merged(name: &str, shards: usize, threads: usize) -> [Vec<u8>; 3] {
    let folder = folder(name);
    for number in (1..=shards).rev() {
        let ran = study().run(&folder, Shard::new(number, shards).unwrap(), threads).unwrap();
        assert_eq!(ran.kept, 0, "{name}: {ran:?}");
    }
    tables(&folder)
}

/// What the logs in a folder are merged into: CSV, an array of NumPy, and the table of its faults.
fn tables(folder: &Path) -> [Vec<u8>; 3] {
    let gathered = study().gather(folder).unwrap();
    assert_eq!(gathered.missing().count(), 0, "{gathered}");
    gathered.write(&folder.join("all.csv")).unwrap();
    gathered.write(&folder.join("all.npy")).unwrap();
    ["all.csv", "all.npy", "all.faults.csv"].map(|name| fs::read(folder.join(name)).unwrap())
}

#[test]
fn any_number_of_shards_and_threads_gives_the_same_bytes() {
    let one = merged("one", 1, 1);
    for (shards, threads) in [(1, 3), (2, 1), (7, 2), (50, 1)] {
        assert!(
            merged(&format!("{shards}-{threads}"), shards, threads) == one,
            "{shards} shards, {threads} threads"
        );
    }
}

#[test]
fn simulations_side_by_side_give_the_bytes_of_those_one_by_one() {
    let start = |[coupler, turned]: [f64; 2]| {
        let mut four_bar = FourBar { coupler, ..FourBar::new() };
        four_bar.start.crank.angle.value = turned;
        four_bar.start()
    };
    let seen = |sim: &Sim<FourBar>| [sim.rocker_angle(), sim.stats().evaluations as f64];
    let alone = |point| {
        let mut sim = start(point)?;
        sim.step(0.2)?;
        Ok::<_, Fault>(seen(&sim))
    };
    let columns = [("end", "rad"), ("evaluations", "")];
    let table = |folder: &Path, gathered: Gathered<2, 2>| {
        assert_eq!((gathered.missing().count(), gathered.failed().count()), (0, 9), "{gathered}");
        gathered.write(&folder.join("all.csv")).unwrap();
        fs::read(folder.join("all.csv")).unwrap()
    };
    let one_by_one = folder("one by one");
    let study = Study::new("four bars", four_bars(), columns, alone);
    study.run(&one_by_one, Shard::WHOLE, 1).unwrap();
    let known = table(&one_by_one, study.gather(&one_by_one).unwrap());
    let study = Study::to("four bars", four_bars(), columns, 0.2, (start, seen));
    for (shards, threads) in [(1, 1), (3, 2)] {
        let folder = folder(&format!("together {shards}"));
        for number in 1..=shards {
            study.run(&folder, Shard::new(number, shards).unwrap(), threads).unwrap();
        }
        assert!(table(&folder, study.gather(&folder).unwrap()) == known, "{shards} shards");
    }
}

#[test]
fn the_table_has_what_the_rows_gave() {
    let [csv, npy, faults] = merged("table", 2, 2);
    let csv = String::from_utf8(csv).unwrap();
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("index,coupler [m],turned [rad],start [rad],end [rad],fault"));
    // From the head on, which numpy.lib.format describes: 8 + 4 * 8 + 1 bytes a row.
    assert_eq!(&npy[..8], b"\x93NUMPY\x02\x00");
    let start = 12 + u32::from_le_bytes(npy[8..12].try_into().unwrap()) as usize;
    let head = str::from_utf8(&npy[12..start]).unwrap().trim_end();
    assert_eq!(
        head,
        "{'descr': [('index', '<u8'), ('coupler', '<f8'), ('turned', '<f8'), ('start', '<f8'), ('end', '<f8'), \
         ('failed', '|b1')], 'fortran_order': False, 'shape': (45,), }"
    );
    assert_eq!((start % 64, npy.len() - start), (0, 45 * 41));
    for (index, (line, row)) in lines.zip(npy[start..].chunks(41)).enumerate() {
        let number = |k: usize| f64::from_le_bytes(row[8 * k..][..8].try_into().unwrap());
        let point = four_bars().at(index).unwrap();
        assert_eq!(row[..8], (index as u64).to_le_bytes());
        assert_eq!([number(1), number(2)], point);
        match rocker(point) {
            Ok([start, end]) => {
                assert_eq!(([number(3), number(4)], row[40]), ([start, end], 0));
                assert_eq!(line, format!("{index},{:?},{:?},{start:?},{end:?},", point[0], point[1]));
            }
            Err(fault) => {
                assert!(number(3).is_nan() && row[40] == 1);
                let told = fault.to_string().replace('"', "\"\"");
                assert!(line.contains(&told), "{line}\n{told}");
                assert!(str::from_utf8(&faults).unwrap().contains(&format!("\n{index},0.05,")), "{index}");
            }
        }
    }
}

#[test]
fn points_that_fail_are_told_with_their_parameters() {
    let folder = folder("failed");
    let ran = study().run(&folder, Shard::WHOLE, 2).unwrap();
    assert_eq!(ran, Ran { kept: 0, computed: 45, failed: 9, notes: vec![] });
    let gathered = study().gather(&folder).unwrap();
    assert_eq!(gathered.failed().map(|(index, _)| index).collect::<Vec<_>>(), (18..27).collect::<Vec<_>>());
    let fault = rocker([0.05, 0.8]).unwrap_err();
    let told = gathered.to_string();
    assert!(told.starts_with("four bars: 45 of 45 points, 9 failed\n"), "{told}");
    assert!(told.contains(&format!("\npoint 18, coupler 0.05 m, turned 0.8 rad: {fault}")), "{told}");
    // They are not tried again.
    assert_eq!(
        study().run(&folder, Shard::WHOLE, 1).unwrap(),
        Ran { kept: 45, computed: 0, failed: 0, notes: vec![] }
    );
}

/// Wherever a process is ended in the midst of its log, each point that was whole is kept, and each other one computed once.
#[test]
fn a_log_that_is_cut_off_anywhere_is_continued() {
    let study = || Study::new("four bars", four_bars(), [("start", "rad"), ("end", "rad")], known as Row<2>);
    let (whole, cut) = (folder("whole"), folder("cut"));
    let whole_tables = {
        study().run(&whole, Shard::WHOLE, 1).unwrap();
        tables(&whole)
    };
    let log = fs::read(whole.join("1-of-1.log")).unwrap();
    let head = log.windows(2).position(|pair| pair == b"\n\n").unwrap() + 2;
    let record = 8 * 5;
    // All offsets in the description's last bytes and the first records, and in the last ones; some between by a fixed step.
    let near_head = head - 5..head + 3 * record + 1;
    let ends = near_head.chain((head..log.len()).step_by(997)).chain(log.len() - 3 * record..=log.len());
    fs::create_dir_all(&cut).unwrap();
    let mut last = (0, 0);
    for end in ends {
        fs::write(cut.join("1-of-1.log"), &log[..end]).unwrap();
        let kept = study().gather(&cut).unwrap().missing().count();
        let ran = study().run(&cut, Shard::WHOLE, 1).unwrap();
        assert_eq!((ran.computed, ran.kept), (kept, 45 - kept), "cut at {end} of {}", log.len());
        assert!(end < last.0 || ran.kept >= last.1, "a longer log has fewer points: {end}");
        last = (end, ran.kept);
        assert!(tables(&cut) == whole_tables, "cut at {end} of {}", log.len());
        assert_eq!(fs::metadata(cut.join("1-of-1.log")).unwrap().len(), log.len() as u64, "cut at {end}");
    }
    assert_eq!(last, (log.len(), 45));
}

#[test]
fn a_damaged_record_is_told_and_costs_its_point_alone() {
    let folder = folder("damaged");
    let sums: fn([f64; 2]) -> Result<[f64; 1], &'static str> = |[a, b]| Ok([a + b]);
    let study = || Study::new("sums", four_bars(), [("sum", "")], sums);
    study().run(&folder, Shard::WHOLE, 1).unwrap();
    let path = folder.join("1-of-1.log");
    let good = fs::read(&path).unwrap();
    let records = good.len() - 45 * 32;
    for byte in [0, 9, 17, 31] {
        let mut log = good.clone();
        log[records + 4 * 32 + byte] ^= 0x10;
        fs::write(&path, &log).unwrap();
        let told = study().gather(&folder).unwrap().to_string();
        assert!(told.starts_with("sums: 44 of 45 points") && told.contains("record 5 is damaged"), "{told}");
        let ran = study().run(&folder, Shard::WHOLE, 1).unwrap();
        assert_eq!((ran.kept, ran.computed, ran.notes.len()), (44, 1, 1), "{ran:?}");
        assert_eq!(study().gather(&folder).unwrap().missing().count(), 0);
    }
}

#[test]
fn no_point_is_computed_twice_by_another_number_of_shards() {
    let (folder, computed) = (folder("other number"), AtomicUsize::new(0));
    let study = Study::new("sums", four_bars(), [("sum", "")], |[a, b]| {
        computed.fetch_add(1, Ordering::Relaxed);
        Ok::<_, &str>([a + b])
    });
    for shard in ["2/3", "1/2", "1/1", "3/7", "2/2"] {
        study.run(&folder, Shard::parse(shard).unwrap(), 2).unwrap();
    }
    assert_eq!(computed.load(Ordering::Relaxed), 45);
    let gathered = study.gather(&folder).unwrap();
    for index in 0..45 {
        let [a, b] = four_bars().at(index).unwrap();
        assert_eq!(gathered.outcome(index), Some(&Ok([a + b])));
    }
}

fn by_chance(seed: u64, count: usize) -> Points<3> {
    let spread = Spread::Uniform { from: 2.0, to: 3.0 };
    let normal = Spread::Normal { mean: -1.0, deviation: 0.5 };
    Points::monte_carlo(seed, count, [("a", "", spread), ("b", "", normal), ("c", "", spread)])
}

/// Moments of 20 000 values, within five standard errors: of the mean s/sqrt(n), of the variance s^2 sqrt(2/n) for the normal
/// distribution and s^2 sqrt(4/(5 n)) for the uniform one, of the correlation 1/sqrt(n).
#[test]
fn monte_carlo_has_the_distributions_that_were_asked_for() {
    let (seed, count) = (31, 20_000);
    let points: Vec<[f64; 3]> = (0..count).map(|index| by_chance(seed, count).at(index).unwrap()).collect();
    let mean = |of: &dyn Fn(&[f64; 3]) -> f64| points.iter().map(of).sum::<f64>() / count as f64;
    let means = [0, 1, 2].map(|k| mean(&|point| point[k]));
    let variances = [0, 1, 2].map(|k| mean(&|point| (point[k] - means[k]).powi(2)));
    let root = (count as f64).sqrt();
    let uniform = (2.5, 1.0 / 12.0, 0.8);
    let shapes: [(f64, f64, f64); 3] = [uniform, (-1.0, 0.25, 2.0), uniform];
    for (k, (expected, variance, shape)) in shapes.into_iter().enumerate() {
        assert!(
            (means[k] - expected).abs() < 5.0 * variance.sqrt() / root,
            "seed {seed}: mean {k} {}",
            means[k]
        );
        let error = (variances[k] - variance).abs();
        assert!(error < 5.0 * variance * shape.sqrt() / root, "seed {seed}: variance {k} {}", variances[k]);
    }
    for (j, k) in [(0, 1), (0, 2), (1, 2)] {
        let both = mean(&|point| (point[j] - means[j]) * (point[k] - means[k]));
        let correlation = both / (variances[j] * variances[k]).sqrt();
        assert!(correlation.abs() < 5.0 / root, "seed {seed}: {j} and {k} {correlation}");
    }
}

#[test]
fn a_point_of_monte_carlo_is_a_function_of_its_number() {
    let few = by_chance(7, 10);
    assert_eq!(few.at(10), None);
    assert_eq!(few.at(9), by_chance(7, 1 << 40).at(9));
    assert_ne!(few.at(9), by_chance(8, 10).at(9));
    // More points go on in the logs of fewer.
    let folder = folder("more points");
    let sums: fn([f64; 3]) -> Result<[f64; 1], &'static str> = |[a, b, c]| Ok([a + b + c]);
    let study = |count| Study::new("sums", by_chance(7, count), [("sum", "")], sums);
    study(10).run(&folder, Shard::WHOLE, 1).unwrap();
    let ran = study(25).run(&folder, Shard::WHOLE, 1).unwrap();
    assert_eq!((ran.kept, ran.computed), (10, 15));
}

#[test]
fn mistakes_say_what_was_found_and_what_is_wanted() {
    let folder = folder("mistakes");
    let words = |words: &[&str]| study().with(words).unwrap_err().to_string();
    for (line, said) in [
        (vec!["--shards", "3"], "--shards belongs to --submit"),
        (vec!["--shard", "4/3"], "no shard 4/3: they are 1/3 to 3/3"),
        (vec!["--shard", "0/3"], "no shard 0/3"),
        (vec!["--shard", "three"], "3/64, not `three`"),
        (vec!["--submit", "pbs"], "slurm and hq, not `pbs`"),
        (vec!["--submit", "hq"], "--shards 64"),
        (vec!["--status", "--shard", "1/2"], "one at a time"),
        (vec!["--threads", "100000"], "100000 threads are too many: 1024 is the most"),
        (vec!["--submit", "hq", "--shards", "4", "--threads", "100000"], "100000 threads"),
        (vec!["--shard", "1/4294967296"], "4294967296 shards are too many"),
        (vec!["--shard", "18446744073709551615/18446744073709551615"], "shards are too many"),
        (vec!["--shard", "1/46"], "46 shards are too many: the study has 45 points"),
        (vec!["--submit", "slurm", "--shards", "46"], "the study has 45 points"),
        (vec!["--sharp", "3/4"], "--shard K/N"),
    ] {
        assert!(words(&line).contains(said), "{line:?}: {}", words(&line));
    }
    let merge = ["--folder", folder.to_str().unwrap(), "--merge", "all.csv"];
    let ran = study().run(&folder, Shard::parse("1/2").unwrap(), 1).unwrap();
    let missing =
        study().gather(&folder).unwrap().missing().take(2).map(|index| index.to_string()).collect::<Vec<_>>();
    let told = format!("\n{} points are missing: {}, ", 45 - ran.computed, missing.join(", "));
    assert!(words(&merge).contains(&told), "{}", words(&merge));
    let other = study().revision("2").run(&folder, Shard::parse("1/2").unwrap(), 1).unwrap_err().to_string();
    assert!(other.contains("it has `revision `, this program `revision 2`"), "{other}");
    let twice =
        Study::new("twice", four_bars(), [("turned", ""), ("b", "")], rocker).run(&folder, Shard::WHOLE, 1);
    assert!(twice.unwrap_err().to_string().contains("called `turned`"));
}

/// A process that has nothing to do says so.
#[test]
fn shards_and_studies_without_points_are_told() {
    let folder = folder("empty");
    let rans: Vec<Ran> =
        (1..=50).map(|number| study().run(&folder, Shard::new(number, 50).unwrap(), 1).unwrap()).collect();
    let empty = rans.iter().filter(|ran| ran.computed == 0);
    assert!(empty.clone().count() == 5 && rans.iter().map(|ran| ran.computed).sum::<usize>() == 45);
    for ran in empty {
        assert!(ran.notes[0].ends_with("has none of the 45 points of the study"), "{ran:?}");
    }
    let none =
        Study::new("none", Points::list([("a", ""), ("b", "")], []), [("start", ""), ("end", "")], rocker);
    assert_eq!(none.with([""; 0]).unwrap_err().to_string(), "the study has no points");
    assert!(study().run(&folder, Shard::WHOLE, 1025).is_err());
}

/// A row that does not follow from its point alone gives two logs that differ about it.
#[test]
fn rows_that_differ_are_told() {
    let (folder, other) = (folder("differ"), folder("differ, other"));
    let study =
        |row: fn([f64; 2]) -> Result<[f64; 1], &'static str>| Study::new("x", four_bars(), [("x", "")], row);
    study(|_| Ok([1.0])).run(&folder, Shard::parse("1/3").unwrap(), 1).unwrap();
    study(|_| Ok([2.0])).run(&other, Shard::WHOLE, 1).unwrap();
    fs::rename(other.join("1-of-1.log"), folder.join("1-of-1.log")).unwrap();
    let told = study(|_| Ok([1.0])).gather(&folder).unwrap_err().to_string();
    assert!(
        told.contains(" has another row here than in a log before it") && told.contains("(coupler 0"),
        "{told}"
    );
}

/// A row of the study that runs tries to run the same shard: its log is open, and the status tells that.
#[test]
fn two_processes_do_not_run_the_same_shard() {
    let folder = folder("twice");
    let points = || Points::list([("a", "")], [[0.0]]);
    let inner = Study::new("x", points(), [("x", "")], |_| Ok::<_, &str>([0.0]));
    let outer = Study::new("x", points(), [("x", "")], |_| match inner.run(&folder, Shard::WHOLE, 1) {
        Err(problem) if inner.gather(&folder).unwrap().to_string().contains("0 failed, running") => {
            Err(problem)
        }
        _ => Ok([0.0]),
    });
    outer.run(&folder, Shard::WHOLE, 1).unwrap();
    let told = outer.gather(&folder).unwrap().to_string();
    assert!(told.contains("another process runs this shard") && !told.contains("running"), "{told}");
}

//! The catalogue of methods by name has every method.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Names and numbers of a catalogue.
macro_rules! rows {
    (by_error { $($a:ident ($i:literal, $c:literal, $m:ty, $t:literal, $rtol:literal, $d:literal, $w:literal))* }
     of_length { $($b:ident ($j:literal, $k:literal, $n:ty, $u:literal, $e:literal, $x:literal))* }) => {
        [$((stringify!($a), $i, $c, $t),)* $((stringify!($b), $j, $k, $u),)*]
    };
}

const ROWS: &[(&str, i32, &str, &str)] = &plm_runtime::methods!(rows);

fn sources(folder: &Path) -> Vec<PathBuf> {
    let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    paths.flat_map(|path| if path.is_dir() { sources(&path) } else { vec![path] }).collect()
}

/// The names that methods give themselves.
fn written() -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("plm-runtime/src/method");
    let mut names = BTreeSet::new();
    for source in sources(&folder) {
        let text = fs::read_to_string(source).unwrap();
        // Tableaus name theirs as an argument.
        for start in
            ["const NAME: &'static str = \"", "fn name(&self) -> &'static str {\n        \"", " name: \""]
        {
            let named = text.split(start).skip(1);
            names.extend(named.filter_map(|rest| rest.split('"').next()).map(str::to_owned));
        }
    }
    names.remove("");
    names
}

#[test]
fn every_method_is_in_the_catalogue() {
    let written = written();
    assert!(written.len() >= 9, "the reader of sources found only {written:?}");
    // Gauss has a row for each number of stages.
    let named = |name: &str| name.strip_prefix("Gauss").map_or(name, |_| "Gauss").to_owned();
    let rows: BTreeSet<String> = ROWS.iter().map(|(name, ..)| named(name)).collect();
    assert_eq!(rows, written);
}

#[test]
fn names_and_numbers_are_unique() {
    let count = ROWS.len();
    let numbers: BTreeSet<i32> = ROWS.iter().map(|row| row.1).collect();
    let names: BTreeSet<&str> = ROWS.iter().map(|row| row.0).collect();
    let constants: BTreeSet<&str> = ROWS.iter().map(|row| row.2).collect();
    assert_eq!(numbers, (0..count as i32).collect());
    assert_eq!((names.len(), constants.len()), (count, count));
    let is_of_its_name =
        |name: &str, kind: &str| name.starts_with(kind.split('<').next().unwrap_or_default());
    assert!(ROWS.iter().all(|(name, _, _, kind)| is_of_its_name(name, kind)));
}

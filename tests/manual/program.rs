//! The program as it is called, and the book beside what it writes.

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use plm::Fault;

use crate::command::sheets;
use crate::demos::sheet::Reading::Rounded;
use crate::demos::sheet::Sheet;
use crate::run;

fn called(words: &[&str]) -> Result<ExitCode, String> {
    let words: Vec<String> = words.iter().map(|&word| word.to_owned()).collect();
    run(&words).map_err(|error| error.to_string())
}

#[test]
fn sheets_are_asked_for_by_name() {
    assert_eq!(called(&["PLMCALCUL", "plmassembly"]), Ok(ExitCode::SUCCESS));
    let unknown = called(&["PLMCALCUL", "PLMPIV99"]).unwrap_err();
    assert!(unknown.starts_with("nothing is called `PLMPIV99`; there are DoublePendulum, "), "{unknown}");
}

fn shows(value: f64) -> Sheet {
    let mut sheet = Sheet::new("DEMO");
    sheet.manual("figure", value, "N", 169.91, Rounded(0.01));
    sheet
}

#[test]
fn a_figure_that_is_missed_fails_the_program() {
    let ends = |run: fn() -> Result<Sheet, Fault>| sheets(&[("DEMO", run)], &[]).unwrap();
    assert_eq!(ends(|| Ok(shows(169.914))), ExitCode::SUCCESS);
    assert_eq!(ends(|| Ok(shows(169.93))), ExitCode::FAILURE);
    assert_eq!(ends(|| Ok(Sheet::new("DEMO"))), ExitCode::FAILURE);
}

/// Curves and text. Pictures of pages are compared by the browser's tests, which look here for what is written.
#[test]
fn the_book_shows_what_the_program_writes() {
    let made = super::made("gallery");
    if made.exists() {
        fs::remove_dir_all(&made).unwrap();
    }
    assert_eq!(called(&["--gallery", made.to_str().unwrap()]), Ok(ExitCode::SUCCESS));
    let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/src");
    let is_shown = |made: &Path, shown: &Path| {
        let same = fs::read(made).unwrap() == fs::read(shown).unwrap_or_default();
        assert!(same, "{} is out of date: `bash docs/gallery.sh manual` makes it", shown.display());
    };
    is_shown(&made.join("gallery.md"), &book.join("gallery.md"));
    let files = fs::read_dir(&made).unwrap().map(|entry| entry.unwrap().path());
    let curves: Vec<_> =
        files.filter(|file| file.extension().is_some_and(|extension| extension == "svg")).collect();
    assert!(!curves.is_empty());
    for curve in &curves {
        is_shown(curve, &book.join("images/manual").join(curve.file_name().unwrap()));
    }
}

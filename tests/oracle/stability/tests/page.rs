//! What the program `stability` takes for right, and how it ends.

use plm_runtime::{Cause, Fault};

use crate::figures::{Page, Row};

#[test]
fn an_error_holds_below_its_bound_and_nowhere_else() {
    for (found, holds) in [(0.0, true), (0.99e-3, true), (1e-3, false), (5e-3, false), (f64::NAN, false)] {
        assert_eq!(Row::below("error", 1e-3, " m", found).holds, holds, "{found}");
    }
    assert!(Row::end("run", &Ok(())).holds);
    assert!(!Row::end("run", &Err(Fault::of_part(1.0, "hinge", Cause::Locked))).holds);
}

#[test]
fn the_program_fails_if_one_line_is_missed() {
    let mut page = Page::default();
    let table =
        page.add("first", &[Row::below("energy", 1e-3, " J", 1e-4), Row::new("count", "3", "3", true)]);
    assert_eq!(
        table,
        "| | known | found |\n|---|---|---|\n| energy | < 1.0e-3 J | 1.0e-4 J |\n| count | 3 | 3 |\n"
    );
    assert_eq!(page.outcome(), Ok(()));
    let table = page.add("second", &[Row::new("count", "3", "4", false), Row::new("end", "b", "b", true)]);
    assert!(table.contains("| count | 3 | 4 **missed** |"), "{table}");
    assert_eq!(page.outcome(), Err("second: count: 4 instead of 3".to_owned()));
    // What is right after it makes nothing good.
    page.add("third", &[Row::new("end", "c", "c", true)]);
    assert!(page.outcome().is_err());
    assert!(
        page.text.contains("<!-- ANCHOR: third -->\n") && page.text.contains("**missed**"),
        "{}",
        page.text
    );
}

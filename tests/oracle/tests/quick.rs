//! The first cases of each sweep.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "tests")]

use plm_oracle::{SWEEPS, Table};

/// The seed of the cases that the tests run.
const SEED: u64 = 31;

/// A test for each sweep, by its name: none of its quick cases is wrong.
macro_rules! quick {
    ($($name:ident)*) => {
        $(
            #[test]
            fn $name() {
                let sweep = SWEEPS.iter().find(|sweep| sweep.name == stringify!($name)).expect("a sweep");
                let table = Table::of(sweep, SEED, 0..sweep.quick);
                assert!(table.holds(), "{}", table.shown(false));
            }
        )*

        const TESTED: &[&str] = &[$(stringify!($name)),*];
    };
}

quick! { bounded driven gradients late locks hostile bounds resets geared pages wheels declarations sources }

#[test]
fn each_sweep_is_tested() {
    let names: Vec<_> = SWEEPS.iter().map(|sweep| sweep.name).collect();
    assert_eq!(names, TESTED);
}

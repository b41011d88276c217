//! What the manual's PLMASSEMBLY says of its over-constrained pendulum (section 4.4), where the run has to say it.
//!
//! Where everything is a literal rustc says it: `tests/ui/assembly/too_many_locks.rs`.

use crate::demos::plmassembly::Plmassembly;

const MESSAGE: &str = "t = 0 s: 2 redundant position constraints: \
                       bob.x (locked), bob.y (locked), bob.angle (locked), tied by pivot";

#[test]
fn locks_of_the_declaration_are_named() {
    assert_eq!(Plmassembly::new().assemble().unwrap_err().to_string(), MESSAGE);
    let longer = Plmassembly { reach: 0.7, ..Plmassembly::new() };
    assert_eq!(longer.start().err().unwrap().to_string(), MESSAGE);
}

#[test]
fn locks_that_are_set_before_the_run_are_named() {
    let mut pendulum = Plmassembly::new();
    let start = &mut pendulum.start.bob;
    (start.x.locked, start.y.locked) = (false, false);
    assert!(pendulum.assemble().is_ok());
    pendulum.start.bob.x.locked = true;
    pendulum.start.bob.y = plm::Start::locked(0.2);
    assert_eq!(pendulum.assemble().unwrap_err().to_string(), MESSAGE);
}

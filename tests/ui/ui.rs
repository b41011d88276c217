//! How mistakes look: what rustc prints for declarations that are wrong.

#[test]
fn wrong_declarations_are_explained() {
    trybuild::TestCases::new().compile_fail("*/*.rs");
}

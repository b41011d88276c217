//! Lets the linker find the script for Cortex-M.

fn main() {
    println!("cargo::rerun-if-changed=cortex_m.x");
    println!("cargo::rustc-link-search={}", env!("CARGO_MANIFEST_DIR"));
}

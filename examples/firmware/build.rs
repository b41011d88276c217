//! Links the bare programs of this package and of tests/no_std without the C runtime and without any library.

use std::env;

fn main() {
    let arguments: &[&str] = match env::var("CARGO_CFG_TARGET_ARCH").as_deref() {
        Ok("x86_64") => &["-nostartfiles", "-nostdlib", "-static", "-no-pie", "-Wl,--gc-sections"],
        // The machine's script lies in the search path that its build script gives.
        Ok("arm") => &["-Tcortex_m.x", "--gc-sections"],
        Ok("wasm32") => &["--no-entry", "--export=program"],
        _ => &[],
    };
    for argument in arguments {
        println!("cargo::rustc-link-arg-bin=bare={argument}");
    }
}

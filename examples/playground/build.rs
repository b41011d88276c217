//! Room for what the larger mechanisms keep on the stack, since linkers give a module of WebAssembly 1 MiB; and a table to which functions
//! are added while it runs.
fn main() {
    if std::env::var("CARGO_CFG_TARGET_ARCH").is_ok_and(|arch| arch == "wasm32") {
        for argument in ["-zstack-size=16777216", "--export-table", "--growable-table"] {
            println!("cargo::rustc-link-arg-cdylib={argument}");
        }
    }
}

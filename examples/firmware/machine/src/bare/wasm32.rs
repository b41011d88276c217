//! WebAssembly: who instantiates the module prints for it and calls [`start`]. A panic that can be reached would be an
//! import that nobody gives, and the module would not be instantiated.

#[link(wasm_import_module = "machine")]
unsafe extern "C" {
    fn write(text: *const u8, length: usize);
    fn end(code: i32) -> !;
}

/// Writes to the standard output.
pub fn print(text: &[u8]) {
    // SAFETY: the host reads the bytes before it returns.
    unsafe { write(text.as_ptr(), text.len()) }
}

/// Ends the program.
pub fn exit(code: i32) -> ! {
    // SAFETY: the host throws.
    unsafe { end(code) }
}

//! The program `plm`.

use std::process::ExitCode;

/// The exit code of what Ctrl+C ends at once, as of a shell.
const INTERRUPTED: i32 = 130;

fn main() -> ExitCode {
    // Without it Ctrl+C ends the program at once.
    let _ = ctrlc::set_handler(|| {
        if !plm_cli::interrupt() {
            std::process::exit(INTERRUPTED);
        }
    });
    // Not locked: the language server reads and writes them in threads of its own.
    let (mut input, mut output, mut errors) = (std::io::stdin(), std::io::stdout(), std::io::stderr());
    let mut streams = plm_cli::Streams { input: &mut input, output: &mut output, errors: &mut errors };
    plm_cli::run(std::env::args_os().skip(1), &mut streams).into()
}

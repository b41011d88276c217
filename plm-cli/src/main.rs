//! The program `plm`.

use std::process::ExitCode;

fn main() -> ExitCode {
    // Not locked: the language server reads and writes them in threads of its own.
    let (mut input, mut output, mut errors) = (std::io::stdin(), std::io::stdout(), std::io::stderr());
    let mut streams = plm_cli::Streams { input: &mut input, output: &mut output, errors: &mut errors };
    plm_cli::run(std::env::args_os().skip(1), &mut streams).into()
}

//! The program `plm`.

use std::process::ExitCode;

/// The exit code of what Ctrl+C ends at once, as of a shell.
const INTERRUPTED: i32 = 130;
/// Stack of the thread that works, bytes: runs of the largest mechanisms with contact keep several MB there, more than the first thread of a
/// program has on Windows.
const STACK: usize = 64 << 20;

/// Counts what is allocated, so that a call of `plm mcp` has a limit: beyond it Rust ends the process.
#[cfg(feature = "mcp")]
#[global_allocator]
static ALLOCATOR: cap::Cap<std::alloc::System> = cap::Cap::new(std::alloc::System, usize::MAX);

fn main() -> ExitCode {
    #[cfg(feature = "mcp")]
    if let Some(limit) = plm_cli::memory_limit()
        && ALLOCATOR.set_limit(limit).is_err()
    {
        eprintln!(
            "plm: the limit of memory is less than what it takes to begin: memory allocation of more failed"
        );
        return ExitCode::from(2);
    }
    // Without it Ctrl+C ends the program at once.
    let _ = ctrlc::set_handler(|| {
        if !plm_cli::interrupt() {
            std::process::exit(INTERRUPTED);
        }
    });
    match std::thread::Builder::new().stack_size(STACK).spawn(work) {
        Ok(working) => working.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
        Err(_) => work(),
    }
}

fn work() -> ExitCode {
    // Not locked: the language server reads and writes them in threads of its own.
    let (mut input, mut output, mut errors) = (std::io::stdin(), std::io::stdout(), std::io::stderr());
    let mut streams = plm_cli::Streams { input: &mut input, output: &mut output, errors: &mut errors };
    plm_cli::run(std::env::args_os().skip(1), &mut streams).into()
}

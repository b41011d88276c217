//! The steps of `run.mjs` in an ordinary program: what it prints is what node must print. `twin --declaration FILE.rs` prints the first
//! declaration of a file of Rust, for both.

use plm_playground::Session;

/// A line of the bits of numbers.
fn line(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!("{:x}", number.to_bits())).collect::<Vec<_>>().join(" ")
}

fn main() {
    let mut files: Vec<String> = std::env::args().skip(1).collect();
    if files.first().is_some_and(|first| first == "--declaration") {
        for file in files.drain(..).skip(1) {
            let text = std::fs::read_to_string(&file).unwrap_or_default();
            print!("{}", plm_cli::declarations(&file, &text).first().map_or("", |first| first));
        }
    }
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap_or_default();
        let mut session = Session::default();
        if !session.compile(&text) {
            println!("{}", session.message());
            continue;
        }
        println!("{} {}", file.rsplit('/').next().unwrap_or_default(), session.results().len());
        println!("{}", line(session.shape()));
        for k in 0..100 {
            if k == 50 {
                session.pull(0, [0.1, 0.2], [1.0, -2.0]);
            }
            let done = session.step(0.01);
            println!("{done} {}", line(session.read()));
        }
        println!("{}", session.trouble());
    }
}

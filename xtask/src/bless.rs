//! Expected texts anew. The difference is read as part of the change.

use crate::Result;
use crate::place::Place;

struct Text {
    name: &'static str,
    /// Description of the expected texts that are written.
    what: &'static str,
    /// Does `cargo test` compare it, with nothing but Rust?
    is_compared: bool,
    /// A variable and its value, if it takes one, and the command.
    variable: Option<(&'static str, &'static str)>,
    command: &'static str,
}

const BLESS: Option<(&str, &str)> = Some(("PLM_BLESS", "1"));

const TEXTS: [Text; 16] = [
    Text {
        name: "ui",
        what: "what rustc prints for wrong declarations: tests/ui/**/*.stderr",
        is_compared: true,
        variable: Some(("TRYBUILD", "overwrite")),
        command: "cargo test -p plm-ui",
    },
    // Before all that compiles these files.
    Text {
        name: "snapshots",
        what: "emitted code: tests/snapshots/",
        is_compared: true,
        variable: BLESS,
        command: "cargo test --test emitted",
    },
    Text {
        name: "book",
        what: "diagnostics and code that pages of the book show, its llms.txt, and colours of declarations",
        is_compared: true,
        variable: BLESS,
        command: "cargo test -p plm-compiler -p plm-cli --test book --test cli",
    },
    Text {
        name: "equations",
        what: "equations of motion in LaTeX and MathML: plm-macros/compiler/tests/written/",
        is_compared: true,
        variable: BLESS,
        command: "cargo test -p plm-compiler --features lowered --lib written",
    },
    Text {
        name: "bits",
        what: "the bits of first steps of what is emitted: tests/snapshots/bits.txt",
        is_compared: true,
        variable: BLESS,
        command: "cargo test --test bits first_steps",
    },
    Text {
        name: "figures",
        what: "the drawings of parts and demos in the book",
        is_compared: true,
        variable: None,
        command: "cargo run --example figures",
    },
    Text {
        name: "contact",
        what: "the pictures of the book's theory of contact",
        is_compared: true,
        variable: BLESS,
        command: "cargo test --test contact pictures",
    },
    Text {
        name: "architecture",
        what: "the picture of the architecture",
        is_compared: true,
        variable: None,
        command: "cargo xtask architecture",
    },
    Text {
        name: "c",
        what: "what wrong calls of C give: tests/c/bad_use.txt",
        is_compared: true,
        variable: BLESS,
        command: "cargo test --test foreign wrong_calls",
    },
    Text {
        name: "gallery",
        what: "curves and pictures of demos and machines, and their pages in the book",
        is_compared: false,
        variable: None,
        command: "bash docs/gallery.sh",
    },
    Text {
        name: "hero",
        what: "the README's moving pictures",
        is_compared: false,
        variable: None,
        command: "bash docs/hero.sh",
    },
    Text {
        name: "work-precision",
        what: "charts of accuracy against speed and their summary, of the stored runs",
        is_compared: false,
        variable: None,
        command: "cargo run -p plm-speed --bin work_precision -- --redraw docs/src/images/work-precision",
    },
    Text {
        name: "contact-peers",
        what: "picture and tables of contact beside other programs, of the stored runs",
        is_compared: false,
        variable: None,
        command: "cargo run -p plm-speed --bin contact_peers -- docs/src/images/contact-peers",
    },
    Text {
        name: "contact-steps",
        what: "picture and tables of steps of Moreau and Jean, of the stored runs",
        is_compared: false,
        variable: None,
        command: "cargo run -p plm-speed --bin contact_peers -- --steps docs/src/images/contact-steps",
    },
    Text {
        name: "machines",
        what: "the book's table of microcontrollers",
        is_compared: false,
        variable: BLESS,
        command: "bash tests/machines.sh --quick",
    },
    Text {
        name: "python",
        what: "the picture in the book's page about Python",
        is_compared: false,
        variable: None,
        command: "bash tests/python.sh --book",
    },
];

pub(crate) fn usage() -> String {
    let lines = TEXTS.iter().map(|text| format!("cargo xtask bless {:<16}{}\n", text.name, text.what));
    lines.collect::<Vec<_>>().concat()
}

/// Writes those that are named, or all that `cargo test` compares.
pub(crate) fn run(place: &Place, names: &[String]) -> Result {
    if let Some(unknown) = names.iter().find(|name| TEXTS.iter().all(|text| text.name != name.as_str())) {
        return Err(format!("`{unknown}` is no text that can be written:\n{}", usage()));
    }
    for text in &TEXTS {
        if names.iter().any(|name| name == text.name) || names.is_empty() && text.is_compared {
            println!("== {}: {}", text.name, text.command);
            let task = place.command(text.command);
            match text.variable {
                Some((variable, value)) => task.set(variable, value).run()?,
                None => task.run()?,
            }
        }
    }
    place.command("git status --short").run()
}

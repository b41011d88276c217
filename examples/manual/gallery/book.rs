//! The gallery page of the book.

use std::fmt::Write as _;

use super::{SHOWN, Shown};

const HEAD: &str = "\
# Gallery

The demos of the [manual](manual.md#demos), as the page shows them, and the manual's curves. The commands under each write its page,
one HTML file that moves; with `--live` it holds the mechanism itself, to be turned and pulled ([The page](running/page.md)).

The curves have the manual's quantities, units and final times. Pictures are what the page draws of the runs: bodies have colours, the
ground is grey. `bash docs/gallery.sh` makes all of them, and this page.
";

/// The whole page.
pub fn text() -> String {
    let mut text = HEAD.to_owned();
    for shown in SHOWN {
        section(&mut text, shown);
    }
    text
}

/// Writing into a text does not fail.
fn section(text: &mut String, shown: &Shown) {
    let Shown { demo, section, text: told, .. } = shown;
    let _ = write!(text, "\n## {demo}\n\nSection {section}. {told}\n");
    for picture in shown.pictures {
        let _ = write!(text, "\n![{0}](images/manual/{1})\n\n{0}\n", picture.caption, picture.file);
    }
    for figure in shown.figures {
        let caption = format!("Figure {}: {}", figure.number, figure.caption);
        let _ = write!(text, "\n![{caption}](images/manual/{})\n\n{caption}\n", figure.file());
    }
    let command = "cargo run --release --example manual --";
    let page = format!("{}.html", demo.to_lowercase());
    let _ =
        write!(text, "\n```sh\n{command} {demo} --view {page}\n{command} {demo} --live --view {page}\n```\n");
}

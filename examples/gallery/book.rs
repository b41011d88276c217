//! The page of the book about the machines, and the list of its moving pictures.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::list::{ARM, MACHINES, Machine};
use crate::sheet::{Line, Sheet, decimals};

const HEAD: &str = "\
# Machines

Mechanisms that people know. A picture leads to the machine: its source, a figure that is known from elsewhere and held by a test,
and the commands that run it. With `--live` the page holds the mechanism itself: parameters are sliders, and bodies can be pulled
where nothing prescribes their motion ([The page](running/page.md)). Each is one file of less than 80 lines in
`examples/gallery/machines`, to be copied; the comment on its last function has the line of a whole program. The demos of the
manual have their own [gallery](gallery.md).

";

const TAIL: &str = "
## All of them

```sh
cargo run --release --example gallery                           # the figures of all machines
cargo run --release --example gallery -- --pages pages --live   # a live page of each, into the folder pages
```

`bash docs/gallery.sh` makes the pictures and this page.
";

/// The whole page, with the sheets of the machines in their order.
pub fn text(sheets: &[Sheet]) -> String {
    let mut text = HEAD.to_owned();
    for machine in MACHINES {
        thumbnail(&mut text, machine.name, machine.title);
    }
    thumbnail(&mut text, ARM.name, ARM.title);
    for (machine, sheet) in MACHINES.iter().zip(sheets) {
        section(&mut text, machine, sheet);
    }
    let _ = write!(text, "\n<a id=\"{}\"></a>\n\n## {}\n\n{}\n", ARM.name, ARM.title, ARM.text);
    commands(&mut text, "manual", ARM.demo, ARM.name);
    text + TAIL
}

/// Light or dark, as the reader has it. Writing into a text does not fail.
fn thumbnail(text: &mut String, name: &str, title: &str) {
    let _ = writeln!(
        text,
        "<span style=\"display:inline-block;text-align:center;vertical-align:top\"><a href=\"#{name}\"><picture>\
         <source media=\"(prefers-color-scheme: dark)\" srcset=\"images/machines/{name}-dark.webp\">\
         <img src=\"images/machines/{name}.webp\" width=\"240\" height=\"150\" alt=\"{title}, moving\"></picture><br>{title}</a></span>"
    );
}

fn section(text: &mut String, machine: &Machine, sheet: &Sheet) {
    let Machine { name, title, source, text: told, .. } = machine;
    let _ = write!(text, "\n<a id=\"{name}\"></a>\n\n## {title}\n\n{told}\n\nSource: {source}.\n\n");
    let _ = writeln!(text, "| held by a test | known value | to |\n|---|---|---|");
    for line in &sheet.lines {
        let Line { name, unit, known, .. } = line;
        let unit = if *unit == "-" { String::new() } else { format!(" {unit}") };
        let digits = decimals(line.tolerance());
        let known = if *known == 0.0 { "0".to_owned() } else { format!("{known:.digits$}") };
        let _ = writeln!(text, "| {name} | {known}{unit} | {:e}{unit} |", line.tolerance());
    }
    commands(text, "gallery", name, name);
}

fn commands(text: &mut String, example: &str, machine: &str, name: &str) {
    let command = format!("cargo run --release --example {example} -- {machine}");
    let _ = write!(
        text,
        "\n```sh\n{command} --view {name}.html          # a page of a run\n\
         {command} --live --view {name}.html   # with the mechanism itself\n```\n"
    );
}

/// Writes the page, and the list of pictures that are to be made of the pages of the machines.
///
/// # Errors
/// A fault of a machine, a file that cannot be written.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let sheets = MACHINES.iter().map(|machine| (machine.sheet)()).collect::<Result<Vec<_>, _>>()?;
    fs::write(folder.join("machines.md"), text(&sheets))?;
    let arm =
        Pictured { page: format!("{}.html", ARM.name), name: ARM.name, paths: ARM.paths, loops: ARM.loops };
    let all = MACHINES.iter().map(|machine| {
        let Machine { name, paths, loops, .. } = *machine;
        Pictured { page: machine.page(), name, paths, loops }
    });
    let pictures: Vec<Value> = all.chain([arm]).flat_map(|pictured| pictured.entries()).collect();
    fs::write(folder.join("pictures.json"), serde_json::to_string_pretty(&pictures)?)?;
    println!("written: {}", folder.display());
    Ok(())
}

struct Pictured {
    page: String,
    name: &'static str,
    paths: &'static str,
    loops: [f64; 2],
}

impl Pictured {
    /// Both pictures of it. A long motion has more frames.
    fn entries(&self) -> [Value; 2] {
        let [from, period] = self.loops;
        let frames = if period > 5.0 { 50 } else { 40 };
        [("light", ""), ("dark", "-dark")].map(|(scheme, suffix)| {
            json!({
                "page": self.page,
                "file": format!("{}{suffix}.webp", self.name),
                "moving": {
                    "width": "280", "height": "176", "frames": frames.to_string(), "fps": "16", "scheme": scheme,
                    "from": from.to_string(), "period": period.to_string(), "paths": self.paths,
                },
            })
        })
    }
}

//! The book says what the compiler does.
//!
//! Every block of a page that is fenced as `plm` is compiled. After the word stand, with commas between, how to read it
//! and what it must give:
//!
//! | fence | the block is |
//! |---|---|
//! | `plm` | a declaration that compiles without a word |
//! | `plm,items` | items of the mechanism [`EXAMPLE`], with which it compiles without a word, but that nothing reads a name |
//! | `plm,E0301` | a declaration that gives this code, and no other |
//!
//! What a program of the chapter `questions` prints, in a `console` block, stands in that program as an assertion.
//!
//! The `text` block right after one with codes is what the compiler says, the block `text,reactions` is that function of
//! the manual's double pendulum; `PLM_BLESS=1` writes both anew.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use plm_compiler::compile;
use plm_compiler::diag::Code;
use plm_compiler::token::Sources;
use plm_compiler::units;

#[path = "book/highlighting.rs"]
mod highlighting;
#[path = "book/llms.rs"]
mod llms;
#[path = "book/parts.rs"]
mod parts;

/// The mechanism that fragments stand in: a chain of two bars. `docs/src/language/declaration.md` shows it.
const EXAMPLE: &str = "
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; port p: (1, 0) m; }
    body arm {
        mass: 1 kg;
        inertia: 0.1 kg*m^2;
        port a: (-0.5, 0) m;
        port b: (0.5, 0) m;
        start angle: 45 deg;
    }
    body rod {
        mass: 1 kg;
        inertia: 0.1 kg*m^2;
        port a: (-0.5, 0) m;
        port b: (0.5, 0) m;
    }
    revolute shoulder(ground.o, arm.a);
    revolute elbow(arm.b, rod.a);
";

fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src")
}

/// All pages, in the order of their paths.
fn pages() -> Vec<PathBuf> {
    let (mut pages, mut folders) = (Vec::new(), vec![book()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                pages.push(path);
            }
        }
    }
    pages.sort();
    pages
}

/// A file is what is made of the compiler's tables; `PLM_BLESS=1` writes it anew.
fn same(path: &Path, made: &str) {
    if std::env::var_os("PLM_BLESS").is_some() {
        fs::write(path, made).unwrap();
    }
    let shown = fs::read_to_string(path).unwrap_or_default().replace("\r\n", "\n");
    assert!(shown == made, "{} is not what the tables give: run `cargo xtask bless book`", path.display());
}

/// A fenced block: lines from `first` to before `end`, without the fences.
struct Block<'a> {
    words: Vec<&'a str>,
    first: usize,
    end: usize,
}

impl<'a> Block<'a> {
    fn text(&self, lines: &[&str]) -> String {
        lines[self.first..self.end].iter().flat_map(|line| [*line, "\n"]).collect()
    }

    fn codes(&self) -> BTreeSet<&'a str> {
        self.words.iter().copied().filter(|word| Code::ALL.iter().any(|code| code.id() == *word)).collect()
    }
}

fn blocks<'a>(lines: &[&'a str]) -> Vec<Block<'a>> {
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    for (number, line) in lines.iter().enumerate() {
        let Some(words) = line.trim_start().strip_prefix("```") else { continue };
        match open.take() {
            Some(block) => blocks.push(Block { end: number, ..block }),
            None => open = Some(Block { words: words.split(',').collect(), first: number + 1, end: 0 }),
        }
    }
    blocks
}

/// What the compiler says to a declaration: its codes and its words.
fn answer(text: &str) -> (BTreeSet<&'static str>, String) {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let expansion = compile(&mut sources);
    let said = expansion.diagnostics.sorted();
    let words: Vec<String> = said.iter().map(|diagnostic| diagnostic.render(&sources)).collect();
    (said.iter().map(|diagnostic| diagnostic.code.id()).collect(), words.join("\n"))
}

#[test]
fn every_declaration_of_the_book_gives_what_it_says() {
    let bless = std::env::var_os("PLM_BLESS").is_some();
    let (mut wrong, mut checked) = (String::new(), 0);
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let blocks = blocks(&lines);
        let mut blessed: Vec<String> = lines.iter().map(ToString::to_string).collect();
        for (k, block) in blocks.iter().enumerate().rev().filter(|(_, block)| block.words[0] == "plm") {
            checked += 1;
            let place = format!("{}:{}", page.display(), block.first);
            let text = block.text(&lines);
            let is_fragment = block.words.contains(&"items");
            let (codes, words) = answer(&if is_fragment {
                format!("pub Example {{ allow(W0007);\n{text}{EXAMPLE}}}")
            } else {
                text
            });
            if codes != block.codes() {
                let _ = writeln!(wrong, "{place}: gives {codes:?}\n{words}");
            }
            let after = blocks.get(k + 1).filter(|next| {
                next.words[0] == "text"
                    && lines[block.end + 1..next.first - 1].iter().all(|line| line.is_empty())
            });
            let Some(after) = after.filter(|_| !block.codes().is_empty()) else { continue };
            if bless {
                blessed.splice(after.first..after.end, words.lines().map(ToString::to_string));
            } else if after.text(&lines).trim_end() != words.trim_end() {
                let _ = writeln!(wrong, "{place}: says\n{words}");
            }
        }
        if bless {
            fs::write(&page, blessed.join("\n") + "\n").unwrap();
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(checked > 80, "only {checked} blocks were found");
}

#[test]
fn programs_assert_the_answers_that_pages_show() {
    let mut checked = 0;
    for page in pages().iter().filter(|page| page.parent().unwrap().ends_with("questions")) {
        let text = fs::read_to_string(page).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        let blocks = blocks(&lines);
        let of = |word| blocks.iter().filter(move |block| block.words[0] == word);
        let programs: String = of("rust").map(|block| block.text(&lines)).collect();
        for answer in of("console").flat_map(|block| &lines[block.first..block.end]) {
            if !answer.starts_with("$ ") {
                let asserted = format!("assert_eq!(answer, {answer:?});");
                assert!(programs.contains(&asserted), "{}: no program has {asserted}", page.display());
                checked += 1;
            }
        }
    }
    assert!(checked >= 6, "only {checked} answers were found");
}

#[test]
fn every_diagnostic_is_shown_on_its_page() {
    for code in Code::ALL {
        let page = book().join(format!("diagnostics/{code}.md"));
        let text = fs::read_to_string(&page).unwrap_or_else(|_| panic!("no page {}", page.display()));
        let heading = format!("# {code}: {}\n", code.title());
        assert!(text.starts_with(&heading), "{}: the heading is not {heading:?}", page.display());
        let lines: Vec<&str> = text.lines().collect();
        let blocks = blocks(&lines);
        // What the compiler cannot give says so in words, and has no example.
        if blocks.iter().any(|block| block.words[0] == "plm") {
            assert!(blocks.iter().any(|block| block.codes().contains(code.id())), "{}", page.display());
        }
    }
}

/// What stands in code in the first cells of tables.
fn first_cells(markdown: &str) -> BTreeSet<&str> {
    let rows = markdown.lines().filter_map(|line| line.strip_prefix("| `")?.split_once('`'));
    rows.map(|(name, _)| name).collect()
}

#[test]
fn the_grammar_is_the_parsers() {
    let syntax = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/syntax");
    for (source, page) in [("mod.rs", "declaration.md"), ("expr.rs", "expressions.md")] {
        let source = fs::read_to_string(syntax.join(source)).unwrap();
        let page = fs::read_to_string(book().join("language").join(page)).unwrap();
        let docs: String = source
            .lines()
            .map_while(|line| line.strip_prefix("//!"))
            .map(|line| [line, "\n"].concat())
            .collect();
        let rules: Vec<&str> = docs.split("```").nth(1).unwrap().lines().skip(1).map(str::trim).collect();
        assert!(rules.len() > 5, "{rules:?}");
        for rule in rules {
            assert!(page.contains(rule), "{rule}");
        }
    }
}

#[test]
fn the_table_of_units_is_the_compilers() {
    let text = fs::read_to_string(book().join("language/units.md")).unwrap();
    let table = text.split("\n## ").next().unwrap();
    let known: BTreeSet<&str> = units::names().collect();
    assert_eq!(first_cells(table), known);
}

/// The source that is emitted for the manual's double pendulum.
fn double_pendulum() -> String {
    let mut sources = Sources::new();
    sources.add_text("double_pendulum.plm", include_str!("../examples/double_pendulum.plm"));
    compile(&mut sources).code.unwrap().text()
}

#[test]
fn the_generated_code_is_as_shown() {
    let page = book().join("generated-code.md");
    let (code, text) = (double_pendulum(), fs::read_to_string(&page).unwrap());
    for cell in first_cells(&text) {
        assert!(code.contains(cell), "{cell}");
    }
    let lines: Vec<&str> = text.lines().collect();
    for block in blocks(&lines).iter().filter(|block| block.words.len() == 2) {
        let start = code.find(&format!("            fn {}(", block.words[1])).unwrap();
        let end = start + code[start..].find("\n            }\n").unwrap() + "\n            }".len();
        let function: Vec<&str> = code[start..end].lines().map(|line| line.get(12..).unwrap_or("")).collect();
        if std::env::var_os("PLM_BLESS").is_some() {
            let blessed = [&lines[..block.first], &function, &lines[block.end..]].concat();
            fs::write(&page, blessed.join("\n") + "\n").unwrap();
        } else {
            assert_eq!(block.text(&lines).trim_end(), function.join("\n"));
        }
    }
}

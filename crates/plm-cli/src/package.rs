//! A package of cargo around a declaration: its program runs the mechanism, and makes C, an FMU or a wheel of it.

use std::collections::BTreeMap;

use plm_compiler::diag::Diagnostics;
use plm_compiler::syntax::ast::{ItemKind, Mechanism};
use plm_compiler::syntax::parse;
use plm_compiler::token::Sources;

/// A package: its name, and its files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Package {
    /// The name of the mechanism in small letters, `four_bar`.
    pub(crate) name: String,
    /// Texts by their paths.
    pub(crate) files: BTreeMap<String, String>,
}

/// Names that cargo refuses for a package: keywords of Rust, and `test`, which is a crate of its own.
const REFUSED: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop",
    "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static",
    "struct", "super", "test", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use",
    "virtual", "where", "while", "yield",
];

impl Package {
    /// The package of a declaration, whose text is `text` and has been read into `sources`; `plm` says in TOML where cargo finds the
    /// crate `plm-planar`.
    ///
    /// # Errors
    /// The text has no mechanism, or one with a parameter without a default; a file that it names cannot be read.
    pub(crate) fn new(text: &str, sources: &Sources, plm: &str) -> Result<Package, String> {
        let declaration = sources.get(0).map(|source| parse(source, &mut Diagnostics::new()));
        let mechanism = declaration.and_then(|declaration| declaration.mechanism);
        let mechanism = mechanism.ok_or("no mechanism is declared")?;
        if let Some(parameter) = without_default(&mechanism) {
            return Err(format!(
                "the parameter `{parameter}` has no default: a program needs a value, as in `param {parameter}: m = 1 m;`"
            ));
        }
        let name = package_name(&mechanism.name.text);
        let mut files = BTreeMap::new();
        for (file, content) in sources.files() {
            let content = content.clone().map_err(|why| format!("{file}: {why}"))?;
            files.insert(file.clone(), content);
        }
        files.insert("Cargo.toml".to_owned(), manifest(&name, plm));
        files.insert("src/main.rs".to_owned(), program(&mechanism.name.text, text));
        Ok(Package { name, files })
    }
}

/// The version of plm as a line of a manifest, for [`Package::new`].
pub(crate) fn version() -> String {
    format!("version = {:?}", env!("CARGO_PKG_VERSION"))
}

fn without_default(mechanism: &Mechanism) -> Option<&str> {
    mechanism.items.iter().find_map(|item| match &item.kind {
        ItemKind::Param(param) if param.value.is_none() && param.optional.is_none() => {
            Some(param.name.ident.text.as_str())
        }
        _ => None,
    })
}

/// `FourBar` as cargo names packages: `four_bar`.
fn package_name(mechanism: &str) -> String {
    let mut name = String::new();
    let mut was_small = false;
    for letter in mechanism.chars() {
        if was_small && letter.is_ascii_uppercase() {
            name.push('_');
        }
        was_small = letter.is_ascii_lowercase() || letter.is_ascii_digit();
        name.push(letter.to_ascii_lowercase());
    }
    if REFUSED.contains(&name.as_str()) { name + "_mechanism" } else { name }
}

fn manifest(name: &str, plm: &str) -> String {
    format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n\
         [dependencies]\nplm = {{ package = \"plm-planar\", {plm}, features = [\"view\"] }}\n\n\
         # It stands by itself, whatever folder it is in.\n[workspace]\n"
    )
}

/// The program: the declaration as it was written, and a `main` with the options of all such programs.
fn program(mechanism: &str, text: &str) -> String {
    let line = |line: &str| if line.is_empty() { "\n".to_owned() } else { format!("    {line}\n") };
    let declaration: String = text.trim_matches('\n').lines().map(line).collect();
    format!(
        "plm::mechanism! {{\n{declaration}}}\n\n\
         /// `cargo run -- --help` lists what it can do.\n\
         fn main() -> std::process::ExitCode {{\n    plm::view::Program::new({mechanism}::new()).main()\n}}\n"
    )
}

#[cfg(test)]
mod tests {
    use plm_compiler::token::Sources;

    use super::{Package, package_name, version};

    fn package(text: &str) -> Result<Package, String> {
        let mut sources = Sources::new();
        sources.add_text("a.plm", text);
        Package::new(text, &sources, &version())
    }

    #[test]
    fn a_package_has_the_name_of_its_mechanism() {
        for (mechanism, name) in
            [("FourBar", "four_bar"), ("S5", "s5"), ("R2Arm", "r2_arm"), ("Loop", "loop_mechanism")]
        {
            assert_eq!(package_name(mechanism), name);
        }
    }

    #[test]
    fn the_text_stands_in_the_program_as_it_is() {
        let made = package("/// A bar.\npub Bar {\n\n    gravity: 0;\n}\n");
        let main = made.as_ref().ok().and_then(|made| made.files.get("src/main.rs"));
        let inside = "plm::mechanism! {\n    /// A bar.\n    pub Bar {\n\n        gravity: 0;\n    }\n}\n";
        assert!(
            main.is_some_and(|main| main.starts_with(inside) && main.contains("(Bar::new())")),
            "{made:?}"
        );
    }

    #[test]
    fn a_program_needs_a_mechanism_and_its_values() {
        assert_eq!(package("part a() { }"), Err("no mechanism is declared".to_owned()));
        let missing = package("pub A { param l: m; param k: m = 1 m; }");
        assert!(missing.is_err_and(|why| why.starts_with("the parameter `l` has no default")));
    }
}

//! A wheel of a mechanism for Python: what of it is text; cargo and maturin do the rest.
//!
//! Only `native.rs.txt` knows pyo3. The package that maturin builds compiles it, this crate never does.

mod maturin;
mod python;

use std::error::Error;
use std::path::{Path, PathBuf};

use plm_foreign::{Foreign, Names};
use plm_view::package::{self, Output, Package, renew};

use self::python::is_keyword;

/// Base class of all mechanisms, in Python.
const MECHANISM: &str = include_str!("../../python/plm/_mechanism.py");
/// Types of values and faults.
const VALUES: &str = include_str!("../../python/plm/_values.py");
/// Checks of callers' numbers.
const CHECKS: &str = include_str!("../../python/plm/_checks.py");
/// Saved moments.
const SAVED: &str = include_str!("../../python/plm/_saved.py");
/// Tables of notebooks, and curves.
const SHOW: &str = include_str!("../../python/plm/_show.py");
/// The way from there to Rust, for runs of a type `Own`.
const NATIVE: &str = include_str!("native.rs.txt");
/// Runs of a compiled mechanism called `NAME` in the package `PREFIX`.
const COMPILED: &str = include_str!("compiled.rs.txt");

/// Writes a wheel of a mechanism, for Python 3.9 and later on machines such as this one, into a folder, and a source distribution,
/// which pip builds on others; gives both files.
///
/// maturin builds them in `target/plm/packages`. They have the mechanism as declared: what was set in this one is not in it, nor
/// is any path of this machine. Their version is that of the package that cargo runs.
///
/// # Errors
/// maturin or cargo is not there or fails, with what it says; a file cannot be written.
pub fn wheel<M: Foreign>(mechanism: &M, folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let name = package_name(M::TABLES.name);
    let file = |file: &str, text: String| (format!("python/{name}/{file}"), text);
    let texts = [
        ("pyproject.toml".to_string(), project(&name, M::TABLES.docs)),
        file("__init__.py", python::source(mechanism)),
        file("__init__.pyi", python::stub(mechanism)),
        file("_mechanism.py", MECHANISM.to_string()),
        file("_values.py", VALUES.to_string()),
        file("_checks.py", CHECKS.to_string()),
        file("_saved.py", SAVED.to_string()),
        file("_show.py", SHOW.to_string()),
        file("py.typed", String::new()),
    ];
    let source = native::<M>(&name);
    let plm = &package::plm();
    let features = &["analysis", "foreign"];
    let package = Package {
        name: &name,
        output: Output::Extension,
        source: &source,
        files: M::FILES,
        plm,
        features,
        bare: None,
    };
    let [built, copied] =
        ["python", "source"].map(|kind| Path::new("target/plm/packages").join(format!("{name}-{kind}")));
    let wheel = maturin::wheel(&package, &built, &texts)?;
    let source = maturin::source_distribution(&package, &copied, &built, &texts)?;
    let mut files = Vec::new();
    for (name, bytes) in [wheel, source] {
        let file = folder.join(name);
        renew(&file, &bytes)?;
        files.push(file);
    }
    Ok(files)
}

/// Modules that Python has or this one needs (`sys.stdlib_module_names` of 3.10 to 3.13).
const TAKEN: &str = include_str!("taken.txt");

/// `double_pendulum`; `platform_mechanism` where Python would not import it.
fn package_name(name: &str) -> String {
    let lower = Names::lower(name).to_string();
    let is_taken = is_keyword(&lower) || TAKEN.split_whitespace().any(|taken| taken == lower);
    if is_taken { format!("{lower}_mechanism") } else { lower }
}

/// Text of `pyproject.toml`, which maturin and pip read.
fn project(name: &str, docs: &str) -> String {
    let about: String = docs.lines().next().unwrap_or_default().trim().replace(['"', '\\'], "'");
    format!(
        "[build-system]\nrequires = [\"maturin>=1.9.4,<2\"]\nbuild-backend = \"maturin\"\n\n\
         [project]\nname = \"{name}\"\ndescription = \"{about}\"\nrequires-python = \">=3.9\"\n\
         dependencies = [\"numpy>=1.21\"]\ndynamic = [\"version\"]\n\n\
         [tool.maturin]\npython-source = \"python\"\nmodule-name = \"{name}._native\"\n\n\
         # Lists of what was built where, and when.\n[tool.maturin.sbom]\nrust = false\nauditwheel = false\n"
    )
}

/// The mechanism and its functions, in Rust. A parameter without default has no value until Python gives one.
fn native<M: Foreign>(package: &str) -> String {
    let without = M::TABLES.parameters.iter().filter(|parameter| parameter.default.is_none());
    let required: Vec<&str> = without.map(|_| "f64::NAN").collect();
    let text = COMPILED.replace("PREFIX", package).replace("REQUIRED", &required.join(", "));
    let text = text.replace("NAME", M::TABLES.name);
    format!("plm::mechanism! {{\n{}\n}}\n{text}\n{NATIVE}", M::DECLARATION)
}

#[cfg(test)]
mod tests {
    use super::package_name;

    #[test]
    fn packages_can_be_imported() {
        for (name, package) in [
            ("DoublePendulum", "double_pendulum"),
            ("Lambda", "lambda_mechanism"),
            ("Platform", "platform_mechanism"),
            ("Platforms", "platforms"),
        ] {
            assert_eq!(package_name(name), package);
        }
    }
}

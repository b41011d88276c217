//! A static library of several mechanisms for C and C++, built by cargo.

use std::boxed::Box;
use std::error::Error;
use std::fmt;
use std::format;
use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;

use plm_foreign::{Foreign, Names, header, source};
use plm_view::package::{Output, Package, renew};

use super::foreign::{complete, declared};

/// A static library that is made of mechanisms, each with a header and functions of its own.
///
/// ```no_run
/// plm::mechanism! {
///     Bar {
///         ground { port o: (0, 0) m; }
///         body bar { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (1, 0) m; }
///         revolute pin(ground.o, bar.a);
///     }
/// }
/// plm::mechanism! {
///     Slider {
///         ground { port o: (0, 0) m; }
///         body slider { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; }
///         prismatic rail(ground.o, slider.a);
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let library = plm::view::Library::new("machines").with(&Bar::new())?.with(&Slider::new())?;
/// library.write("c".as_ref())?; // c/libmachines.a, c/bar.h, c/slider.h
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Library {
    name: String,
    target: Option<String>,
    /// Prefixes of the mechanisms, and their headers.
    headers: Vec<(String, String)>,
    source: String,
    files: Vec<(&'static str, &'static str)>,
}

/// Two mechanisms, or two of their files, have one name.
#[derive(Clone, PartialEq, Eq)]
struct SameName(String);

impl fmt::Debug for SameName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for SameName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the library has `{}` already: each mechanism, and each file, needs a name of its own",
            self.0
        )
    }
}

impl Error for SameName {}

impl Library {
    /// A library without mechanisms, `libmachines.a`; the name is of letters, digits and `_`.
    pub fn new(name: &str) -> Self {
        let name = Names::lower(name).to_string();
        Self { name, target: None, headers: Vec::new(), source: String::new(), files: Vec::new() }
    }

    /// For a machine without an operating system, as rustc calls it: `thumbv7em-none-eabihf`. It has no std and
    /// needs nothing beside it. Sizes in the headers are then those of this machine, which are enough.
    #[must_use]
    pub fn for_target(self, target: &str) -> Self {
        Self { target: Some(target.to_string()), ..self }
    }

    /// The same with a mechanism as declared: what was set in this one is not in it.
    ///
    /// # Errors
    /// [`NoDefault`](super::NoDefault); a mechanism of this name is in it, or has a file of the same name.
    pub fn with<M: Foreign>(mut self, mechanism: &M) -> Result<Self, Box<dyn Error>> {
        complete::<M>()?;
        let (prefix, mut text, mut code) =
            (Names::lower(M::TABLES.name).to_string(), String::new(), String::new());
        if self.headers.iter().any(|(own, _)| *own == prefix) {
            return Err(SameName(prefix).into());
        }
        for (name, path) in M::FILES {
            match self.files.iter().find(|(own, _)| own == name) {
                Some((_, own)) if own != path => return Err(SameName((*name).to_string()).into()),
                Some(_) => {}
                None => self.files.push((name, path)),
            }
        }
        header(&declared(mechanism), &mut text)?;
        source::<M>(&mut code)?;
        self.source.extend(["mod ", &prefix, "_of_c {\n", &code, "\n}\n"]);
        self.headers.push((prefix, text));
        Ok(self)
    }

    /// Writes it and its headers into a folder; gives the files. cargo builds it in `target/plm/packages`.
    ///
    /// # Errors
    /// cargo is not there or fails, with what it says; a file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
        let source =
            if self.target.is_some() { format!("{ALONE}{}", self.source) } else { self.source.clone() };
        let package = Package {
            name: &self.name,
            output: Output::Static,
            source: &source,
            files: &self.files,
            plm: Path::new(core::env!("CARGO_MANIFEST_DIR")),
            features: &["foreign"],
            bare: self.target.as_deref(),
        };
        let kind = self.target.as_deref().map_or("c".to_string(), |target| format!("c-{target}"));
        let built = package.build(&Path::new("target/plm/packages").join(format!("{}-{kind}", self.name)))?;
        let is_msvc = self.target.is_none() && cfg!(target_env = "msvc");
        let ending = if is_msvc { format!("{}.lib", self.name) } else { format!("lib{}.a", self.name) };
        let mut files = std::vec![folder.join(ending)];
        renew(&files[0], &built)?;
        for (prefix, text) in &self.headers {
            let file = folder.join(format!("{prefix}.h"));
            renew(&file, text.as_bytes())?;
            files.push(file);
        }
        Ok(files)
    }
}

/// What a library without std begins with. Nothing in it panics.
const ALONE: &str = "#![no_std]\n
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}\n
";

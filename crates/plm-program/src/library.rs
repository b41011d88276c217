//! A static library of several mechanisms for C and C++, built by cargo.

use std::env;
use std::error::Error;
use std::fmt;
use std::path::{Path, PathBuf};

use plm_foreign::{By, Entry, Foreign, Names, cpp_header, declared, header, source};
use plm_view::package::{self, Linkage, Output, Package, renew};

use super::foreign::complete;
use super::linking::Linking;

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
/// library.write("c".as_ref())?; // c/libmachines.a, c/bar.h, c/slider.h, and more
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Library {
    name: String,
    target: Option<String>,
    linkage: Linkage,
    prefix: String,
    methods: Vec<By>,
    entries: Vec<Written>,
    source: String,
    files: Vec<(&'static str, &'static str)>,
}

/// A mechanism of a library.
#[derive(Clone, Debug)]
struct Written {
    /// Prefix of its functions.
    name: String,
    /// Names and texts.
    headers: [(String, String); 2],
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

/// The methods of a library where nothing else is said.
const USUAL: [By; 1] = [By::Dop853];

impl Library {
    /// A library without mechanisms, `libmachines.a`; the name is of letters, digits and `_`.
    pub fn new(name: &str) -> Self {
        Self {
            name: Names::lower(name).to_string(),
            target: None,
            linkage: Linkage::Static,
            prefix: String::new(),
            methods: USUAL.to_vec(),
            entries: Vec::new(),
            source: String::new(),
            files: Vec::new(),
        }
    }

    /// For a machine without an operating system, as rustc calls it: `thumbv7em-none-eabihf`. It has no std and
    /// needs nothing beside it. Sizes in the headers are then those of this machine, which are enough.
    #[must_use]
    pub fn for_target(self, target: &str) -> Self {
        Self { target: Some(target.to_string()), ..self }
    }

    /// A shared library of this machine, `libmachines.so`, in place of a static one.
    #[must_use]
    pub fn shared(self) -> Self {
        Self { linkage: Linkage::Shared, ..self }
    }

    /// Names of mechanisms that are added from now on begin with this prefix: `acme_press_step`. So two suppliers may both have a mechanism
    /// `Press`, and one library can have it with two kinds of numbers.
    #[must_use]
    pub fn prefixed(self, prefix: &str) -> Self {
        Self { prefix: Names::lower(prefix).to_string(), ..self }
    }

    /// Mechanisms that are added from now on run by one of these methods, which C chooses; by the first if it does not. Each makes the
    /// library larger, and an object is as large as its largest run. Without this call the method is [`By::Dop853`] alone.
    #[must_use]
    pub fn by(self, methods: &[By]) -> Self {
        let (mut own, mut all) = (Vec::new(), methods.to_vec());
        all.extend(USUAL.iter().filter(|_| methods.is_empty()));
        for method in all {
            if !own.contains(&method) {
                own.push(method);
            }
        }
        Self { methods: own, ..self }
    }

    /// Adds a mechanism as declared, without later changes of its values. Its numbers are those of the mechanism: of `Press::<f32>::of()`
    /// they are `float`.
    ///
    /// # Errors
    /// [`NoDefault`](super::NoDefault); a mechanism of this name is in it, or has a file of the same name.
    pub fn with<M: Foreign>(mut self, mechanism: &M) -> Result<Self, Box<dyn Error>> {
        complete::<M>()?;
        let name = match &self.prefix[..] {
            "" => M::TABLES.name.to_string(),
            prefix => format!("{prefix}_{}", M::TABLES.name),
        };
        let name = Names::lower(&name).to_string();
        if self.entries.iter().any(|own| own.name == name) {
            return Err(SameName(name).into());
        }
        for (name, path) in M::FILES {
            match self.files.iter().find(|(own, _)| own == name) {
                Some((_, own)) if own != path => return Err(SameName((*name).to_string()).into()),
                Some(_) => {}
                None => self.files.push((name, path)),
            }
        }
        let (declared, entry) = (declared(mechanism), Entry { name: &name, methods: &self.methods });
        let [mut c, mut cpp, mut code] = [const { String::new() }; 3];
        header(&declared, entry, &mut c)?;
        cpp_header(&declared, entry, &mut cpp)?;
        source::<M>(entry, &mut code)?;
        self.source.extend(["mod ", &name, "_of_c {\n", &code, "\n}\n"]);
        self.entries
            .push(Written { headers: [(format!("{name}.h"), c), (format!("{name}.hpp"), cpp)], name });
        Ok(self)
    }

    /// Writes it, its headers, and what pkg-config and CMake read, into a folder; gives the files, the library first. cargo
    /// builds it in `target/plm/packages`.
    ///
    /// # Errors
    /// cargo is not there or fails, with what it says; what puts a static library into one object is missing; a file cannot be
    /// written.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
        let source =
            if self.target.is_some() { format!("{ALONE}{}", self.source) } else { self.source.clone() };
        let linkage = if self.target.is_some() { Linkage::Static } else { self.linkage };
        let package = Package {
            name: &self.name,
            output: Output::Static,
            source: &source,
            files: &self.files,
            plm: &package::plm(),
            features: &["foreign"],
            bare: self.target.as_deref(),
        };
        let kind = self.target.as_deref().map_or("c".to_string(), |target| format!("c-{target}"));
        let prefixes: Vec<&str> = self.entries.iter().map(|own| own.name.as_str()).collect();
        let packages = Path::new("target/plm/packages");
        let packages = packages.join(format!("{}-{kind}", self.name));
        let (built, library) = (package.build_library(&packages, linkage, &prefixes)?, self.library(linkage));
        let mut files = vec![folder.join(&library)];
        renew(&files[0], &built)?;
        let linking = Linking {
            name: &self.name,
            library: &library,
            linkage,
            is_bare: self.target.is_some(),
            mechanisms: &prefixes,
        };
        let of_tools = [linking.pkg_config(), linking.cmake()];
        let headers = self.entries.iter().flat_map(|own| &own.headers);
        for (name, text) in headers.chain(&of_tools) {
            let file = folder.join(name);
            renew(&file, text.as_bytes())?;
            files.push(file);
        }
        Ok(files)
    }

    /// Its file.
    fn library(&self, linkage: Linkage) -> String {
        let name = &self.name;
        let is_msvc = self.target.is_none() && cfg!(target_env = "msvc");
        match (linkage, is_msvc) {
            (Linkage::Shared, _) => format!("{}{name}{}", env::consts::DLL_PREFIX, env::consts::DLL_SUFFIX),
            (Linkage::Static, true) => format!("{name}.lib"),
            (Linkage::Static, false) => format!("lib{name}.a"),
        }
    }
}

/// Head of a library without std. Nothing in it panics.
const ALONE: &str = "#![no_std]\n
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}\n
";

//! Descriptions of a library for programs of C and C++: for pkg-config, and for CMake.

use plm_view::package::{Linkage, version};

/// A library in a folder.
pub(super) struct Linking<'a> {
    pub(super) name: &'a str,
    /// Its file.
    pub(super) library: &'a str,
    pub(super) linkage: Linkage,
    /// For a machine without an operating system.
    pub(super) is_bare: bool,
    pub(super) mechanisms: &'a [&'a str],
}

impl Linking<'_> {
    /// Further libraries that a static library needs (`rustc --print native-static-libs`); libraries of Windows by their names.
    fn needed(&self) -> &'static [&'static str] {
        match (self.linkage == Linkage::Shared || self.is_bare, std::env::consts::FAMILY) {
            (true, _) => &[],
            (false, "windows") => &["kernel32", "ntdll", "userenv", "ws2_32", "dbghelp"],
            (false, _) => &["m", "pthread", "dl"],
        }
    }

    /// A file of pkg-config, by its name and its text. All paths begin at the folder in which it lies.
    pub(super) fn pkg_config(&self) -> (String, String) {
        let Self { name, library, linkage, mechanisms, .. } = self;
        let own = if *linkage == Linkage::Shared {
            format!("-L\"${{pcfiledir}}\" -l{name}")
        } else {
            format!("\"${{pcfiledir}}/{library}\"")
        };
        let needed = self.needed().iter().fold(own, |all, library| format!("{all} -l{library}"));
        let text = format!(
            "Name: {name}\nDescription: mechanisms of plm: {}\nVersion: {}\nCflags: -I\"${{pcfiledir}}\"\nLibs: {needed}\n",
            mechanisms.join(", "),
            version()
        );
        (format!("{name}.pc"), text)
    }

    /// A file of CMake: `find_package(machines CONFIG PATHS c)` gives the target `plm::machines`.
    pub(super) fn cmake(&self) -> (String, String) {
        let Self { name, library, linkage, .. } = self;
        let kind = match linkage {
            Linkage::Static => "STATIC",
            Linkage::Shared => "SHARED",
        };
        let text = format!(
            "if(NOT TARGET plm::{name})
    add_library(plm::{name} {kind} IMPORTED)
    set_target_properties(plm::{name} PROPERTIES
        IMPORTED_LOCATION \"${{CMAKE_CURRENT_LIST_DIR}}/{library}\"
        INTERFACE_INCLUDE_DIRECTORIES \"${{CMAKE_CURRENT_LIST_DIR}}\"
        INTERFACE_LINK_LIBRARIES \"{}\")
endif()
",
            self.needed().join(";")
        );
        (format!("{name}-config.cmake"), text)
    }
}

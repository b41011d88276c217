//! `plm export`: a declaration as a project, from which cargo makes a program, C, an FMU or a wheel, as C source, as CUDA C, as a file of MuJoCo or
//! ROS, as drawings of its links, or as a link to the playground.

mod links;

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command as Process;

use plm_compiler::token::Sources;
use plm_compiler::{Assembled, Oracle};
use plm_dynamic::Mechanism;
use plm_import::{Exported, PlaceOf};
use plm_source::{Interfaces, Precision, Version};
use plm_view::package::archive;
use plm_view::replace_file;

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::checked::{Checked, Declarations, place};
use crate::package::{Package, version};
use crate::read;

pub(super) const COMMAND: Command = Command {
    name: "export",
    usage: "FILE --rust FOLDER …",
    title: "writes a project that makes a program, C, an FMU or a wheel of a declaration, its C source, CUDA C, MJCF or URDF, drawings of its links, or a link",
    options: &[
        ("--rust FOLDER", "a Rust package whose program runs the mechanism"),
        ("--c FOLDER", "the same package, and how it makes a library for C and C++"),
        ("--fmu FOLDER", "the same package, and how it makes an FMU"),
        ("--python FOLDER", "the same package, and how it makes a wheel"),
        ("--c-source FOLDER", "C99 of it, for compilers of any target: no Rust, no library"),
        ("--cuda FOLDER", "CUDA C of it: mechanisms side by side, each by a thread of a GPU"),
        ("--single", "of --c-source and --cuda: numbers of 32 bits"),
        ("--ros2 FOLDER", "a package of ROS 2 with a node that steps its C source"),
        ("--fmu-source FILE", "an FMU with C sources: no Rust, no compiler"),
        ("--fmi VERSION", "of --fmu-source: 2 or 3, for FMI 2.0 or 3.0"),
        ("--interface NAME", "of --fmu-source: `model-exchange` or `co-simulation` alone"),
        ("--mjcf FILE", "a model of MuJoCo; `-` is the standard output"),
        ("--urdf FILE", "a robot of ROS; `-` is the standard output"),
        (
            "--dxf FOLDER",
            "its links in true size as DXF, side by side and each alone, with tables of pins and lengths",
        ),
        ("--svg FOLDER", "the same as SVG"),
        (
            "--until SECONDS",
            "of --dxf and --svg: the motion over which links that meet get different layers, and slots their lengths",
        ),
        ("--hole MM", "of --dxf and --svg: diameter of holes for pins, 5 mm without it"),
        ("--width MM", "of --dxf and --svg: width of links that declare none, 20 mm without it"),
        ("--kerf MM", "of --dxf and --svg: width of what a laser takes away"),
        ("--link ADDRESS", "a link that opens it in the playground at this address, on the standard output"),
        ("--name NAME", "the declaration of a file that has several"),
        ("--plm FOLDER", "a clone of plm, in place of the crate of the registry"),
        ("--build", "runs the commands that it tells"),
        ("--force", "writes over files that have other contents"),
    ],
    run,
};

/// A product of a package.
struct Product {
    option: &'static str,
    /// Options of the program that makes it, in the folder of the package; `NAME` is the name of the package.
    made_by: &'static str,
    /// A command before, and one after.
    around: [Option<&'static str>; 2],
}

const PRODUCTS: [Product; 4] = [
    Product { option: "--rust", made_by: "--until 5 --csv outputs.csv", around: [None, None] },
    Product { option: "--c", made_by: "--c c", around: [None, None] },
    Product { option: "--fmu", made_by: "--fmu NAME.fmu", around: [None, None] },
    Product {
        option: "--python",
        made_by: "--python wheels",
        around: [Some("pip install maturin numpy"), Some("pip install wheels/NAME-*.whl")],
    },
];

/// A format of others.
type Format = fn(&Assembled, &str, PlaceOf) -> Exported;

const FORMATS: [(&str, Format); 2] = [("--mjcf", plm_import::to_mjcf), ("--urdf", plm_import::to_urdf)];

/// A product, and where it is written.
enum Wanted {
    Package(&'static Product, PathBuf),
    Source(PathBuf, Precision),
    Cuda(PathBuf, Precision),
    Ros2(PathBuf),
    SourceFmu(PathBuf, Version, Option<Interfaces>),
    File(Format, String),
    Links(links::Wanted),
    Link(String),
}

/// Parsed arguments of the command.
struct Asked {
    wanted: Wanted,
    name: Option<String>,
    /// The dependency on plm, in TOML.
    plm: String,
    builds: bool,
    overwrites: bool,
}

impl Asked {
    fn new(words: &mut Words) -> Result<Asked, Failure> {
        let mut wanted = Vec::new();
        for product in &PRODUCTS {
            wanted.extend(words.value(product.option).map(|folder| Wanted::Package(product, folder.into())));
        }
        for (option, format) in FORMATS {
            wanted.extend(words.value(option).map(|file| Wanted::File(format, file)));
        }
        wanted.extend(of_source(words)?);
        wanted.extend(links::Wanted::asked(words)?.into_iter().map(Wanted::Links));
        wanted.extend(words.value("--link").map(Wanted::Link));
        let (Some(wanted), true) = (wanted.pop(), wanted.is_empty()) else {
            return Err(
                "an export makes one of --rust, --c, --c-source, --cuda, --fmu, --fmu-source, --python, --ros2, --mjcf, \
                 --urdf, --dxf, --svg and --link"
                    .into(),
            );
        };
        let plm = match words.value("--plm") {
            None => version(),
            Some(folder) => path_of(&folder).map_err(|why| format!("--plm {folder}: {why}"))?,
        };
        let name = words.value("--name");
        let (builds, overwrites) = (words.takes("--build"), words.takes("--force"));
        Ok(Asked { wanted, name, plm, builds, overwrites })
    }
}

/// C source, a node over it, or an FMU of it, with their own options.
fn of_source(words: &mut Words) -> Result<Vec<Wanted>, Failure> {
    let is_single = words.takes("--single");
    let [fmi, interface] = ["--fmi", "--interface"].map(|option| words.value(option));
    let [source, cuda, ros2, fmu] =
        ["--c-source", "--cuda", "--ros2", "--fmu-source"].map(|option| words.value(option));
    if is_single && source.is_none() && cuda.is_none() {
        return Err("--single is of --c-source and --cuda: an FMU has numbers of 64 bits".into());
    }
    if (fmi.is_some() || interface.is_some()) && fmu.is_none() {
        return Err("--fmi and --interface are of --fmu-source".into());
    }
    let precision = if is_single { Precision::Single } else { Precision::Double };
    let (version, interfaces) = (version_of(fmi.as_deref())?, interfaces_of(interface.as_deref())?);
    let source = source.map(|folder| Wanted::Source(folder.into(), precision));
    let fmu = fmu.map(|file| Wanted::SourceFmu(file.into(), version, interfaces));
    let ros2 = ros2.map(|folder| Wanted::Ros2(folder.into()));
    let cuda = cuda.map(|folder| Wanted::Cuda(folder.into(), precision));
    Ok(source.into_iter().chain(cuda).chain(ros2).chain(fmu).collect())
}

/// The version of an FMU with sources.
fn version_of(word: Option<&str>) -> Result<Version, Failure> {
    match word {
        None | Some("3" | "3.0") => Ok(Version::Three),
        Some("2" | "2.0") => Ok(Version::Two),
        Some(other) => Err(format!("--fmi is 2 or 3, not `{other}`").into()),
    }
}

/// Its interfaces, where they are chosen.
fn interfaces_of(word: Option<&str>) -> Result<Option<Interfaces>, Failure> {
    Ok(match word {
        None => None,
        Some("model-exchange") => Some(Interfaces::ModelExchange),
        Some("co-simulation") => Some(Interfaces::CoSimulation),
        Some(other) => {
            return Err(format!("--interface is model-exchange or co-simulation, not `{other}`").into());
        }
    })
}

/// A clone of plm, in TOML.
fn path_of(folder: &str) -> std::io::Result<String> {
    let path = std::path::absolute(folder)?;
    if !path.join("Cargo.toml").is_file() {
        return Err(std::io::Error::new(ErrorKind::NotFound, "there is no Cargo.toml in it"));
    }
    Ok(format!("path = {:?}", path.display().to_string()))
}

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let asked = Asked::new(&mut words)?;
    let file = read::file(&words.file()?, streams.input)?;
    let declarations = Declarations::new(&file.name, &file.text);
    let Some((text, checked)) = declarations.named(asked.name.as_deref())? else {
        return Err(format!("{}: there is no `mechanism!` in it", file.name).into());
    };
    let Checked { sources, expansion } = checked;
    for diagnostic in expansion.diagnostics.sorted() {
        writeln!(streams.errors, "{}", diagnostic.render(&sources))?;
    }
    if expansion.diagnostics.has_errors() {
        return Ok(Outcome::Wrong);
    }
    match &asked.wanted {
        Wanted::Package(product, folder) => {
            let package = Package::new(&text, &sources, &asked.plm)?;
            let files = package.files.iter().map(|(path, text)| (folder.join(path), text.as_str()));
            write(&files.collect::<Vec<_>>(), asked.overwrites, streams)?;
            let commands = product.commands(&package.name);
            writeln!(streams.output, "\ncd {}", folder.display())?;
            for (_, command) in &commands {
                writeln!(streams.output, "{command}")?;
            }
            if asked.builds { build(folder, &commands, streams) } else { Ok(Outcome::Good) }
        }
        Wanted::Source(folder, _) | Wanted::Cuda(folder, _) | Wanted::Ros2(folder) => {
            let mechanism =
                Mechanism::from_named_text(&file.name, &text).map_err(|error| error.to_string())?;
            let files = match asked.wanted {
                Wanted::Source(_, precision) => plm_source::c(&mechanism, precision),
                Wanted::Cuda(_, precision) => plm_source::cuda(&mechanism, precision),
                _ => plm_source::ros2(&mechanism),
            };
            let files = files.map_err(|failure| failure.to_string())?;
            let files = files.iter().map(|made| (folder.join(&made.name), made.text.as_str()));
            write(&files.collect::<Vec<_>>(), asked.overwrites, streams)?;
            Ok(Outcome::Good)
        }
        Wanted::SourceFmu(file_name, version, interfaces) => {
            let mechanism =
                Mechanism::from_named_text(&file.name, &text).map_err(|error| error.to_string())?;
            let made =
                plm_source::fmu(&mechanism, *version, *interfaces).map_err(|failure| failure.to_string())?;
            if interfaces.is_none() {
                for refused in &made.without_exchange {
                    writeln!(streams.errors, "co-simulation alone: {refused}")?;
                }
            }
            let entries = made.files.into_iter().map(|made| (made.name, made.text.into_bytes()));
            write(&[(file_name.clone(), &archive(entries)?)], asked.overwrites, streams)?;
            Ok(Outcome::Good)
        }
        Wanted::File(format, path) => {
            let assembled = expansion.oracle.as_ref().map(Oracle::assembled);
            let mechanism = assembled.ok_or("there is no mechanism in it")?;
            let exported = format(&mechanism, &file.name, &|span| place(&sources, span));
            for notice in &exported.notices {
                writeln!(streams.errors, "{notice}")?;
            }
            let Some(text) = exported.text else { return Ok(Outcome::Wrong) };
            if path == "-" {
                write!(streams.output, "{text}")?;
            } else {
                write(&[(path.into(), &text)], asked.overwrites, streams)?;
            }
            Ok(Outcome::Good)
        }
        Wanted::Links(wanted) => {
            let assembled = expansion.oracle.as_ref().map(Oracle::assembled);
            let mechanism = assembled.ok_or("there is no mechanism in it")?;
            let named = (file.name.as_str(), text.as_str());
            let (links, ended) = wanted.links(&mechanism, named, &|span| place(&sources, span))?;
            for notice in &links.notices {
                writeln!(streams.errors, "{notice}")?;
            }
            if let Some(ended) = ended {
                writeln!(streams.errors, "warning: {ended}")?;
            }
            let files = links.files.iter().map(|(name, text)| (wanted.folder.join(name), text.as_str()));
            write(&files.collect::<Vec<_>>(), asked.overwrites, streams)?;
            Ok(Outcome::Good)
        }
        Wanted::Link(address) => {
            writeln!(streams.output, "{}", link(address, &text, &sources)?)?;
            Ok(Outcome::Good)
        }
    }
}

/// A link to the playground at an address, which has the text and no file beside it.
fn link(address: &str, text: &str, sources: &Sources) -> Result<String, String> {
    if let Some((file, _)) = sources.files().into_iter().next() {
        return Err(format!("the declaration names the file {file}, which a link does not hold"));
    }
    plm_view::playground_link(address, text)
        .ok_or_else(|| "the declaration is too long for a link".to_owned())
}

/// Writes files; none where one has other contents.
fn write(
    files: &[(PathBuf, impl AsRef<[u8]>)],
    overwrites: bool,
    streams: &mut Streams,
) -> Result<(), Failure> {
    let is_other = |(path, content): &&(PathBuf, _)| {
        path.exists() && fs::read(path).map_or(true, |present| present != AsRef::<[u8]>::as_ref(content))
    };
    if let Some((path, _)) = files.iter().find(is_other).filter(|_| !overwrites) {
        return Err(format!("{} has other contents: `--force` writes over it", path.display()).into());
    }
    for (path, content) in files {
        let unwritten = |why: std::io::Error| format!("{}: {why}", path.display());
        fs::create_dir_all(path.parent().unwrap_or(Path::new(""))).map_err(unwritten)?;
        replace_file(path, content.as_ref()).map_err(unwritten)?;
        writeln!(streams.output, "written: {}", path.display())?;
    }
    Ok(())
}

/// Does cargo run it? Else a person does.
type ByCargo = bool;

impl Product {
    /// The commands that make it, in the folder of the package of this name.
    fn commands(&self, name: &str) -> Vec<(ByCargo, String)> {
        let [before, after] = self.around;
        let cargo = format!("cargo run --release -- {}", self.made_by);
        let all = [
            before.map(|line| (false, line.to_owned())),
            Some((true, cargo)),
            after.map(|line| (false, line.to_owned())),
        ];
        all.into_iter().flatten().map(|(by, line)| (by, line.replace("NAME", name))).collect()
    }
}

/// Runs the commands of cargo in the folder of the package.
fn build(folder: &Path, commands: &[(ByCargo, String)], streams: &mut Streams) -> Result<Outcome, Failure> {
    for (_, command) in commands.iter().filter(|(by_cargo, _)| *by_cargo) {
        let mut words = command.split(' ').skip(1);
        let mut cargo = Process::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        let done = cargo.args(words.by_ref()).current_dir(folder).output();
        let done = done.map_err(|why| format!("cargo cannot be run: {why}"))?;
        streams.output.write_all(&done.stdout)?;
        if !done.status.success() {
            streams.errors.write_all(&done.stderr)?;
            return Ok(Outcome::Wrong);
        }
    }
    Ok(Outcome::Good)
}

//! C source of a compiled mechanism: its declaration, with the numbers that it has.

use std::error::Error;
use std::path::{Path, PathBuf};

use plm_dynamic::Mechanism;
use plm_runtime::described::by_number;
use plm_runtime::{Described, StartValues as _, Statics};
use plm_source::Precision;
use plm_view::package::renew;

/// Writes C99 of a mechanism into a folder: a header, a source, and `plm_math.h`; gives the files. The source has the parameters and start
/// values that the mechanism has now, inputs and locks as declared, and the bits of its steps by themselves.
///
/// # Errors
/// [`Failure`](plm_source::Failure), which names what no source has; a parameter that the equations do not allow; a file that cannot be
/// written.
pub fn c_source<M: Described<S = f64> + Statics>(
    mechanism: &M,
    precision: Precision,
    folder: &Path,
) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let files = plm_source::c(&from_declaration(mechanism)?, precision)?;
    let mut written = Vec::new();
    for file in files {
        let path = folder.join(file.name);
        renew(&path, file.text.as_bytes())?;
        written.push(path);
    }
    Ok(written)
}

/// The mechanism from the text of its declaration, with its numbers.
fn from_declaration<M: Described<S = f64> + Statics>(mechanism: &M) -> Result<Mechanism, plm_dynamic::Error> {
    let name = beside(mechanism.files(), mechanism.tables().name);
    let mut own = Mechanism::from_named_text(&name.display().to_string(), mechanism.declaration())?;
    for (row, value) in mechanism.tables().parameters.iter().zip(by_number::parameters(mechanism)) {
        own.set_parameter(row.name, value)?;
    }
    // Start values that were set by hand; the others follow the parameters there, too.
    let (mut present, mut all) = (*mechanism, Vec::new());
    mechanism.declared_starts().each(&mut |_, start| all.push(start.value));
    let mut declared = all.into_iter();
    let mut by_hand = Vec::new();
    present.starts_mut().each(&mut |name, start| {
        if declared.next() != Some(start.value) {
            by_hand.push((name, start.value));
        }
    });
    by_hand.into_iter().try_for_each(|(name, value)| own.set_start(name, value))?;
    Ok(own)
}

/// A name of the declaration beside which the files are that it names.
fn beside(files: &[(&str, &str)], name: &str) -> PathBuf {
    let folder = files.first().and_then(|(named, path)| path.strip_suffix(named));
    Path::new(folder.unwrap_or_default()).join(name)
}

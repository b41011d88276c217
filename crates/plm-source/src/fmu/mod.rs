//! FMUs with sources: the C source of a mechanism, the functions of FMI over it, and its description. They are written without a compiler;
//! whoever imports them compiles.

mod facts;
mod refused;
mod texts;

use plm_dynamic::Mechanism;
use plm_foreign::fmi::{Interfaces, Version, build_description};

use crate::plan::{Plan, Refused};
use crate::{Failure, File, Precision};

/// An FMU with sources.
#[derive(Clone, Debug)]
pub struct Fmu {
    /// Its files, by their paths in the archive.
    pub files: Vec<File>,
    /// The interfaces that it has.
    pub interfaces: Interfaces,
    /// Parts of the mechanism for which it has no model exchange.
    pub without_exchange: Vec<Refused>,
}

/// An FMU with sources of a mechanism, with the values that its parameters, inputs and start values have: in co-simulation steps of the
/// source, in model exchange rates and event indicators. Without `wanted` interfaces it has all that the mechanism
/// can have, co-simulation at least.
///
/// # Errors
/// Those of [`c`](crate::c); [`Failure::Refused`] of a mechanism that cannot have model exchange where that is wanted.
pub fn fmu(mechanism: &Mechanism, version: Version, wanted: Option<Interfaces>) -> Result<Fmu, Failure> {
    let [header, source, math] = crate::printed(mechanism, Precision::Double)?;
    let without_exchange = refused::exchange(mechanism.lowered());
    let interfaces = match wanted {
        Some(wanted) if wanted.exchange() && !without_exchange.is_empty() => {
            return Err(Failure::Refused(without_exchange));
        }
        Some(wanted) => wanted,
        None if without_exchange.is_empty() => Interfaces::Both,
        None => Interfaces::CoSimulation,
    };
    let steps = mechanism.steps().map_err(Failure::Start)?;
    let plan = Plan::new(mechanism, &steps, Precision::Double);
    let (name, mark) = (format!("{}_fmi.c", plan.name), mark(&[&header, &source, &math]));
    let token = format!("{{{}-{mark:016x}}}", plan.lowered.name);
    let listed = [name.as_str()];
    let facts = facts::facts(&plan, interfaces, &token, &listed);
    let text = texts::functions(&plan, version, &facts, mark);
    let mut described = String::new();
    // Writing to a text cannot fail.
    let _ = facts.describe(version, &mut described);
    let mut files = vec![File { name: "modelDescription.xml".to_owned(), text: described }];
    if version == Version::Three {
        let mut text = String::new();
        let _ = build_description(&plan.name, &listed, &mut text);
        files.push(File { name: "sources/buildDescription.xml".to_owned(), text });
    }
    let own = File { name: name.clone(), text: source.text + &text };
    files.extend([own, header, math].map(|file| File { name: format!("sources/{}", file.name), ..file }));
    Ok(Fmu { files, interfaces, without_exchange })
}

/// A number of the texts of files: FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo).
fn mark(files: &[&File]) -> u64 {
    let bytes = files.iter().flat_map(|file| file.text.bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

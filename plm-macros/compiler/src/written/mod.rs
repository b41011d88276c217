//! Equations of motion as people write them, in LaTeX and in MathML.

mod equation;
mod formula;
mod latex;
mod mathml;
mod name;
#[cfg(test)]
mod tests;

use crate::collect::CollectVec;

use self::equation::{Side, equations};
use self::formula::Writer;
use self::name::Names;
use crate::formulate::textbook;
use crate::oracle::Oracle;

/// The equations of motion of a mechanism, as texts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// Name of the mechanism.
    pub name: String,
    /// Paths of the coordinates, and their symbols in LaTeX and in MathML.
    pub coordinates: Vec<[String; 3]>,
    /// Each equation in LaTeX, without marks of a block.
    pub latex: Vec<String>,
    /// Each equation as a `math` element.
    pub mathml: Vec<String>,
    /// Sentences on what is not in the equations.
    pub notes: Vec<String>,
}

impl Oracle {
    /// The equations of motion in the order of a textbook.
    pub fn written(&self) -> Written {
        self.graph.borrow_mut().enter(|| {
            let (model, all) = (&self.model, textbook(&self.model, &self.equations));
            let names = Names::new(model, &all);
            let writer = Writer::new(&names);
            let sides: Vec<[Side; 2]> = equations(model, &self.equations, &all, &writer);
            let coordinates = all.names.iter().zip(&all.value).map(|(path, value)| {
                let name = names.of(*value);
                [path.clone(), latex::name(&name), mathml::name(&name)]
            });
            Written {
                name: model.name.text.clone(),
                coordinates: coordinates.collect_vec(),
                latex: sides.iter().map(latex::equation).collect_vec(),
                mathml: sides.iter().map(mathml::equation).collect_vec(),
                notes: self.notes(all.reason.as_deref()),
            }
        })
    }

    fn notes(&self, reason: Option<&str>) -> Vec<String> {
        let mut notes = Vec::new();
        if let Some(reason) = reason {
            notes.push(format!("The coordinates are absolute, because {reason}."));
        }
        if !self.model.contacts.is_empty() {
            notes.push(
                "Forces of contact and friction stand by their names; their laws are not written.".to_owned(),
            );
        }
        if !self.equations.signals.is_empty() {
            notes.push("Forces that read accelerations or reactions are left out.".to_owned());
        }
        if !self.model.whens.is_empty() {
            notes.push("Events that set states are left out.".to_owned());
        }
        notes
    }
}

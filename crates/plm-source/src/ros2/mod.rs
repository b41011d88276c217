//! Packages of ROS 2: the C source of a mechanism, and a node in C++ that steps it.

use plm_dynamic::Mechanism;
use plm_foreign::Names;

use crate::plan::Plan;
use crate::template::fill;
use crate::{Failure, File, Precision};

const NODE: &str = include_str!("node.cpp.txt");
const CMAKE: &str = include_str!("CMakeLists.cmake.txt");
const PACKAGE: &str = include_str!("package.xml.txt");

/// A package of ROS 2 for `ament_cmake`, with the values that parameters, inputs and start values of the mechanism have: its description,
/// the source of [`c`](crate::c) and a node that steps it, takes inputs and publishes outputs and poses of bodies.
///
/// # Errors
/// Those of [`c`](crate::c).
pub fn ros2(mechanism: &Mechanism) -> Result<Vec<File>, Failure> {
    let source = crate::printed(mechanism, Precision::Double)?;
    let steps = mechanism.steps().map_err(Failure::Start)?;
    let plan = Plan::new(mechanism, &steps, Precision::Double);
    let tables = plan.tables;
    let settable = tables.parameters.iter().zip(&plan.is_fixed).enumerate();
    let settable = settable.filter(|(_, (_, is_fixed))| !**is_fixed).map(|(k, (row, _))| (k, row.name));
    let words = [
        ("parameters", numbers(settable)),
        ("inputs", numbers(tables.inputs.iter().map(|row| row.name).enumerate())),
        ("outputs", numbers(plan.outputs().map(|(_, output)| output.name.as_str()).enumerate())),
        ("bodies", numbers(plan.lowered.bodies.iter().map(String::as_str).enumerate())),
        ("description", description(tables.name, tables.docs)),
        ("title", tables.name.to_owned()),
        ("p", plan.name.clone()),
    ];
    let own = [("package.xml", PACKAGE), ("CMakeLists.txt", CMAKE), ("src/node.cpp", NODE)];
    let own = own.map(|(name, template)| File { name: name.to_owned(), text: fill(template, &words) });
    let source = source.map(|file| File { name: format!("src/{}", file.name), ..file });
    Ok(own.into_iter().chain(source).collect())
}

/// Numbers of the source, with names that ROS allows: those in which only letters, digits and single `_` stand.
fn numbers<'a>(rows: impl Iterator<Item = (usize, &'a str)>) -> String {
    let rows: Vec<(usize, String)> = rows.map(|(k, name)| (k, Names::lower(name).to_string())).collect();
    let is_alone = |name: &String| rows.iter().filter(|(_, other)| other == name).count() == 1;
    let row = |(k, name): &(usize, String)| {
        // Names that differ in other than letters and digits get their number.
        let number = if is_alone(name) { String::new() } else { format!("_{k}") };
        format!("\n    {{\"{name}{number}\", {k}}},")
    };
    rows.iter().map(row).collect()
}

/// The documentation of a mechanism, or its name, as XML.
fn description(name: &str, docs: &str) -> String {
    let text = if docs.trim().is_empty() { name } else { docs.trim() };
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

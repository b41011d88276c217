//! The table of instruction counts has a row for each scene that is counted, within its limits.

use super::root;
use super::workspace;

const TABLE: &str = "benches/instructions.txt";
const SCENES: &str = "benches/scenes/mod.rs";

/// The scenes of the benchmark: name, limit of the formula, limit of a step of `Sim`.
fn scenes(text: &str) -> Vec<(&str, Option<f64>, f64)> {
    let number = |text: &str| text.replace('_', "").parse().ok();
    let lines = text.lines().filter_map(|line| line.trim().strip_prefix("scene(\""));
    let scene = |line| {
        let (name, rest): (&str, &str) = str::split_once(line, '"')?;
        let (_, limits) = rest.split_once('(')?;
        let (formula, sim) = limits.split_once("), |")?.0.rsplit_once(", ")?;
        let formula = formula.strip_prefix("Some(").and_then(|limit| number(limit.trim_end_matches(')')));
        Some((name, formula, number(sim)?))
    };
    lines.map(|line| scene(line).unwrap_or_else(|| panic!("{SCENES}: limits of {line}?"))).collect()
}

#[test]
fn instruction_counts_are_those_of_the_scenes() {
    let [table, text] = [TABLE, SCENES].map(|path| workspace::read(&root().join(path)).unwrap());
    let mut rows = table.lines().skip(1);
    for (name, formula, sim) in scenes(&text) {
        let row = rows.next().and_then(|row| row.strip_prefix(name)).unwrap_or_else(|| {
            panic!("{TABLE} has no row of {name} in its place: bash benches/instructions.sh >{TABLE}")
        });
        let numbers: Vec<f64> = row.split_whitespace().filter_map(|number| number.parse().ok()).collect();
        // After the count of the formula and of a body stand its limit and the ratio to it, if there is a limit.
        let (counted, with_sim) = (numbers[0], numbers[if formula.is_some() { 4 } else { 2 }]);
        assert!(formula.is_none_or(|limit| counted <= limit), "{TABLE}: {name} is above its limit");
        assert!(with_sim <= sim, "{TABLE}: a step of `Sim` of {name} is above its limit, {sim}");
    }
    assert_eq!(rows.next(), None, "{TABLE} has a row that the benchmark does not print");
}

//! The end states that errors are measured against: `benches/data/references.csv`, which names their sources.

/// The table as it stands in the repository.
const TABLE: &str = include_str!("../../../../../benches/data/references.csv");

/// Names and values of a scene, in the order of the table.
pub fn of(scene: &str) -> Vec<(&'static str, f64)> {
    let rows = TABLE.lines().filter(|line| !line.starts_with('#'));
    let fields = rows.map(|line| line.split(',').collect::<Vec<_>>());
    let ours = fields.filter(|fields| fields.first() == Some(&scene));
    ours.filter_map(|fields| Some((*fields.get(1)?, fields.get(2)?.parse().ok()?))).collect()
}

//! Runs of scenes with contact, as `runs.csv` has them.

/// The first line of the file.
pub const HEAD: &str = "scene,program,settings,size,error,seconds,steps,creep,gain";

/// One run.
pub struct Run {
    pub scene: String,
    pub program: String,
    pub settings: String,
    /// A step, s; of plm the tolerance.
    pub size: f64,
    /// At the end, m or rad; none if it is no number.
    pub error: Option<f64>,
    /// CPU time, s.
    pub seconds: f64,
    pub steps: u64,
    /// Speed of what sticks, um/s.
    pub creep: Option<f64>,
    /// How far the energy after an impact is from that of the law, as a fraction of it: the largest by its amount.
    pub gain: Option<f64>,
}

/// All runs of a file.
///
/// # Errors
/// A row that is no run.
pub fn read(text: &str) -> Result<Vec<Run>, String> {
    let mut lines = text.lines();
    if lines.next() != Some(HEAD) {
        return Err(format!("the first line is not `{HEAD}`"));
    }
    lines.map(|row| run(row).ok_or_else(|| format!("`{row}` is no run"))).collect()
}

fn run(row: &str) -> Option<Run> {
    let fields: Vec<&str> = row.split(',').collect();
    let &[scene, program, settings, size, error, seconds, steps, creep, gain] = &fields[..] else {
        return None;
    };
    let number = |text: &str| if text.is_empty() { Some(None) } else { text.parse().ok().map(Some) };
    Some(Run {
        scene: scene.to_owned(),
        program: program.to_owned(),
        settings: settings.to_owned(),
        size: size.parse().ok()?,
        error: number(error)?,
        seconds: seconds.parse().ok()?,
        steps: steps.parse().ok()?,
        creep: number(creep)?,
        gain: number(gain)?,
    })
}

/// Programs with their settings, in the order of the tables; true for those that the picture shows.
pub const LINES: [(&str, &str, bool); 9] = [
    ("plm", "DOP853", true),
    ("MuJoCo", "defaults", false),
    ("MuJoCo", "stiff", true),
    ("MuJoCo", "RK4", true),
    ("Rapier2D", "defaults", false),
    ("Rapier2D", "tight", true),
    ("Box2D", "usual", false),
    ("Box2D", "tight", true),
    ("Siconos", "Moreau-Jean", true),
];

/// The runs of a program with its settings in a scene, from coarse to fine. Runs over an hour are left out where the others take a
/// minute.
pub fn line<'a>(runs: &'a [Run], scene: &str, program: &str, settings: &str) -> Vec<&'a Run> {
    let is_of = |run: &&Run| run.scene == scene && run.program == program && run.settings == settings;
    let is_long = |run: &Run| run.program != "plm" && run.steps as f64 * run.size > 1000.0;
    let mut found: Vec<&Run> = runs.iter().filter(is_of).filter(|run| !is_long(run)).collect();
    found.sort_by(|a, b| b.size.total_cmp(&a.size));
    found
}

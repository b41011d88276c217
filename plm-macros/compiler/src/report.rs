//! Report of the compiler: its findings and choices, in words and numbers.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::{Count, Expr, algebra};

use crate::formulate::{Chart, Function, Program, Reduced};
use crate::model::{Model, Repetitions, Stabilisation};
use crate::numeric::{Assembly, Scene, Searched, add_switches, run, value};

/// Degrees per radian.
const DEGREES: f64 = 180.0 / std::f64::consts::PI;
/// Operations of a right-hand side from which on what repeats itself is written in loops, of a tree and of all else. Instructions
/// of longer code do not stay in a processor's caches; shorter code is faster without loops, as values stay in registers, and
/// those of loops in closed form in pairs (`docs/src/internals/scale.md`).
const MOST_UNROLLED: [usize; 2] = [2000, 5000];
/// Coordinates whose move the report lists one by one.
const MOST_MOVES: usize = 12;

/// The report of one mechanism.
#[derive(Clone, Debug)]
pub struct Report {
    /// Name of the mechanism.
    pub name: String,
    /// Number of bodies, `N`.
    pub bodies: usize,
    /// Number of parts at the top level.
    pub parts: usize,
    /// Number of coordinates, `NQ = 3 N`.
    pub coordinates: usize,
    /// Number of constraint rows, `M`.
    pub constraints: usize,
    /// Number of first-order states.
    pub states: usize,
    /// Degrees of freedom by the manual's count, `F = 3 N - M`.
    pub freedom: isize,
    /// Rank of `phi_q` with the position locks, and the number of locks, where they are known at compile time.
    pub rank: Option<(usize, usize)>,
    /// The formulation that was taken, and why.
    pub taken: Taken,
    /// The formulation in lines of text, with coordinates and method.
    pub formulation: Vec<String>,
    /// Bodies without mass.
    pub massless: Vec<String>,
    /// Numbers in the state.
    pub state: usize,
    /// Size of the scene, m.
    pub length: f64,
    /// Operations of one right-hand side.
    pub rate: Count,
    /// How repetitions are to be written, where that is ordered.
    pub ordered: Option<Repetitions>,
    /// Operations of the other functions, by name.
    pub functions: Vec<(&'static str, Count)>,
    /// Report of assembly: lines of text.
    pub assembly: Vec<String>,
}

/// The formulation that was taken.
#[derive(Clone, Debug)]
pub struct Taken {
    /// Its number, from 1 (kinematics) to 5 (absolute coordinates).
    pub number: u8,
    /// Kind of the unknowns: `joint coordinates`.
    pub formulation: String,
    /// Why, in words that go on after it: `the joints make a tree, …`.
    pub reason: String,
}

impl Report {
    /// The report of a program before anything is said of the start.
    pub(crate) fn new(scene: &Scene, program: &Program) -> Report {
        let Scene { model, equations, .. } = scene;
        let Program { absolute, reduced } = program;
        let functions = [
            ("phi", &absolute.phi),
            ("phi_dot", &absolute.phi_dot),
            ("phi_q", &absolute.phi_q),
            ("closing step", &absolute.min_norm),
        ];
        let of_tree = program.reduced().and_then(|reduced| reduced.first()?.reactions.as_ref());
        let functions = of_tree.map(|reactions| ("reactions", reactions)).into_iter().chain(functions);
        let coordinates = equations.q.len();
        let taken = taken(model, reduced.as_ref().map_err(String::as_str));
        let mechanical = program.reduced().map_or(2 * coordinates, |reduced| 2 * reduced.freedom());
        let massless = model.bodies.iter().filter(|body| !body.has_mass).map(|body| body.name.text.clone());
        Report {
            name: model.name.text.clone(),
            bodies: model.bodies.len(),
            parts: model.parts.len(),
            coordinates,
            constraints: equations.phi.len(),
            states: equations.x.len(),
            freedom: coordinates as isize - equations.phi.len() as isize,
            rank: None,
            formulation: formulation(model, program.reduced(), &taken),
            massless: massless.collect_vec(),
            taken,
            state: mechanical + equations.x.len(),
            length: scene.length,
            rate: counted(program.rate()),
            ordered: model.repetitions,
            functions: functions.map(|(name, function)| (name, counted(function))).collect_vec(),
            assembly: Vec::new(),
        }
    }

    /// Adds what assembly found: ranks, how far it moved the bodies, branches, and how far charts are from flat.
    pub(crate) fn add_start(&mut self, scene: &Scene, found: &Assembly, reduced: Option<&Reduced>) {
        let mut values = scene.moving(&found.q, &found.v);
        add_switches(scene.model, &mut values);
        self.add_rank(found);
        self.add_moves(scene, found);
        self.add_branches(scene, &values);
        self.add_measures(&measures(reduced, &values), reduced);
    }

    fn add_rank(&mut self, found: &Assembly) {
        let locks = found.locked.iter().filter(|lock| **lock).count();
        self.rank = Some((found.rank.value(), locks));
        let kind = if !found.rank.dependent.is_empty() {
            "redundant"
        } else if (self.freedom - locks as isize) > 0 {
            "insufficient (the nearest pose is taken)"
        } else {
            "sufficient"
        };
        if let Some(Searched { starts, closed }) = found.searched.filter(|_| found.is_closed()) {
            self.assembly.push(format!(
                "Newton's steps from the declared start closed nothing: nearest of what {closed} of {starts} starts about it closed"
            ));
        }
        self.assembly.push(format!(
            "constraints and locks: {kind}; F = {}, {locks} locked, rank {} of {} rows, {} Newton steps",
            self.freedom,
            found.rank.value(),
            self.constraints + locks,
            found.steps
        ));
    }

    fn add_moves(&mut self, scene: &Scene, found: &Assembly) {
        let mut moves: Vec<(usize, f64)> =
            found.q.iter().zip(&found.start).map(|(q, start)| q - start).enumerate().collect_vec();
        moves.retain(|&(k, by)| !found.locked[k] && by.abs() > 1e-9);
        for &(k, by) in moves.iter().take(MOST_MOVES) {
            self.assembly.push(moved(scene.model, k, found.start[k], by));
        }
        if moves.len() > MOST_MOVES {
            self.assembly.push(format!("… and {} coordinates more", moves.len() - MOST_MOVES));
        }
    }

    fn add_branches(&mut self, scene: &Scene, values: &[(Expr, f64)]) {
        let Scene { model, equations, .. } = scene;
        let turns: Vec<Expr> = equations.branches.iter().map(|branch| branch.turn).collect_vec();
        let turns = run(&algebra::tape(&turns), values);
        for (branch, turn) in equations.branches.iter().zip(turns).take(MOST_MOVES) {
            let [first, second] = branch.bodies.map_each(|body| &model.bodies[body].name.text);
            let turn = turn * DEGREES;
            let side = if turn >= 0.0 { "left" } else { "right" };
            let joint = &model.parts[branch.part].name.text;
            let line = format!(
                "branch: at `{joint}`, `{second}` turns {side} from `{first}` by {:.2} deg",
                turn.abs()
            );
            self.assembly.push(line);
        }
    }

    /// Adds how far the charts are from flat at the start, and counts the operations of the one that is taken there.
    fn add_measures(&mut self, measures: &[f64], reduced: Option<&Reduced>) {
        let taken = taken_first(measures);
        if let Some(chart) = reduced.and_then(|reduced| reduced.charts.get(taken)).filter(|_| taken > 0) {
            self.rate = counted(&chart.rate);
            if let Some(line) = self.formulation.iter_mut().find(|line| line.starts_with(ACCELERATIONS)) {
                *line = format!("Chart {taken} is taken first. {}", accelerations(chart));
            }
        }
        if !measures.is_empty() {
            let each: Vec<String> =
                measures.iter().enumerate().map(|(k, measure)| format!("{k}: {measure:.3}")).collect_vec();
            self.assembly.push(format!("measures of the charts at the start: {}", each.join(", ")));
        }
    }

    /// Lines for the documentation of the generated module.
    pub(crate) fn summary(&self) -> Vec<String> {
        let mut lines = vec![format!(
            "{} bodies, {} parts: {} coordinates, {} constraint rows, F = 3 N - M = {}.",
            self.bodies, self.parts, self.coordinates, self.constraints, self.freedom
        )];
        lines.push_all(self.formulation.iter().cloned());
        if !self.massless.is_empty() {
            let massless = self.massless.join("`, `");
            lines.push(format!(
                "Bodies without mass: `{massless}`; no energy, and no force that depends on their masses."
            ));
        }
        lines.push(format!("State: {} numbers, {} bytes in f64.", self.state, 8 * self.state));
        if self.constraints > 0 {
            let workspace = 8 * self.constraints * (self.coordinates + self.constraints);
            lines
                .push(format!("A solution by rank, where one is needed: {workspace} bytes of stack in f64."));
        }
        lines.push(format!("One right-hand side: {}.", self.rate));
        lines.push_all(self.repetitions());
        lines
    }

    /// Does the code have loops for what repeats itself?
    pub(crate) fn rerolls(&self) -> bool {
        match self.ordered {
            Some(ordered) => ordered == Repetitions::Rolled,
            None => self.rate.total() > self.most_unrolled(),
        }
    }

    fn most_unrolled(&self) -> usize {
        let [of_a_tree, of_all_else] = MOST_UNROLLED;
        if self.taken.number <= 2 { of_a_tree } else { of_all_else }
    }

    fn repetitions(&self) -> Option<String> {
        let why = match self.ordered {
            Some(_) => "as the declaration orders".to_owned(),
            None if self.rerolls() => {
                format!("since more than {} operations in a row are slower than loops", self.most_unrolled())
            }
            None => return None,
        };
        let code = if self.rerolls() { "what repeats itself in loops" } else { "without loops" };
        Some(format!("Code: {code}, {why}."))
    }
}

impl std::fmt::Display for Report {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "{}", self.name)?;
        for line in self.summary().iter().chain(&self.assembly) {
            writeln!(f, "  {line}")?;
        }
        for (name, count) in &self.functions {
            writeln!(f, "  {name}: {count}")?;
        }
        Ok(())
    }
}

/// The formulation, why it was taken, and which joints are compliant.
fn formulation(model: &Model, reduced: Option<&Reduced>, taken: &Taken) -> Vec<String> {
    let Taken { number, formulation, reason } = taken;
    let mut lines = match reduced {
        Some(reduced) => {
            let title = format!("Formulation {number}: {formulation}; {reason}.");
            [title].into_iter().chain(coordinates(reduced)).collect_vec()
        }
        None => vec![format!("Formulation {number}: {formulation}, because {reason}.")],
    };
    let mut giving: Vec<&str> =
        model.compliant.iter().map(|row| model.parts[row.part].name.text.as_str()).collect_vec();
    giving.dedup();
    if !giving.is_empty() {
        lines.push(format!("Forces of a compliance instead of constraints: {}.", giving.join(", ")));
    }
    lines
}

/// Number of the formulation, what the unknowns are, and why.
fn taken(model: &Model, reduced: Result<&Reduced, &str>) -> Taken {
    let joint_coordinates = "joint coordinates";
    let kept = match model.stabilisation {
        Stabilisation::Projection => "projection",
        Stabilisation::Baumgarte(_) => "Baumgarte's method",
    };
    let absolute = format!("absolute coordinates and multipliers, kept on the constraints by {kept}");
    let (number, formulation, reason) = match reduced {
        Err(reason) => (5, absolute.as_str(), reason),
        Ok(reduced) => match (reduced.has_loops(), reduced.freedom()) {
            (_, 0) => (1, "kinematics", "no freedom is left, and the motion follows from the time alone"),
            (false, _) => (2, joint_coordinates, "the joints make a tree, so that no constraint is left"),
            (true, _) if reduced.iterates() => (
                4,
                joint_coordinates,
                "loops that do not split are solved by Newton's iteration from the last state, in a fixed number of steps, so that no constraint is left",
            ),
            (true, _) => {
                (3, joint_coordinates, "the loops are solved in closed form, so that no constraint is left")
            }
        },
    };
    Taken { number, formulation: formulation.to_owned(), reason: reason.to_owned() }
}

/// Joint coordinates, chart by chart.
fn coordinates(reduced: &Reduced) -> Vec<String> {
    let mut lines = Vec::new();
    for (k, chart) in reduced.charts.iter().enumerate() {
        let label = if reduced.has_loops() { format!("Chart {k}") } else { "Coordinates".to_owned() };
        let names = if chart.names.is_empty() { "none".to_owned() } else { chart.names.join(", ") };
        let then = if chart.groups.is_empty() {
            String::new()
        } else {
            format!("; then {}", chart.groups.join("; "))
        };
        lines.push(format!("{label}: {names}{then}."));
    }
    if let Some(chart) = reduced.first().filter(|chart| !chart.names.is_empty()) {
        lines.push(accelerations(chart));
    }
    lines
}

const ACCELERATIONS: &str = "Accelerations by";

fn accelerations(chart: &Chart) -> String {
    format!("{ACCELERATIONS} {}.", chart.method)
}

/// The chart in which a run begins: the first if it is not flat at the start, else the best; as the runtime's
/// `charts::enter`.
fn taken_first(measures: &[f64]) -> usize {
    const FLAT: f64 = 0.3;
    let better = |best: usize, k: usize| if measures[k] > measures[best] { k } else { best };
    match measures.first() {
        Some(first) if *first < FLAT => (0..measures.len()).fold(0, better),
        _ => 0,
    }
}

fn counted(function: &Function) -> Count {
    algebra::count(&function.values())
}

/// How far each chart is from flat at the start: 1 at best, 0 where a loop lies in one line.
fn measures(reduced: Option<&Reduced>, values: &[(Expr, f64)]) -> Vec<f64> {
    let remembered = reduced
        .into_iter()
        .flat_map(|reduced| &reduced.charts)
        .filter_map(|chart| chart.remember_pose.as_ref());
    let squares = remembered.filter_map(|function| function.results.last());
    squares.map(|&(_, square)| value(square, values).max(0.0).sqrt()).collect_vec()
}

/// `forearm.angle: 0 deg moved by -25.7586 deg`.
fn moved(model: &Model, k: usize, start: f64, by: f64) -> String {
    let name = crate::formulate::coordinate_name(model, k);
    if k % 3 == 2 {
        format!("{name}: {:.4} deg moved by {:.4} deg", start * DEGREES, by * DEGREES)
    } else {
        format!("{name}: {start:.6} m moved by {by:.6} m")
    }
}

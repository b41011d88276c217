//! The linearised equations of a large tree: their coefficients as a function, their pattern as constants.

use super::bodies::{Shape, write};
use super::{Emission, Origin, push};
use crate::formulate::{Augmented, Part};

/// The type in which implicit methods keep the derivatives, and how they are found if not as a matrix.
pub(super) fn derivatives(emission: &Emission) -> (String, String) {
    let (length, _) = emission.state_length();
    let Some(augmented) = augmented(emission) else {
        return (format!("[[S; {length}]; {length}]"), String::new());
    };
    let form = format!(
        "rt::linalg::Sparse<S, Augmented, {}, {}, {}>",
        augmented.coefficients.results.len(),
        augmented.pattern.places.len(),
        augmented.pattern.pivots.len()
    );
    let differentiate = format!(
        "
        fn differentiate(
            &self,
            t: S,
            u: &Self::U,
            x: &[S; {length}],
            by_x: &mut Self::Derivatives,
            by_t: Option<&mut [S; {length}]>,
        ) -> rt::Health<S> {{
            let mut dx = [S::lit(0.0); {length}];
            let health = rt::lanes::Rate::rate(self, t, u, x, &mut dx);
            self.linearised(t, u, x, &dx, &mut by_x.coefficients);
            match by_t {{
                Some(by_t) => self.jvp(t, u, x, (S::lit(1.0), &[S::lit(0.0); {length}]), by_t),
                None => health,
            }}
        }}
"
    );
    (form, differentiate)
}

fn augmented<'a>(emission: &Emission<'a>) -> Option<&'a Augmented> {
    emission.reduced?.first()?.augmented.as_ref()
}

/// The coefficients and the pattern.
pub(super) fn emit(text: &mut String, emission: &Emission) {
    let inputs = emission.inputs("S");
    let Some(augmented) = augmented(emission) else { return };
    let (length, _) = emission.state_length();
    let count = augmented.coefficients.results.len();
    push(text, format_args!("    impl<S: Scalar> {}<S> {{\n", emission.name));
    write(
        text,
        emission,
        &augmented.coefficients,
        Origin::Chart(0),
        &Shape {
            docs: &[
                "The coefficients of the linearised equations before anything is eliminated; `dx` is the rate there.",
            ],
            attribute: "",
            signature: &format!(
                "fn linearised(&self, t: S, u: &{inputs}, x: &[S; {length}], dx: &[S; {length}], c: &mut [S; {count}])"
            ),
            arguments: &["t", "u", "x", "dx", "c"],
        },
    );
    text.push_str("    }\n\n");
    pattern(text, emission, augmented);
}

/// What stands where, and the order of elimination.
fn pattern(text: &mut String, emission: &Emission, augmented: &Augmented) {
    let Augmented { terms, pattern, .. } = augmented;
    let place = |row: usize, column: usize| pattern.places.get(&(row, column)).copied();
    let term = |term: &crate::formulate::Term| {
        let entry = place(term.row, term.column).unwrap_or_default();
        format!("t({}, {}, {}, {entry}, {})", term.coefficient, term.row, term.column, part(term.part))
    };
    let (mut pivots, mut below, mut right, mut targets) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for pivot in &pattern.pivots {
        let (first_below, first_right, first_target) = (below.len(), right.len(), targets.len());
        for &row in &pivot.below {
            let entry = place(row, pivot.row).unwrap_or_default();
            let across = place(pivot.row, row).map_or("u32::MAX".to_owned(), |across| across.to_string());
            below.push(format!("b({row}, {entry}, {across})"));
            let changed = pivot.right.iter().filter_map(|&column| place(row, column));
            targets.extend(changed.map(|target| target.to_string()));
        }
        for &column in &pivot.right {
            right.push(format!("[{column}, {}]", place(pivot.row, column).unwrap_or_default()));
        }
        pivots.push(format!(
            "p({}, {}, [{first_below}, {}], [{first_right}, {}], {first_target})",
            pivot.row,
            place(pivot.row, pivot.row).unwrap_or_default(),
            below.len(),
            right.len()
        ));
    }
    let freedom = emission.reduced.map_or(0, crate::formulate::Reduced::freedom);
    push(
        text,
        format_args!(
            "    /// Where the coefficients of the linearised equations stand, and how those are eliminated.
    #[derive(Clone, Copy, Debug)]
    pub struct Augmented;

    impl rt::linalg::Patterned for Augmented {{
        const PATTERN: rt::linalg::Pattern = {{
            use rt::linalg::Part::{{Acceleration as A, Position as P, Rate as R, Value as N, Velocity as V}};
            use rt::linalg::{{Below, Part, Pattern, Pivot, Term}};
            const fn t(coefficient: u32, row: u32, column: u32, entry: u32, part: Part) -> Term {{
                Term {{ coefficient, row, column, entry, part }}
            }}
            const fn p(row: u32, entry: u32, below: [u32; 2], right: [u32; 2], targets: u32) -> Pivot {{
                Pivot {{ row, entry, below, right, targets }}
            }}
            const fn b(row: u32, entry: u32, across: u32) -> Below {{
                Below {{ row, entry, across }}
            }}
            Pattern {{
                coordinates: {freedom},
                states: {},
                terms: const {{ &[{}] }},
                pivots: const {{ &[{}] }},
                below: const {{ &[{}] }},
                right: &[{}],
                targets: &[{}],
            }}
        }};
    }}

",
            emission.equations.x.len(),
            listed(&terms.iter().map(term).collect::<Vec<String>>()),
            listed(&pivots),
            listed(&below),
            listed(&right),
            listed(&targets),
        ),
    );
}

fn part(part: Part) -> char {
    match part {
        Part::Value => 'N',
        Part::Rate => 'R',
        Part::Position => 'P',
        Part::Velocity => 'V',
        Part::Acceleration => 'A',
    }
}

/// Entries of an array, some to a line.
fn listed(entries: &[String]) -> String {
    let lines: Vec<String> = entries.chunks(8).map(|chunk| chunk.join(", ")).collect();
    lines.join(",\n                ")
}

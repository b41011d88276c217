//! Symbols as they are drawn: a letter with what stands below it.

use crate::collect::CollectVec;
use plm_cas::Expr;

use crate::formulate::Textbook;
use crate::model::Model;

/// A symbol of a formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Name {
    /// A letter, the name of a Greek one, or a word.
    pub(super) base: String,
    /// A part, a body or a number.
    pub(super) below: Vec<String>,
    /// How many dots stand above it.
    pub(super) dots: usize,
}

/// Greek letters by their names.
pub(super) const GREEK: [(&str, char); 25] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ϵ'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'ϕ'),
    ("varphi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Omega", 'Ω'),
];

impl Name {
    /// The symbol of a path of the model: of `arm.angle` an angle of the arm, of `m_1` a mass with a number.
    fn of_path(path: &str) -> Name {
        let (owner, own) = path.rsplit_once('.').map_or((None, path), |(owner, own)| (Some(owner), own));
        let base = match own {
            "angle" => "varphi",
            "omega" => return Name { dots: 1, ..Name::of_path(&path.replace(".omega", ".angle")) },
            "displacement" => "s",
            other => other,
        };
        let (base, number) = base.split_once('_').map_or((base, None), |(base, rest)| (base, Some(rest)));
        let digits = base.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let (base, digit) = if digits.is_empty() { (base, "") } else { base.split_at(digits.len()) };
        let below = [number.unwrap_or_default(), digit, owner.unwrap_or_default()];
        let below = below.into_iter().filter(|part| !part.is_empty()).map(str::to_owned);
        Name { base: base.to_owned(), below: below.collect_vec(), dots: 0 }
    }

    /// The multiplier of a row of a part; its number where the part has several.
    pub(super) fn multiplier(part: &str, number: Option<usize>) -> Name {
        let number = number.map(|number| number.to_string());
        let below = [Some(part.to_owned()), number].into_iter().flatten();
        Name { base: "lambda".to_owned(), below: below.collect_vec(), dots: 0 }
    }

    pub(super) fn dotted(&self, dots: usize) -> Name {
        Name { dots: self.dots + dots, ..self.clone() }
    }
}

/// Symbols that are not drawn by the names of the graph.
pub(super) struct Names {
    known: Vec<(Expr, Name)>,
}

impl Names {
    pub(super) fn new(model: &Model, all: &Textbook) -> Names {
        let mut known = vec![(model.time, Name { base: "t".to_owned(), below: Vec::new(), dots: 0 })];
        for ((path, &value), &rate) in all.names.iter().zip(&all.value).zip(&all.rate) {
            let name = Name::of_path(path);
            known.push((rate, name.dotted(1)));
            known.push((value, name));
        }
        Names { known }
    }

    pub(super) fn of(&self, symbol: Expr) -> Name {
        match self.known.iter().find(|(own, _)| *own == symbol) {
            Some((_, name)) => name.clone(),
            None => Name::of_path(&symbol.name().unwrap_or_else(|| "c".to_owned())),
        }
    }
}

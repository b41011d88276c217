//! Bindings of the symbols of the model: the text by which an emitted function reads each.

use super::Emission;
use super::contract::contact_sliding;
use super::lower::Bindings;
use crate::collect::CollectVec;
use crate::model::ContactMode;
pub(super) use crate::source::Origin;
use crate::source::{OfScalar, Source, Symbols};

impl Emission<'_> {
    /// Source text of the parameters, where `self` is the mechanism.
    pub(super) fn parameters(&self) -> Bindings {
        let params = self.model.params.iter().zip(&self.fields.params);
        params.map(|(param, field)| (param.symbol, format!("self.{field}"))).collect()
    }

    /// Source text of every symbol.
    pub(super) fn bindings(&self, origin: Origin) -> Bindings {
        let &Emission { model, equations, program: absolute, .. } = self;
        let symbols = Symbols { model, equations, absolute, reduced: self.reduced };
        let mut places = symbols.of(origin);
        for (symbols, array) in contact_sliding::symbols(self) {
            for (k, &symbol) in symbols.iter().enumerate() {
                places.push((symbol, Source::Element(array, k)));
            }
        }
        let of_state = matches!(origin, Origin::State);
        let texts = places.into_iter().map(|(symbol, source)| (symbol, self.place_in_rust(source, of_state)));
        Bindings::of(texts.collect_vec())
    }

    /// Source text of a place; `of_state` where `self` is a `State`.
    fn place_in_rust(&self, source: Source, of_state: bool) -> String {
        let Emission { fields, .. } = self;
        let [mechanism, held, time] =
            if of_state { ["self.mechanism", "self.held", "self.time"] } else { ["self", "u", "t"] };
        match source {
            Source::Time => time.to_owned(),
            Source::Parameter(k) => format!("{mechanism}.{}", fields.params[k]),
            Source::Input(k) => format!("{held}.input.{}", fields.inputs[k]),
            Source::Switch(k) => format!("{held}.switches[{k}]"),
            Source::Turns(k) => format!("S::of_turns({held}.turns[{k}])"),
            Source::Multiplier(k) if of_state => format!("contact[{k}]"),
            Source::Multiplier(k) => format!("u.contact.lambda[{k}]"),
            Source::Mode(k, mode) => {
                let does = match mode {
                    ContactMode::Open => "is_open",
                    ContactMode::Sticking => "is_sticking",
                };
                format!("S::lit({held}.contact.modes.{does}({k}) as u8 as f64)")
            }
            Source::Scalar(number) => {
                let name = match number {
                    OfScalar::MostGrowth => "MOST_GROWTH",
                    OfScalar::Agreement => "AGREEMENT",
                    OfScalar::Precision => "PRECISION",
                };
                format!("lit(S::{name})")
            }
            Source::Remembered(k) => {
                let paths = self.reduced.and_then(|reduced| reduced.memory.get(k));
                paths.map(|(_, path)| format!("m.{path}")).unwrap_or_default()
            }
            Source::Element("x", k) if of_state => format!("self.x[{k}]"),
            Source::Element(array, k) => format!("{array}[{k}]"),
            Source::Number(name) => name.to_owned(),
        }
    }
}

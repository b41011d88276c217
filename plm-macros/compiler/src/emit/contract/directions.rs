//! In which directions dual numbers differentiate the rate.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::{Emission, Form, Sizes, number};
use super::contact;
use crate::formulate::{Chart, Reads};

/// Directions that one evaluation has at most; no more, so that what belongs to a number stays in a few registers.
const MOST: usize = 4;

/// The full matrix where implicit methods take it by dual numbers, in the directions that it needs; none where it is one
/// direction for each column, four at once.
pub(super) fn directions(emission: &Emission) -> Option<TokenStream> {
    // What solves for contact forces reads more than the rate by itself.
    if emission.sparse().is_some() || contact::are_there(emission) {
        return None;
    }
    let colours = reads(emission)?.colours();
    let passes = colours.count.div_ceil(MOST).max(1);
    let at_once = colours.count.div_ceil(passes).max(1);
    let knows_time = emission.rate_knows_time();
    if colours.of_columns.is_empty() || !colours.save() && at_once == MOST {
        return None;
    }
    let Sizes { length, .. } = &emission.sizes;
    let (count, at_once) = (number(colours.count), number(at_once));
    let list = |columns: &[Option<usize>], none: usize| {
        emission.list(columns.iter().map(|column| column.unwrap_or(none).to_string()))
    };
    let of_columns = list(&colours.of_columns, colours.count);
    let none = colours.of_columns.len();
    let columns = colours.columns.iter().map(|columns| list(columns, none)).collect_vec();
    Some(quote! {
        fn jacobian(
            &self,
            t: S,
            u: &Self::U,
            x: &[S; #length],
            by_x: &mut [[S; #length]; #length],
            by_t: Option<&mut [S; #length]>,
        ) -> rt::Health<S> {
            let colours = rt::linear::Colours::<#length, #count> {
                of_columns: [#of_columns],
                columns: [#([#columns],)*],
                knows_time: #knows_time,
            };
            rt::linear::by_directions::<Self, #at_once, #length, #count>(self, (t, u, x), &colours, by_x, by_t)
        }
    })
}

/// Reads of the rate, in all charts together.
fn reads(emission: &Emission) -> Option<Reads> {
    let first_order = &emission.equations.x;
    let of_chart = |chart: &Chart| Reads::of(&chart.rate, [&chart.y, &chart.y_dot, first_order]);
    match emission.form {
        Form::Absolute => {
            let equations = emission.equations;
            Some(Reads::of(&emission.program.dynamics, [&equations.q, &equations.v, first_order]))
        }
        Form::Tree(chart) => Some(of_chart(chart)),
        Form::Loops(reduced) => {
            let charts = reduced.charts.iter().map(of_chart);
            charts.reduce(|reads, other| reads.joined(&other))
        }
    }
}

//! Whole turns that are counted: where their angles stand, and where they are brought back.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use proc_macro2::TokenStream;

use super::super::{Emission, Form, Sizes, number, table_compression};
use crate::formulate::Reduced;

/// Is anything counted?
pub(in super::super) fn are_counted(emission: &Emission) -> bool {
    !emission.model.turns.is_empty()
}

/// By count, the places in a list of what belongs to its `bodies`.
fn places<'a>(emission: &'a Emission, bodies: &'a [Option<usize>]) -> impl Iterator<Item = String> + 'a {
    emission.model.turns.iter().map(move |counted| {
        let of_count = |body: &Option<usize>| body.is_some_and(|body| counted.bodies.contains(&body));
        let places = bodies.iter().enumerate().filter(|(_, body)| of_count(body));
        let places: Vec<String> = places.map(|(place, _)| place.to_string()).collect_vec();
        format!("&[{}]", places.join(", "))
    })
}

/// By count, the places in a list of what belongs to its `bodies`: a reference to an array.
fn all_places(emission: &Emission, bodies: &[Option<usize>]) -> TokenStream {
    let turns = &emission.model.turns;
    let all = table_compression::is_long(turns.len()).then(|| in_short(emission, bodies)).flatten();
    all.unwrap_or_else(|| {
        let places = emission.list(places(emission, bodies));
        quote!(&[#places])
    })
}

/// Places in short form where each count has one place, all of them equally far apart.
fn in_short(emission: &Emission, bodies: &[Option<usize>]) -> Option<TokenStream> {
    let turns = &emission.model.turns;
    let mut place_of = vec![None; emission.model.bodies.len()];
    for (place, body) in bodies.iter().enumerate() {
        if let Some(body) = body
            && place_of[*body].replace(place).is_some()
        {
            return None;
        }
    }
    let places = turns.iter().map(|counted| match counted.bodies[..] {
        [body] => place_of[body],
        _ => None,
    });
    let places = places.collect::<Option<Vec<usize>>>()?;
    let (first, step) = (*places.first()?, places.get(1)?.checked_sub(places[0])?);
    let is_even = places.iter().zip(0..).all(|(place, k)| *place == first + step * k);
    let [first, step, count] = [first, step, places.len()].map_each(number);
    is_even.then(|| {
        quote!(const {
            &rt::compact::singles::<#count>(const { &rt::compact::places::<#count>(#first, #step) })
        })
    })
}

/// By count, the places of its angles in the pose of all bodies: a reference to an array.
pub(in super::super) fn in_pose(emission: &Emission) -> TokenStream {
    let of_pose = |k: usize| (k % 3 == 2).then_some(k / 3);
    let bodies: Vec<Option<usize>> = (0..emission.equations.q.len()).map(of_pose).collect_vec();
    all_places(emission, &bodies)
}

/// By count, the places of its angles in the state; not of loops, which have other coordinates in each chart.
fn in_state(emission: &Emission) -> Option<TokenStream> {
    let Form::Tree(chart) = emission.form else {
        return (!emission.is_reduced()).then(|| in_pose(emission));
    };
    Some(all_places(emission, &chart.turning))
}

/// `update` and `is_settled` of what has no charts.
pub(super) fn update(emission: &Emission) -> Option<TokenStream> {
    let Sizes { length, .. } = &emission.sizes;
    let (Form::Tree(_) | Form::Absolute) = emission.form else { return None };
    let Some(places) = are_counted(emission).then(|| in_state(emission)).flatten() else {
        return Some(quote! {
            #[inline]
            fn is_settled(&self, _t: S, _u: &Self::U, _x: &[S; #length]) -> bool {
                true
            }
        });
    };
    Some(quote! {
        #[inline]
        fn is_settled(&self, _t: S, _u: &Self::U, x: &[S; #length]) -> bool {
            !rt::turns::are_due(x, #places)
        }

        #[inline]
        fn update(&self, _t: S, u: &mut Self::U, x: &mut [S; #length]) -> Result<rt::Updated, Fault> {
            let turned = rt::turns::unwind(&mut u.turns, x, #places);
            Ok(rt::Updated { turned, ..Default::default() })
        }
    })
}

/// The condition that no angle is to be brought back at states side by side; not of loops.
pub(super) fn are_near(emission: &Emission) -> TokenStream {
    match in_state(emission) {
        Some(places) if are_counted(emission) => quote!(rt::turns::all_near(x, #places)),
        _ => quote!(T::lit(1.0)),
    }
}

/// By count, its angles in charts.
pub(super) fn of_charts(emission: &Emission, reduced: &Reduced) -> TokenStream {
    let of_all = |bodies: &[Option<usize>]| places(emission, bodies).collect_vec();
    let charts: Vec<Vec<String>> = reduced.charts.iter().map(|chart| of_all(&chart.turning)).collect_vec();
    let remembered: Vec<Option<usize>> = reduced.turning.iter().copied().map(Some).collect_vec();
    let followed: Vec<Option<usize>> = reduced.followed.iter().map(|(_, body)| *body).collect_vec();
    let (remembered, followed) = (of_all(&remembered), of_all(&followed));
    let counted = (0..emission.model.turns.len()).map(|k| {
        let coordinates: Vec<&str> = charts.iter().map(|places| places[k].as_str()).collect_vec();
        format!(
            "rt::charts::Revolutions {{ coordinates: &[{}], angles: {}, iterated: {} }}",
            coordinates.join(", "),
            remembered[k],
            followed[k]
        )
    });
    emission.lines(counted)
}

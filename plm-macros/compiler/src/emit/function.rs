//! The straight-line functions of a mechanism.

use crate::collect::CollectVec;
use crate::emit::template::{joined, quote};
use plm_cas::Expr;
use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::format_ident;

use super::bindings::Origin;
use super::contract::contact;
use super::contract::rate::is_short;
use super::{Emission, Form, Sizes, docs, lower, memory, number};
use crate::formulate::{Chart, Function, Reduced};
use crate::model::Step;

/// A straight-line function: its documentation, what stands before its body, what it computes and from what.
pub(super) fn function(
    emission: &Emission,
    docs: &str,
    signature: &TokenStream,
    (function, origin): (&Function, Origin),
) -> TokenStream {
    let arguments = arguments(signature);
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect_vec();
    let (docs, body) = body(emission, docs, &arguments, (function, origin));
    quote! {
        #docs
        #signature {
            #body
        }
    }
}

/// The documentation of a straight-line function of these arguments, with its operations, and its body.
pub(super) fn body(
    emission: &Emission,
    docs: &str,
    arguments: &[&str],
    (function, origin): (&Function, Origin),
) -> (TokenStream, TokenStream) {
    let reserved = [arguments, &["lit", "by"]].concat();
    let direct: Option<Vec<Expr>> = match origin {
        Origin::Rate(chart) => Some(direct_angles(chart).map(|(_, angle)| angle).collect_vec()),
        _ => None,
    };
    let (direct, rerolled) = (direct.as_deref(), emission.rerolled);
    let around = lower::Around { reserved: &reserved, by_reference: true, scalar: "S", direct, rerolled };
    let (body, count) = lower::statements(function, &emission.bindings(origin), &around);
    let count = if count.total() > 0 { format!("\n\n{count}.") } else { String::new() };
    (docs::docs(emission, &format!("{docs}{count}")), emission.text(body))
}

/// Names of the arguments of a function.
fn arguments(signature: &TokenStream) -> Vec<String> {
    let is_list =
        |tree: &TokenTree| matches!(tree, TokenTree::Group(of) if of.delimiter() == Delimiter::Parenthesis);
    let Some(TokenTree::Group(list)) = signature.clone().into_iter().find(is_list) else { return Vec::new() };
    let trees: Vec<TokenTree> = list.stream().into_iter().collect_vec();
    let named = trees.windows(2).filter_map(|two| match two {
        [TokenTree::Ident(name), TokenTree::Punct(mark)]
            if mark.as_char() == ':' && mark.spacing() == Spacing::Alone =>
        {
            Some(name.to_string())
        }
        _ => None,
    });
    named.collect_vec()
}

/// The equations of motion in absolute coordinates, and what the rank-revealing fallback needs.
pub(super) fn dynamics(emission: &Emission) -> TokenStream {
    let Emission { name, program, sizes: Sizes { nq, nc, nx, full, .. }, .. } = emission;
    if emission.reactions().is_some() {
        return TokenStream::new();
    }
    let state = quote!(t: S, u: &Held<S>, x: &[S; #full]);
    let dynamics = function(
        emission,
        "The right-hand side and the multipliers: `M a + phi_q^T lambda = Q`, `phi_q a = gamma`.
Returns the smallest pivot ratio of the factorisation.",
        &quote! {
            #[inline(always)]
            fn dynamics(&self, #state, dx: &mut [S; #full], lambda: &mut [S; #nc]) -> S
        },
        (&program.dynamics, Origin::Arguments),
    );
    let free = function(
        emission,
        "Applied forces `Q` (N, N, N m per body) and `gamma`, for the rank-revealing solution.",
        &quote! {
            #[cold]
            fn free(&self, #state, force: &mut [S; #nq], gamma: &mut [S; #nc])
        },
        (&program.free, Origin::Arguments),
    );
    let x_dot = (!emission.equations.x.is_empty()).then(|| {
        function(
            emission,
            "Rates of the first-order states.",
            &quote! {
                #[cold]
                fn x_dot(&self, #state, x_dot: &mut [S; #nx])
            },
            (&program.x_dot, Origin::Arguments),
        )
    });
    let of_state = (&program.guards, Origin::Arguments);
    let switching = (!matches!(emission.form, Form::Tree(_)))
        .then(|| switching(emission, &quote!(switching), &state, of_state));
    quote! {
        impl<S: Scalar> #name<S> {
            #dynamics
            #free
            #x_dot
            #switching
        }
    }
}

/// How far the conditions are from switching.
fn switching(
    emission: &Emission,
    name: &TokenStream,
    state: &TokenStream,
    guards: (&Function, Origin),
) -> TokenStream {
    let (count, Sizes { nq, nc, .. }) = (number(emission.model.watched()), &emission.sizes);
    let solution = emission.events_read_solution().then(|| quote!(a: &[S; #nq], lambda: &[S; #nc],));
    if emission.model.watched() == 0 {
        return TokenStream::new();
    }
    function(
        emission,
        "How far every condition is from switching: positive while the side that is held applies; then what bends where it passes zero.",
        &quote!(fn #name(&self, #state, #solution g: &mut [S; #count])),
        guards,
    )
}

/// The right-hand side in joint coordinates, and the way to those of all bodies and back.
pub(super) fn motion(emission: &Emission) -> TokenStream {
    let name = &emission.name;
    let functions = match emission.form {
        Form::Absolute => return TokenStream::new(),
        Form::Tree(chart) => tree(emission, chart),
        Form::Loops(reduced) => {
            let charts = reduced.charts.iter().enumerate();
            joined(charts.map(|(index, chart)| in_chart(emission, reduced, (index, chart))).collect_vec())
        }
    };
    quote!(impl<S: Scalar> #name<S> { #functions })
}

fn tree(emission: &Emission, chart: &Chart) -> TokenStream {
    let Sizes { nq, nc, length, .. } = &emission.sizes;
    let state = quote!(t: S, u: &Held<S>, x: &[S; #length]);
    let origin = Origin::Chart(chart);
    let direct = is_straight(emission).then(|| quote!(<const DIRECT: bool>));
    let of_rate = if direct.is_some() { Origin::Rate(chart) } else { origin };
    let motion = function(
        emission,
        "The right-hand side in joint coordinates.",
        &quote! {
            #[inline(always)]
            fn motion #direct(&self, #state, dx: &mut [S; #length])
        },
        (&chart.rate, of_rate),
    );
    let pose = function(
        emission,
        POSE,
        &quote! {
            #[inline]
            fn pose(&self, #state, q: &mut [S; #nq], v: &mut [S; #nq])
        },
        (&chart.pose, origin),
    );
    let reactions = chart.reactions.as_ref().filter(|_| emission.reads_solution()).map(|reactions| {
        function(
            emission,
            "Accelerations of every body, and the multipliers: `M a + phi_q^T lambda = Q`.",
            &quote! {
                #[inline]
                fn reactions(&self, #state, a: &mut [S; #nq], lambda: &mut [S; #nc])
            },
            (reactions, origin),
        )
    });
    let project = projection(emission, &quote!(to_chart), chart);
    let switching = switching(emission, &quote!(switching), &state, (&chart.guards, origin));
    quote!(#motion #pose #reactions #project #switching)
}

/// Is a step by itself one straight line, in the first chart? Its stages have copies of the rate, which is a function
/// `<const DIRECT: bool>`: of angles in the state whose sines and cosines need no branch, and of loops that are closed.
pub(super) fn is_straight(emission: &Emission) -> bool {
    let is_reduced = !matches!(emission.form, Form::Absolute);
    !contact::are_there(emission)
        && is_reduced
        && emission.model.steps.contains(&Step::Rk4)
        && is_short(emission)
}

/// The coordinates that are angles, by their places in the state: `DIRECT` tells of these.
pub(super) fn direct_angles(chart: &Chart) -> impl Iterator<Item = (usize, Expr)> {
    let all = chart.y.iter().copied().enumerate().zip(&chart.turning);
    all.filter_map(|(place, body)| body.map(|_| place))
}

const POSE: &str = "Pose and velocity of every body: m, m, rad; m/s, m/s, rad/s.";

/// The coordinates of a chart at a pose.
fn projection(emission: &Emission, name: &TokenStream, chart: &Chart) -> TokenStream {
    let Sizes { nq, length, .. } = &emission.sizes;
    function(
        emission,
        "The joint coordinates and their rates at a pose that closes the joints.",
        &quote!(fn #name(&self, t: S, q: &[S; #nq], v: &[S; #nq], x: &mut [S; #length])),
        (&chart.from_pose, Origin::Pose),
    )
}

fn in_chart(emission: &Emission, reduced: &Reduced, (index, chart): (usize, &Chart)) -> TokenStream {
    let Sizes { nq, length, .. } = &emission.sizes;
    let memory = memory(reduced, &quote!(S));
    let state = quote!(t: S, u: &Held<S>, m: &#memory, x: &[S; #length]);
    let origin = Origin::Chart(chart);
    let named = |function: &str| {
        let name = format_ident!("{function}_{index}");
        quote!(#name)
    };
    // The first chart is the one that runs, the others hardly ever do.
    let attribute = if index == 0 { quote!(#[inline(always)]) } else { quote!(#[inline(never)]) };
    let name = named("motion");
    let direct = (index == 0 && is_straight(emission)).then(|| quote!(<const DIRECT: bool>));
    let of_rate = if direct.is_some() { Origin::Rate(chart) } else { origin };
    let motion = function(
        emission,
        &format!(
            "The right-hand side in the coordinates {}.\nReturns the smallest square of a dyad's measure.",
            chart.names.join(", ")
        ),
        &quote!(#attribute fn #name #direct(&self, #state, dx: &mut [S; #length]) -> S),
        (&chart.rate, of_rate),
    );
    let name = named("pose");
    let pose = function(
        emission,
        POSE,
        &quote!(fn #name(&self, #state, q: &mut [S; #nq], v: &mut [S; #nq]) -> S),
        (&chart.pose, origin),
    );
    let switching = switching(emission, &named("switching"), &state, (&chart.guards, origin));
    let project = projection(emission, &named("to_chart"), chart);
    let name = named("remember");
    let remember = chart.remember.as_ref().map(|remember| {
        function(
            emission,
            "What is to be remembered of a state, and the smallest square of a dyad's measure.",
            &quote!(fn #name(&self, #state, memory: &mut #memory) -> S),
            (remember, origin),
        )
    });
    let name = named("remember_pose");
    let remember_pose = chart.remember_pose.as_ref().map(|remember_pose| {
        function(
            emission,
            "The same of a pose and velocity.",
            &quote! {
                #[cold]
                fn #name(&self, t: S, q: &[S; #nq], v: &[S; #nq], memory: &mut #memory) -> S
            },
            (remember_pose, Origin::Pose),
        )
    });
    let name = named("jacobian");
    let jacobian = chart.jacobian.as_ref().filter(|_| reduced.has_jacobian());
    let jacobian = jacobian.map(|jacobian| {
        function(
            emission,
            "The derivatives of the rate by the state; `dx` is the rate there.",
            &quote!(fn #name(&self, #state, dx: &[S; #length], by_x: &mut [[S; #length]; #length])),
            (&jacobian.entries, origin),
        )
    });
    quote!(#motion #pose #switching #project #remember #remember_pose #jacobian)
}

/// When conditions on the time alone change.
pub(super) fn instants(emission: &Emission) -> TokenStream {
    let Emission { model, name, program, .. } = emission;
    let count = model.switches.len() - model.guards();
    if count == 0 {
        return TokenStream::new();
    }
    let count = number(count);
    let instants = function(
        emission,
        "Times at which conditions change, s, and the slope of what they compare.",
        &quote! {
            #[cold]
            fn instants(&self, u: &Held<S>, at: &mut [S; #count], slope: &mut [S; #count])
        },
        (&program.instants, Origin::Arguments),
    );
    quote!(impl<S: Scalar> #name<S> { #instants })
}

//! The catalogue of methods by name.
//!
//! The enumerations of C, of the command line and of Python are made of this one list.

/// Calls the macro `$with` with the catalogue, after the tokens that stand after its name here.
///
/// First come the methods with error control, then those with fixed steps. A row has the name and, in brackets, the number in saved runs
/// and in C, the name of that number in C after `PLM_`, the type for a mechanism `M`, the type as a text for numbers `REAL` of a mechanism
/// `OWN`, the usual relative tolerance of a method that has one, a link for documentation, and a description of the method. Numbers are
/// never reused: a new method takes the next one.
#[macro_export]
#[doc(hidden)]
macro_rules! methods {
    ($with:ident $($before:tt)*) => {
        $with! {
            $($before)*
            by_error {
                Dop853 (0, "DOP853", $crate::method::Dop853<M>, "Dop853<OWN>", 1e-9,
                    "[`Dop853`](plm_runtime::method::Dop853)", "order 8, steps by their error")
                Vern9 (1, "VERN9", $crate::method::Vern9<M>, "Vern9<OWN>", 1e-9,
                    "[`Vern9`](plm_runtime::method::Vern9)", "order 9, steps by their error")
                Adams (2, "ADAMS", $crate::method::Adams<M>, "Adams<OWN>", 1e-9,
                    "[`Adams`](plm_runtime::method::Adams)", "order 1 to 13, steps by their error")
                Dopri5 (3, "DOPRI5", $crate::method::Dopri5<M>, "Dopri5<OWN>", 1e-8,
                    "[`Dopri5`](plm_runtime::method::Dopri5)", "order 5, steps by their error")
                RadauIia5 (4, "RADAU_IIA5", $crate::method::RadauIia5<M>, "RadauIia5<OWN>", 1e-8,
                    "[`RadauIia5`](plm_runtime::method::RadauIia5)",
                    "order 5, steps by their error, for what is stiff")
            }
            of_length {
                Rk4 (5, "RK4", $crate::method::Rk4<M::S>, "Rk4<REAL>",
                    "[`Rk4`](plm_runtime::method::Rk4)", "order 4, steps of fixed length")
                SemiImplicitEuler (6, "SEMI_IMPLICIT_EULER", $crate::method::SemiImplicitEuler<M::S>,
                    "SemiImplicitEuler<REAL>",
                    "[`SemiImplicitEuler`](plm_runtime::method::SemiImplicitEuler)",
                    "order 1, steps of fixed length")
                Gauss2 (7, "GAUSS2", $crate::method::Gauss<M, 2>, "Gauss<OWN, 2>",
                    "[`Gauss`](plm_runtime::method::Gauss) of two stages",
                    "order 4, symplectic, steps of fixed length")
                Gauss3 (8, "GAUSS3", $crate::method::Gauss<M, 3>, "Gauss<OWN, 3>",
                    "[`Gauss`](plm_runtime::method::Gauss) of three stages",
                    "order 6, symplectic, steps of fixed length")
                Ros34Pw2 (9, "ROS34PW2", $crate::method::Ros34Pw2<M::S>, "Ros34Pw2<REAL>",
                    "[`Ros34Pw2`](plm_runtime::method::Ros34Pw2)",
                    "order 3, steps of fixed length, for what is stiff")
                MoreauJean (10, "MOREAU_JEAN", $crate::method::MoreauJean<M::S>, "MoreauJean<REAL>",
                    "[`MoreauJean`](plm_runtime::method::MoreauJean)",
                    "order 1, steps of fixed length over impacts and friction")
            }
        }
    };
}

//! Rules of the constructors, as data: the list that the documentation shows and that the tests apply.
//!
//! The algebra is that of the real numbers. A rule that is wrong somewhere in f64 says where it is right. Two
//! conventions follow from the conditions: a zero coefficient removes its term even if the rest could become
//! infinite, and a factor cancels against its inverse although the quotient has no value where it is zero.

/// Condition under which a rule is true in f64, up to rounding, overflow and the sign of zeros. All but `Always`
/// require finite variables; what they require beyond that concerns `x`, the first variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Condition {
    /// Everywhere, infinities and NaN included.
    Always,
    /// All variables are finite.
    Finite,
    /// x != 0.
    NonZero,
    /// x >= 0.
    NonNegative,
    /// x > 0.
    Positive,
    /// |x| <= 1.
    WithinOne,
}

impl Condition {
    /// Does it hold for these variables, `x` being the first?
    pub fn holds(self, variables: &[f64]) -> bool {
        let x = variables.first().copied().unwrap_or(0.0);
        let finite = variables.iter().all(|v| v.is_finite());
        match self {
            Self::Always => true,
            Self::Finite => finite,
            Self::NonZero => finite && x != 0.0,
            Self::NonNegative => finite && x >= 0.0,
            Self::Positive => finite && x > 0.0,
            Self::WithinOne => finite && x.abs() <= 1.0,
        }
    }
}

/// One step of simplification, in the notation of [`parse_sexpr`](crate::Graph::parse_sexpr).
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    /// Its name.
    pub name: &'static str,
    /// The expression before.
    pub pattern: &'static str,
    /// The expression after.
    pub result: &'static str,
    /// Condition under which both have the same value.
    pub condition: Condition,
}

use Condition::{Always, Finite, NonNegative, NonZero, Positive, WithinOne};

const fn rule(name: &'static str, pattern: &'static str, result: &'static str, condition: Condition) -> Rule {
    Rule { name, pattern, result, condition }
}

/// Every rule, grouped by what it is about. The symbols x, y, z ascend.
pub const RULES: &[Rule] = &[
    // Sums
    rule("zero term", "(+ x 0)", "x", Always),
    rule("constants fold", "(+ 1/2 1/3)", "5/6", Always),
    rule("like terms", "(+ x x)", "(* 2 x)", Always),
    rule("like coefficients", "(+ (* 2 x) (* 3 x))", "(* 5 x)", Always),
    rule("cancelled term", "(- x x)", "0", Finite),
    rule("nested sums", "(+ x (+ y (- z x)))", "(+ y z)", Finite),
    rule("common sign", "(- (- x) y)", "(* -1 (+ x y))", Always),
    rule("turned difference", "(- y x)", "(* -1 (- x y))", Always),
    rule("common magnitude", "(- (* 3 x) (* 3 y))", "(* 3 (- x y))", Always),
    rule("sum of scaled sums", "(+ x (* 2 (+ x y)))", "(+ (* 3 x) (* 2 y))", Always),
    // Products
    rule("zero factor", "(* 0 x)", "0", Finite),
    rule("unit factor", "(* 1 x)", "x", Always),
    rule("number in front", "(* (* 2 x) (* 3 y))", "(* 6 x y)", Always),
    rule("nested products", "(* x (* y z))", "(* z y x)", Always),
    rule("signs of factors", "(* (- x y) (- y x))", "(* -1 (^ (- x y) 2))", Always),
    rule("powers of one base", "(* (^ x 2) (^ x 3))", "(^ x 5)", Always),
    rule("power of a power", "(^ (^ x 2) 3)", "(^ x 6)", Always),
    rule("power of a product", "(^ (* x y) 2)", "(* (^ x 2) (^ y 2))", Always),
    rule("zeroth power", "(^ x 0)", "1", Always),
    rule("quotient of equals", "(/ x x)", "1", NonZero),
    rule("cancelled factor", "(/ (* x y) x)", "y", NonZero),
    rule("cancelled power", "(/ (^ x 3) x)", "(^ x 2)", NonZero),
    rule("inverse of an inverse", "(/ 1 (/ 1 x))", "x", NonZero),
    // Trigonometry
    rule("sine of a negative", "(sin (- x))", "(- (sin x))", Always),
    rule("cosine of a negative", "(cos (- x))", "(cos x)", Always),
    rule("sine, a quarter turn on", "(sin (+ x (* 1/2 pi)))", "(cos x)", Always),
    rule("cosine, a quarter turn on", "(cos (+ x (* 1/2 pi)))", "(- (sin x))", Always),
    rule("quarter turns and several terms", "(cos (+ x (- y pi)))", "(- (cos (+ x y)))", Always),
    rule("sine, a constant angle on", "(sin (+ x 1))", "(+ (* (cos 1) (sin x)) (* (sin 1) (cos x)))", Always),
    rule(
        "cosine, a constant angle on",
        "(cos (- x 1))",
        "(+ (* (cos 1) (cos x)) (* (sin 1) (sin x)))",
        Always,
    ),
    rule("sine of a twelfth", "(sin (* 1/6 pi))", "1/2", Always),
    rule("cosine of a sixth", "(cos (* 1/3 pi))", "1/2", Always),
    rule("sine of half turns", "(sin (* 7 pi))", "0", Always),
    rule("Pythagoras", "(+ (^ (sin x) 2) (^ (cos x) 2))", "1", Finite),
    rule("Pythagoras, scaled", "(+ (* 3 y (^ (sin x) 2)) (* 3 y (^ (cos x) 2)))", "(* 3 y)", Finite),
    rule(
        "Pythagoras, repeated",
        "(+ (^ (sin x) 4) (* (^ (sin x) 2) (^ (cos x) 2)))",
        "(^ (sin x) 2)",
        Always,
    ),
    rule("tangent", "(tan x)", "(/ (sin x) (cos x))", Always),
    rule("sine of the arc sine", "(sin (asin x))", "x", WithinOne),
    rule("cosine of the arc cosine", "(cos (acos x))", "x", WithinOne),
    rule("arc sine of a negative", "(asin (- x))", "(- (asin x))", Always),
    rule("arc sine of a half", "(asin 1/2)", "(* 1/6 pi)", Always),
    rule("arc cosine of a half", "(acos -1/2)", "(* 2/3 pi)", Always),
    rule("angle of a diagonal", "(atan2 2 -2)", "(* 3/4 pi)", Always),
    // Roots, exponentials
    rule("root of a square number", "(sqrt 4/9)", "2/3", Always),
    rule("square factor of a root", "(sqrt (* 4 x))", "(* 2 (sqrt x))", Always),
    rule("square of a root", "(^ (sqrt x) 2)", "x", NonNegative),
    rule("odd power of a root", "(^ (sqrt x) 3)", "(* x (sqrt x))", Always),
    rule("inverse square of a root", "(^ (sqrt x) -2)", "(/ 1 x)", Positive),
    rule("root of a square", "(sqrt (^ x 2))", "(abs x)", Always),
    rule("root of squares", "(sqrt (* 9 (^ x 2) (^ y 4)))", "(* 3 (abs x) (^ y 2))", Always),
    rule("exponential of a logarithm", "(exp (ln x))", "x", Positive),
    rule("logarithm of an exponential", "(ln (exp x))", "x", Always),
    rule("exponential of zero", "(exp 0)", "1", Always),
    rule("logarithm of one", "(ln 1)", "0", Always),
    // Magnitude, sign, order
    rule("magnitude of a multiple", "(abs (* -3 x))", "(* 3 (abs x))", Always),
    rule("magnitude of a magnitude", "(abs (abs x))", "(abs x)", Always),
    rule("magnitude of an even power", "(abs (^ x 2))", "(^ x 2)", Always),
    rule("magnitude of a product", "(abs (* x (^ y 2) (exp z)))", "(* (abs x) (^ y 2) (exp z))", Always),
    rule("magnitude of a root", "(abs (sqrt x))", "(sqrt x)", Always),
    rule("magnitude of an exponential", "(abs (exp x))", "(exp x)", Always),
    rule("even power of a magnitude", "(^ (abs x) 3)", "(* (^ x 2) (abs x))", Always),
    rule("inverse square of a magnitude", "(^ (abs x) -2)", "(/ 1 (^ x 2))", Always),
    rule("sign of a multiple", "(sign (* -2 x))", "(- (sign x))", Always),
    rule("sign of a sign", "(sign (sign x))", "(sign x)", Always),
    rule("minimum of equals", "(min x x)", "x", Always),
    rule("maximum of equals", "(max x x)", "x", Always),
    rule("order in a minimum", "(min y x)", "(min x y)", Finite),
    rule("order in a maximum", "(max y x)", "(max x y)", Finite),
    rule("minimum of constants", "(min 2 1)", "1", Always),
    rule("nothing is less than itself", "(if (< x x) y z)", "z", Always),
    rule("known condition", "(if (< 1 2) x y)", "x", Always),
    rule("choice of equals", "(if (< x y) z z)", "z", Always),
    rule("number as a condition", "(if x y z)", "(if (< 0 x) y z)", Always),
];

//! The algebra of plm: exact, deterministic, hash-consed expressions of real numbers.
//!
//! A [`Graph`] holds expressions in canonical form; its constructors are the simplifier ([`RULES`] lists what they
//! do and under which condition each step is true). On top stand derivatives ([`Graph::diff`],
//! [`Graph::gradient`], [`Graph::directional`]), substitution, printing ([`Graph::display`]), the search for what
//! several expressions have in common ([`share`]), and the [`Tape`]: the list of single operations that is both
//! emitted as code and evaluated here as its oracle.
//!
//! Formulas are written with operators: [`algebra`].
//!
//! It runs inside a procedural macro, unoptimised, for every user. So the data are flat, nothing recurses over the
//! graph, no unordered collection is iterated, and the same calls give the same bytes on every host.
//!
//! ```
//! use plm_cas::{Expr, Graph, Number, Tape, share};
//!
//! let mut graph = Graph::new();
//! let length = Number::parse_decimal("0.15").ok_or("not a number")?;
//! let (phi, slope) = graph.enter(|| {
//!     let (x, angle) = (Expr::symbol("x"), Expr::symbol("angle"));
//!     let phi = x - Expr::from(length) * angle.cos();
//!     (phi, phi.diff(angle))
//! });
//! assert_eq!(graph.display(phi).to_string(), "x - 0.15*cos(angle)");
//! assert_eq!(graph.display(slope).to_string(), "0.15*sin(angle)");
//!
//! let roots = share(&mut graph, &[phi, slope]);
//! let tape = Tape::new(&graph, &roots);
//! assert_eq!(tape.count().to_string(), "1 add, 2 mul, 1 sin_cos");
//! # Ok::<(), &str>(())
//! ```

pub mod algebra;
mod build;
mod diff;
mod graph;
mod hash;
mod math;
mod node;
mod number;
mod print;
mod rules;
mod sexpr;
mod share;
mod substitute;
mod tape;

pub use algebra::{Rotation, Vec2};
pub use graph::Graph;
pub use node::{Expr, Function, Node};
pub use number::Number;
pub use plm_math::Operations;
pub use print::Infix;
pub use rules::{Condition, RULES, Rule};
pub use sexpr::ParseError;
pub use share::share;
pub use tape::{Count, Instr, Machine, Op, Ref, Tape};

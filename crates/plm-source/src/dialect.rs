//! A language that blocks are printed in.

use crate::block::{Argument, OfOne, OfTwo};

/// A language. Texts of values are names, constants, or elements of arrays.
pub(crate) trait Dialect {
    /// A constant, exactly.
    fn number(&self, number: f64) -> String;
    /// A number that the function reads.
    fn argument(&self, argument: Argument) -> String;
    /// A statement that gives a new name its value.
    fn declare(&self, name: &str, value: &str) -> String;
    /// A statement that gives a new name the sine and cosine of an angle.
    fn declare_pair(&self, name: &str, angle: &str) -> String;
    /// Sine and cosine of what [`declare_pair`](Self::declare_pair) has named.
    fn of_pair(&self, name: &str) -> [String; 2];
    /// A function of one number.
    fn one(&self, of: OfOne, a: &str) -> String;
    /// A function of two numbers.
    fn two(&self, of: OfTwo, a: &str, b: &str) -> String;
    /// `if a < b { c } else { d }`.
    fn select(&self, operands: [&str; 4]) -> String;
    /// A statement that stores a value.
    fn store(&self, place: &str, value: &str) -> String;
    /// A statement that returns a value.
    fn give_back(&self, value: &str) -> String;
}

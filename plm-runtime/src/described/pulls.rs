//! Pulling bodies: inputs of force and torque that are added to a declaration, and found again by number.

use core::fmt;

use super::Described;

/// Prefix of the names of the part and the inputs through which a body is pulled; its number follows.
const PULL: &str = "plm_pull_";

/// A declaration to which an input of force and torque at the centre of gravity of each body is added, three for each:
/// `plm_pull_0_x`, `plm_pull_0_y` (N), `plm_pull_0_turn` (N*m). Where they are zero, what moves is the same but for rounding.
#[derive(Clone, Copy, Debug)]
pub struct WithPulls<'a> {
    /// The declaration, whose last bracket closes it.
    pub declaration: &'a str,
    /// The names of the bodies.
    pub bodies: &'a [&'a str],
}

impl fmt::Display for WithPulls<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some((head, _)) = self.declaration.trim_end().rsplit_once('}') else {
            return f.write_str(self.declaration);
        };
        f.write_str(head)?;
        f.write_str(
            "\npart plm_pull(a: body) { input x: N = 0; input y: N = 0; input turn: N*m = 0; force on a: (x, y); torque on a: turn; }\n",
        )?;
        for (k, body) in self.bodies.iter().enumerate() {
            writeln!(
                f,
                "input {PULL}{k}_x: N = 0; input {PULL}{k}_y: N = 0; input {PULL}{k}_turn: N*m = 0;"
            )?;
            writeln!(
                f,
                "plm_pull {PULL}{k}({body}) {{ x: {PULL}{k}_x; y: {PULL}{k}_y; turn: {PULL}{k}_turn; }}"
            )?;
        }
        f.write_str("}\n")
    }
}

/// The number of the input through which a body is pulled: `x`, `y` or `turn`.
pub fn pull_input<M: Described>(of: &M, body: usize, suffix: &str) -> Option<usize> {
    of.input_names().iter().position(|(name, _)| {
        let rest = name.strip_prefix(PULL).and_then(|rest| rest.split_once('_'));
        rest.is_some_and(|(number, end)| number.parse() == Ok(body) && end == suffix)
    })
}

//! Accelerations and multipliers at a state, for outputs that read them.

use super::Emission;
use crate::derive::feeds_back;

pub(crate) fn emit(emission: &Emission) -> String {
    if emission.reactions().is_some() { of_tree(emission) } else { of_absolute(emission) }
}

/// By the backward pass of a tree, whose reactions nothing leaves undetermined.
fn of_tree(emission: &Emission) -> String {
    let held = emission.inputs_of_state();
    let (nq, nc) = (emission.equations.q.len(), emission.equations.phi.len());
    let solved = if emission.reads_solution() {
        format!(
            "        /// Accelerations and multipliers.
        #[inline]
        fn solved_(&self) -> ([S; {nq}], [S; {nc}]) {{
            let (mut a, mut lambda) = ([S::lit(0.0); {nq}], [S::lit(0.0); {nc}]);
            self.mechanism.reactions(self.time, &{held}, &self.x, &mut a, &mut lambda);
            (a, lambda)
        }}

"
        )
    } else {
        String::new()
    };
    format!(
        "    impl<S: Real> State<S> {{
{solved}        /// Reactions that redundancy leaves undetermined, by constraint row: none.
        pub fn undetermined(&self) -> [bool; {nc}] {{
            [false; {nc}]
        }}
    }}

"
    )
}

/// By rung 5, and by rank where elimination is unhealthy.
fn of_absolute(emission: &Emission) -> String {
    let held = emission.inputs_of_state();
    let inputs = emission.inputs("S");
    let Emission { name, equations, .. } = emission;
    let (nq, nc) = (equations.q.len(), equations.phi.len());
    let length = 2 * nq + equations.x.len();
    let absolute = if emission.reduced.is_some() { "self.absolute_()" } else { "self.x" };
    // Forces that read the unknowns are known for independent constraints alone.
    let refusal = if feeds_back(emission.model) {
        format!("            return Err(Fault::new(t.to_f64(), rt::Cause::Singular {{ rows: {nc} }}));\n")
    } else {
        String::new()
    };
    format!(
        "    impl<S: Real> {name}<S> {{
        /// Accelerations and multipliers by a rank-revealing decomposition.
        #[cold]
        fn accelerate(&self, t: S, u: &{inputs}, x: &[S; {length}]) -> Result<absolute::Acceleration<S, NQ, NC>, Fault> {{
{refusal}            let (q, _): ([S; {nq}], [S; {nq}]) = absolute::split(x);
            let (mut force, mut gamma) = ([S::lit(0.0); {nq}], [S::lit(0.0); {nc}]);
            self.free(t, u, x, &mut force, &mut gamma);
            let mut inverse_mass = [S::lit(0.0); {nq}];
            self.reciprocal_mass(&mut inverse_mass);
            absolute::accelerate(t, &inverse_mass, &force, &gamma, |rows| absolute::jacobian(self, t, &q, rows))
        }}
    }}

    impl<S: Real> State<S> {{
        /// Accelerations and multipliers; multipliers that redundancy leaves undetermined have their minimum norm.
        fn solved_(&self) -> ([S; {nq}], [S; {nc}]) {{
            let (mut dx, mut lambda) = ([S::lit(0.0); {length}], [S::lit(0.0); {nc}]);
            let x = {absolute};
            let health = self.mechanism.dynamics(self.time, &{held}, &x, &mut dx, &mut lambda);
            if !rt::Health(health).is_good() {{
                if let Ok(solution) = self.mechanism.accelerate(self.time, &{held}, &x) {{
                    return (solution.a, solution.lambda);
                }}
            }}
            let (_, a): ([S; {nq}], [S; {nq}]) = absolute::split(&dx);
            (a, lambda)
        }}

        /// Reactions that redundancy leaves undetermined, by constraint row; they are given with minimum norm.
        pub fn undetermined(&self) -> [bool; {nc}] {{
            match self.mechanism.accelerate(self.time, &{held}, &{absolute}) {{
                Ok(solution) => solution.undetermined,
                Err(_) => [true; {nc}],
            }}
        }}
    }}

"
    )
}

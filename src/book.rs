//! The Rust code of the book and the README, compiled and run as doc tests.
//!
//! `cargo test --doc` takes every block that is fenced as `rust`; nothing of this stands in the library.

/// Gives each page a private item whose documentation it is.
macro_rules! pages {
    ($($name:ident = $path:literal;)*) => {
        $(#[doc = include_str!(concat!("../docs/src/", $path))] struct $name;)*
    };
}

pages! {
    Readme = "../../README.md";
    LookAtIt = "look-at-it.md";
    GettingStarted = "getting-started.md";
    Kinematics = "questions/kinematics.md";
    InverseDynamics = "questions/inverse-dynamics.md";
    Gradients = "questions/gradients.md";
    GeneratedCode = "generated-code.md";
    Bodies = "language/bodies.md";
    Outputs = "language/outputs.md";
    Parts = "language/parts.md";
    Repeat = "language/repeat.md";
    Declaration = "language/declaration.md";
    Assembly = "running/assembly.md";
    Described = "running/described.md";
    Integrators = "running/integrators.md";
    Methods = "running/methods.md";
    RealTime = "running/real-time.md";
    Scalars = "running/scalars.md";
    Stack = "running/stack.md";
    Targets = "targets.md";
    Equations = "theory/equations.md";
    ContactTheory = "theory/contact.md";
    MechanicsRecipes = "recipes/mechanics.md";
    Motion = "parts/motion.md";
}

#[cfg(feature = "optimise")]
pages! {
    Identification = "questions/identification.md";
    OptimalControl = "questions/optimal-control.md";
}

#[cfg(feature = "analysis")]
pages! {
    Modes = "running/modes.md";
    Statics = "questions/statics.md";
    Feedback = "questions/feedback.md";
    Linearise = "running/linearise.md";
}

#[cfg(feature = "synthesis")]
pages! {
    Linkages = "questions/linkages.md";
}

#[cfg(all(feature = "synthesis", feature = "dynamic"))]
pages! {
    Synthesis = "questions/synthesis.md";
    BalanceAndTolerances = "questions/tolerances.md";
}

#[cfg(all(feature = "analysis", feature = "view"))]
pages! {
    FrequencyResponse = "questions/frequency-response.md";
}

#[cfg(all(feature = "analysis", feature = "jit"))]
pages! {
    AtRunTime = "running/at-run-time.md";
}

#[cfg(feature = "view")]
pages! {
    Results = "running/results.md";
    FromAFile = "questions/from-a-file.md";
}

#[cfg(feature = "lanes")]
pages! {
    Lanes = "running/lanes.md";
}

#[cfg(feature = "batch")]
pages! {
    Batch = "running/batch.md";
    ManyMachines = "running/many-machines.md";
}

#[cfg(feature = "view")]
pages! {
    FromC = "running/c.md";
    AsAnFmu = "running/fmu.md";
    TenQuestions = "questions/ten.md";
    FromPython = "running/python.md";
    ThePage = "running/page.md";
}

#[cfg(all(feature = "batch", feature = "view"))]
pages! {
    RunningRecipes = "recipes/running.md";
}

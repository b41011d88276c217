//! Runs from text have the bits of compiled code. Here rustc compiles what other tests declare by text: every shape of emitted code.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

#[path = "../support/beside_text.rs"]
mod beside_text;
#[path = "../snapshots/blessed.rs"]
mod blessed;

/// Here `scene!` is [`plm::mechanism!`].
macro_rules! scene {
    ($($declaration:tt)*) => {
        plm::mechanism! { $($declaration)* }
    };
}

/// That of `tests/contact/machines.rs`.
macro_rules! mechanism {
    ($($declaration:tt)*) => {
        plm::mechanism! { $($declaration)* }
    };
}

mod analysis;
#[path = "../scenes/analysis.rs"]
mod analysis_scenes;
mod contact;
#[path = "../scenes/contact.rs"]
mod contact_scenes;
mod emitted;
#[path = "../scenes/events.rs"]
mod event_scenes;
mod events;
mod every_method;
mod first_steps;
mod from_text;
#[path = "../support/linearised.rs"]
mod linearised;
#[cfg(feature = "jit")]
mod machine_code;
#[path = "../contact/machines.rs"]
mod machines;
mod massless;
#[path = "../scenes/massless.rs"]
mod massless_scenes;
mod near_singular;
#[path = "../scenes/near_singular.rs"]
mod near_singular_scenes;
#[path = "../scenes/parts/mod.rs"]
mod part_scenes;
mod parts;
mod starts;
#[path = "../scenes/starts.rs"]
mod starts_scenes;

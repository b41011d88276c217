//! Declarations by formulation, with all their numbers as parameters.

/// Declares a mechanism in each of the formulations that are named. With the feature `compiled` rustc compiles it too.
macro_rules! declare {
    ($formulation:ident $($other:ident)?; parameters $names:tt bodies $bodies:tt $items:tt) => {
        pub mod $formulation {
            declare!(@one $formulation $names $bodies $items);
        }
        $(
            pub mod $other {
                declare!(@one $other $names $bodies $items);
            }
        )?
    };
    (@one $formulation:ident { $($name:ident: ($($unit:tt)*),)*; $($ratio:ident)* } $bodies:tt { $($items:tt)* }) => {
        declare!(@evaluated { $($name)* $($ratio)* } $bodies
            pub Model {
                formulation: $formulation;
                allow(W0001);
                allow(W0002);
                $(param $name: $($unit)* = 1 $($unit)*;)*
                part foot(sole: frame, floor: frame) {
                    param mu: 1;
                    param e: 1 = 0;
                    let along = sole.position - floor.position;
                    unilateral gap: dot(along, floor.normal) >= 0 m { restitution: e; }
                    friction grip: rate(dot(along, floor.axis)) within mu*reaction(gap);
                }
                $(param $ratio: 1 = 1;)*
                $($items)*
            }
        );
    };
    (@evaluated { $($number:ident)* } { $($body:ident)* } $($declaration:tt)*) => {
        pub static TEXT: &str = stringify!($($declaration)*);
        #[cfg(feature = "compiled")]
        plm::mechanism! { $($declaration)* }
        #[cfg(feature = "compiled")]
        impl $crate::compiled::Build for Model {
            fn build(numbers: &[f64], starts: &[plm::Start<f64>]) -> Self {
                let mut built = Self::new();
                let mut numbers = numbers.iter();
                $(built.$number = numbers.next().copied().unwrap_or(f64::NAN);)*
                let mut starts = starts.iter();
                plm::runtime::StartValues::each(&mut built.start, &mut |_, start| {
                    if let Some(given) = starts.next() {
                        *start = *given;
                    }
                });
                built
            }
        }
        #[cfg(feature = "compiled")]
        impl plm_oracle::Look for Model {
            fn bodies(state: &Self::State, mut each: impl FnMut(plm::BodyState<f64>)) {
                $(each(state.$body());)*
            }

            fn energies(state: &Self::State) -> [f64; 2] {
                [state.kinetic_energy(), state.gravity_energy()]
            }
        }
    };
}

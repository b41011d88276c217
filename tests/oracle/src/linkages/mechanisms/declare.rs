//! One text for a mechanism: its shape for the reference, and its declarations for `plm`.

/// Declares a mechanism in its default formulation and in absolute coordinates, with all its numbers as parameters.
///
/// Ports have x, y and the angle of their axis; joints have a spring, a damper and the place at which the spring is free.
/// The first joint, a revolute, carries the load. With the feature `compiled` rustc compiles them too.
macro_rules! declare {
    ($module:ident { $($all:tt)* }) => {
        pub mod $module {
            declare!(@shape $module $($all)*);
            pub mod loops {
                declare!(@formulation loops $($all)*);
            }
            pub mod absolute {
                declare!(@formulation absolute $($all)*);
            }
        }
    };
    (@joint $kind:ident $name:ident $a:ident $pa:ident $b:ident $pb:ident) => {
        $crate::scene::JointShape {
            kind: $crate::scene::Kind::$kind,
            name: stringify!($name),
            a: (stringify!($a), stringify!($pa)),
            b: (stringify!($b), stringify!($pb)),
        }
    };
    (@shape $module:ident
        ground { $($g:ident($gx:ident $gy:ident $gw:ident)),* }
        $(body $body:ident($m:ident $i:ident) { $($p:ident($x:ident $y:ident $w:ident)),* })*
        drive $j0:ident($a0:ident.$pa0:ident, $b0:ident.$pb0:ident) $k0:ident $d0:ident $r0:ident;
        $(revolute $jr:ident($ar:ident.$par:ident, $br:ident.$pbr:ident) $kr:ident $dr:ident $rr:ident;)*
        $(prismatic $jp:ident($ap:ident.$pap:ident, $bp:ident.$pbp:ident) $kp:ident $dp:ident $rp:ident;)*
        $(pin_slot $js:ident($as:ident.$pas:ident, $bs:ident.$pbs:ident) $ks:ident $ds:ident $rs:ident;)*
    ) => {
        pub static SHAPE: $crate::scene::Shape = $crate::scene::Shape {
            name: stringify!($module),
            ground: &[$(stringify!($g)),*],
            bodies: &[$((stringify!($body), &[$(stringify!($p)),*])),*],
            joints: &[
                declare!(@joint Revolute $j0 $a0 $pa0 $b0 $pb0),
                $(declare!(@joint Revolute $jr $ar $par $br $pbr),)*
                $(declare!(@joint Prismatic $jp $ap $pap $bp $pbp),)*
                $(declare!(@joint Slot $js $as $pas $bs $pbs),)*
            ],
        };
    };
    (@formulation $formulation:ident
        ground { $($g:ident($gx:ident $gy:ident $gw:ident)),* }
        $(body $body:ident($m:ident $i:ident) { $($p:ident($x:ident $y:ident $w:ident)),* })*
        drive $j0:ident($a0:ident.$pa0:ident, $b0:ident.$pb0:ident) $k0:ident $d0:ident $r0:ident;
        $(revolute $jr:ident($ar:ident.$par:ident, $br:ident.$pbr:ident) $kr:ident $dr:ident $rr:ident;)*
        $(prismatic $jp:ident($ap:ident.$pap:ident, $bp:ident.$pbp:ident) $kp:ident $dp:ident $rp:ident;)*
        $(pin_slot $js:ident($as:ident.$pas:ident, $bs:ident.$pbs:ident) $ks:ident $ds:ident $rs:ident;)*
    ) => {
        declare!(@evaluated
            {
                weight push begin rise turn fall $($gx $gy $gw)* $($m $i $($x $y $w)*)*
                $k0 $d0 $r0 $($kr $dr $rr)* $($kp $dp $rp)* $($ks $ds $rs)*
            }
            { $($body)* }
            pub Linkage {
                formulation: $formulation;
                allow(W0001);
                param weight: m/s^2 = 9.81 m/s^2;
                gravity: weight;
                param push: N*m = 0 N*m;
                param begin: s = 0 s;
                param rise: s = 1 s;
                param turn: s = 2 s;
                param fall: s = 1 s;
                $(param $gx: m = 0 m; param $gy: m = 0 m; param $gw: rad = 0 rad;)*
                ground { $(port $g: ($gx, $gy), axis: $gw;)* }
                $(
                    param $m: kg = 1 kg;
                    param $i: kg*m^2 = 1 kg*m^2;
                    $(param $x: m = 0 m; param $y: m = 0 m; param $w: rad = 0 rad;)*
                    body $body { mass: $m; inertia: $i; $(port $p: ($x, $y), angle: $w;)* }
                )*
                param $k0: N*m/rad = 0 N*m/rad; param $d0: N*m*s/rad = 0 N*m*s/rad; param $r0: rad = 0 rad;
                revolute $j0($a0.$pa0, $b0.$pb0) {
                    stiffness: $k0; damping: $d0; rest: $r0;
                    drive: push*(
                        clamp((t - begin)/rise, 0, 1)^2*(3 - 2*clamp((t - begin)/rise, 0, 1))
                        - 2*clamp((t - turn)/fall, 0, 1)^2*(3 - 2*clamp((t - turn)/fall, 0, 1))
                    );
                }
                $(
                    param $kr: N*m/rad = 0 N*m/rad; param $dr: N*m*s/rad = 0 N*m*s/rad; param $rr: rad = 0 rad;
                    revolute $jr($ar.$par, $br.$pbr) { stiffness: $kr; damping: $dr; rest: $rr; }
                )*
                $(
                    param $kp: N/m = 0 N/m; param $dp: N*s/m = 0 N*s/m; param $rp: m = 0 m;
                    prismatic $jp($ap.$pap, $bp.$pbp) { stiffness: $kp; damping: $dp; free_length: $rp; }
                )*
                $(
                    param $ks: N/m = 0 N/m; param $ds: N*s/m = 0 N*s/m; param $rs: m = 0 m;
                    pin_slot $js($as.$pas, $bs.$pbs) { stiffness: $ks; damping: $ds; free_length: $rs; }
                )*
            }
        );
    };
    (@evaluated $numbers:tt $bodies:tt $($declaration:tt)*) => {
        pub static TEXT: &str = stringify!($($declaration)*);
        #[cfg(feature = "compiled")]
        plm::mechanism! { $($declaration)* }
        #[cfg(feature = "compiled")]
        declare!(@build f64, $numbers $bodies);
        #[cfg(feature = "compiled")]
        declare!(@build f32, $numbers $bodies);
    };
    (@build $scalar:ident, { $($number:ident)* } { $($body:ident)* }) => {
        impl $crate::compiled::Build for Linkage<$scalar> {
            fn build(numbers: &[f64], starts: &[plm::Start<f64>]) -> Self {
                let mut built = Self::of();
                let mut numbers = numbers.iter();
                $(built.$number = numbers.next().copied().unwrap_or(f64::NAN) as $scalar;)*
                let mut starts = starts.iter();
                plm::runtime::StartValues::each(&mut built.start, &mut |_, start| {
                    if let Some(given) = starts.next() {
                        start.value = given.value as $scalar;
                        start.locked = given.locked;
                    }
                });
                built
            }
        }

        impl plm_oracle::Look for Linkage<$scalar> {
            fn bodies(state: &Self::State, mut each: impl FnMut(plm::BodyState<$scalar>)) {
                $(each(state.$body());)*
            }

            fn energies(state: &Self::State) -> [$scalar; 2] {
                [state.kinetic_energy(), state.gravity_energy()]
            }
        }
    };
}

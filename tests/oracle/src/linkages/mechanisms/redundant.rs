//! A loop that says twice what is so. Whether it does is decided at the lengths that stand in the declaration.

/// Three parallel cranks.
pub mod third_crank {
    declare!(@shape third_crank
        ground { a(x y w), d(x y w), g(x y w) }
        body one(m i) { a(x y w), b(x y w) }
        body beam(m i) { b(x y w), c(x y w), e(x y w) }
        body two(m i) { d(x y w), c(x y w) }
        body three(m i) { g(x y w), e(x y w) }
        drive ja(ground.a, one.a) k d r;
        revolute jb(one.b, beam.b) k d r;
        revolute jc(beam.c, two.c) k d r;
        revolute jd(ground.d, two.d) k d r;
        revolute je(beam.e, three.e) k d r;
        revolute jg(ground.g, three.g) k d r;
    );

    macro_rules! in_formulation {
        ($formulation:ident) => {
            pub mod $formulation {
                declare!(@evaluated
                    {
                        weight push begin rise turn fall gax gay gaw gdx gdy gdw ggx ggy ggw
                        m1 i1 ax1 ay1 aw1 bx1 by1 bw1 m2 i2 bx2 by2 bw2 cx2 cy2 cw2 ex2 ey2 ew2
                        m3 i3 dx3 dy3 dw3 cx3 cy3 cw3 m4 i4 gx4 gy4 gw4 ex4 ey4 ew4
                        ka da ra kb db rb kc dc rc kd dd rd ke de re kh dh rh
                    }
                    { one beam two three }
                    pub Linkage {
                        formulation: $formulation;
                        allow(W0001, W0007);
                        param weight: m/s^2 = 9.81 m/s^2;
                        gravity: weight;
                        param push: N*m = 0 N*m;
                        param begin: s = 0 s;
                        param rise: s = 1 s;
                        param turn: s = 2 s;
                        param fall: s = 1 s;
                        param gax: m = 0 m; param gay: m = 0 m; param gaw: rad = 0 rad;
                        param gdx: m = 1 m; param gdy: m = 0 m; param gdw: rad = 0 rad;
                        param ggx: m = 0.5 m; param ggy: m = 0.25 m; param ggw: rad = 0 rad;
                        ground { port a: (gax, gay); port d: (gdx, gdy); port g: (ggx, ggy); }
                        param m1: kg = 1 kg; param i1: kg*m^2 = 0.1 kg*m^2;
                        param ax1: m = -0.25 m; param ay1: m = 0 m; param aw1: rad = 0 rad;
                        param bx1: m = 0.25 m; param by1: m = 0 m; param bw1: rad = 0 rad;
                        body one {
                            mass: m1; inertia: i1; port a: (ax1, ay1); port b: (bx1, by1);
                            start y: 0.25 m; start angle: 90 deg;
                        }
                        param m2: kg = 1 kg; param i2: kg*m^2 = 0.1 kg*m^2;
                        param bx2: m = -0.5 m; param by2: m = 0 m; param bw2: rad = 0 rad;
                        param cx2: m = 0.5 m; param cy2: m = 0 m; param cw2: rad = 0 rad;
                        param ex2: m = 0 m; param ey2: m = 0.25 m; param ew2: rad = 0 rad;
                        body beam {
                            mass: m2; inertia: i2; port b: (bx2, by2); port c: (cx2, cy2); port e: (ex2, ey2);
                            start x: 0.5 m; start y: 0.5 m;
                        }
                        param m3: kg = 1 kg; param i3: kg*m^2 = 0.1 kg*m^2;
                        param dx3: m = -0.25 m; param dy3: m = 0 m; param dw3: rad = 0 rad;
                        param cx3: m = 0.25 m; param cy3: m = 0 m; param cw3: rad = 0 rad;
                        body two {
                            mass: m3; inertia: i3; port d: (dx3, dy3); port c: (cx3, cy3);
                            start x: 1 m; start y: 0.25 m; start angle: 90 deg;
                        }
                        param m4: kg = 1 kg; param i4: kg*m^2 = 0.1 kg*m^2;
                        param gx4: m = -0.25 m; param gy4: m = 0 m; param gw4: rad = 0 rad;
                        param ex4: m = 0.25 m; param ey4: m = 0 m; param ew4: rad = 0 rad;
                        body three {
                            mass: m4; inertia: i4; port g: (gx4, gy4); port e: (ex4, ey4);
                            start x: 0.5 m; start y: 0.5 m; start angle: 90 deg;
                        }
                        param ka: N*m/rad = 0 N*m/rad; param da: N*m*s/rad = 0 N*m*s/rad; param ra: rad = 0 rad;
                        revolute ja(ground.a, one.a) {
                            stiffness: ka; damping: da; rest: ra;
                            drive: push*(
                                clamp((t - begin)/rise, 0, 1)^2*(3 - 2*clamp((t - begin)/rise, 0, 1))
                                - 2*clamp((t - turn)/fall, 0, 1)^2*(3 - 2*clamp((t - turn)/fall, 0, 1))
                            );
                        }
                        param kb: N*m/rad = 0 N*m/rad; param db: N*m*s/rad = 0 N*m*s/rad; param rb: rad = 0 rad;
                        revolute jb(one.b, beam.b) { stiffness: kb; damping: db; rest: rb; }
                        param kc: N*m/rad = 0 N*m/rad; param dc: N*m*s/rad = 0 N*m*s/rad; param rc: rad = 0 rad;
                        revolute jc(beam.c, two.c) { stiffness: kc; damping: dc; rest: rc; }
                        param kd: N*m/rad = 0 N*m/rad; param dd: N*m*s/rad = 0 N*m*s/rad; param rd: rad = 0 rad;
                        revolute jd(ground.d, two.d) { stiffness: kd; damping: dd; rest: rd; }
                        param ke: N*m/rad = 0 N*m/rad; param de: N*m*s/rad = 0 N*m*s/rad; param re: rad = 0 rad;
                        revolute je(beam.e, three.e) { stiffness: ke; damping: de; rest: re; }
                        param kh: N*m/rad = 0 N*m/rad; param dh: N*m*s/rad = 0 N*m*s/rad; param rh: rad = 0 rad;
                        revolute jg(ground.g, three.g) { stiffness: kh; damping: dh; rest: rh; }
                    }
                );
            }
        };
    }
    in_formulation!(loops);
    in_formulation!(absolute);
}

//! The linkages that are driven, in two formulations.

macro_rules! linkages {
    ($formulation:ident) => {
        [
            stringify! {
                pub FourBar {
                    formulation: $formulation;
                    allow(W0001);
                    param r1: m = 0.1 m;
                    param r2: m = 0.3 m;
                    param r3: m = 0.3 m;
                    param span: m = 0.4 m;
                    param from: rad = 1 rad;
                    param rate: rad/s = 1 rad/s;
                    ground { port a: (0, 0) m; port d: (span, 0 m); }
                    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (r1, 0 m); start angle: from; }
                    body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (r2, 0 m); }
                    body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (r3, 0 m); start x: span; }
                    revolute ja(ground.a, crank.a);
                    revolute jb(crank.b, coupler.b);
                    revolute jc(coupler.c, rocker.c);
                    revolute jd(ground.d, rocker.d);
                    constraint motor: crank.angle = from + rate*t;
                }
            },
            stringify! {
                pub SliderCrank {
                    formulation: $formulation;
                    allow(W0001);
                    param r1: m = 0.1 m;
                    param r2: m = 0.3 m;
                    param rail: m = 0.05 m;
                    param from: rad = 0 rad;
                    param rate: rad/s = 1 rad/s;
                    ground { port a: (0, 0) m; port g: (0 m, rail); }
                    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (r1, 0 m); start angle: from; }
                    body rod { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (r2, 0 m); start x: r1; }
                    body slider { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0, 0) m; start y: rail; }
                    revolute ja(ground.a, crank.a);
                    revolute jb(crank.b, rod.b);
                    revolute jc(rod.c, slider.c);
                    prismatic guide(ground.g, slider.c);
                    constraint motor: crank.angle = from + rate*t;
                }
            },
            stringify! {
                pub Pushed {
                    formulation: $formulation;
                    allow(W0001);
                    param r1: m = 0.1 m;
                    param r2: m = 0.3 m;
                    param rail: m = 0.05 m;
                    param from: m = 0.3 m;
                    param rate: m/s = 0.1 m/s;
                    ground { port a: (0, 0) m; port g: (0 m, rail); }
                    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (r1, 0 m); }
                    body rod { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (r2, 0 m); }
                    body slider { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0, 0) m; start x: from; start y: rail; }
                    revolute ja(ground.a, crank.a);
                    revolute jb(crank.b, rod.b);
                    revolute jc(rod.c, slider.c);
                    prismatic guide(ground.g, slider.c);
                    constraint motor: slider.x = from + rate*t;
                }
            },
        ]
    };
}

/// Declarations by formulation, joint and absolute coordinates, and kind.
pub static DECLARATIONS: [[&str; 3]; 2] = [linkages!(loops), linkages!(absolute)];

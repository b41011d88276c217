//! The README's four-bar with a rocker that is too short.

plm::mechanism! { pub FourBar {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) cm; port d: (30, 0) cm; }
    body crank { mass: 1 kg; inertia: rod(1 kg, 10 cm); port a: (-5, 0) cm; port b: (5, 0) cm; }
    body coupler { mass: 3 kg; inertia: 0.04 kg*m^2;
        port b: (-14, 0) cm; port c: (14, 0) cm; port tip: (0, 15) cm; }
    body rocker { mass: 2 kg; inertia: rod(2 kg, 25 cm);
        port c: (2.5, 0) cm; port d: (-2.5, 0) cm; start angle: 110 deg; }
    revolute pin_a(ground.a, crank.a);
    revolute pin_b(crank.b, coupler.b);
    revolute pin_c(coupler.c, rocker.c);
    revolute pin_d(ground.d, rocker.d);
    constraint motor: crank.angle = 1 rev/s*t;
    output coupler.tip.position in cm, torque = -reaction(motor);
    output pin_a.force, pin_b.force, pin_c.force, pin_d.force;
}}

fn main() {}

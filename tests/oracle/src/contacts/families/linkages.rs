//! Loops with friction in their joints.

/// A slider-crank: friction of its slider on its rail and in all pins, each by what it carries.
pub mod slider_crank {
    use crate::families::Draft;
    use crate::families::laws::{loaded, sum};
    use crate::reference::world::{Bound, Force, Law, World};
    use plm_oracle::Random;

    declare! { loops absolute;
        parameters { m1: (kg), j1: (kg*m^2), m2: (kg), j2: (kg*m^2), m3: (kg), g: (m/s^2), crank: (m), rod: (m), push: (N*m),
            radius: (m), buffer: (m),; mu nu e }
        bodies { arm bar block }
        {
            gravity: g;
            ground { port o: (0, 0) m; port rail: (0, 0) m, axis: 0 deg; }
            body arm { mass: m1; inertia: j1; port o: (0, 0) m; port a: (crank, 0 m); }
            body bar { mass: m2; inertia: j2; port a: (-rod/2, 0 m); port b: (rod/2, 0 m); }
            body block { mass: m3; inertia: 1 kg*m^2; port b: (0, 0) m; }
            revolute o(ground.o, arm.o);
            revolute a(arm.a, bar.a);
            revolute b(bar.b, block.b);
            prismatic rail(ground.rail, block.b);
            force motor(arm.o) { torque: push; }
            unilateral stop: block.x >= buffer { restitution: e; }
            friction slide: rate(block.x) within mu*norm(rail.force);
            friction pin_o: rate(arm.angle) within nu*radius*norm(o.force);
            friction pin_a: rate(bar.angle - arm.angle) within nu*radius*norm(a.force);
            friction pin_b: rate(bar.angle) within nu*radius*norm(b.force);
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let [m1, m2, m3] = [0; 3].map(|_| random.between(0.3, 2.0));
        let (g, crank) = (random.between(0.0, 12.0), random.between(0.1, 0.3));
        let rod = crank * random.between(1.5, 4.0);
        let (j1, j2) =
            (m1 * crank * crank * random.between(0.1, 1.0), m2 * rod * rod * random.between(0.05, 0.15));
        let push = random.between(-1.0, 1.0) * (m3 + m1) * 10.0 * crank;
        let radius = crank * random.between(0.01, 0.08);
        let (mu, nu) = (random.between(0.0, 0.4), random.between(0.0, 0.5));
        // A stop that is out of reach, or within it.
        let buffer = if random.chance(0.5) { 0.0 } else { rod - crank * random.between(0.2, 0.8) };
        let e = if random.chance(0.5) { 0.0 } else { random.between(0.1, 0.6) };
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let (arm, bar, block) =
            (Some(world.body(m1, j1)), Some(world.body(m2, j2)), Some(world.body(m3, 1.0)));
        let o = world.pin((arm, [0.0; 2]), (None, [0.0; 2]));
        let a = world.pin((arm, [crank, 0.0]), (bar, [-0.5 * rod, 0.0]));
        let b = world.pin((bar, [0.5 * rod, 0.0]), (block, [0.0; 2]));
        let rail = world.joints.len();
        world.joints.extend([sum([(7, 1.0)], 0.0), sum([(8, 1.0)], 0.0)]);
        world.forces.push(Force::On {
            coordinate: 2,
            constant: push,
            amplitude: 0.0,
            omega: 0.0,
            phase: 0.0,
        });
        world.row(sum([(6, 1.0)], -buffer), Law::Gap { restitution: e });
        let slide = Bound { joint: Some((rail, None, mu)), adhesion: 1.0, ..Bound::default() };
        world.row(sum([(6, 1.0)], 0.0), Law::Rub(slide));
        world.row(sum([(2, 1.0)], 0.0), loaded(o, nu * radius));
        world.row(sum([(5, 1.0), (2, -1.0)], 0.0), loaded(a, nu * radius));
        world.row(sum([(5, 1.0)], 0.0), loaded(b, nu * radius));
        let turn = random.between(-1.0, 1.0);
        let spin = random.between(-12.0, 12.0);
        let (s, c) = turn.sin_cos();
        let lean = -(crank * s / rod).asin();
        let (sl, cl) = lean.sin_cos();
        let tilt = -crank * c * spin / (rod * cl);
        let x = crank * c + rod * cl;
        let vx = -crank * s * spin - rod * sl * tilt;
        let starts = vec![
            [0.0, 0.0, turn, 0.0, 0.0, spin],
            [
                crank * c + 0.5 * rod * cl,
                crank * s + 0.5 * rod * sl,
                lean,
                -crank * s * spin - 0.5 * rod * sl * tilt,
                crank * c * spin + 0.5 * rod * cl * tilt,
                tilt,
            ],
            [x, 0.0, 0.0, vx, 0.0, 0.0],
        ];
        Draft {
            numbers: vec![m1, j1, m2, j2, m3, g, crank, rod, push, radius, buffer, mu, nu, e],
            starts,
            world,
        }
    }
}

/// A parallelogram of unequal bars that swings: dry friction in a bearing, that of a loaded pin, a buffer.
pub mod four_bar {
    use crate::families::Draft;
    use crate::families::laws::{dry, loaded, sum};
    use crate::reference::world::{Law, World};
    use plm_oracle::Random;

    declare! { loops absolute;
        parameters { m1: (kg), m2: (kg), m3: (kg), g: (m/s^2), ax: (m), dx: (m),
            radius: (m), rub: (N*m), limit: (rad), l1: (m), l2: (m), l3: (m),;
            mu e }
        bodies { crank coupler rocker }
        {
            gravity: g;
            ground { port a: (ax, 0 m); port d: (dx, 0 m); }
            body crank { mass: m1; inertia: m1*l1^2; port a: (-l1, 0 m); port b: (l1, 0 m); }
            body coupler { mass: m2; inertia: m2*l2^2; port b: (-l2, 0 m); port c: (l2, 0 m); }
            body rocker { mass: m3; inertia: m3*l3^2; port d: (-l3, 0 m); port c: (l3, 0 m); }
            revolute a(ground.a, crank.a);
            revolute b(crank.b, coupler.b);
            revolute c(rocker.c, coupler.c);
            revolute d(ground.d, rocker.d);
            unilateral buffer: crank.angle >= limit { restitution: e; }
            friction bearing: rate(rocker.angle) within rub;
            friction pin: rate(coupler.angle - crank.angle) within mu*radius*norm(b.force);
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let [m1, m2, m3] = [0; 3].map(|_| random.between(0.3, 2.0));
        let g = random.between(3.0, 12.0);
        let (ax, dx) = (0.0, random.between(0.8, 1.2));
        let (bx, by) = (random.between(-0.2, 0.2), random.between(0.3, 0.6));
        let (cx, cy) = (dx + random.between(-0.2, 0.2), random.between(0.4, 0.8));
        let half = |x: f64, y: f64| (0.5 * x.hypot(y), y.atan2(x));
        let ((l1, a1), (l2, a2), (l3, a3)) = (half(bx - ax, by), half(cx - bx, cy - by), half(cx - dx, cy));
        let radius = random.between(0.005, 0.05);
        let rub = random.between(0.0, 1.0);
        let limit = a1 - random.between(0.05, 1.2);
        let (mu, e) =
            (random.between(0.0, 0.5), if random.chance(0.5) { 0.0 } else { random.between(0.1, 0.6) });
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let bodies = [(m1, l1), (m2, l2), (m3, l3)].map(|(m, l)| Some(world.body(m, m * l * l)));
        let [crank, coupler, rocker] = bodies;
        world.pin((crank, [-l1, 0.0]), (None, [ax, 0.0]));
        let b = world.pin((crank, [l1, 0.0]), (coupler, [-l2, 0.0]));
        world.pin((rocker, [l3, 0.0]), (coupler, [l2, 0.0]));
        world.pin((rocker, [-l3, 0.0]), (None, [dx, 0.0]));
        world.row(sum([(2, 1.0)], -limit), Law::Gap { restitution: e });
        world.row(sum([(8, 1.0)], 0.0), dry(rub));
        world.row(sum([(5, 1.0), (2, -1.0)], 0.0), loaded(b, mu * radius));
        let spin = random.between(-3.0, 3.0);
        // Velocities of b and c: vc is across dc and differs from vb across bc.
        let (vbx, vby) = (-by * spin, (bx - ax) * spin);
        let (ux, uy, px, py) = (cx - bx, cy - by, cx - dx, cy);
        // vb + w2 (-uy, ux) = w3 (-py, px)
        let det = -uy * -px - (py * ux);
        let w2 = (-vbx * -px - py * -vby) / det;
        let w3 = (-uy * -vby - ux * -vbx) / det;
        let middle = |x: f64, y: f64, w: f64, (vx, vy): (f64, f64)| (vx - 0.5 * y * w, vy + 0.5 * x * w);
        let (v1, v2, v3) = (
            middle(bx - ax, by, spin, (0.0, 0.0)),
            middle(ux, uy, w2, (vbx, vby)),
            middle(px, py, w3, (0.0, 0.0)),
        );
        let starts = vec![
            [0.5 * (ax + bx), 0.5 * by, a1, v1.0, v1.1, spin],
            [0.5 * (bx + cx), 0.5 * (by + cy), a2, v2.0, v2.1, w2],
            [0.5 * (cx + dx), 0.5 * cy, a3, v3.0, v3.1, w3],
        ];
        Draft { numbers: vec![m1, m2, m3, g, ax, dx, radius, rub, limit, l1, l2, l3, mu, e], starts, world }
    }
}

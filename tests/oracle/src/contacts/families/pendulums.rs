//! Open chains on pins: stops, ropes, floors, friction in joints.

/// A pendulum between two stops, with dry friction and that of its loaded pin on one axis.
pub mod pendulum {
    use crate::families::Draft;
    use crate::families::laws::{dry, loaded, sum};
    use crate::reference::world::{Force, Law, World};
    use plm_oracle::Random;

    declare! { tree absolute;
        parameters { mass: (kg), j: (kg*m^2), g: (m/s^2), length: (m), low: (rad), high: (rad), torque: (N*m),
            radius: (m), push: (N*m), omega: (Hz),; mu e }
        bodies { bar }
        {
            gravity: g;
            ground { port o: (0, 0) m; }
            body bar { mass: mass; inertia: j; port o: (0 m, length); port c: (0, 0) m; }
            revolute o(ground.o, bar.o);
            force motor(bar.c) { torque: push*sin(omega*t*(1 rad)); }
            unilateral low_stop: bar.angle >= low { restitution: e; }
            unilateral high_stop: bar.angle <= high { restitution: e; }
            friction dry: rate(bar.angle) within torque;
            friction pin: rate(bar.angle) within mu*radius*norm(o.force);
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let (m, g, l) = (random.between(0.5, 3.0), random.between(2.0, 12.0), random.between(0.1, 1.0));
        let j = m * l * l * random.between(0.05, 0.5);
        let (low, high) = (random.between(-1.5, -0.05), random.between(0.05, 1.5));
        let torque = random.between(0.0, 0.3) * m * g * l;
        let radius = l * random.between(0.02, 0.2);
        let push = random.between(0.0, 1.0) * m * g * l;
        let omega = random.between(3.0, 20.0);
        let (mu, e) =
            (random.between(0.0, 0.5), if random.chance(0.3) { 0.0 } else { random.between(0.1, 0.7) });
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let bar = world.body(m, j);
        let pin = world.pin((Some(bar), [0.0, l]), (None, [0.0; 2]));
        world.forces.push(Force::On { coordinate: 2, constant: 0.0, amplitude: push, omega, phase: 0.0 });
        world.row(sum([(2, 1.0)], -low), Law::Gap { restitution: e });
        world.row(sum([(2, -1.0)], high), Law::Gap { restitution: e });
        world.row(sum([(2, 1.0)], 0.0), dry(torque));
        world.row(sum([(2, 1.0)], 0.0), loaded(pin, mu * radius));
        let turn = low + (high - low) * random.between(0.05, 0.95);
        let spin = if random.chance(0.3) { 0.0 } else { random.between(-3.0, 3.0) };
        let (s, c) = turn.sin_cos();
        let start = [l * s, -l * c, turn, l * c * spin, l * s * spin, spin];
        Draft {
            numbers: vec![m, j, g, l, low, high, torque, radius, push, omega, mu, e],
            starts: vec![start],
            world,
        }
    }
}

/// Two bars: stops in both directions at the elbow, dry friction in both pins, and a tip that strikes and rubs a floor.
pub mod arm {
    use crate::families::Draft;
    use crate::families::laws::{dry, foot, sum};
    use crate::reference::world::{Law, World};
    use plm_oracle::Random;

    declare! { tree absolute;
        parameters { m1: (kg), j1: (kg*m^2), m2: (kg), j2: (kg*m^2), g: (m/s^2), l1: (m), l2: (m), floor: (m),
            low: (rad), high: (rad), rub1: (N*m), rub2: (N*m),; mu e }
        bodies { upper fore }
        {
            gravity: g;
            ground { port o: (0, 0) m; port floor: (0 m, floor), axis: 0 deg; }
            body upper { mass: m1; inertia: j1; port o: (-l1, 0 m); port a: (l1, 0 m); }
            body fore { mass: m2; inertia: j2; port a: (-l2, 0 m); port tip: (l2, 0 m); }
            revolute o(ground.o, upper.o);
            revolute a(upper.a, fore.a);
            unilateral low_stop: fore.angle - upper.angle >= low { restitution: e; }
            unilateral high_stop: fore.angle - upper.angle <= high { restitution: e; }
            friction shoulder: rate(upper.angle) within rub1;
            friction elbow: rate(fore.angle - upper.angle) within rub2;
            foot tip(fore.tip, ground.floor) { mu: mu; e: e; }
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let (m1, m2, g) = (random.between(0.5, 3.0), random.between(0.5, 3.0), random.between(2.0, 12.0));
        let (l1, l2) = (random.between(0.15, 0.5), random.between(0.15, 0.5));
        let (j1, j2) = (m1 * l1 * l1 * random.between(0.1, 0.5), m2 * l2 * l2 * random.between(0.1, 0.5));
        let (low, high) = (random.between(-2.0, -0.1), random.between(0.1, 2.0));
        let (a1, b) = (random.between(-3.0, 3.0), low + (high - low) * random.between(0.05, 0.95));
        let a2 = a1 + b;
        let (s1, c1, s2, c2) = (a1.sin(), a1.cos(), a2.sin(), a2.cos());
        let floor = 2.0 * (l1 * s1 + l2 * s2) - random.between(0.02, 0.5);
        let rubs = [0, 1].map(|_| random.between(0.0, 0.2) * m2 * g * l2);
        let (mu, e) =
            (random.between(0.0, 0.6), if random.chance(0.4) { 0.0 } else { random.between(0.1, 0.6) });
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let (upper, fore) = (Some(world.body(m1, j1)), Some(world.body(m2, j2)));
        world.pin((upper, [-l1, 0.0]), (None, [0.0; 2]));
        world.pin((fore, [-l2, 0.0]), (upper, [l1, 0.0]));
        world.row(sum([(5, 1.0), (2, -1.0)], -low), Law::Gap { restitution: e });
        world.row(sum([(5, -1.0), (2, 1.0)], high), Law::Gap { restitution: e });
        world.row(sum([(2, 1.0)], 0.0), dry(rubs[0]));
        world.row(sum([(5, 1.0), (2, -1.0)], 0.0), dry(rubs[1]));
        foot(&mut world, (fore, [l2, 0.0]), (None, [0.0, floor]), 0.0, [mu, e]);
        let (w1, w2) = (random.between(-2.0, 2.0), random.between(-2.0, 2.0));
        let starts = vec![
            [l1 * c1, l1 * s1, a1, -l1 * s1 * w1, l1 * c1 * w1, w1],
            [
                2.0 * l1 * c1 + l2 * c2,
                2.0 * l1 * s1 + l2 * s2,
                a2,
                -2.0 * l1 * s1 * w1 - l2 * s2 * w2,
                2.0 * l1 * c1 * w1 + l2 * c2 * w2,
                w2,
            ],
        ];
        Draft {
            numbers: vec![m1, j1, m2, j2, g, l1, l2, floor, low, high, rubs[0], rubs[1], mu, e],
            starts,
            world,
        }
    }
}

/// Two bodies on ropes that go slack, one below the other, over a floor.
pub mod ropes {
    use crate::families::Draft;
    use crate::families::laws::foot;
    use crate::reference::world::Place;
    use crate::reference::world::{Law, World};
    use plm_oracle::Random;

    declare! { tree;
        parameters { m1: (kg), j1: (kg*m^2), m2: (kg), j2: (kg*m^2), g: (m/s^2), d1: (m), d2: (m), l1: (m), l2: (m),
            floor: (m),; mu e }
        bodies { one two }
        {
            gravity: g;
            ground { port o: (0, 0) m; port floor: (0 m, floor), axis: 0 deg; }
            body one { mass: m1; inertia: j1; port top: (0 m, d1); port c: (0, 0) m; }
            body two { mass: m2; inertia: j2; port top: (0 m, d2); port c: (0 m, -d2); }
            unilateral first: norm(one.top.position - ground.o.position) <= l1 { restitution: e; }
            unilateral second: norm(two.top.position - one.c.position) <= l2 { restitution: e; }
            foot sole(two.c, ground.floor) { mu: mu; e: e; }
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let (m1, m2, g) = (random.between(0.5, 3.0), random.between(0.5, 3.0), random.between(2.0, 12.0));
        let (d1, d2) = (random.between(0.05, 0.3), random.between(0.05, 0.3));
        let (j1, j2) = (m1 * d1 * d1 * random.between(0.2, 2.0), m2 * d2 * d2 * random.between(0.2, 2.0));
        let (a, b) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let (r1, r2) = (random.between(0.2, 0.8), random.between(0.2, 0.8));
        let (l1, l2) = (r1 + random.between(0.005, 0.1), r2 + random.between(0.005, 0.1));
        let top = [r1 * a.sin(), -r1 * a.cos()];
        let one = [top[0], top[1] - d1];
        let other = [one[0] + r2 * b.sin(), one[1] - r2 * b.cos()];
        let two = [other[0], other[1] - d2];
        let floor = two[1] - d2 - random.between(0.02, 0.4);
        let (mu, e) =
            (random.between(0.0, 0.6), if random.chance(0.4) { 0.0 } else { random.between(0.1, 0.6) });
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let (first, second) = (Some(world.body(m1, j1)), Some(world.body(m2, j2)));
        let rope = |a, b, length| Place::Distance { a, b, factor: -1.0, offset: length };
        world.row(rope((first, [0.0, d1]), (None, [0.0; 2]), l1), Law::Gap { restitution: e });
        world.row(rope((second, [0.0, d2]), (first, [0.0; 2]), l2), Law::Gap { restitution: e });
        foot(&mut world, (second, [0.0, -d2]), (None, [0.0, floor]), 0.0, [mu, e]);
        let mut speed = || random.between(-1.0, 1.0);
        let starts = vec![
            [one[0], one[1], 0.0, speed(), speed(), speed()],
            [two[0], two[1], 0.0, speed(), speed(), speed()],
        ];
        Draft { numbers: vec![m1, j1, m2, j2, g, d1, d2, l1, l2, floor, mu, e], starts, world }
    }
}

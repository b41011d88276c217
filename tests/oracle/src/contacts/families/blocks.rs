//! Free bodies that strike, slide, tip and rest.

use plm_oracle::Random;

/// Numbers of a block: mass, moment of inertia, gravity, half its width and height, two coefficients of friction, restitution.
fn drawn(random: &mut Random) -> [f64; 8] {
    let (m, g, w, h) = (
        random.between(0.5, 3.0),
        random.between(5.0, 12.0),
        random.between(0.1, 0.5),
        random.between(0.1, 0.5),
    );
    let j = m * (w * w + h * h) * random.between(0.2, 0.6);
    let (mu, nu) = (random.between(0.0, 0.8), random.between(0.0, 0.8));
    let e = if random.chance(0.5) { 0.0 } else { random.between(0.0, 0.5) };
    [m, j, g, w, h, mu, nu, e]
}

/// Two feet on a slope.
pub mod block {
    use super::drawn;
    use crate::families::Draft;
    use crate::families::laws::foot;
    use crate::reference::world::World;
    use plm_oracle::Random;

    declare! { tree;
        parameters { mass: (kg), j: (kg*m^2), g: (m/s^2), width: (m), height: (m), tilt: (rad),; mu nu e }
        bodies { block }
        {
            gravity: g;
            ground { port floor: (0, 0) m, axis: tilt; }
            body block { mass: mass; inertia: j; port left: (-width, -height); port right: (width, -height); }
            foot left(block.left, ground.floor) { mu: mu; e: e; }
            foot right(block.right, ground.floor) { mu: nu; e: e; }
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let [m, j, g, w, h, mu, nu, e] = drawn(random);
        let tilt = random.between(-0.5, 0.5);
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let body = world.body(m, j);
        foot(&mut world, (Some(body), [-w, -h]), (None, [0.0; 2]), tilt, [mu, e]);
        foot(&mut world, (Some(body), [w, -h]), (None, [0.0; 2]), tilt, [nu, e]);
        // On its feet, on one of them, or above.
        let pick = random.below(4);
        let turn =
            [0.0, random.between(0.02, 0.4), random.between(-0.4, -0.02), random.between(-0.4, 0.4)][pick];
        let (s, c) = turn.sin_cos();
        let low = (s * w).abs() + c * h;
        let rise = if pick == 3 { low + random.between(0.01, 0.3) } else { low };
        let spin = if pick == 0 { 0.0 } else { random.between(-2.0, 2.0) };
        let slide = if random.chance(0.3) { 0.0 } else { random.between(-1.5, 1.5) };
        // The foot that touches has no speed across the floor.
        let arm = if turn > 0.0 { -c * w + s * h } else { c * w + s * h };
        let climb = match pick {
            0 => 0.0,
            3 => random.between(-1.0, 1.0),
            _ => -spin * arm,
        };
        let (st, ct) = tilt.sin_cos();
        let start =
            [-st * rise, ct * rise, tilt + turn, ct * slide - st * climb, st * slide + ct * climb, spin];
        Draft { numbers: vec![m, j, g, w, h, tilt, mu, nu, e], starts: vec![start], world }
    }
}

/// Four corners between a floor and a wall: eight pairs of gaps and frictions would touch at most three at once.
pub mod crate_in_corner {
    use super::drawn;
    use crate::families::Draft;
    use crate::families::laws::foot;
    use crate::reference::world::World;
    use plm_oracle::Random;

    declare! { tree;
        parameters { mass: (kg), j: (kg*m^2), g: (m/s^2), width: (m), height: (m),; mu nu e }
        bodies { block }
        {
            gravity: g;
            ground { port floor: (0, 0) m, axis: 0 deg; port wall: (0, 0) m, axis: -90 deg; }
            body block { mass: mass; inertia: j; port a: (-width, -height); port b: (width, -height); port c: (width, height); port d: (-width, height); }
            foot a(block.a, ground.floor) { mu: mu; e: e; }
            foot b(block.b, ground.floor) { mu: mu; e: e; }
            foot c(block.c, ground.floor) { mu: mu; e: e; }
            foot d(block.d, ground.floor) { mu: mu; e: e; }
            foot a1(block.a, ground.wall) { mu: nu; e: e; }
            foot d1(block.d, ground.wall) { mu: nu; e: e; }
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let [m, j, g, w, h, mu, nu, e] = drawn(random);
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let body = Some(world.body(m, j));
        let corners = [[-w, -h], [w, -h], [w, h], [-w, h]];
        for corner in corners {
            foot(&mut world, (body, corner), (None, [0.0; 2]), 0.0, [mu, e]);
        }
        for corner in [corners[0], corners[3]] {
            foot(&mut world, (body, corner), (None, [0.0; 2]), -std::f64::consts::FRAC_PI_2, [nu, e]);
        }
        let turn = random.between(-1.2, 1.2);
        let (s, c) = turn.sin_cos();
        let (low, left) = (s.abs() * w + c * h, s.abs() * h + c * w);
        let start = [
            left + random.between(0.02, 0.4),
            low + random.between(0.02, 0.4),
            turn,
            random.between(-2.0, 0.5),
            random.between(-2.0, 0.5),
            random.between(-3.0, 3.0),
        ];
        Draft { numbers: vec![m, j, g, w, h, mu, nu, e], starts: vec![start], world }
    }
}

/// A block on a wedge that slides on the ground.
pub mod wedge {
    use crate::families::Draft;
    use crate::families::laws::foot;
    use crate::reference::world::{Bound, Law, Place, World};
    use plm_oracle::Random;

    declare! { tree absolute;
        parameters { m1: (kg), m2: (kg), j2: (kg*m^2), g: (m/s^2), width: (m), height: (m), tilt: (rad),; mu nu e }
        bodies { wedge block }
        {
            gravity: g;
            ground { port o: (0, 0) m, axis: 0 deg; }
            body wedge { mass: m1; inertia: 1 kg*m^2; port o: (0, 0) m; port face: (0, 0) m, axis: tilt; }
            body block { mass: m2; inertia: j2; port left: (-width, -height); port right: (width, -height); }
            prismatic rail(ground.o, wedge.o);
            foot left(block.left, wedge.face) { mu: mu; e: e; }
            foot right(block.right, wedge.face) { mu: mu; e: e; }
            friction rub: rate(wedge.x) within nu*norm(rail.force);
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let (m1, m2, g) = (random.between(0.5, 3.0), random.between(0.5, 3.0), random.between(5.0, 12.0));
        let (w, h) = (random.between(0.1, 0.5), random.between(0.1, 0.3));
        let j = m2 * (w * w + h * h) * random.between(0.2, 0.6);
        let tilt = random.between(-0.6, 0.6);
        let (mu, nu) = (random.between(0.0, 0.8), random.between(0.0, 0.4));
        let e = if random.chance(0.5) { 0.0 } else { random.between(0.0, 0.5) };
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let (wedge, block) = (Some(world.body(m1, 1.0)), Some(world.body(m2, j)));
        let rail = world.joints.len();
        let zero = |k| Place::Sum { terms: vec![(k, 1.0)], offset: 0.0, rate: 0.0 };
        world.joints.extend([zero(1), zero(2)]);
        foot(&mut world, (block, [-w, -h]), (wedge, [0.0; 2]), tilt, [mu, e]);
        foot(&mut world, (block, [w, -h]), (wedge, [0.0; 2]), tilt, [mu, e]);
        let bound = Bound { joint: Some((rail, None, nu)), adhesion: 1.0, ..Bound::default() };
        world.row(zero(0), Law::Rub(bound));
        let turn = if random.chance(0.5) { 0.0 } else { random.between(-0.3, 0.3) };
        let (s, c) = turn.sin_cos();
        let rise = s.abs() * w + c * h + if turn == 0.0 { 0.0 } else { random.between(0.0, 0.2) };
        let speed = if random.chance(0.4) { 0.0 } else { random.between(-1.0, 1.0) };
        let (slide, spin) = if turn == 0.0 { (speed, 0.0) } else { (speed, random.between(-1.0, 1.0)) };
        let drift = if random.chance(0.5) { 0.0 } else { random.between(-1.0, 1.0) };
        let (st, ct) = tilt.sin_cos();
        let fall = if turn == 0.0 { 0.0 } else { -0.1 };
        let starts = vec![
            [0.0, 0.0, 0.0, drift, 0.0, 0.0],
            [
                -st * rise,
                ct * rise,
                tilt + turn,
                drift + ct * slide - st * fall,
                st * slide + ct * fall,
                spin,
            ],
        ];
        Draft { numbers: vec![m1, m2, j, g, w, h, tilt, mu, nu, e], starts, world }
    }
}

/// A block on a block: eight rows that rest at once.
pub mod stack {
    use crate::families::Draft;
    use crate::families::laws::foot;
    use crate::reference::world::World;
    use plm_oracle::Random;

    declare! { tree;
        parameters { m1: (kg), j1: (kg*m^2), m2: (kg), j2: (kg*m^2), g: (m/s^2), w1: (m), h1: (m), w2: (m), h2: (m),
            tilt: (rad),; mu nu e }
        bodies { lower upper }
        {
            gravity: g;
            ground { port floor: (0, 0) m, axis: tilt; }
            body lower { mass: m1; inertia: j1; port left: (-w1, -h1); port right: (w1, -h1); port top: (0 m, h1), axis: 0 deg; }
            body upper { mass: m2; inertia: j2; port left: (-w2, -h2); port right: (w2, -h2); }
            foot a(lower.left, ground.floor) { mu: mu; e: e; }
            foot b(lower.right, ground.floor) { mu: mu; e: e; }
            foot c(upper.left, lower.top) { mu: nu; e: e; }
            foot d(upper.right, lower.top) { mu: nu; e: e; }
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let (m1, m2, g) = (random.between(0.5, 3.0), random.between(0.5, 3.0), random.between(5.0, 12.0));
        let [w1, h1, w2, h2] =
            [(0.3, 0.6), (0.1, 0.3), (0.1, 0.3), (0.1, 0.4)].map(|(low, high)| random.between(low, high));
        let j1 = m1 * (w1 * w1 + h1 * h1) * random.between(0.2, 0.6);
        let j2 = m2 * (w2 * w2 + h2 * h2) * random.between(0.2, 0.6);
        let tilt = random.between(-0.4, 0.4);
        let (mu, nu) = (random.between(0.0, 0.8), random.between(0.0, 0.8));
        let e = if random.chance(0.7) { 0.0 } else { random.between(0.0, 0.4) };
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let (lower, upper) = (Some(world.body(m1, j1)), Some(world.body(m2, j2)));
        for side in [-w1, w1] {
            foot(&mut world, (lower, [side, -h1]), (None, [0.0; 2]), tilt, [mu, e]);
        }
        for side in [-w2, w2] {
            foot(&mut world, (upper, [side, -h2]), (lower, [0.0, h1]), 0.0, [nu, e]);
        }
        let (st, ct) = tilt.sin_cos();
        let turn = if random.chance(0.6) { 0.0 } else { random.between(-0.3, 0.3) };
        let lift =
            if turn == 0.0 { h2 } else { turn.sin().abs() * w2 + turn.cos() * h2 + random.between(0.0, 0.1) };
        let [slide, drift] = [0; 2].map(|_| if random.chance(0.4) { 0.0 } else { random.between(-1.0, 1.0) });
        let rise = 2.0 * h1 + lift;
        let starts = vec![
            [-st * h1, ct * h1, tilt, ct * slide, st * slide, 0.0],
            [-st * rise, ct * rise, tilt + turn, ct * drift, st * drift, 0.0],
        ];
        Draft { numbers: vec![m1, j1, m2, j2, g, w1, h1, w2, h2, tilt, mu, nu, e], starts, world }
    }
}

/// A drawer between two guides, pulled beside its middle, with clearance.
pub mod drawer {
    use crate::families::Draft;
    use crate::families::laws::foot;
    use crate::reference::world::{Force, World};
    use plm_oracle::Random;

    declare! { tree;
        parameters { mass: (kg), j: (kg*m^2), pull: (N), omega: (Hz), arm: (m), length: (m), width: (m), clearance: (m),; mu e }
        bodies { drawer }
        {
            ground { port low: (0 m, -width - clearance), axis: 0 deg; port high: (0 m, width + clearance), axis: 180 deg; }
            body drawer {
                mass: mass; inertia: j; port o: (0, 0) m;
                port a: (-length, -width); port b: (length, -width); port c: (length, width); port d: (-length, width);
            }
            force motor(drawer.o) { x: pull*sin(omega*t*(1 rad)); torque: -arm*pull*sin(omega*t*(1 rad)); }
            foot a(drawer.a, ground.low) { mu: mu; e: e; }
            foot b(drawer.b, ground.low) { mu: mu; e: e; }
            foot c(drawer.c, ground.high) { mu: mu; e: e; }
            foot d(drawer.d, ground.high) { mu: mu; e: e; }
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let (m, l, w) = (random.between(0.5, 3.0), random.between(0.1, 0.4), random.between(0.1, 0.4));
        let j = m * (w * w + l * l) * random.between(0.2, 0.6);
        let (pull, omega) = (random.between(1.0, 20.0), random.between(2.0, 12.0));
        let arm = random.between(-0.5, 0.5);
        let clearance = random.between(0.002, 0.03);
        let (mu, e) =
            (random.between(0.0, 0.7), if random.chance(0.6) { 0.0 } else { random.between(0.0, 0.4) });
        let mut world = World::default();
        let body = Some(world.body(m, j));
        let swing =
            |coordinate, amplitude| Force::On { coordinate, constant: 0.0, amplitude, omega, phase: 0.0 };
        world.forces.extend([swing(0, pull), swing(2, -arm * pull)]);
        let (low, high) = ((None, [0.0, -w - clearance]), (None, [0.0, w + clearance]));
        foot(&mut world, (body, [-l, -w]), low, 0.0, [mu, e]);
        foot(&mut world, (body, [l, -w]), low, 0.0, [mu, e]);
        foot(&mut world, (body, [l, w]), high, std::f64::consts::PI, [mu, e]);
        foot(&mut world, (body, [-l, w]), high, std::f64::consts::PI, [mu, e]);
        let shift = random.between(-0.8, 0.8) * clearance;
        let start = [
            0.0,
            shift,
            0.0,
            random.between(-1.0, 1.0),
            random.between(-0.2, 0.2),
            random.between(-0.5, 0.5),
        ];
        Draft { numbers: vec![m, j, pull, omega, arm, l, w, clearance, mu, e], starts: vec![start], world }
    }
}

/// Two feet on a table that shakes up and down.
pub mod shaken {
    use crate::families::Draft;
    use crate::reference::world::{Bound, Law, Place, World};
    use plm_oracle::Random;

    declare! { tree;
        parameters { mass: (kg), j: (kg*m^2), g: (m/s^2), width: (m), height: (m), swing: (m), omega: (Hz),; mu e }
        bodies { block }
        {
            gravity: g;
            ground { port table: (0 m, swing*sin(omega*t*(1 rad))), axis: 0 deg; }
            body block { mass: mass; inertia: j; port left: (-width, -height); port right: (width, -height); }
            foot left(block.left, ground.table) { mu: mu; e: e; }
            foot right(block.right, ground.table) { mu: mu; e: e; }
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let (m, g) = (random.between(0.5, 3.0), random.between(5.0, 12.0));
        let (w, h) = (random.between(0.1, 0.3), random.between(0.1, 0.3));
        let j = m * (w * w + h * h) * random.between(0.2, 0.6);
        let omega = random.between(5.0, 20.0);
        let swing = random.between(0.2, 2.0) * g / (omega * omega);
        let (mu, e) =
            (random.between(0.0, 0.8), if random.chance(0.5) { 0.0 } else { random.between(0.1, 0.5) });
        let mut world = World { gravity: [0.0, -g], ..World::default() };
        let body = Some(world.body(m, j));
        for side in [-w, w] {
            let along = |angle, swing| Place::Along {
                a: (body, [side, -h]),
                b: (None, [0.0; 2]),
                angle,
                turns: true,
                swing,
            };
            let gap =
                world.row(along(std::f64::consts::FRAC_PI_2, [swing, omega]), Law::Gap { restitution: e });
            let bound = Bound { by: Some((gap, mu)), adhesion: 1.0, ..Bound::default() };
            world.row(along(0.0, [0.0; 2]), Law::Rub(bound));
        }
        let turn = random.between(-0.3, 0.3);
        let rise = turn.sin().abs() * w + turn.cos() * h + random.between(0.01, 0.2);
        let start = [
            0.0,
            rise,
            turn,
            random.between(-1.0, 1.0),
            random.between(-1.0, 1.0),
            random.between(-2.0, 2.0),
        ];
        Draft { numbers: vec![m, j, g, w, h, swing, omega, mu, e], starts: vec![start], world }
    }
}

//! Bodies on rails: belts, buffers, rows of blocks.

use super::laws::sum;
use crate::reference::world::World;

/// A body that moves along x alone.
pub fn on_rail(world: &mut World, mass: f64) -> usize {
    let body = world.body(mass, 1.0);
    world.joints.extend([sum([(3 * body + 1, 1.0)], 0.0), sum([(3 * body + 2, 1.0)], 0.0)]);
    body
}

/// A block on a belt, on a spring, between buffers; what sticks holds more than what slips.
pub mod belt {
    use super::on_rail;
    use crate::families::Draft;
    use crate::families::laws::sum;
    use crate::reference::world::{Bound, Force, Law, Place, World};
    use plm_oracle::Random;

    declare! { tree;
        parameters { mass: (kg), k: (N/m), damper: (N*s/m), speed: (m/s), bound: (N), push: (N), omega: (Hz), reach: (m),;
            ratio e }
        bodies { block }
        {
            ground { port o: (0, 0) m; }
            body block { mass: mass; inertia: 1 kg*m^2; port o: (0, 0) m; }
            prismatic rail(ground.o, block.o);
            force spring_and_motor(block.o) { x: push*sin(omega*t*(1 rad)) - k*block.x - damper*block.vx; }
            unilateral left: block.x >= -reach { restitution: e; }
            unilateral right: block.x <= reach { restitution: e; }
            friction slip: rate(block.x - speed*t) within bound { static: ratio*bound; }
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let (m, k) = (random.between(0.5, 3.0), random.between(5.0, 200.0));
        let damper = random.between(0.0, 0.3);
        let speed = if random.chance(0.3) { 0.0 } else { random.between(-0.5, 0.5) };
        let bound = random.between(0.1, 10.0);
        let push = random.between(0.0, 15.0);
        let (omega, reach) = (random.between(3.0, 20.0), random.between(0.1, 0.4));
        let ratio = if random.chance(0.5) { 1.0 } else { random.between(1.0, 2.0) };
        let e = if random.chance(0.4) { 0.0 } else { random.between(0.1, 0.7) };
        let mut world = World::default();
        on_rail(&mut world, m);
        world.forces.push(Force::On { coordinate: 0, constant: 0.0, amplitude: push, omega, phase: 0.0 });
        world.forces.push(Force::Spring {
            place: sum([(0, 1.0)], 0.0),
            stiffness: k,
            rest: 0.0,
            damping: damper,
        });
        world.row(sum([(0, 1.0)], reach), Law::Gap { restitution: e });
        world.row(sum([(0, -1.0)], reach), Law::Gap { restitution: e });
        let slip = Place::Sum { terms: vec![(0, 1.0)], offset: 0.0, rate: -speed };
        world.row(slip, Law::Rub(Bound { own: [bound; 2], adhesion: ratio, ..Bound::default() }));
        let start = [reach * random.between(-0.9, 0.9), 0.0, 0.0, random.between(-1.0, 1.0), 0.0, 0.0];
        Draft {
            numbers: vec![m, k, damper, speed, bound, push, omega, reach, ratio, e],
            starts: vec![start],
            world,
        }
    }
}

/// Three blocks on a line between two walls, with springs and dry friction.
pub mod train {
    use super::on_rail;
    use crate::families::Draft;
    use crate::families::laws::{dry, sum};
    use crate::reference::world::{Force, Law, World};
    use plm_oracle::Random;

    declare! { tree absolute;
        parameters { m1: (kg), m2: (kg), m3: (kg), k: (N/m), push: (N), omega: (Hz), width: (m), wall: (m), r1: (N), r2: (N),
            r3: (N),; e }
        bodies { one two three }
        {
            ground { port o: (0, 0) m; }
            body one { mass: m1; inertia: 1 kg*m^2; port o: (0, 0) m; }
            body two { mass: m2; inertia: 1 kg*m^2; port o: (0, 0) m; }
            body three { mass: m3; inertia: 1 kg*m^2; port o: (0, 0) m; }
            prismatic first(ground.o, one.o);
            prismatic second(ground.o, two.o);
            prismatic third(ground.o, three.o);
            force motor(one.o) { x: push*sin(omega*t*(1 rad)); }
            force spring_of_two(two.o) { x: -k*two.x; }
            unilateral wall_left: one.x >= -wall { restitution: e; }
            unilateral gap_one: two.x - one.x >= width { restitution: e; }
            unilateral gap_two: three.x - two.x >= width { restitution: e; }
            unilateral wall_right: three.x <= wall { restitution: e; }
            friction rub_one: rate(one.x) within r1;
            friction rub_two: rate(two.x) within r2;
            friction rub_three: rate(three.x) within r3;
        }
    }

    pub fn draw(random: &mut Random) -> Draft {
        let [m1, m2, m3] = [0; 3].map(|_| random.between(0.5, 3.0));
        let (k, push, omega) =
            (random.between(0.0, 200.0), random.between(0.0, 30.0), random.between(3.0, 20.0));
        let (width, wall) = (0.2, random.between(0.3, 0.6));
        let rubs = [0; 3].map(|_| if random.chance(0.3) { 0.0 } else { random.between(0.1, 5.0) });
        let e = if random.chance(0.4) { 0.0 } else { random.between(0.1, 0.7) };
        let mut world = World::default();
        for m in [m1, m2, m3] {
            on_rail(&mut world, m);
        }
        world.forces.push(Force::On { coordinate: 0, constant: 0.0, amplitude: push, omega, phase: 0.0 });
        world.forces.push(Force::Spring {
            place: sum([(3, 1.0)], 0.0),
            stiffness: k,
            rest: 0.0,
            damping: 0.0,
        });
        let gap = Law::Gap { restitution: e };
        world.row(sum([(0, 1.0)], wall), gap);
        world.row(sum([(3, 1.0), (0, -1.0)], -width), gap);
        world.row(sum([(6, 1.0), (3, -1.0)], -width), gap);
        world.row(sum([(6, -1.0)], wall), gap);
        for (k, rub) in rubs.iter().enumerate() {
            world.row(sum([(3 * k, 1.0)], 0.0), dry(*rub));
        }
        let free = wall - width;
        let x = random.between(-0.5, 0.5) * free;
        let x1 = -wall + (x - width + wall) * random.between(0.05, 0.95);
        let x3 = x + width + (wall - x - width) * random.between(0.05, 0.95);
        let starts = [x1, x, x3].map(|x| [x, 0.0, 0.0, random.between(-2.0, 2.0), 0.0, 0.0]);
        Draft {
            numbers: vec![m1, m2, m3, k, push, omega, width, wall, rubs[0], rubs[1], rubs[2], e],
            starts: starts.to_vec(),
            world,
        }
    }
}

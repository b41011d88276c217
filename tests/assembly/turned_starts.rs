//! Starts by angles alone, far from the origin: no body turns by more than half a turn, and loops close on the image that the
//! declared angles are nearest to.
//!
//! A pose is drawn, and the dimensions of the mechanism follow from it; the declaration has the angles of the pose with an error.
//! All images of a loop are known in closed form.

use std::f64::consts::{PI, TAU};

use plm_compiler::compile;
use plm_compiler::token::Sources;

use crate::drawn::{Asked, Chain, Draw, Loader, Rocking, SixBar, chain, loader, rocking, six_bar};
use crate::random::Random;
use crate::scene::{Given as _, Scene};

/// A pose all of whose angles are as near as this to the declared ones is as good as another, rad.
const NEAR: f64 = 0.5;

/// What came of a kind of cases.
#[derive(Default, Debug)]
struct Tally {
    cases: usize,
    /// No pose was found.
    open: usize,
    /// A body has turned by more than half a turn.
    turned: usize,
    /// Another image is nearer to the declaration.
    farther: usize,
}

impl Tally {
    /// Judges the angles that assembly found by the declared ones, and by all images of the loops. An angle that was not given is
    /// not a number in `declared`.
    fn judge(&mut self, case: &str, found: Option<Vec<f64>>, declared: &[f64], images: &[Vec<f64>]) {
        self.cases += 1;
        let Some(found) = found else {
            self.open += 1;
            println!("{case}: open");
            return;
        };
        let moved: Vec<f64> = found.iter().zip(declared).map(|(found, declared)| found - declared).collect();
        let is_wound =
            |(by, angle): (&f64, &f64)| if by.is_nan() { angle.abs() >= TAU } else { by.abs() > PI };
        if moved.iter().zip(&found).any(is_wound) {
            self.turned += 1;
            println!("{case}: moved by {moved:.2?} to {found:.2?}");
        }
        let least = images.iter().map(|image| off(image, declared)).fold(f64::INFINITY, f64::min);
        if moved.iter().any(|by| by.abs() > NEAR) && off(&found, declared) > least + 1e-6 {
            self.farther += 1;
            println!("{case}: moved by {moved:.2?} where {least:.3} rad^2 is enough");
        }
    }

    fn is_clean(&self) {
        self.has_farther(0);
    }

    /// No more than so many of 200 cases are on an image that is farther than it must be.
    fn has_farther(&self, most: u64) {
        println!("{self:?}");
        assert_eq!((self.open, self.turned), (0, 0), "{self:?}");
        assert!(200 * self.farther as u64 <= most * cases(), "{self:?}");
    }
}

/// The sum of squares of the angles between two poses where both are numbers, but for whole turns.
fn off(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).fold(0.0, |sum, (one, other)| {
        let by = one - other;
        if by.is_nan() {
            return sum;
        }
        let by = by - (by / TAU).round() * TAU;
        by.mul_add(by, sum)
    })
}

/// How many cases there are of each kind.
fn cases() -> u64 {
    std::env::var("PLM_TURNED").map_or(100, |cases| cases.parse().unwrap())
}

/// The angles of bodies.
fn angles(q: &[f64]) -> Vec<f64> {
    q.iter().skip(2).step_by(3).copied().collect()
}

#[test]
fn a_loader_is_assembled_next_to_its_angles() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let Some((m, declared, images)) = loader(seed) else { continue };
        let found = m.assemble().ok().map(|found| angles(&found.q));
        tally.judge(&format!("loader {seed}"), found, &declared, &images);
    }
    tally.is_clean();
}

#[test]
fn a_six_bar_is_assembled_next_to_its_angles() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let Some((m, declared, images)) = six_bar(seed) else { continue };
        let found = m.assemble().ok().map(|found| angles(&found.q));
        tally.judge(&format!("six-bar {seed}"), found, &declared, &images);
    }
    tally.is_clean();
}

/// The link is where loop closure puts it, since nobody gives its angle.
#[test]
fn a_loader_is_assembled_next_to_the_angles_that_are_given() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let Some((mut m, mut declared, images)) = loader(seed) else { continue };
        m = m.with_start("link.angle", 0.0);
        declared[1] = f64::NAN;
        let found = m.assemble().ok().map(|found| angles(&found.q));
        tally.judge(&format!("loader without link {seed}"), found, &declared, &images);
    }
    tally.is_clean();
}

#[test]
fn a_six_bar_is_assembled_next_to_the_angles_that_are_given() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let Some((mut m, mut declared, images)) = six_bar(seed) else { continue };
        m = m.with_start("coupler.angle", 0.0).with_start("link.angle", 0.0);
        (declared[1], declared[3]) = (f64::NAN, f64::NAN);
        let found = m.assemble().ok().map(|found| angles(&found.q));
        tally.judge(&format!("six-bar without couplers {seed}"), found, &declared, &images);
    }
    // Three angles of five fix the image, and each has an error.
    tally.has_farther(4);
}

#[test]
fn a_four_bar_is_assembled_next_to_the_angle_of_its_rocker() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let Some((m, declared, images)) = rocking(seed) else { continue };
        let found = m.assemble().ok().map(|found| angles(&found.q));
        tally.judge(&format!("rocking {seed}"), found, &declared, &images);
    }
    tally.is_clean();
}

/// A crank of 1 m at 40 deg, a coupler of 0.4 m and a rocker of 0.9 m whose pivots are 0.8 m apart: by the law of cosines the rocker is
/// at 93.04 deg + 23.30 deg or - 23.30 deg, and 120 deg are given.
#[test]
fn a_coupler_without_an_angle_leaves_the_rocker_on_its_image() {
    let tip = [40_f64.to_radians().cos() - 0.8, 40_f64.to_radians().sin()];
    let far = tip[0].hypot(tip[1]);
    let rocker = tip[1].atan2(tip[0]) + ((0.9 * 0.9 + far * far - 0.4 * 0.4) / (2.0 * 0.9 * far)).acos();
    let found = angles(&Rocking::new().assemble().unwrap().q);
    assert!((found[2] - rocker).abs() < 1e-12, "{found:?} is not {rocker}");
    assert_same_pose(
        "rocking",
        0,
        (Rocking::text(&Rocking::new()), Rocking::new().assemble().unwrap().q.to_vec()),
    );
}

#[test]
fn a_geared_chain_is_assembled_next_to_its_angles() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let (m, declared) = chain(seed);
        let found = m.assemble().ok().map(|found| angles(&found.q));
        tally.judge(&format!("chain {seed}"), found, &declared, &[]);
    }
    tally.is_clean();
}

/// The four-bar that asks for an image, from these angles, the first of which is locked.
fn asked([one, two, three]: [f64; 3]) -> Scene {
    let started = Asked::new().with_start("second.angle", two).with_start("third.angle", three);
    started.released("second.angle").released("third.angle").with_lock("first.angle", one)
}

#[test]
fn a_turned_image_is_turned_no_further_than_it_must() {
    let mut tally = Tally::default();
    for seed in 0..cases() {
        let mut r = Draw(Random(seed));
        let declared = [0; 3].map(|_| r.angle());
        let m = asked(declared);
        let found = m.assemble().ok().map(|found| angles(&found.q));
        tally.judge(&format!("four-bar {seed}"), found, &declared, &[]);
    }
    tally.is_clean();
}

#[test]
fn what_is_locked_stays_and_what_is_in_place_hardly_moves() {
    for seed in 0..cases() {
        let (m, declared) = chain(seed);
        let mut m = m.locked("one.angle").locked("two.angle");
        let found = m.assemble().unwrap();
        assert_eq!(angles(&found.q)[..2], declared[..2], "chain {seed}");
        // From the assembled pose nothing moves, whatever turns it has.
        for (k, body) in ["one", "two", "wheel"].into_iter().enumerate() {
            let turns = [2.0, -3.0, -4.0][k] * TAU;
            let [x, y, angle] = [0, 1, 2].map(|i| found.q[3 * k + i]);
            for (name, value) in [("x", x), ("y", y), ("angle", angle + turns)] {
                m = m.with_start(&format!("{body}.{name}"), value);
            }
        }
        let again = m.assemble().unwrap();
        assert!(again.moved.iter().all(|by| by.abs() < 1e-12), "chain {seed}: {:?}", again.moved);
    }
}

/// The compiler closes the same start from the text of the declaration.
#[test]
fn the_compiler_assembles_the_same_poses() {
    for seed in 0..12 {
        let mut r = Draw(Random(seed));
        let (chain, _) = chain(seed);
        let angles = [0; 3].map(|_| r.angle());
        let [one, two, three] = angles;
        let asked = asked(angles).with("one", one).with("two", two).with("three", three);
        assert_same_pose("four-bar", seed, (Asked::text(&asked), asked.assemble().unwrap().q.to_vec()));
        assert_same_pose("chain", seed, (Chain::text(&chain), chain.assemble().unwrap().q.to_vec()));
        // The texts give no angles of the links.
        if let Some((mut m, ..)) = loader(seed) {
            m = m.with_start("link.angle", 0.0);
            assert_same_pose("loader", seed, (Loader::text(&m), m.assemble().unwrap().q.to_vec()));
        }
        if let Some((mut m, ..)) = six_bar(seed) {
            m = m.with_start("coupler.angle", 0.0).with_start("link.angle", 0.0);
            assert_same_pose("six-bar", seed, (SixBar::text(&m), m.assemble().unwrap().q.to_vec()));
        }
    }
}

fn assert_same_pose(case: &str, seed: u64, (text, q): (String, Vec<f64>)) {
    let mut sources = Sources::new();
    sources.add_text("declaration", &text);
    let picture = compile(&mut sources).oracle.expect(&text).picture();
    let poses = picture.bodies.iter().flat_map(|body| body.pose);
    for (found, compiled) in q.iter().zip(poses) {
        assert!((found - compiled).abs() < 1e-7, "{case} {seed}: {q:?} is not {:?}", picture.bodies);
    }
}

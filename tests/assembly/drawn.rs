//! Mechanisms whose dimensions follow from a pose drawn by chance, with all images of their loops.

use std::f64::consts::PI;

use crate::random::Random;
use crate::scene::{Given as _, Scene};

/// Largest error of a declared angle, rad.
const ERROR: f64 = 0.3;
/// Declares a mechanism, and gives the text of its declaration with numbers in place of its parameters.
macro_rules! declare {
    ($name:ident, [$($param:ident: $unit:ident = $value:literal),+], { $($item:tt)* }) => {
        scene! {
            pub $name {
                joint ram(a: frame, b: frame) {
                    param length: m;
                    constraint distance: norm(b.position - a.position) = length;
                }
                formulation: absolute;
                $(param $param: $unit = $value $unit;)+
                $($item)*
            }
        }

        impl $name {
            pub fn text(of: &Scene) -> String {
                let joint = "joint ram(a: frame, b: frame) { param length: m; constraint distance: norm(b.position - a.position) = length; }";
                let params = [$(format!("param {0}: {1} = {2:?} {1};", stringify!($param), stringify!($unit), of.parameter_of(stringify!($param)))),+];
                let items = concat!($(stringify!($item), " "),*);
                format!("{joint} pub {} {{ formulation: absolute; {} {items} }}", stringify!($name), params.concat())
            }
        }
    };
}

/// Points whose coordinates are parameters: of `a` they are `ax` and `ay`.
fn with_points(scene: Scene, points: &[(&str, Point)]) -> Scene {
    points.iter().fold(scene, |scene, (name, [x, y])| {
        scene.with(&format!("{name}x"), *x).with(&format!("{name}y"), *y)
    })
}

// A rocker that a driven jack turns, and a link from it to a bucket. The declaration gives no angle of the link.
declare!(
    Loader,
    [
        ax: m = 0.1, ay: m = 0, dx: m = 1, dy: m = 0, jx: m = 0, jy: m = -1, ux: m = 0.3, uy: m = 0.2, rx: m = 0.5, ry: m = 0,
        lx: m = 0.8, ly: m = 0, bx: m = 0.4, by: m = 0.1, reach: m = 1.12, one: rad = 1, three: rad = 1
    ],
    {
        ground { port a: (ax, ay); port d: (dx, dy); port j: (jx, jy); }
        body rocker { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port j: (ux, uy); port b: (rx, ry); start angle: one; }
        body link { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (lx, ly); }
        body bucket { mass: 1 kg; inertia: 1 kg*m^2; port d: (0, 0) m; port c: (bx, by); start angle: three; }
        revolute a(ground.a, rocker.a);
        revolute b(rocker.b, link.b);
        revolute c(link.c, bucket.c);
        revolute d(ground.d, bucket.d);
        ram jack(ground.j, rocker.j) { length: reach; }
    }
);

// A four-bar whose coupler carries a second dyad; its crank is driven. The declaration gives no angles of the couplers.
declare!(
    SixBar,
    [
        ax: m = 0, ay: m = 0, dx: m = 1, dy: m = 0, gx: m = 0.5, gy: m = 1, kx: m = 0.3, ky: m = 0, cx: m = 0.9, cy: m = 0,
        sx: m = 0.4, sy: m = 0.2, rx: m = 0.7, ry: m = 0, lx: m = 0.6, ly: m = 0, tx: m = 0.6, ty: m = 0,
        q: rad = 1, three: rad = 1, five: rad = 1
    ],
    {
        ground { port a: (ax, ay); port d: (dx, dy); port g: (gx, gy); }
        body crank { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (kx, ky); start angle: q; }
        body coupler { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (cx, cy); port s: (sx, sy); }
        body rocker { mass: 1 kg; inertia: 1 kg*m^2; port d: (0, 0) m; port c: (rx, ry); start angle: three; }
        body link { mass: 1 kg; inertia: 1 kg*m^2; port s: (0, 0) m; port tip: (lx, ly); }
        body arm { mass: 1 kg; inertia: 1 kg*m^2; port g: (0, 0) m; port tip: (tx, ty); start angle: five; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(ground.d, rocker.d);
        revolute s(coupler.s, link.s);
        revolute tip(link.tip, arm.tip);
        revolute g(ground.g, arm.g);
        constraint drive: crank.angle = q;
    }
);

// A four-bar whose bodies have their origins in the middle. The declaration gives no angle of the coupler.
declare!(
    Rocking,
    [
        ax: m = 0, ay: m = 0, dx: m = 0.8, dy: m = 0, kx: m = 0.5, ky: m = 0, cx: m = 0.2, cy: m = 0, rx: m = 0.45, ry: m = 0,
        q: rad = 0.6981317007977318, three: rad = 2.0943951023931953
    ],
    {
        ground { port a: (ax, ay); port d: (dx, dy); }
        body crank { mass: 1 kg; inertia: 1 kg*m^2; port a: (-kx, -ky); port b: (kx, ky); start angle: q, locked; }
        body coupler { mass: 1 kg; inertia: 1 kg*m^2; port b: (-cx, -cy); port c: (cx, cy); }
        body rocker { mass: 1 kg; inertia: 1 kg*m^2; port d: (-rx, -ry); port c: (rx, ry); start angle: three; }
        revolute a(ground.a, crank.a);
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c);
        revolute d(ground.d, rocker.d);
    }
);

// Three bars in a row, the last with a wheel that a gear turns with the first.
declare!(
    Chain,
    [
        ax: m = 0, ay: m = 0, ux: m = 0.5, uy: m = 0, vx: m = 0.5, vy: m = 0, ex: m = 0, ey: m = 0.1, phase: rad = 0,
        first: rad = 0, second: rad = 0, third: rad = 0
    ],
    {
        ground { port a: (ax, ay); }
        body one { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (ux, uy); start angle: first; }
        body two { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (vx, vy); start angle: second; }
        body wheel { mass: 1 kg; inertia: 1 kg*m^2; port c: (ex, ey); start angle: third; }
        revolute a(ground.a, one.a);
        revolute b(one.b, two.b);
        revolute c(two.c, wheel.c);
        constraint gear: wheel.angle + 2*one.angle = phase;
    }
);

// A four-bar that asks for an image.
declare!(
    Asked,
    [
        crank: m = 0.3, coupler: m = 0.9, rocker: m = 0.7, span: m = 1,
        one: rad = 1, two: rad = 0, three: rad = 1
    ],
    {
        ground { port a: (0, 0) m; port d: (span, 0); }
        body first { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; port b: (crank, 0); start angle: one, locked; }
        body second { mass: 1 kg; inertia: 1 kg*m^2; port b: (0, 0) m; port c: (coupler, 0); start angle: two; }
        body third { mass: 1 kg; inertia: 1 kg*m^2; port d: (0, 0) m; port c: (rocker, 0); start angle: three; }
        revolute a(ground.a, first.a);
        revolute b(first.b, second.b);
        revolute c(second.c, third.c) { branch: left; }
        revolute d(ground.d, third.d);
    }
);

type Point = [f64; 2];

fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

fn direction(a: Point) -> f64 {
    a[1].atan2(a[0])
}

fn size(a: Point) -> f64 {
    a[0].hypot(a[1])
}

fn turned([x, y]: Point, by: f64) -> Point {
    let (sin, cos) = by.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

/// The place of a point of a body whose origin stands at `at`.
fn place(at: Point, angle: f64, local: Point) -> Point {
    let arm = turned(local, angle);
    [at[0] + arm[0], at[1] + arm[1]]
}

/// Both angles of the bodies of a dyad: one at `a` whose pin is at `p`, one at `b` whose pin is at `q`, both seen in their bodies.
fn dyad(a: Point, b: Point, p: Point, q: Point) -> Vec<[f64; 2]> {
    let (line, far) = (sub(b, a), size(sub(b, a)));
    let (first, second) = (size(p), size(q));
    let cosine = (first * first + far * far - second * second) / (2.0 * first * far);
    if cosine.abs() > 1.0 {
        return Vec::new();
    }
    let both = [cosine.acos(), -cosine.acos()].map(|half| {
        let one = direction(line) + half - direction(p);
        [one, direction(sub(place(a, one, p), b)) - direction(q)]
    });
    both.to_vec()
}

/// Places by chance.
pub struct Draw(pub Random);

impl Draw {
    pub fn angle(&mut self) -> f64 {
        PI * self.0.unit()
    }

    /// A point that is not too near to others.
    fn point(&mut self, about: Point, from: &[Point]) -> Point {
        loop {
            let point = [about[0] + self.0.unit(), about[1] + self.0.unit()];
            if from.iter().all(|other| size(sub(point, *other)) > 0.3) {
                return point;
            }
        }
    }

    /// A declared angle, which is not exact.
    fn declared(&mut self, angle: f64) -> f64 {
        ERROR.mul_add(self.0.unit(), angle)
    }
}

/// Is the triangle of a dyad far from flat?
fn is_wide(a: Point, pin: Point, b: Point) -> bool {
    let turn = direction(sub(pin, a)) - direction(sub(b, pin));
    turn.sin().abs() > 0.35
}

/// Where a mechanism stands: at the origin, or metres away.
fn site(r: &mut Draw, seed: u64) -> Point {
    let far = [0.5, 2.0, 10.0][(seed % 3) as usize];
    [far * r.0.unit(), far * r.0.unit()]
}

pub fn loader(seed: u64) -> Option<(Scene, [f64; 3], Vec<Vec<f64>>)> {
    let mut r = Draw(Random(seed));
    let at = site(&mut r, seed);
    let a = r.point(at, &[]);
    let d = r.point(at, &[a]);
    let foot = r.point(at, &[a]);
    let head = r.point(at, &[a, foot]);
    let b = r.point(at, &[a, d]);
    let c = r.point(at, &[b, d]);
    if !(is_wide(b, c, d) && is_wide(a, head, foot)) {
        return None;
    }
    let [rocker, link, bucket] = [0; 3].map(|_| r.angle());
    let [[ux, uy], [rx, ry]] = [head, b].map(|pin| turned(sub(pin, a), -rocker));
    let [lx, ly] = turned(sub(c, b), -link);
    let [bx, by] = turned(sub(c, d), -bucket);
    let reach = size(sub(head, foot));
    let declared = [rocker, link, bucket].map(|angle| r.declared(angle));
    let points =
        [("a", a), ("d", d), ("j", foot), ("u", [ux, uy]), ("r", [rx, ry]), ("l", [lx, ly]), ("b", [bx, by])];
    let m = with_points(Loader::new(), &points)
        .with("reach", reach)
        .with("one", declared[0])
        .with("three", declared[2])
        .with_start("rocker.angle", declared[0])
        .with_start("link.angle", declared[1])
        .with_start("bucket.angle", declared[2]);
    let mut images = Vec::new();
    for [rocker, _] in dyad(a, foot, [ux, uy], [reach, 0.0]) {
        let b = place(a, rocker, [rx, ry]);
        images.extend(
            dyad(b, d, [lx, ly], [bx, by]).into_iter().map(|[link, bucket]| vec![rocker, link, bucket]),
        );
    }
    Some((m, declared, images))
}

pub fn six_bar(seed: u64) -> Option<(Scene, [f64; 5], Vec<Vec<f64>>)> {
    let mut r = Draw(Random(seed));
    let at = site(&mut r, seed);
    let a = r.point(at, &[]);
    let d = r.point(at, &[a]);
    let g = r.point(at, &[d]);
    let b = r.point(at, &[a, d]);
    let c = r.point(at, &[b, d]);
    let s = r.point(at, &[b, c, g]);
    let t = r.point(at, &[s, g]);
    if !(is_wide(b, c, d) && is_wide(s, t, g)) {
        return None;
    }
    let [q, coupler, rocker, link, arm] = [0; 5].map(|_| r.angle());
    let [kx, ky] = turned(sub(b, a), -q);
    let [[cx, cy], [sx, sy]] = [c, s].map(|pin| turned(sub(pin, b), -coupler));
    let [rx, ry] = turned(sub(c, d), -rocker);
    let [lx, ly] = turned(sub(t, s), -link);
    let [tx, ty] = turned(sub(t, g), -arm);
    let mut declared = [q, coupler, rocker, link, arm].map(|angle| r.declared(angle));
    declared[0] = q;
    let points = [
        ("a", a),
        ("d", d),
        ("g", g),
        ("k", [kx, ky]),
        ("c", [cx, cy]),
        ("s", [sx, sy]),
        ("r", [rx, ry]),
        ("l", [lx, ly]),
        ("t", [tx, ty]),
    ];
    let m = with_points(SixBar::new(), &points)
        .with("q", q)
        .with("three", declared[2])
        .with("five", declared[4])
        .with_start("crank.angle", declared[0])
        .with_start("coupler.angle", declared[1])
        .with_start("rocker.angle", declared[2])
        .with_start("link.angle", declared[3])
        .with_start("arm.angle", declared[4]);
    let mut images = Vec::new();
    for [coupler, rocker] in dyad(b, d, [cx, cy], [rx, ry]) {
        let s = place(b, coupler, [sx, sy]);
        images.extend(
            dyad(s, g, [lx, ly], [tx, ty]).into_iter().map(|[link, arm]| vec![q, coupler, rocker, link, arm]),
        );
    }
    Some((m, declared, images))
}

/// Of the crank, the coupler and the rocker; the angle of the coupler is not given.
pub fn rocking(seed: u64) -> Option<(Scene, [f64; 3], Vec<Vec<f64>>)> {
    let mut r = Draw(Random(seed));
    let at = site(&mut r, seed);
    let a = r.point(at, &[]);
    let d = r.point(at, &[a]);
    let b = r.point(at, &[a, d]);
    let c = r.point(at, &[b, d]);
    if !is_wide(b, c, d) {
        return None;
    }
    let [q, coupler, rocker] = [0; 3].map(|_| r.angle());
    let half = |bar: Point, angle: f64| turned(bar, -angle).map(|side| 0.5 * side);
    let [[kx, ky], [cx, cy], [rx, ry]] =
        [half(sub(b, a), q), half(sub(c, b), coupler), half(sub(c, d), rocker)];
    let three = r.declared(rocker);
    let points = [("a", a), ("d", d), ("k", [kx, ky]), ("c", [cx, cy]), ("r", [rx, ry])];
    let m = with_points(Rocking::new(), &points)
        .with("q", q)
        .with("three", three)
        .with_start("crank.angle", q)
        .with_start("rocker.angle", three);
    let images = dyad(b, d, [2.0 * cx, 2.0 * cy], [2.0 * rx, 2.0 * ry]);
    Some((
        m,
        [q, f64::NAN, three],
        images.into_iter().map(|[coupler, rocker]| vec![q, coupler, rocker]).collect(),
    ))
}

pub fn chain(seed: u64) -> (Scene, [f64; 3]) {
    let mut r = Draw(Random(seed));
    let [ax, ay] = site(&mut r, seed);
    let [[ux, uy], [vx, vy], [ex, ey]] = [0; 3].map(|_| r.point([0.0; 2], &[[0.0; 2]]));
    let [one, two, wheel] = [0; 3].map(|_| r.angle());
    let declared = [one, two, wheel].map(|angle| r.declared(angle));
    let points = [("a", [ax, ay]), ("u", [ux, uy]), ("v", [vx, vy]), ("e", [ex, ey])];
    let m = with_points(Chain::new(), &points)
        .with("phase", 2.0_f64.mul_add(one, wheel))
        .with("first", declared[0])
        .with("second", declared[1])
        .with("third", declared[2])
        .with_start("one.angle", declared[0])
        .with_start("two.angle", declared[1])
        .with_start("wheel.angle", declared[2]);
    (m, declared)
}

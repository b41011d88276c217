//! The pictures, which a test compares with those of the book.

use std::error::Error;

use plm::Real;
use plm::synthesis::motion::{BodyPose, burmester_curves, five_pose_dyads};
use plm::synthesis::path::{Bounds, Crank, Found, Path, Search, Timing};
use plm::synthesis::tolerance::{Dimension, Distribution, Quantity, stack};
use plm::view::{Axis, Chart, Series};

/// A picture: its path in the repository, and its text.
type Figure = (String, String);

/// All pictures.
///
/// # Errors
/// A synthesis without a result.
pub fn all() -> Result<Vec<Figure>, Box<dyn Error>> {
    let figure =
        |name: &str, chart: &Chart| (format!("docs/src/images/synthesis/{name}.svg"), chart.to_svg());
    Ok(vec![
        figure("ellipse", &ellipse_chart()?),
        figure("burmester", &burmester_chart()?),
        figure("pareto", &pareto_chart()?),
    ])
}

/// Marks without a line: each is a series of one point.
fn dots(points: &[[f64; 2]]) -> Vec<(f64, f64)> {
    points.iter().flat_map(|&[x, y]| [(x, y), (f64::NAN, f64::NAN)]).collect()
}

fn line(points: &[[f64; 2]]) -> Vec<(f64, f64)> {
    points.iter().map(|&[x, y]| (x, y)).collect()
}

/// Ten points of an ellipse (Acharyya and Mandal, 2009), m.
fn ellipse() -> Path {
    let points = vec![
        [20.0, 10.0],
        [17.66, 15.142],
        [11.736, 17.878],
        [5.0, 16.928],
        [0.60307, 12.736],
        [0.60307, 7.2638],
        [5.0, 3.0718],
        [11.736, 2.1215],
        [17.66, 4.8577],
        [20.0, 10.0],
    ];
    let around = [-80.0, 80.0];
    let bounds = Bounds {
        pivot: [around; 2],
        ground_angle: [0.0, std::f64::consts::TAU],
        lengths: [[5.0, 80.0]; 4],
        point: [around; 2],
    };
    Path { points, timing: Timing::Free, bounds, crank: Crank::Turns, transmission: 0.0 }
}

fn best(path: &Path) -> Result<Found, Box<dyn Error>> {
    let found = path.search(&Search { starts: 300, ..Search::default() })?;
    found.into_iter().next().ok_or_else(|| "no linkage".into())
}

/// Declaration of the linkage that draws the ellipse.
///
/// # Errors
/// A search without a result.
#[allow(dead_code, reason = "the test draws pictures alone")]
pub fn declaration() -> Result<String, Box<dyn Error>> {
    let found = best(&ellipse())?;
    found.four_bar.declaration("Ellipse", found.angles[0]).ok_or_else(|| "the loop is open".into())
}

fn ellipse_chart() -> Result<Chart, Box<dyn Error>> {
    let path = ellipse();
    let found = best(&path)?;
    let pose = found.four_bar.pose(found.angles[1]).ok_or("the loop is open")?;
    let [[pin, _], [pivot, _]] = [pose.pins, found.four_bar.pivots];
    Ok(Chart::new(Axis::linear("x", "m").range(-3.0, 22.7), Axis::linear("y", "m").range(-1.0, 20.0))
        .titled("Ten points of an ellipse, and the coupler curve")
        .noted(format!("sum of squared distances {:.3e} m^2, best of 300 starts", found.error))
        .with(Series::new("coupler curve", line(&found.four_bar.curve(361))))
        .with(Series::new("points", dots(&path.points)).marked())
        .with(Series::new("crank and coupler point", line(&[pivot, pin, pose.point])).marked()))
}

/// Five poses of the page on synthesis.
fn poses() -> [BodyPose; 5] {
    let pose = |x, y, degrees: f64| BodyPose { place: [x, y], angle: degrees.to_radians() };
    [
        pose(0.1, 0.1, 0.0),
        pose(0.5, 0.1, 15.0),
        pose(1.2, 0.1, 45.0),
        pose(1.8, 0.4, 80.0),
        pose(2.1, 0.5, 115.0),
    ]
}

fn burmester_chart() -> Result<Chart, Box<dyn Error>> {
    let poses = poses();
    let curves = burmester_curves(&poses[..4], [1.0, 1.0], 90)?;
    let dyads = five_pose_dyads(&poses)?;
    let inside = |place: &[f64; 2]| (-1.0..3.5).contains(&place[0]) && (-0.6..2.57).contains(&place[1]);
    let centres: Vec<[f64; 2]> = curves.iter().map(|p| p.dyad.centre).filter(inside).collect();
    let circles: Vec<[f64; 2]> = curves.iter().map(|p| p.dyad.circle).filter(inside).collect();
    let mut chart =
        Chart::new(Axis::linear("x", "m").range(-1.0, 3.5), Axis::linear("y", "m").range(-0.6, 2.57))
            .titled("Burmester's curves of four poses, and the dyads of five")
            .noted(
                "a dyad joins a centre point on the ground to a circle point on the body at its first pose",
            )
            .with(Series::new("centre points", dots(&centres)).marked())
            .with(Series::new("circle points", dots(&circles)).marked());
    for (number, dyad) in dyads.iter().enumerate() {
        let name = format!("dyad {}", number + 1);
        chart =
            chart.with(Series::new(name, line(&[dyad.centre, dyad.circle])).of_family(2, number).marked());
    }
    Ok(chart)
}

/// Place of an offset slider-crank at 60 degrees of its crank, m.
struct Press;

impl Quantity<4> for Press {
    fn value<S: Real>(&self, [crank, rod, offset, angle]: [S; 4]) -> Option<S> {
        let (sin, cos) = angle.sin_cos();
        let height = offset - crank * sin;
        let square = rod * rod - height * height;
        (square.to_f64() > 0.0).then(|| crank * cos + square.sqrt())
    }
}

fn pareto_chart() -> Result<Chart, Box<dyn Error>> {
    let normal = Distribution::Normal;
    let dimension = |name, nominal, tolerance| Dimension { name, nominal, tolerance, distribution: normal };
    let dimensions = [
        dimension("crank", 40e-3, 0.02e-3),
        dimension("rod", 120e-3, 0.05e-3),
        dimension("offset", 10e-3, 0.05e-3),
        dimension("angle", 60_f64.to_radians(), 0.1_f64.to_radians()),
    ];
    let stack = stack(&Press, &dimensions).ok_or("the press does not close")?;
    let mut chart =
        Chart::new(Axis::linear("rank", "").range(0.4, 4.6), Axis::linear("share", "%").range(0.0, 100.0))
            .titled("Shares of the tolerances in the place of a slider")
            .noted(format!(
                "worst case {:.1} um, standard deviation {:.1} um",
                1e6 * stack.worst,
                1e6 * stack.deviation
            ));
    let mut sums = Vec::new();
    let mut sum = 0.0;
    for (rank, part) in stack.contributions.iter().enumerate() {
        let (x, share) = (rank as f64 + 1.0, 100.0 * part.share);
        sum += share;
        sums.push((x, sum));
        let bar = [(x - 0.4, 0.0), (x - 0.4, share), (x + 0.4, share), (x + 0.4, 0.0)];
        chart = chart.with(Series::new(format!("{} {share:.0} %", part.name), bar));
    }
    Ok(chart.with(Series::new("sum", sums).muted(0).marked()))
}

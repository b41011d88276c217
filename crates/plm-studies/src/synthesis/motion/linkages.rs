//! Four-bars of two dyads.

use super::{BodyPose, Dyad, displacements};
use crate::synthesis::four_bar::{Defect, Demands, FourBar, Image, Vector, point, unit, vector};

/// Four-bar that guides a body through poses.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// Linkage; its coupler is the body, its coupler point the origin of the body.
    pub four_bar: FourBar,
    /// Angle of the body beyond that of the coupler, rad.
    pub body_angle: f64,
    /// Angle of the crank from the x-axis at each pose, rad, with the image on which the pose lies.
    pub positions: Vec<(f64, Image)>,
    /// Defects between the poses.
    pub defects: Vec<Defect>,
}

/// Four-bars of each ordered pair of dyads: the first is the crank. Pairs with a common pivot or pin make no linkage.
pub fn guides(poses: &[BodyPose], dyads: &[Dyad], demands: &Demands) -> Vec<Guide> {
    let pairs = (0..dyads.len()).flat_map(|i| (0..dyads.len()).map(move |j| (i, j)));
    let pairs = pairs.filter(|(i, j)| i != j);
    pairs.filter_map(|(i, j)| guide(poses, &dyads[i], &dyads[j], demands)).collect()
}

fn guide(poses: &[BodyPose], crank: &Dyad, rocker: &Dyad, demands: &Demands) -> Option<Guide> {
    let first = poses.first()?;
    let [pin, other] = [crank.circle, rocker.circle].map(vector);
    let coupler = other - pin;
    let ground = vector(rocker.centre) - vector(crank.centre);
    let size = crank.length + rocker.length;
    if coupler.norm() <= 1e-9 * size || ground.norm() <= 1e-9 * size {
        return None;
    }
    let along = coupler / coupler.norm();
    let mut four_bar = FourBar {
        pivots: [crank.centre, rocker.centre],
        crank: crank.length,
        coupler: coupler.norm(),
        rocker: rocker.length,
        point: point((vector(first.place) - pin) * along.conj()),
        image: Image::Left,
    };
    let mut positions = vec![(pin, other)];
    positions.extend(displacements(poses).iter().map(|d| (d.of(pin), d.of(other))));
    let position = |(pin, other): (Vector, Vector)| {
        let angle = (pin - vector(crank.centre)).arg();
        (angle, four_bar.image_of([point(pin), point(other)]))
    };
    let positions: Vec<(f64, Image)> = positions.into_iter().map(position).collect();
    four_bar.image = positions[0].1;
    let defects = four_bar.defects(&positions, demands);
    let body_angle = (unit(first.angle) * along.conj()).arg();
    Some(Guide { four_bar, body_angle, positions, defects })
}

//! Pose of a six-bar on numbers of any kind: a four-bar by its crank, and a dyad between two of its links.

use plm_runtime::Real;

use super::{Chain, Host};
use crate::synthesis::four_bar::Image;

/// Vector of the plane as a complex number.
#[derive(Clone, Copy, Debug)]
pub(super) struct Z<S> {
    pub(super) re: S,
    pub(super) im: S,
}

impl<S: Real> Z<S> {
    pub(super) fn new(re: S, im: S) -> Self {
        Self { re, im }
    }

    pub(super) fn unit(angle: S) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self::new(cos, sin)
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }

    pub(super) fn minus(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }

    pub(super) fn times(self, other: Self) -> Self {
        Self::new(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)
    }

    pub(super) fn by(self, factor: S) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }
}

/// Frame of a link: where it begins, and its unit vector.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame<S> {
    pub(super) origin: Z<S>,
    pub(super) along: Z<S>,
}

impl<S: Real> Frame<S> {
    pub(super) fn at(self, point: Z<S>) -> Z<S> {
        self.origin.plus(self.along.times(point))
    }

    /// A frame that is given in the same frame as this one, in this one.
    pub(super) fn relative(self, other: Self) -> Self {
        let back = Z::new(self.along.re, -self.along.im);
        Self { origin: back.times(other.origin.minus(self.origin)), along: back.times(other.along) }
    }
}

/// Dimensions of a six-bar with its chain and its images.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dimensions<S> {
    pub(super) chain: Chain,
    /// Ground, crank, coupler, rocker.
    pub(super) lengths: [S; 4],
    /// Ends of the dyad in the frames of their links.
    pub(super) ends: [Z<S>; 2],
    /// Bars of the dyad.
    pub(super) bars: [S; 2],
    /// Images of the four-bar and of the dyad.
    pub(super) images: [Image; 2],
}

/// Pose, from the crank's pivot with the x-axis along the ground.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solved<S> {
    /// Coupler and rocker.
    pub(super) links: [Frame<S>; 2],
    /// Ends of the dyad.
    pub(super) ends: [Z<S>; 2],
    /// Bars of the dyad, each from its end to their common pin.
    pub(super) bars: [Frame<S>; 2],
}

/// The first bar of a dyad that spans a vector, as in [`crate::synthesis::four_bar::dyad`]; flat ones are open here.
fn dyad<S: Real>(span: Z<S>, first: S, second: S, image: Image) -> Option<Z<S>> {
    let square = span.re * span.re + span.im * span.im;
    if square <= S::ZERO {
        return None;
    }
    let along = (first * first - second * second + square) / (S::lit(2.0) * square);
    let height = first * first / square - along * along;
    (height > S::ZERO).then(|| span.times(Z::new(along, height.sqrt() * S::lit(image.sign()))))
}

impl<S: Real> Solved<S> {
    /// The link that carries the point, in the frame of the ground. Of Stephenson's second chain the ground is the second bar, and what is
    /// solved is in the frame of the crank.
    pub(super) fn traced(&self, chain: Chain) -> Frame<S> {
        match chain {
            Chain::StephensonTwo => self.bars[1].relative(self.links[0]),
            _ => self.bars[0],
        }
    }

    /// Direction of the output: of the second bar, or of Stephenson's second chain of the first one from its pivot on the ground.
    pub(super) fn output(&self, chain: Chain) -> Z<S> {
        match chain {
            Chain::StephensonTwo => self.bars[1].relative(self.bars[0]).along.by(S::lit(-1.0)),
            _ => self.bars[1].along,
        }
    }

    /// Direction of the crank of Stephenson's second chain.
    pub(super) fn crank(&self) -> Z<S> {
        Z::new(self.bars[1].along.re, -self.bars[1].along.im)
    }

    /// Cosines of the transmission angles of both dyads.
    pub(super) fn cosines(&self) -> [S; 2] {
        [self.links, self.bars]
            .map(|[one, other]| one.along.re * other.along.re + one.along.im * other.along.im)
    }
}

impl<S: Real> Dimensions<S> {
    /// Pose at an angle of the crank from the line of the pivots. `None` where a loop does not close.
    pub(super) fn solve(&self, angle: S) -> Option<Solved<S>> {
        let [ground, crank, coupler, rocker] = self.lengths;
        let one = S::lit(1.0);
        let origin = Z::new(S::ZERO, S::ZERO);
        let (along_crank, pivot) = (Z::unit(angle), Z::new(ground, S::ZERO));
        let pin = along_crank.by(crank);
        let bar = dyad(pivot.minus(pin), coupler, rocker, self.images[0])?;
        let along_rocker = pin.plus(bar).minus(pivot).by(one / rocker);
        let links = [
            Frame { origin: pin, along: bar.by(one / coupler) },
            Frame { origin: pivot, along: along_rocker },
        ];
        let frame = |host| match host {
            Host::Ground => Frame { origin, along: Z::new(one, S::ZERO) },
            Host::Crank => Frame { origin, along: along_crank },
            Host::Coupler => links[0],
            Host::Rocker => links[1],
        };
        let [host, other] = self.chain.hosts();
        let ends = [frame(host).at(self.ends[0]), frame(other).at(self.ends[1])];
        let first = dyad(ends[1].minus(ends[0]), self.bars[0], self.bars[1], self.images[1])?;
        let second = ends[0].plus(first).minus(ends[1]);
        let bars = [
            Frame { origin: ends[0], along: first.by(one / self.bars[0]) },
            Frame { origin: ends[1], along: second.by(one / self.bars[1]) },
        ];
        Some(Solved { links, ends, bars })
    }
}

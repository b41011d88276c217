//! The manual's curves: what each shows, over which axis.

use plm::view::{Axis, Chart, Recording, Series};

/// A figure of the manual with its axes.
pub struct Figure {
    pub number: u8,
    /// The manual's own.
    pub caption: &'static str,
    pub across: Across,
    /// One above another; A/, B/ and so on where the manual calls them so.
    pub panels: &'static [Panel],
}

/// The horizontal axis.
pub enum Across {
    /// From zero to so many seconds, the manual's final time.
    Time(f64),
    /// A recorded quantity: its column, label and unit.
    Column(&'static str, &'static str, &'static str),
}

/// A vertical axis and what is drawn over it.
pub struct Panel {
    quantity: &'static str,
    unit: &'static str,
    /// From where to where; to what is drawn where there is none.
    range: Option<[f64; 2]>,
    curves: &'static [Curve],
}

/// A column of a run, and its name in the legend.
pub struct Curve {
    run: &'static str,
    column: &'static str,
    name: &'static str,
}

pub const fn panel(quantity: &'static str, unit: &'static str, curves: &'static [Curve]) -> Panel {
    Panel { quantity, unit, range: None, curves }
}

pub const fn curve(run: &'static str, column: &'static str, name: &'static str) -> Curve {
    Curve { run, column, name }
}

impl Figure {
    pub fn file(&self) -> String {
        format!("figure-{:02}.svg", self.number)
    }

    /// The chart of some runs.
    ///
    /// # Errors
    /// A run or a column that is not there.
    pub fn chart(&self, runs: &[Recording]) -> Result<Chart, String> {
        let x = match self.across {
            Across::Time(end) => Axis::linear("time", "s").range(0.0, end),
            Across::Column(_, label, unit) => Axis::linear(label, unit),
        };
        let mut chart = if let [panel] = self.panels { Chart::new(x, panel.axis()) } else { Chart::rows(x) };
        for panel in self.panels {
            if self.panels.len() > 1 {
                chart = chart.below(panel.axis());
            }
            for curve in panel.curves {
                chart = chart.with(self.series(curve, runs)?);
            }
        }
        Ok(chart)
    }

    fn series(&self, curve: &Curve, runs: &[Recording]) -> Result<Series, String> {
        let Curve { run: wanted, column, name } = curve;
        let run = runs.iter().find(|run| run.about.name == *wanted);
        let run = run.ok_or_else(|| format!("figure {}: there is no run `{wanted}`", self.number))?;
        let find = |column: &str| {
            let found = run.columns().iter().position(|known| known.name == column);
            found.ok_or_else(|| format!("figure {}: `{wanted}` has no column `{column}`", self.number))
        };
        let y = find(column)?;
        let x = match self.across {
            Across::Time(_) => None,
            Across::Column(column, ..) => Some(find(column)?),
        };
        let points = run.times().iter().zip(run.rows());
        Ok(Series::new(*name, points.map(|(&time, row)| (x.map_or(time, |x| row[x]), row[y]))))
    }
}

impl Panel {
    /// The same over this range.
    pub const fn within(self, low: f64, high: f64) -> Self {
        Self { range: Some([low, high]), ..self }
    }

    fn axis(&self) -> Axis {
        let axis = Axis::linear(self.quantity, self.unit);
        self.range.map_or(axis.clone(), |[low, high]| axis.range(low, high))
    }
}

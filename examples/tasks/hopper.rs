//! How high does a one-legged hopper jump, if its leg pushes from the lowest point on?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// A body on a springy leg with a foot, which jumps upwards along a mast.
    pub Hopper {
        /// Added to the spring while the leg extends.
        param thrust: N = 40 N;
        gravity: 9.81 m/s^2;
        ground { port floor: (0, 0) m; port mast: (0, 0) m, axis: 90 deg; }
        body hull { mass: 4 kg; inertia: 0.1 kg*m^2; port hip: (0, 0) m, angle: 90 deg; start y: 0.8 m; }
        body foot { mass: 0.5 kg; inertia: 1e-3 kg*m^2; port ankle: (0, 0) m, angle: 90 deg; start y: 0.3 m; }
        prismatic mast(ground.mast, hull.hip);
        // The leg is 0.5 m long at most, and pressed out by 50 N then.
        prismatic leg(foot.ankle, hull.hip) {
            stiffness: 2000 N/m; free_length: 0.525 m; upper_limit: 0.5 m;
            drive: if leg.speed > 1 mm/s then thrust else 0 N;
        }
        point_on_line floor(ground.floor, foot.ankle);
        discrete height: m = 0;
        discrete jumps: 1 = 0;
        when hull.vy < 0 { height = foot.y; jumps = jumps + 1; }
        output height, jumps, leg.displacement;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Hopper::new().start()?;
    let mut heights = Vec::new();
    sim.run(8.0, 0.01, |state| {
        if heights.len() < state.jumps() as usize {
            heights.push(state.height());
        }
    })?;
    // The first height is that of the start.
    let [_, first, second, ..] = heights[..] else { return Err("it does not jump".into()) };
    let tenth = *heights.get(10).ok_or("it does not jump ten times")?;
    Ok(vec![
        Answer::new("first jump", first, "m"),
        Answer::new("second jump", second, "m"),
        Answer::new("tenth jump", tenth, "m"),
    ])
}

//! Figures of the machines beside closed forms and published values, which know nothing of the declarations.

use plm::{Dop853, Fault, Stabilise};

use crate::machines::andrews::Andrews;
use crate::machines::excavator::Excavator;
use crate::machines::geneva::Geneva;
use crate::machines::jansen::Jansen;
use crate::machines::klann::Klann;
use crate::machines::lambda::Lambda;
use crate::machines::peaucellier::Peaucellier;
use crate::machines::pumpjack::Pumpjack;
use crate::machines::scissor::Scissor;
use crate::machines::walschaerts::Walschaerts;
use crate::machines::watt::Watt;
use crate::machines::whitworth::Whitworth;
use crate::machines::wiper::Wiper;
use crate::sheet::Sheet;

pub fn watt() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("watt");
    let [mut off, mut aside, mut known] = [0.0_f64; 3];
    for degrees in -20..=20 {
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        let pin = [-0.3 + 0.3 * cos, 0.1 + 0.3 * sin];
        let other = meet(pin, 0.2, [0.3, -0.1], 0.3, -1.0);
        let mut watt = Watt::new();
        watt.start.lever.angle.value = f64::from(degrees).to_radians();
        let [x, y] = watt.start()?.coupler_middle_position();
        off = off.max((x - 0.5 * (pin[0] + other[0])).hypot(y - 0.5 * (pin[1] + other[1])));
        known = known.max((0.5 * (pin[0] + other[0])).abs());
        aside = aside.max(x.abs());
    }
    sheet.theory("the middle off that by intersections of circles", off, "m", 0.0, 1e-12);
    sheet.theory("off the line while the lever swings by ± 20 deg", 1e3 * aside, "mm", 1e3 * known, 1e-9);
    Ok(sheet)
}

pub fn peaucellier() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("peaucellier");
    let line = (0.5 * 0.5 - 0.25 * 0.25) / (2.0 * 0.17);
    let (mut off, mut highest) = (0.0_f64, 0.0_f64);
    Peaucellier::new().start()?.run(4.0, 0.01, |s| {
        let [x, y] = s.far_upper_d_position();
        off = off.max((x - line).abs());
        highest = highest.max(y);
    })?;
    sheet.theory("D off the line x = (L^2 - l^2)/(2 r)", off, "m", 0.0, 1e-12);
    // The line from O to D turns by half as much as the crank.
    sheet.theory(
        "reach of D along it, at 60 deg of the crank",
        highest,
        "m",
        line * 30_f64.to_radians().tan(),
        1e-12,
    );
    Ok(sheet)
}

pub fn lambda() -> Result<Sheet, Fault> {
    let at = |cosine: f64| {
        let mut lambda = Lambda::new();
        lambda.start.crank.angle.value = cosine.acos();
        Ok::<_, Fault>(lambda.start()?.coupler_p_position())
    };
    let mut sheet = Sheet::new("lambda");
    // With u the cosine of the crank's angle, y^2 = (2 - u)^2 (20 + 4 u)/(5 - 4 u) r^2: 16 r^2 at u = 0 and -1, 1029/64 r^2 at -5/8.
    let (first, middle, most) = (at(0.0)?, at(-1.0)?, at(-0.625)?);
    sheet.theory("stroke over half a turn", 2.0 * (first[0] - middle[0]), "m", 0.4, 1e-12);
    sheet.theory("the ends of the line above its middle", first[1] - middle[1], "m", 0.0, 1e-12);
    let bow = (1029_f64.sqrt() / 8.0 - 4.0) / 4.0;
    sheet.theory("off the line, of the stroke", (most[1] - middle[1]) / 0.4, "-", bow, 1e-12);
    Ok(sheet)
}

/// A point at the distances `r` from `p` and `s` from `q`, left of the way from `p` to `q`, or right of it.
fn meet(p: [f64; 2], r: f64, q: [f64; 2], s: f64, left: f64) -> [f64; 2] {
    let [x, y] = [q[0] - p[0], q[1] - p[1]];
    let d = x.hypot(y);
    let along = (r * r - s * s + d * d) / (2.0 * d);
    let aside = left * (r * r - along * along).sqrt();
    [p[0] + (along * x - aside * y) / d, p[1] + (along * y + aside * x) / d]
}

pub fn jansen() -> Result<Sheet, Fault> {
    let toe = |angle: f64| {
        let (hip, pin) = ([-38.0, -7.8], [15.0 * angle.cos(), 15.0 * angle.sin()]);
        let end = meet(meet(pin, 50.0, hip, 41.5, -1.0), 55.8, hip, 40.1, -1.0);
        let ankle = meet(pin, 61.9, hip, 39.3, 1.0);
        meet(ankle, 49.0, meet(end, 39.4, ankle, 36.7, -1.0), 65.7, 1.0)
    };
    let mut sheet = Sheet::new("jansen");
    let mut sim = Jansen::new().start()?;
    let (mut off, mut low, mut high) = (0.0_f64, [f64::MAX; 2], [f64::MIN; 2]);
    sim.run(6.0, 0.005, |s| {
        let seen = s.toe();
        let known = toe(s.crank().angle - s.chassis().angle);
        for k in 0..2 {
            off = off.max((seen[k] - known[k] / 100.0).abs());
            low[k] = low[k].min(seen[k]);
            high[k] = high[k].max(seen[k]);
        }
    })?;
    sheet.theory("way of two turns, of four steps", sim.chassis().x / (4.0 * 0.67908), "-", 1.0, 0.05);
    sheet.theory("a toe off the path by intersections of circles", off, "m", 0.0, 1e-9);
    sheet.theory("length of a step", high[0] - low[0], "m", 0.679_08, 1e-4);
    sheet.theory("height of a step", high[1] - low[1], "m", 0.224_57, 1e-4);
    Ok(sheet)
}

pub fn klann() -> Result<Sheet, Fault> {
    let foot = |degrees: f64| {
        let mut klann = Klann::new();
        klann.start.crank.angle.value = degrees.to_radians();
        Ok::<_, Fault>(klann.start()?.leg_0_foot_position())
    };
    let mut sheet = Sheet::new("klann");
    let (front, back) = (foot(0.0)?, foot(180.0)?);
    // Lengths are in units of the stride of half a turn, with four digits.
    sheet.theory("stride of half a turn, the unit of its lengths", front[0] - back[0], "m", 1.0, 5e-4);
    sheet.theory("height between its ends", front[1] - back[1], "m", 0.0, 5e-4);
    Ok(sheet)
}

pub fn whitworth() -> Result<Sheet, Fault> {
    let at = |degrees: f64| {
        let mut shaper = Whitworth::new();
        let (sin, cos) = degrees.to_radians().sin_cos();
        shaper.start.crank.angle.value = degrees.to_radians();
        shaper.start.lever.angle.value = (0.1 * sin + 0.05).atan2(0.1 * cos);
        let sim = shaper.start()?;
        Ok::<_, Fault>([sim.guide_displacement(), sim.guide_speed()])
    };
    let mut sheet = Sheet::new("whitworth");
    // The ram turns back at 180 + asin(e/r) and at -asin(e/r).
    let dead = 0.5_f64.asin().to_degrees();
    let ([left, from_left], [right, from_right]) = (at(-dead)?, at(180.0 + dead)?);
    sheet.theory(
        "speed at the angles of the closed form",
        from_left.abs().max(from_right.abs()),
        "m/s",
        0.0,
        1e-12,
    );
    sheet.theory("time ratio by these angles", (180.0 + 2.0 * dead) / (180.0 - 2.0 * dead), "-", 2.0, 1e-12);
    sheet.theory("stroke", right - left, "m", 0.16, 1e-12);
    Ok(sheet)
}

pub fn geneva() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("geneva");
    let mut sim = Geneva::new().start()?;
    let sin = 45_f64.to_radians().sin();
    sheet.theory("ratio in the middle, sin/(1 - sin)", sim.ratio().abs(), "-", sin / (1.0 - sin), 1e-12);
    sim.step(0.9)?;
    sheet.theory("angle of the cross at rest", sim.cross().angle.to_degrees(), "deg", -45.0, 1e-12);
    sim.step(3.1)?;
    sheet.theory("angle of the cross after two turns", sim.cross().angle.to_degrees(), "deg", -180.0, 1e-9);
    Ok(sheet)
}

pub fn excavator() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("excavator");
    let held = Excavator::new().stabilise()?.mechanism;
    let s = held.start()?;
    // Moments of the weights about a pivot, and the lever of the line through two points.
    let bodies =
        [(1500.0, s.boom()), (800.0, s.arm()), (900.0, s.bucket()), (60.0, s.rocker()), (60.0, s.link())];
    let moment = |pivot: [f64; 2], from: usize| -> f64 {
        bodies[from..].iter().map(|(mass, body)| 9.81 * mass * (body.x - pivot[0])).sum()
    };
    let lever = |pivot: [f64; 2], a: [f64; 2], b: [f64; 2]| {
        let (x, y) = (b[0] - a[0], b[1] - a[1]);
        ((a[0] - pivot[0]) * y - (a[1] - pivot[1]) * x) / x.hypot(y)
    };
    let (foot, tip) = ([0.2, 1.55], s.arm_pivot_position());
    let boom = moment(foot, 0) / lever(foot, [0.75, 1.15], s.boom_ram_position());
    let arm = moment(tip, 1) / lever(tip, s.boom_arm_position(), s.arm_ram_position());
    sheet.theory(
        "cylinder of the boom, by moments about its foot",
        s.boom_ram_force() / 1e3,
        "kN",
        boom / 1e3,
        1e-6,
    );
    sheet.theory(
        "cylinder of the arm, by moments about its pivot",
        s.arm_ram_force() / 1e3,
        "kN",
        arm / 1e3,
        1e-6,
    );
    let (mut sim, mut flow, mut power) = (held.start()?, 0.0_f64, 0.0_f64);
    for k in 1..=600 {
        sim.step_to(0.02 * f64::from(k))?;
        (flow, power) = (flow.max(sim.main_flow()), power.max(sim.main_power()));
    }
    sheet.theory("greatest flow of the pump", flow * 60e3, "L/min", 430.0, 1e-6);
    sheet.theory("greatest power of the pump", power / 1e3, "kW", 90.0, 1e-3);
    Ok(sheet)
}

/// The angle swept by the rocker `c` of a four-bar with the ground `k`, between the positions where crank and coupler lie in line.
fn swept(k: f64, c: f64, p: f64, r: f64) -> f64 {
    let turned_back = |reach: f64| ((k * k + c * c - reach * reach) / (2.0 * k * c)).acos();
    turned_back(p + r) - turned_back(p - r)
}

pub fn pumpjack() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("pumpjack");
    let (mut least, mut most) = (f64::MAX, f64::MIN);
    Pumpjack::new().start()?.run(5.5, 1e-3, |s| {
        least = least.min(s.rod_clamp_y());
        most = most.max(s.rod_clamp_y());
    })?;
    // Samples that are 1e-3 s apart miss an end by less than 1e-5 m.
    sheet.theory(
        "stroke of the rod",
        most - least,
        "m",
        3.0 * swept(2.6_f64.hypot(2.8), 2.4, 2.8, 0.9),
        1e-5,
    );
    Ok(sheet)
}

pub fn scissor() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("scissor");
    let mut sim = Scissor::new().start()?;
    for (time, label) in
        [(0.0, "force at the bottom, by virtual work"), (3.5, "force at the top, by virtual work")]
    {
        sim.step(time)?;
        let (sin, cos) = (sim.platform_pin_y() / (3.0 * 1.6)).asin().sin_cos();
        // The platform rises by 3 L cos w dw, the six bars in the middle by half of that.
        let rise = 9.81 * (300.0 + 90.0 / 2.0) * 3.0 * 1.6 * cos;
        let stretch = 0.8 * 8.0 * sin * cos / (cos * cos + 9.0 * sin * sin).sqrt();
        sheet.theory(label, sim.cylinder_force() / 1e3, "kN", rise / stretch / 1e3, 1e-8);
    }
    Ok(sheet)
}

pub fn andrews() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("andrews");
    let mut sim = Andrews::new().start_with(Dop853::new(1e-11))?;
    sim.step(0.03)?;
    sheet.model("beta after 0.03 s", sim.k1_angle(), "rad", 15.810_771_195_153_707, 1e-9);
    sheet.model("gamma after 0.03 s", sim.k3_angle(), "rad", 0.040_822_240_119_645_8, 1e-9);
    sheet.model("delta after 0.03 s", sim.k5_angle(), "rad", 0.524_409_965_879_954_1, 1e-9);
    Ok(sheet)
}

/// Where the valve stands with the crank at an angle, in mm, by closing one loop after the other.
fn valve(angle: f64, gear: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let drop = [330.0 * cos + (2500_f64.powi(2) - (330.0 * sin).powi(2)).sqrt(), -260.0];
    let (ecc_sin, ecc_cos) = (angle + 1250_f64.atan2(-80.0)).sin_cos();
    let rod = (1250_f64.powi(2) + 80.0 * 80.0 + 140.0 * 140.0).sqrt();
    let trunnion = [1250.0, 420.0];
    let foot = meet([140.0 * ecc_cos, 140.0 * ecc_sin], rod, trunnion, 340.0, -1.0);
    // Unit vectors up the link and to its right.
    let up = [(trunnion[0] - foot[0]) / 340.0, (trunnion[1] - foot[1]) / 340.0];
    let bow = 1700.0 - (1700_f64.powi(2) - gear * gear).sqrt();
    let die = [trunnion[0] + gear * up[0] + bow * up[1], trunnion[1] + gear * up[1] - bow * up[0]];
    // The lever's tilt, by bisection: its top hangs on the radius rod, and its low end is where the union link puts it.
    let valve_and_gap = |tilt: f64| {
        let (sin, cos) = tilt.sin_cos();
        let top = 360.0 + 60.0 * cos;
        let valve = die[0] + (1700_f64.powi(2) - (top - die[1]).powi(2)).sqrt() + 60.0 * sin;
        (valve, (valve + 620.0 * sin - drop[0]).hypot(360.0 - 620.0 * cos - drop[1]) - 450.0)
    };
    let (mut low, mut high) = (-1.0, 1.0);
    while high - low > 1e-14 {
        let middle = 0.5 * (low + high);
        if valve_and_gap(middle).1 > 0.0 { high = middle } else { low = middle }
    }
    valve_and_gap(low).0 - 2950.0
}

pub fn walschaerts() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("walschaerts");
    for (gear, label) in
        [(150.0, "travel of the valve, full ahead"), (50.0, "travel of the valve, cut off early")]
    {
        let (mut seen, mut known) = ([f64::MAX, f64::MIN], [f64::MAX, f64::MIN]);
        let mut engine = Walschaerts { gear: gear / 1e3, ..Walschaerts::new() };
        for angle in (0..36).map(|k| f64::from(10 * k).to_radians()) {
            engine.start.driver.angle.value = angle;
            let place = 1e3 * engine.start()?.chest_displacement();
            let other = valve(angle, gear);
            seen = [seen[0].min(place), seen[1].max(place)];
            known = [known[0].min(other), known[1].max(other)];
        }
        sheet.theory(label, seen[1] - seen[0], "mm", known[1] - known[0], 1e-8);
    }
    Ok(sheet)
}

pub fn wiper() -> Result<Sheet, Fault> {
    let mut sheet = Sheet::new("wiper");
    let (mut least, mut most, mut apart) = (f64::MAX, f64::MIN, 0.0_f64);
    Wiper::new().start()?.run(1.6, 1e-4, |s| {
        least = least.min(s.left_angle());
        most = most.max(s.left_angle());
        apart = apart.max((s.left_angle() - s.right_angle()).abs());
    })?;
    // Samples that are 1e-4 s apart miss an end by less than 1e-5 deg.
    let known = swept(0.3, 0.06, 0.297, 0.045).to_degrees();
    sheet.theory("sweep", (most - least).to_degrees(), "deg", known, 1e-4);
    sheet.theory("one wiper beside the other", apart, "rad", 0.0, 1e-9);
    Ok(sheet)
}

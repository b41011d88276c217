//! Contact and conditions in model exchange, by an importer that hands events over late, beside closed forms.

mod forms;
mod importer;

use std::sync::OnceLock;

use plm_dynamic::{Compiled, Dynamic};
use plm_foreign::fmi::{Instance, Interface, Variable};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

use self::forms::{Known, bounced, slid, thrown_back};
use self::importer::{Finds, Importer};

pub(crate) type Mechanism = Dynamic<f64, 9, 8, 32, 9>;

/// Kind of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Family {
    /// A box that is thrown on a rough floor, bounces, slides and sticks.
    Bounce,
    /// A block on a spring that slides to and fro and sticks.
    Slide,
    /// A ball that a `when` throws back.
    When,
}

const BOUNCE: &str = "pub Bounce {
    gravity: 10 m/s^2;
    param e: 1 = 0.5; param mu: 1 = 0.2;
    body ball { mass: 1 kg; inertia: 0.1 kg*m^2; start y: 1 m, locked; start vx: 1 m/s, locked; }
    constraint upright: ball.angle = 0 rad;
    unilateral floor: ball.y >= 0 m { restitution: e; }
    friction rub: rate(ball.x) within mu*reaction(floor);
    output ball.x, ball.vx, ball.y, ball.vy;
}";

const SLIDE: &str = "pub Slide {
    gravity: 10 m/s^2;
    param e: 1 = 0.5; param mu: 1 = 0.2;
    ground { port rail: (0, 0) m; }
    body ball { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; start x: 1 m, locked; start vx: 1 m/s, locked; }
    constraint upright: ball.angle = 0 rad;
    constraint level: ball.y = 0 m;
    force spring(ball.o) { x: -(20 N/m)*ball.x; }
    friction rub: rate(ball.x) within mu*(10 N) { static: mu*(1 + e)*(10 N); }
    output ball.x, ball.vx, ball.y, ball.vy;
    allow(W0002);
}";

const WHEN: &str = "pub When {
    gravity: 10 m/s^2;
    param e: 1 = 0.5; param mu: 1 = 0.2;
    body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m, locked; start vx: 1 m/s, locked; }
    constraint upright: ball.angle = 0 rad;
    when ball.y < 0 m { ball.vy = -e*ball.vy; ball.vx = (1 - mu)*ball.vx; }
    output ball.x, ball.vx, ball.y, ball.vy;
    allow(W0002);
}";

impl Family {
    fn mechanism(self) -> Result<Mechanism, String> {
        static ALL: [OnceLock<Result<Mechanism, String>>; 3] = [const { OnceLock::new() }; 3];
        let text = [BOUNCE, SLIDE, WHEN][self as usize];
        let made = || {
            let compiled = Compiled::new("late", text).map_err(|error| error.to_string())?;
            compiled.mechanism::<9, 8, 32, 9, 64>().map_err(|error| error.to_string())
        };
        ALL[self as usize].get_or_init(made).clone()
    }
}

/// The numbers of a case.
#[derive(Clone, Copy, Debug)]
struct Numbers {
    /// m, m/s
    height: f64,
    speed: f64,
    e: f64,
    mu: f64,
    /// s
    end: f64,
    step: f64,
    late: f64,
    finds: Finds,
    tolerance: Option<f64>,
}

/// Draws a motion, its numbers and an importer, and compares the run with the closed form.
pub(crate) fn case(draw: &mut Draw) -> Case {
    let family = *draw.one_of(&[Family::Bounce, Family::Bounce, Family::Slide, Family::When]);
    let numbers = Numbers {
        height: draw.number(
            0.05,
            1.5,
            if family == Family::When { &[1.0, 0.5] } else { &[0.0, 1.0, 0.5, 0.25] },
        ),
        speed: draw.number(-4.0, 4.0, &[0.0, 3.0, -1.0]),
        e: draw.number(0.0, 0.9, if family == Family::When { &[0.5, 1.0] } else { &[0.0, 0.5, 1.0] }),
        mu: draw.number(0.0, 0.8, &[0.0, 0.2, 0.5]),
        end: if family == Family::When {
            draw.number(0.2, 1.2, &[1.0])
        } else {
            draw.number(0.3, 3.0, &[2.5])
        },
        // Parabolas are exact by steps of any length; the spring's half cycle takes 0.7 s.
        step: *draw.one_of(if family == Family::Slide { &[1e-2, 5e-3, 2e-3] } else { &[2e-2, 1e-2, 5e-3] }),
        late: *draw.one_of(&[0.0, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2]),
        finds: *draw.one_of(&[Finds::ByHalves, Finds::AtSteps, Finds::ByCompletedSteps]),
        tolerance: *draw.one_of(&[None, Some(1e-4), Some(1e-6), Some(1e-9)]),
    };
    let verdict = family.mechanism().and_then(|mechanism| run(&mechanism, family, &numbers));
    Case {
        family: format!("{family:?} {:?}", numbers.finds),
        text: format!("{}\n{numbers:?}", [BOUNCE, SLIDE, WHEN][family as usize]),
        verdict: verdict.unwrap_or_else(Verdict::Stopped),
    }
}

/// The run of an importer beside the closed form.
fn run(mechanism: &Mechanism, family: Family, numbers: &Numbers) -> Result<Verdict, String> {
    let told = |error: plm_foreign::Error| error.to_string();
    let known = |t: f64| match family {
        Family::Bounce => bounced(numbers, t),
        Family::Slide => slid(numbers, t),
        Family::When => thrown_back(numbers, t),
    };
    let undecided = || Ok(Verdict::Undecided("an event is near, or events accumulate".to_owned()));
    let Some(expected) = known(numbers.end) else { return undecided() };
    let mut instance = Instance::new(*mechanism, Interface::ModelExchange);
    instance.begin_at(0.0, numbers.tolerance).map_err(told)?;
    let place = usize::from(family != Family::Slide);
    let starts = [(place, numbers.height), (3, numbers.speed)].map(|(k, value)| (Variable::Start(k), value));
    let parameters = [(0, numbers.e), (1, numbers.mu)].map(|(k, value)| (Variable::Parameter(k), value));
    for (variable, value) in starts.into_iter().chain(parameters) {
        instance.set(variable, value).map_err(told)?;
    }
    let mut importer = Importer::new(instance, numbers.step, (numbers.finds, numbers.late));
    // Some more for what a step touches twice, and for what drifts.
    let most = expected.events + expected.events / 4 + 4;
    if let Err(error) = importer.run(numbers.end, most) {
        return Ok(Verdict::Wrong(format!(
            "{error}, expected {} events until {} s",
            expected.events, numbers.end
        )));
    }
    let Some(expected) = known(importer.time()?) else { return undecided() };
    let mut worst: f64 = 0.0;
    for (k, (known, bound)) in expected.numbers.into_iter().zip(bounds(numbers, &expected)).enumerate() {
        let found = importer.instance.get(Variable::Output(k)).map_err(told)?;
        let off = (found - known).abs() / bound;
        if off.is_nan() || off > 1.0 {
            let name = ["x", "vx", "y", "vy"][k];
            return Ok(Verdict::Wrong(format!("{name} = {found}, expected {known} within {bound:.1e}")));
        }
        worst = worst.max(off);
    }
    Ok(Verdict::Right(worst))
}

/// By how much numbers may be off: by the importer's steps, and where bounces have ended by flights that it cannot follow.
fn bounds(numbers: &Numbers, known: &Known) -> [f64; 4] {
    let g = 10.0;
    let step = if numbers.finds == Finds::ByHalves { 0.0 } else { numbers.step };
    // A flight three times as long as it is late, and one as high as some of its tolerances.
    let speed =
        (1.6 * g * (numbers.late + step)).max((2.0 * g * 20.0 * numbers.tolerance.unwrap_or(0.0)).sqrt());
    let (is_low, rests) = (known.bounce <= 1.2 * speed, known.bounce == 0.0);
    let lost = if is_low { numbers.mu * speed } else { 0.0 };
    let (own, at_rest) = (1e-5, 1e-9);
    let [y, vy] = match (rests, is_low) {
        (true, _) => [1e-7, at_rest],
        (false, true) => [own + speed * speed / g, own + 2.0 * speed],
        (false, false) => [own, 10.0 * own],
    };
    [own + lost * numbers.end, if known.sticks { at_rest } else { own + lost }, y, vy]
}

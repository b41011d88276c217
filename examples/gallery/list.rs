//! What the gallery says of each machine, in the order of its page.

use plm::Fault;

use crate::command::Command;
use crate::figures;
use crate::machines::{
    andrews, excavator, geneva, jansen, klann, lambda, peaucellier, pumpjack, scissor, walschaerts, watt,
    whitworth, wiper,
};
use crate::sheet::Sheet;

/// A machine as the gallery shows it.
pub struct Machine {
    /// As the command line has it.
    pub name: &'static str,
    pub title: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// What it is, in a sentence or two of Markdown.
    pub text: &'static str,
    /// Points whose paths the thumbnail draws.
    pub paths: &'static str,
    /// Seconds of the run that the thumbnail shows, from where and how many.
    pub loops: [f64; 2],
    /// One run as the command line asks for it.
    pub program: Command,
    /// Figures beside those that are known.
    pub sheet: fn() -> Result<Sheet, Fault>,
}

impl Machine {
    /// The name of its page in a folder of all.
    pub fn page(&self) -> String {
        format!("{}.html", self.name)
    }
}

/// The manual's arm, which is among its demos.
pub struct Arm {
    pub name: &'static str,
    pub title: &'static str,
    pub text: &'static str,
    pub demo: &'static str,
    pub paths: &'static str,
    pub loops: [f64; 2],
}

pub const ARM: Arm = Arm {
    name: "arm",
    title: "The manual's hydraulic arm",
    text: "Two arms, one sliding along the other, each on a hydraulic cylinder with servo-valve and lines. Its figures are those that the manual \
           prints ([DoubleArm](gallery.md#doublearm)), held by `tests/manual`.",
    demo: "DoubleArm",
    paths: "",
    loops: [0.0, 4.0],
};

pub const MACHINES: [Machine; 13] = [
    Machine {
        name: "watt",
        title: "Watt's straight line",
        source: "J. Watt, patent 1432, 1784; the curve: J. D. Lawrence, A Catalog of Special Plane Curves, 1972",
        text: "The middle of a coupler between two levers. Nothing drives it: once moved it goes round the whole of Watt's curve, along the \
               line and through both bows.",
        paths: "coupler.middle",
        loops: [0.0, 3.6],
        program: Command::new(watt::program),
        sheet: figures::watt,
    },
    Machine {
        name: "peaucellier",
        title: "Peaucellier-Lipkin linkage",
        source: "C.-N. Peaucellier, letter to the Nouvelles annales de mathématiques, 1864",
        text: "The first linkage that turns a circle into a line, exactly: seven bars of three lengths.",
        paths: "far_upper.d",
        loops: [0.0, 4.0],
        program: Command::new(peaucellier::program),
        sheet: figures::peaucellier,
    },
    Machine {
        name: "lambda",
        title: "Chebyshev's lambda",
        source: "P. L. Chebyshev, Théorie des mécanismes connus sous le nom de parallélogrammes, 1854",
        text: "Half a turn of the crank becomes a line four cranks long, to a quarter of a percent; the other half leads back.",
        paths: "coupler.p",
        loops: [0.0, 4.0],
        program: Command::new(lambda::program),
        sheet: figures::lambda,
    },
    Machine {
        name: "jansen",
        title: "Jansen's walker",
        source: "T. Jansen, The Great Pretender, 2007",
        text: "Four legs on one crank, 26 bodies, on their own feet: each is a contact with friction, so that it walks, and can be pulled \
               over. The lengths are the \"holy numbers\".",
        paths: "foot[0][0].toe|foot[1][0].toe",
        loops: [0.0, 3.0],
        program: Command::new(jansen::program),
        sheet: figures::jansen,
    },
    Machine {
        name: "klann",
        title: "Klann's linkage",
        source: "J. Klann, Walking Device, US patent 6 260 862, 2001",
        text: "Two legs half a turn apart, which replace a wheel: one foot is on the ground while the other returns. The frame is held.",
        paths: "leg[0].foot|leg[1].foot",
        loops: [0.0, 4.0],
        program: Command::new(klann::program),
        sheet: figures::klann,
    },
    Machine {
        name: "whitworth",
        title: "Whitworth's quick return",
        source: "J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, 1980",
        text: "The ram of a shaping machine cuts slowly and returns fast: two thirds of a turn against one third.",
        paths: "lever.end|crank.pin",
        loops: [0.0, 4.0],
        program: Command::new(whitworth::program),
        sheet: figures::whitworth,
    },
    Machine {
        name: "geneva",
        title: "Geneva drive",
        source: "J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, 1980",
        text: "A turn of the driver becomes a quarter of a turn of the cross, and a rest. There is no contact here: pin, slot and locking \
               disc are one exact row.",
        paths: "driver.pin",
        loops: [0.0, 2.0],
        program: Command::new(geneva::program),
        sheet: figures::geneva,
    },
    Machine {
        name: "excavator",
        title: "Excavator",
        source: "lengths and masses are our own, near those of a machine of 20 t",
        text: "Boom, arm, and bucket with its four-bar, on three cylinders behind proportional valves. One load-sensing pump feeds them, limited in flow and in power. It digs; on the live page each lever is a slider.",
        paths: "bucket.teeth",
        loops: [0.0, 12.0],
        program: Command::new(excavator::program),
        sheet: figures::excavator,
    },
    Machine {
        name: "pumpjack",
        title: "Pumpjack",
        source: "names as in API Specification 11E, Pumping Units; the lengths are our own",
        text: "Crank, pitman and walking beam; the rod hangs on a rope that runs on the horse head. The counterweight evens out the torque.",
        paths: "crank.pin|beam.tail",
        loops: [0.0, 5.0],
        program: Command::new(pumpjack::program),
        sheet: figures::pumpjack,
    },
    Machine {
        name: "scissor",
        title: "Scissor lift",
        source: "the principle of virtual work: J. L. Meriam, L. G. Kraige, Engineering Mechanics: Statics, 2012; the lengths are our own",
        text: "Three stages under a platform with a load, raised by a cylinder whose length is prescribed and whose force is asked for.",
        paths: "left[2].high",
        loops: [0.0, 7.0],
        program: Command::new(scissor::program),
        sheet: figures::scissor,
    },
    Machine {
        name: "andrews",
        title: "Andrews' squeezing mechanism",
        source: "E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, section VII.7",
        text: "Seven bodies of millimetres and grams, the standard test of integrators: a constant torque turns the crank two and a half \
               times in 0.03 s.",
        paths: "k2.e|k5.g|k7.h",
        loops: [0.0, 0.03],
        program: Command::new(andrews::program),
        sheet: figures::andrews,
    },
    Machine {
        name: "walschaerts",
        title: "Walschaerts' valve gear",
        source: "the construction: W. E. Dalby, Valves and Valve-Gear Mechanisms, 1906; the lengths are our own",
        text: "A locomotive with its valve gear. On the live page `gear` is the reverser: 150 mm full ahead, -150 mm full astern.",
        paths: "rod.head|radius.lever",
        loops: [0.0, 4.0],
        program: Command::new(walschaerts::program),
        sheet: figures::walschaerts,
    },
    Machine {
        name: "wiper",
        title: "Windscreen wipers",
        source: "a crank and rocker as in J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, 1980; the lengths are our own",
        text: "One motor; crank and rocker for the left wiper, and a parallel rod that takes the right one along.",
        paths: "left.tip|right.tip",
        loops: [0.0, 1.5],
        program: Command::new(wiper::program),
        sheet: figures::wiper,
    },
];

//! Walschaerts' valve gear of a locomotive.
//!
//! Source: E. Walschaerts, Belgian patent, 1844; the construction as in W. E. Dalby, Valves and Valve-Gear Mechanisms, 1906. The lengths
//! are our own, in mm:
//!
//! | crank | rod | return crank | link, foot | radius rod | lever, above and below | union link | wheels |
//! |---|---|---|---|---|---|---|---|
//! | 330 | 2500 | 140 | 340 | 1700 | 60, 620 | 450 | 1600 |
//!
//! The reverser sets how far above the trunnion the die stands in its link, whose slot is an arc about the far end of the radius rod.

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// A locomotive's gear on a motor.
    pub Walschaerts {
        param speed: rev/min = -15 rev/min;
        param gear: mm = 150 mm;
        let die = 1700 mm - sqrt((1700 mm)^2 - gear^2);
        ground { port driver: (0, 0) mm; port trailing: (-1750, 0) mm; port guide: (2500, 0) mm; port trunnion: (1250, 420) mm; port chest: (2950, 360) mm; }
        body engine {
            mass: 4e4 kg; inertia: 1e5 kg*m^2; port driver: (0, 0) mm; depth: -300 mm;
            contour: (-2750, 300), (-2750, 1500), (-2600, 1500), (-2600, 2350), (-2900, 2400), (-2850, 2520), (-2000, 2600), (-1150, 2520), (-1150, 1950), (300, 1950),
                (350, 2250), (800, 2250), (850, 1950), (3150, 1950), (3150, 2600), (3050, 2700), (3650, 2700), (3550, 2600), (3550, 1950), (3950, 1950), (3950, 750), (4400, 700), (4400, 300) mm;
        }
        weld stands(ground.driver, engine.driver);
        body driver {
            mass: 2000 kg; inertia: disc(2000 kg, 0.8 m); port hub: (0, 0) mm; port pin: (330, 0) mm; depth: -100 mm; port ecc: turn((140, 0) mm, atan2(1250 mm, -80 mm));
            contour: (800, 0), (773, 207), (693, 400), (566, 566), (400, 693), (207, 773), (0, 800), (-207, 773), (-400, 693), (-566, 566), (-693, 400), (-773, 207),
                (-800, 0), (-773, -207), (-693, -400), (-566, -566), (-400, -693), (-207, -773), (0, -800), (207, -773), (400, -693), (566, -566), (693, -400), (773, -207) mm;
            start angle: 0 deg, locked; start omega: speed, locked;
        }
        body trailing {
            mass: 2000 kg; inertia: disc(2000 kg, 0.8 m); port hub: (0, 0) mm; port pin: (330, 0) mm; depth: -100 mm; start x: -1750 mm;
            contour: (800, 0), (773, 207), (693, 400), (566, 566), (400, 693), (207, 773), (0, 800), (-207, 773), (-400, 693), (-566, 566), (-693, 400), (-773, 207),
                (-800, 0), (-773, -207), (-693, -400), (-566, -566), (-400, -693), (-207, -773), (0, -800), (207, -773), (400, -693), (566, -566), (693, -400), (773, -207) mm;
        }
        body side { mass: 150 kg; inertia: rod(150 kg, 1.75 m); port front: (0, 0) mm; port rear: (-1750, 0) mm; start x: 330 mm; depth: 0 mm; }
        body rod { mass: 300 kg; inertia: rod(300 kg, 2.5 m); centre: (1250, 0) mm; port pin: (0, 0) mm; port head: (2500, 0) mm; start x: 330 mm; depth: 60 mm; }
        body head {
            mass: 300 kg; inertia: 20 kg*m^2; port pin: (0, 0) mm; port drop: (0, -260) mm; start x: 2830 mm; depth: 0 mm;
            contour: (-140, -90), (-40, -90), (-40, -290), (40, -290), (40, -90), (140, -90), (140, -25), (950, -25), (950, -250), (1050, -250), (1050, 250), (950, 250), (950, 25), (140, 25),
                (140, 90), (-140, 90) mm;
        }
        body ecc_rod { mass: 60 kg; inertia: rod(60 kg, 1.26 m); port ecc: (0, 0) mm; port foot: (sqrt(1250^2 + 80^2 + 140^2), 0) mm; start y: 140 mm; depth: 120 mm; }
        body link {
            mass: 60 kg; inertia: 3 kg*m^2; port trunnion: (0, 0) mm; port foot: (0, -340) mm; port die: (die, gear); depth: 60 mm;
            contour: (-45, 0), (-30, 210), (65, 210), (45, 0), (65, -210), (30, -370), (-30, -370), (-30, -210) mm; start x: 1250 mm; start y: 420 mm;
        }
        body radius { mass: 50 kg; inertia: rod(50 kg, 1.7 m); port die: (0, 0) mm; port lever: (1700, 0) mm; start x: 1260 mm; start y: 570 mm; start angle: -5 deg; depth: 120 mm; }
        body lever { mass: 30 kg; inertia: rod(30 kg, 0.68 m); port radius: (0, 60) mm; port valve: (0, 0) mm; port union: (0, -620) mm; start x: 2980 mm; start y: 360 mm; start angle: 25 deg; depth: 60 mm; }
        body union { mass: 15 kg; inertia: rod(15 kg, 0.45 m); port lever: (450, 0) mm; port head: (0, 0) mm; start x: 2830 mm; start y: -260 mm; depth: 120 mm; }
        body valve {
            mass: 40 kg; inertia: 2 kg*m^2; port stem: (0, 0) mm; start x: 2980 mm; start y: 360 mm; depth: 0 mm;
            contour: (-30, -18), (350, -18), (350, -90), (430, -90), (430, -18), (830, -18), (830, -90), (910, -90), (910, 90), (830, 90), (830, 18), (430, 18), (430, 90), (350, 90), (350, 18), (-30, 18) mm;
        }
        revolute axle(ground.driver, driver.hub) { drive: 5e5 N*m*s/rad*(speed - axle.speed); }
        revolute second(ground.trailing, trailing.hub);
        constraint roll: trailing.angle = driver.angle; // on one rail, so that the side rod stays level
        constraint level: side.angle = 0 rad;
        revolute crank(driver.pin, side.front); revolute big_end(driver.pin, rod.pin);
        revolute small_end(rod.head, head.pin);
        prismatic guide(ground.guide, head.pin);
        revolute return_crank(driver.ecc, ecc_rod.ecc); revolute foot(ecc_rod.foot, link.foot);
        revolute trunnion(ground.trunnion, link.trunnion); revolute block(link.die, radius.die);
        revolute top(radius.lever, lever.radius); revolute stem(lever.valve, valve.stem);
        revolute low(lever.union, union.lever); revolute drop(union.head, head.drop);
        prismatic chest(ground.chest, valve.stem);
        output chest.displacement in mm, guide.displacement in mm;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Walschaerts::new()).until(4.0).every(0.01).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Walschaerts::new()).until(4.0).every(0.01).with(options)
}

//! Friction and unilateral contact by model exchange and by co-simulation.

use plm::runtime::Described;
use plm::{Dop853, Moment, Sim};
use plm_foreign::fmi::{Call, Instance, Interface, Variable};
use plm_foreign::{By, Entry, Kind, Object, Status, header};

use super::{Importer, exchanged};

plm::mechanism! {
    /// A block that is thrown on a rough floor, bounces, slides to and fro on a spring, and sticks.
    Thrown {
        gravity: 9.81 m/s^2;
        input pull: N = 0 N;
        body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start y: 0.2 m; start vx: 1 m/s; }
        constraint level: block.angle = 0;
        force hand(block.o) { x: pull - (20 N/m)*block.x; }
        unilateral floor: block.y >= 0 m { restitution: 0.4; }
        friction slip: rate(block.x) within 0.3*reaction(floor) { static: 0.4*reaction(floor); }
        output block.x, block.y, block.vx, block.vy, push = reaction(floor), drag = reaction(slip);
    }
}

type Precise = Sim<Thrown, Dop853<Thrown>>;

fn precise() -> Precise {
    Thrown::new().start_with(Dop853::new(1e-12)).unwrap()
}

/// An instance of co-simulation after its initialisation.
fn stepped(has_events: bool) -> Instance<Thrown> {
    let mut instance = Instance::new(Thrown::new(), Interface::CoSimulation { has_events });
    instance.begin_at(0.0, Some(1e-12)).unwrap();
    instance.renew().unwrap();
    instance.pass(Call::ExitInitializationMode);
    instance
}

/// A force that sets the block in motion again where it rests, and lets it go.
fn force(t: f64) -> f64 {
    if t > 1.0 && t < 1.5 { 14.0 } else { 0.0 }
}

#[track_caller]
fn same(instance: &mut Instance<Thrown>, sim: &Precise, within: f64) {
    for k in 0..6 {
        let [found, known] =
            [instance.get(Variable::Output(k)).unwrap(), Thrown::observed(sim.state(), k).unwrap()];
        assert!((found - known).abs() <= within, "{k}, t = {}: {found} is not {known}", sim.state().time());
    }
}

/// In flight, between bounces, at rest, sliding, and at rest again; a solver of order 4, which shows all of its steps or some.
#[test]
fn a_solver_outside_strikes_slides_and_sticks() {
    for shown in [1, 7] {
        let mut importer = Importer::new(exchanged(Thrown::new()), 1e-3, shown).unwrap();
        let mut sim = precise();
        for until in [0.1, 0.3, 0.44, 0.6, 1.0, 1.2, 1.5, 1.6, 2.5] {
            importer.run(until).unwrap();
            sim.step_to(importer.time()).unwrap();
            same(&mut importer.instance, &sim, 1e-9);
            importer.instance.pass(Call::EnterEventMode);
            importer.instance.set(Variable::Input(0), force(until)).unwrap();
            importer.instance.update().unwrap();
            importer.instance.pass(Call::EnterContinuousTimeMode);
            sim.input.pull = force(until);
        }
        // Sixteen impacts, and the end of the slip.
        assert_eq!(importer.events, 17, "shown every {shown}");
    }
}

/// The speed of the block falls by e from impact to impact; outputs in event mode are those after it.
#[test]
fn a_step_returns_at_an_impact() {
    for has_events in [false, true] {
        let mut instance = stepped(has_events);
        let (mut sim, mut impacts) = (precise(), 0);
        for k in 1..=50 {
            let until = 0.05 * f64::from(k);
            while instance.step_to(until, has_events).unwrap() {
                let before = instance.get(Variable::Output(3)).unwrap();
                if !instance.update().unwrap().states_changed {
                    continue;
                }
                let speed = f64::sqrt(2.0 * 9.81 * 0.2) * f64::powi(0.4, impacts);
                let after = instance.get(Variable::Output(3)).unwrap();
                assert!((before + speed).abs() < 1e-11, "impact {impacts}: {before}");
                // The sixteenth flight would be lower than rounding.
                let after_known = if impacts < 15 { 0.4 * speed } else { 0.0 };
                assert!((after - after_known).abs() < 1e-11, "impact {impacts}: {after}");
                impacts += 1;
            }
            sim.step_to(until).unwrap();
            // By itself it has the bits of a run.
            same(&mut instance, &sim, if has_events { 1e-10 } else { 0.0 });
            instance.set(Variable::Input(0), force(until)).unwrap();
            sim.input.pull = force(until);
        }
        assert_eq!(impacts, if has_events { 16 } else { 0 });
    }
}

/// In a flight, at rest, and in the middle of a slide: an instance that was made of bytes goes on with the same bits.
#[test]
fn a_saved_instance_goes_on_in_the_modes_that_it_had() {
    let mut instance = stepped(true);
    for k in 1..=50 {
        let until = 0.05 * f64::from(k);
        let mut bytes = vec![0; instance.saved_size()];
        instance.save(&mut bytes).unwrap();
        let mut other = stepped(true).saved(&bytes).unwrap();
        for instance in [&mut instance, &mut other] {
            while instance.step_to(until, true).unwrap() {
                instance.update().unwrap();
            }
        }
        for variable in (0..6).map(Variable::Output) {
            let [one, two] = [&mut instance, &mut other].map(|instance| instance.get(variable).unwrap());
            assert_eq!(one.to_bits(), two.to_bits(), "{variable:?}, t = {until}");
        }
        instance.set(Variable::Input(0), force(until)).unwrap();
    }
}

/// What C calls: the bits of a run, what rows do, and their names in the header.
#[test]
fn an_object_of_c_has_the_bits_of_a_run_and_tells_its_modes() {
    let (mut object, mut sim) = (Object::new(Thrown::new()), Thrown::new().start().unwrap());
    assert_eq!(object.get(Kind::Contact, 0).unwrap_err().status(), Status::NotStarted);
    object.start().unwrap();
    for k in 1..=50 {
        let until = 0.05 * f64::from(k);
        object.step_to(until).unwrap();
        sim.step_to(until).unwrap();
        assert_eq!(object.state().unwrap().x(), sim.state().x());
        let mode = |row| object.get(Kind::Contact, row).unwrap();
        let modes: Vec<f64> = sim.contacts().map(|(_, mode)| mode.number() as f64).collect();
        assert_eq!(vec![mode(0), mode(1)], modes);
        // The place, the height and their velocities are left in a flight, the height is not on the floor.
        let directions =
            modes.iter().fold(4, |left, mode| left - if [1.0, 3.0].contains(mode) { 2 } else { 0 });
        assert_eq!(object.linearised().unwrap().directions(), directions);
        object.set(Kind::Input, 0, force(until)).unwrap();
        sim.input.pull = force(until);
    }
    assert_eq!(object.set(Kind::Contact, 0, 1.0).unwrap_err().status(), Status::ReadOnly);
    let mut text = String::new();
    header(&Thrown::new(), Entry { name: "thrown", methods: &[By::Dop853] }, &mut text).unwrap();
    for line in [
        "PLM_CONTACT = 8",
        "PLM_STICKS = 3,",
        "THROWN_CONTACT_FLOOR = 0, /* floor */",
        "THROWN_CONTACT_SLIP = 1 /* slip */",
    ] {
        assert!(text.contains(line), "{line}");
    }
}

/// Pushes and frictions may depend on all that is known, and so may what reads them.
#[test]
fn what_a_push_depends_on_is_not_listed() {
    let reads = Thrown::<f64>::TABLES.reads;
    assert!(reads[..4].iter().all(Option::is_some) && reads[4..6].iter().all(Option::is_none), "{reads:?}");
}

/// Before it other modes were held.
#[test]
fn a_time_before_the_last_event_is_refused_and_so_are_seeds_that_are_no_numbers() {
    let mut importer = Importer::new(exchanged(Thrown::new()), 1e-3, 1).unwrap();
    importer.run(0.3).unwrap();
    let instance = &mut importer.instance;
    // The first impact is at 0.202 s.
    let outcomes = [0.1, 0.25].map(|time| instance.place(Some(time), None).map_err(|error| error.status()));
    assert_eq!(outcomes, [Err(Status::Interval), Ok(())]);
    let along = |seed| [(Variable::Input(0), seed)];
    let wrong = instance.tangents(&along(f64::NAN), &[Variable::Rate(2)]).unwrap_err();
    assert_eq!(wrong.status(), Status::NotFinite);
    assert!(instance.tangents(&along(1.0), &[Variable::Rate(2)]).is_ok());
}

/// Open in a flight, closed on the floor; off, slipping, and sticking.
#[test]
fn modes_of_rows_are_variables() {
    let mut importer = Importer::new(exchanged(Thrown::new()), 1e-3, 1).unwrap();
    for (until, modes) in [(0.1, [0, 2]), (2.4, [1, 3])] {
        importer.run(until).unwrap();
        let found = [0, 1].map(|row| importer.instance.integer(Variable::Contact(row)).unwrap());
        assert_eq!(found, modes, "t = {until}");
    }
    assert_eq!(importer.instance.set(Variable::Contact(0), 1.0).unwrap_err().status(), Status::NoSuch);
}

/// By the pull: nothing moves while the block sticks, and friction takes it all; where it slides it is 1/m.
#[test]
fn derivatives_are_those_of_the_modes_held() {
    let mut instance = stepped(false);
    let unknowns = [Variable::Rate(2), Variable::Output(5)];
    for (until, known) in [(0.3, [0.5, 0.0]), (0.9, [0.0, -1.0]), (1.2, [0.5, 0.0])] {
        instance.step_to(until, false).unwrap();
        let found = instance.tangents(&[(Variable::Input(0), 1.0)], &unknowns).unwrap();
        assert!(
            found.iter().zip(known).all(|(found, known)| (found - known).abs() < 1e-14),
            "{until}: {found:?}"
        );
        if until > 0.5 {
            instance.set(Variable::Input(0), 14.0).unwrap();
        }
    }
}

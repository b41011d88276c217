//! Runs by embedded pairs, eight at a time: each with lengths, errors and acceptance of its own, and with the bits of a run alone.
//!
//! An attempt of a step is made in all lanes at once. A lane whose step is accepted goes on to the next one, one whose error is too large
//! tries a shorter one, and both is decided side by side. What needs more leaves the lanes for that step, which is then made from its
//! beginning by the code of a single run. A lane whose run has come to its end takes the next run.

mod seat;
mod wide;

use core::array;
use core::borrow::BorrowMut;

use self::seat::{Run, Seat};
use self::wide::{Attempt, Numbers, Watch};
use super::batch::Batch;
use super::side::WideHeld;
use super::{LANES, Lanes, Pack};
use crate::fault::Fault;
use crate::mechanism::Moment;
use crate::method::{Embedded, Pair};
use crate::sim::Sim;

impl<M: Pack<S = f64>, L: Lanes, P: Pair> Batch<M, L, Embedded<M, P>> {
    /// Runs all for the communication interval `dt`, in s; gives what [`Sim::step`] would give for each, whatever their times.
    ///
    /// Mechanisms without conditions, kinks and rows of contact go together where their drift need not be checked, the others alone.
    pub fn step(&mut self, dt: f64) -> [Result<(), Fault>; LANES] {
        let mut outcomes = [Ok(()); LANES];
        let runs = self.sims.iter_mut().map(|sim| (sim, dt));
        run_all::<M, L, P, _>(runs, |number, _, outcome| outcomes[number % LANES] = outcome);
        outcomes
    }
}

/// Steps each run for its interval, s, as [`Sim::step`] does, eight at a time; `done` gets the number of each in their order, the run and
/// the outcome.
pub fn run_all<M: Pack<S = f64>, L: Lanes, P: Pair, B: BorrowMut<Sim<M, Embedded<M, P>>>>(
    runs: impl IntoIterator<Item = (B, f64)>,
    done: impl FnMut(usize, B, Result<(), Fault>),
) {
    let seats = [const { None }; LANES];
    let list = List { runs: runs.into_iter(), count: 0, done };
    Walk::<M, L, P, B, _, _> { list, seats, numbers: None, chart: None }.run();
}

/// Runs that have not begun yet, and the way of those that are done.
struct List<I, D> {
    runs: I,
    /// So many have begun.
    count: usize,
    done: D,
}

impl<I, D> List<I, D> {
    /// The next run that goes with others; those before it, which do not, are made.
    fn next<M: Pack<S = f64>, P: Pair, B: BorrowMut<Run<M, P>>>(&mut self) -> Option<Seat<M, P, B>>
    where
        I: Iterator<Item = (B, f64)>,
        D: FnMut(usize, B, Result<(), Fault>),
    {
        for (run, dt) in self.runs.by_ref() {
            let number = self.count;
            self.count += 1;
            match Seat::new(run, number, dt) {
                Ok(seat) => return Some(seat),
                Err(mut run) => {
                    let outcome = run.borrow_mut().step(dt);
                    (self.done)(number, run, outcome);
                }
            }
        }
        None
    }
}

/// Eight runs on their ways.
struct Walk<M: Pack<S = f64>, L: Lanes, P: Pair, B, I, D> {
    list: List<I, D>,
    seats: [Option<Seat<M, P, B>>; LANES],
    /// Those of the lanes; nothing before the first have come.
    numbers: Option<Numbers<M, L, P>>,
    /// The chart of the lanes that go together.
    chart: Option<usize>,
}

impl<M, L, P, B, I, D> Walk<M, L, P, B, I, D>
where
    M: Pack<S = f64>,
    L: Lanes,
    P: Pair,
    B: BorrowMut<Run<M, P>>,
    I: Iterator<Item = (B, f64)>,
    D: FnMut(usize, B, Result<(), Fault>),
{
    fn run(mut self) {
        for i in 0..LANES {
            self.seats[i] = self.list.next();
        }
        while self.seats.iter().any(Option::is_some) {
            self.arrange();
            for i in 0..LANES {
                if self.seats[i].is_some() && !self.goes(i) {
                    self.step_alone(i);
                }
            }
            self.attempt();
        }
    }

    /// Does a lane go with the others?
    fn goes(&self, i: usize) -> bool {
        self.numbers.as_ref().is_some_and(|numbers| numbers.going.value(i) > 0.0)
    }

    /// Lets those lanes join that are in the chart of the others, or of most if none goes yet.
    fn arrange(&mut self) {
        let apart: [Option<usize>; LANES] = array::from_fn(|i| {
            let seat = self.seats[i].as_ref().filter(|_| !self.goes(i));
            seat.and_then(Seat::place)
        });
        if apart.iter().all(Option::is_none) {
            return;
        }
        if !(0..LANES).any(|i| self.goes(i)) {
            let like = |place: &Option<usize>| {
                apart.iter().filter(|other| place.is_some() && *other == place).count()
            };
            self.chart = apart.iter().copied().max_by_key(like).flatten();
        }
        let (mut have_come, mut is_new) = (false, !(0..LANES).any(|i| self.goes(i)));
        for i in (0..LANES).filter(|i| apart[*i].is_some() && apart[*i] == self.chart) {
            let Some(seat) = &mut self.seats[i] else { continue };
            let Some(going) = seat.ready() else { continue };
            let numbers = self.numbers.get_or_insert_with(|| Numbers::new(seat, &going));
            numbers.put(i, seat.moment(), &going);
            // A run that comes back has the parameters and inputs that its lane has.
            if seat.was_packed {
                let held = seat.sim().state.held();
                M::put_held(&mut numbers.held, &held, |wide: &mut L, one| wide.put(i, one));
            } else {
                is_new = true;
            }
            have_come = true;
        }
        if have_come && is_new {
            self.pack();
        }
    }

    /// Packs mechanisms and discrete states of the lanes that go together.
    fn pack(&mut self) {
        let Some(first) = (0..LANES).find(|i| self.goes(*i)) else { return };
        let Some(numbers) = &mut self.numbers else { return };
        let Some(lead) = &self.seats[first] else { return };
        let at = |i: usize| if numbers.going.value(i) > 0.0 { i } else { first };
        let seats: [&Seat<M, P, B>; LANES] = array::from_fn(|i| self.seats[at(i)].as_ref().unwrap_or(lead));
        let helds: [M::U; LANES] = array::from_fn(|i| numbers.held_of(at(i), seats[i]));
        numbers.held = M::pack_held(&helds[first], helds.each_ref(), L::of);
        numbers.pack(seats);
        let going = numbers.going;
        for (i, seat) in self.seats.iter_mut().enumerate() {
            if let Some(seat) = seat {
                seat.was_packed = going.value(i) > 0.0;
            }
        }
    }

    /// An attempt of a step of the lanes that go together.
    fn attempt(&mut self) {
        let Some(numbers) = &mut self.numbers else { return };
        let stuck = numbers.stuck();
        if L::any(L::lit(0.0).lt(stuck)) {
            self.leave(stuck);
        }
        let Some(numbers) = self.numbers.as_mut().filter(|numbers| L::any(L::lit(0.0).lt(numbers.going)))
        else {
            return;
        };
        let Attempt { ends, moves, leaves } = numbers.attempt(&mut self.seats);
        let some = |lanes: L| (0..LANES).filter(move |i| lanes.value(*i) > 0.0);
        if L::any(L::lit(0.0).lt(ends + moves + leaves)) {
            for i in some(ends) {
                let _ = self.take(i);
                self.finish(i, Ok(()));
            }
            for i in some(moves) {
                let from = self.take(i);
                let judge = |seat: &mut Seat<M, P, B>| seat.judge(from?);
                if let Some(outcome) = self.seats[i].as_mut().and_then(judge) {
                    self.finish(i, outcome);
                }
            }
            self.leave(leaves);
        }
    }

    /// Makes steps of lanes alone, from their beginnings.
    #[inline(never)]
    fn leave(&mut self, lanes: L) {
        for i in (0..LANES).filter(|i| lanes.value(*i) > 0.0) {
            let _ = self.take(i);
            self.step_alone(i);
        }
    }

    /// Takes a run out of its lane; time and state at the beginning of its last step.
    fn take(&mut self, i: usize) -> Option<(f64, M::X)> {
        let (numbers, seat) = (self.numbers.as_mut()?, self.seats[i].as_mut()?);
        let lately = numbers.lately(i, seat);
        let from = (lately.last.time, lately.last.from);
        seat.take(&lately);
        numbers.going.put(i, 0.0);
        Some(from)
    }

    fn step_alone(&mut self, i: usize) {
        if let Some(outcome) = self.seats[i].as_mut().and_then(Seat::step) {
            self.finish(i, outcome);
        }
    }

    /// Hands back a run that has ended, and takes the next one.
    fn finish(&mut self, i: usize, outcome: Result<(), Fault>) {
        if let Some(mut seat) = self.seats[i].take() {
            if outcome.is_ok() {
                seat.run.borrow_mut().clock = seat.clock;
            }
            (self.list.done)(seat.number, seat.run, outcome);
        }
        self.seats[i] = self.list.next();
    }
}

impl<M: Pack<S = f64>, L: Lanes, P: Pair, B: BorrowMut<Run<M, P>>> Watch<M, L>
    for [Option<Seat<M, P, B>>; LANES]
{
    fn has_looked(&mut self, before: &WideHeld<M, L>, looked: L) {
        for (i, seat) in self.iter_mut().enumerate().filter(|(i, _)| looked.value(*i) > 0.0) {
            let Some(seat) = seat else { continue };
            let mut was = seat.sim().state.held();
            M::take_held(&mut was, before, |wide: L| wide.value(i));
            seat.was = Some(was);
        }
    }

    fn is_judged(&mut self, i: usize, last: Option<(f64, M::X, bool)>, held: &WideHeld<M, L>) {
        let Some(Some(seat)) = self.get_mut(i) else { return };
        let mut own = seat.sim().state.held();
        M::take_held(&mut own, held, |wide: L| wide.value(i));
        seat.remember(last, own);
    }
}

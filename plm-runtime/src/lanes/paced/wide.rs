//! Steps of eight lanes as one, each with a time, a length and an error of its own.

use core::borrow::BorrowMut;

use super::super::lane::{column, set_column};
use super::super::side::{Wide, WideHeld};
use super::super::{LANES, Lanes, Pack};
use super::seat::{Lately, Run, Seat};
use crate::mechanism::Moment;
use crate::method::{Going, Pace, Pair, Rates, Span, Watched, goes_on, shortest_between, weight};
use crate::scalar::Scalar;
use crate::system::Rate;
use crate::vector::Vector;

/// The lanes as one mechanism, each at a moment of its own.
pub(super) struct Numbers<M: Pack<S = f64>, L: Lanes, P: Pair> {
    pub(super) mechanism: M::Packed<L>,
    pub(super) held: WideHeld<M, L>,
    /// Typical sizes of the numbers of a state.
    pub(super) typical: Wide<M, L>,
    /// 1 in the lanes that go together, 0 elsewhere.
    pub(super) going: L,
    pub(super) time: L,
    pub(super) end: L,
    pub(super) x: Wide<M, L>,
    pub(super) rate: Wide<M, L>,
    pub(super) pace: Pace<L>,
    /// The pace at the beginning of the step, and how many attempts of it were rejected.
    pub(super) beginning: (Pace<L>, L),
    /// The last steps, and 1 where the error decided their lengths.
    pub(super) last: Span<L, Wide<M, L>>,
    pub(super) by_error: L,
    /// 1 where they changed the discrete state.
    looked: L,
    pub(super) stages: P::Stages<Wide<M, L>>,
    pub(super) options: Options<L>,
    /// Steps and rejected attempts since the lane came.
    pub(super) steps: L,
    pub(super) rejected: L,
    /// The longest of them, s.
    pub(super) longest: L,
}

/// Options of the methods of the lanes.
pub(super) struct Options<L> {
    pub(super) rtol: L,
    pub(super) longest_step: L,
    /// So many steps may be tried yet.
    pub(super) most_steps: L,
}

/// Outcome of an attempt: 1 in the lanes that it is true of, 0 elsewhere.
pub(super) struct Attempt<L> {
    /// The step was made, and is the last one.
    pub(super) ends: L,
    /// The step was made, and changes more than continuation data, or is refused for that: it is judged alone.
    pub(super) moves: L,
    /// The step has to be made alone, from its beginning.
    pub(super) leaves: L,
}

/// Receiver of those changes of an attempt that are treated lane by lane.
pub(super) trait Watch<M: Pack<S = f64>, L: Lanes> {
    /// A step has changed continuation data in the lanes of ones; these are the discrete states before it.
    fn has_looked(&mut self, before: &WideHeld<M, L>, looked: L);

    /// The step of a lane is judged alone. The one before it in the lane, if any, had this time and state at its beginning, and has looked
    /// or not; this is the discrete state after it.
    fn is_judged(&mut self, i: usize, last: Option<(f64, M::X, bool)>, held: &WideHeld<M, L>);
}

/// A step that was tried.
struct Tried<M: Pack<S = f64>, L: Lanes> {
    /// Length of the proposal, and of the step.
    proposal: L,
    h: L,
    time: L,
    x: Wide<M, L>,
    rate: Wide<M, L>,
    estimate: L,
    error: L,
    /// 1 in the lanes whose solutions are healthy and whose numbers are finite.
    good: L,
}

/// 1 where the mask is set, 0 elsewhere.
fn number<L: Lanes>(mask: L::Mask) -> L {
    L::select(mask, L::lit(1.0), L::lit(0.0))
}

impl<M: Pack<S = f64>, L: Lanes, P: Pair> Numbers<M, L, P> {
    /// Lanes that go together and whose next step is not allowed: it would be too short, or one too many.
    #[inline]
    pub(super) fn stuck(&self) -> L {
        let (proposal, zero) = (self.proposal(), L::lit(0.0));
        let shortest = shortest_between(L::lit(f64::EPSILON), [self.time, self.end]);
        // A proposal that is no number is none.
        let is_one = number(L::lit(-1.0).lt(proposal));
        let moves = L::select(goes_on(proposal, self.end - self.time), number(shortest.lt(proposal)), is_one);
        let tried = self.steps + self.rejected;
        let allowed = L::select(tried.lt(self.options.most_steps), moves, zero);
        L::select(zero.lt(allowed), zero, self.going)
    }

    fn proposal(&self) -> L {
        self.pace.proposal.min(self.options.longest_step)
    }

    /// An attempt of all lanes; `watch` gets the discrete states before the step, if it has changed some, and 1 in their lanes.
    #[inline]
    pub(super) fn attempt(&mut self, watch: &mut impl Watch<M, L>) -> Attempt<L> {
        let tried = self.step();
        let zero = L::lit(0.0);
        let accepted = L::select(L::lit(1.0).lt(tried.error), zero, tried.good);
        let calm = accepted * M::are_calm(&self.typical, tried.time, &self.held, &tried.x);
        let made = if L::any(calm.lt(accepted)) {
            let before = self.held;
            let seen = M::look(&self.mechanism, tried.time, &mut self.held, &tried.x, accepted - calm);
            watch.has_looked(&before, seen);
            self.looked = L::select(zero.lt(seen), L::lit(1.0), self.looked);
            calm + seen
        } else {
            calm
        };
        self.looked = L::select(zero.lt(calm), zero, self.looked);
        let moves = accepted - made;
        for i in (0..LANES).filter(|i| moves.value(*i) > 0.0) {
            let last = (self.last.time.value(i), column(&self.last.from, i), self.looked.value(i) > 0.0);
            watch.is_judged(i, Some(last).filter(|_| self.steps.value(i) > 0.0), &self.held);
        }
        let refused = self.refuse(tried.good - accepted, &tried);
        let ends = L::select(tried.time.lt(self.end), zero, made);
        let leaves = self.going - made - moves - refused;
        self.keep(made + moves, &tried);
        Attempt { ends, moves, leaves }
    }

    /// A step of all lanes, without a decision.
    #[allow(clippy::inline_always, reason = "its states stay where they are")]
    #[inline(always)]
    fn step(&mut self) -> Tried<M, L> {
        let (proposal, rest, zero) = (self.proposal(), self.end - self.time, L::lit(0.0));
        let whole = goes_on(proposal, rest);
        let h = L::select(zero.lt(self.going), L::select(whole, proposal, rest), zero);
        let time = L::select(whole, self.time + h, self.end);
        let mut rates = Watched::new(&self.mechanism, &self.held);
        let x = P::step::<M::Packed<L>>(self.time, h, &self.x, &self.rate, &mut self.stages, &mut rates);
        let mut rate = x;
        match P::rate_at_end(&self.stages) {
            Some(last) => rate = *last,
            None => (&mut rates).at(time, &x, &mut rate),
        }
        let health = rates.worst.0;
        let weights =
            Vector::from_fn(|i| weight(self.options.rtol, self.typical.at(i), [self.x.at(i), x.at(i)]));
        let estimate = P::error(h, &self.stages, (&weights, self.mechanism.states()));
        let error = self.pace.error::<P>(h, estimate);
        // Zero times a value that is not finite is NaN.
        let probe = |sum: L, number: L| number.mul_add(zero, sum);
        let sum = rate.fold(x.fold(error * zero, probe), probe);
        let finite = L::select(sum.lt(L::lit(1.0)), self.going, zero);
        let good = L::select(L::lit(f64::HEALTHY).lt(health), finite, zero);
        Tried { proposal, h, time, x, rate, estimate, error, good }
    }

    /// Shortens the steps of the lanes whose errors are too large; 1 in those in which the time still moves.
    #[inline]
    fn refuse(&mut self, too_large: L, tried: &Tried<M, L>) -> L {
        let zero = L::lit(0.0);
        if !L::any(zero.lt(too_large)) {
            return zero;
        }
        let mut shorter = self.pace;
        shorter.proposal = shorter.reject::<P>(tried.h, tried.error);
        let shortest = shortest_between(L::lit(f64::EPSILON), [self.time, self.end]);
        let refused = L::select(shortest.lt(shorter.proposal), too_large, zero);
        self.pace = Pace::select(zero.lt(refused), &shorter, &self.pace);
        self.rejected = self.rejected + refused;
        self.beginning.1 = self.beginning.1 + refused;
        refused
    }

    /// Keeps the steps of the lanes in which they were made.
    #[inline]
    fn keep(&mut self, made: L, tried: &Tried<M, L>) {
        let (zero, one) = (L::lit(0.0), L::lit(1.0));
        let (is_made, h) = (zero.lt(made), tried.h);
        let mut pace = self.pace;
        pace.accept::<P>(tried.proposal, h, (tried.error, tried.estimate));
        self.pace = Pace::select(is_made, &pace, &self.pace);
        self.beginning =
            (Pace::select(is_made, &pace, &self.beginning.0), L::select(is_made, zero, self.beginning.1));
        let choose =
            |new: &Wide<M, L>, old: &Wide<M, L>| new.map2(old, |new, old| L::select(is_made, new, old));
        self.last = Span {
            time: L::select(is_made, self.time, self.last.time),
            h: L::select(is_made, h, self.last.h),
            from: choose(&self.x, &self.last.from),
            to: choose(&tried.x, &self.last.to),
            rate_from: choose(&self.rate, &self.last.rate_from),
            rate_to: choose(&tried.rate, &self.last.rate_to),
        };
        let by_error = L::select(h.lt(self.options.longest_step), number(tried.time.lt(self.end)), zero);
        self.by_error = L::select(is_made, by_error, self.by_error);
        self.time = L::select(is_made, tried.time, self.time);
        (self.x, self.rate) = (choose(&tried.x, &self.x), choose(&tried.rate, &self.rate));
        self.steps = self.steps + made;
        self.longest = self.longest.max(h * L::select(is_made, one, zero));
    }

    /// Numbers of lanes none of which goes yet, with places for runs like this one.
    pub(super) fn new<B: BorrowMut<Run<M, P>>>(seat: &Seat<M, P, B>, going: &Going<f64, M::X>) -> Self {
        let (state, zero) = (&seat.sim().state, L::lit(0.0));
        let (system, held, lone) = (state.mechanism(), state.held(), &going.pace);
        let x: Wide<M, L> = Vector::from_fn(|k| L::lit(state.x().at(k)));
        let pace = Pace::of(|number: fn(&Pace<f64>) -> f64| L::lit(number(lone)));
        Self {
            mechanism: system.pack([system; LANES], L::of),
            held: M::pack_held(&held, [&held; LANES], L::of),
            typical: x,
            going: zero,
            time: zero,
            end: zero,
            x,
            rate: x,
            pace,
            beginning: (pace, zero),
            last: Span { time: zero, h: zero, from: x, to: x, rate_from: x, rate_to: x },
            by_error: zero,
            looked: zero,
            stages: P::blank(x),
            options: Options { rtol: zero, longest_step: zero, most_steps: zero },
            steps: zero,
            rejected: zero,
            longest: zero,
        }
    }

    /// Packs the mechanisms of runs, and what follows from them.
    pub(super) fn pack<B: BorrowMut<Run<M, P>>>(&mut self, seats: [&Seat<M, P, B>; LANES]) {
        let systems = seats.map(|seat| seat.sim().state.mechanism());
        self.mechanism = systems[0].pack(systems, L::of);
        let typical = systems.map(Rate::typical);
        self.typical = Vector::from_fn(|k| L::of(typical.each_ref().map(|one| one.at(k))));
        let numbers = seats.map(Seat::options);
        let option = |of: fn(&[f64; 2]) -> f64| L::of(numbers.each_ref().map(of));
        (self.options.rtol, self.options.longest_step) = (option(|own| own[0]), option(|own| own[1]));
    }

    /// The discrete state of a lane, which has this run.
    pub(super) fn held_of<B: BorrowMut<Run<M, P>>>(&self, i: usize, seat: &Seat<M, P, B>) -> M::U {
        let mut held = seat.sim().state.held();
        if self.steps.value(i) > 0.0 {
            M::take_held(&mut held, &self.held, |wide: L| wide.value(i));
        }
        held
    }

    /// The steps that a lane, which has this run, has made since it came.
    pub(super) fn lately<B: BorrowMut<Run<M, P>>>(&self, i: usize, seat: &Seat<M, P, B>) -> Lately<M, P> {
        let last = &self.last;
        let mut stages = P::blank(M::X::fill(0.0));
        P::map(&self.stages, &mut stages, |wide: &Wide<M, L>, one: &mut M::X| *one = column(wide, i));
        Lately {
            going: self.going(i),
            last: Span {
                time: last.time.value(i),
                h: last.h.value(i),
                from: column(&last.from, i),
                to: column(&last.to, i),
                rate_from: column(&last.rate_from, i),
                rate_to: column(&last.rate_to, i),
            },
            stages,
            by_error: self.by_error.value(i) > 0.0,
            time: self.time.value(i),
            held: self.held_of(i, seat),
            was: seat.was.filter(|_| self.looked.value(i) > 0.0),
            steps: self.steps.value(i) as u64,
            rejected: (self.rejected.value(i) - self.beginning.1.value(i)) as u64,
            longest: self.longest.value(i),
        }
    }

    /// Gives one lane another run, at a time on its way to another, in a state.
    pub(super) fn put(
        &mut self,
        i: usize,
        (time, end, x, most_steps): (f64, f64, M::X, f64),
        going: &Going<f64, M::X>,
    ) {
        self.time.put(i, time);
        self.end.put(i, end);
        self.options.most_steps.put(i, most_steps);
        set_column(&mut self.x, i, &x);
        set_column(&mut self.rate, i, &going.rate);
        let one = Pace::<L>::of(|number: fn(&Pace<f64>) -> f64| L::lit(number(&going.pace)));
        let mask = number_of_lane::<L>(i);
        self.pace = Pace::select(mask, &one, &self.pace);
        self.beginning =
            (Pace::select(mask, &one, &self.beginning.0), L::select(mask, L::lit(0.0), self.beginning.1));
        for number in [&mut self.steps, &mut self.rejected, &mut self.longest, &mut self.looked] {
            number.put(i, 0.0);
        }
        self.going.put(i, 1.0);
    }

    /// The pace and rate of one lane at the beginning of its step.
    pub(super) fn going(&self, i: usize) -> Going<f64, M::X> {
        let pace = Pace::<f64>::of(|number: fn(&Pace<L>) -> L| number(&self.beginning.0).value(i));
        Going { pace, rate: column(&self.rate, i) }
    }
}

/// A mask that is set in one lane.
fn number_of_lane<L: Lanes>(i: usize) -> L::Mask {
    let mut one = L::lit(0.0);
    one.put(i % LANES, 1.0);
    L::lit(0.0).lt(one)
}

//! From which coordinates the closures are solved best.

use super::blocks::{Block, Equation, System};
use crate::collect::{CollectVec, PushAll};
use crate::sorted::sort_by;

/// Up to this many sets of independent coordinates are all tried.
const MOST_SETS: usize = 2000;

/// A set of independent coordinates, and how everything else follows from it.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Choice {
    /// The unknowns that are given, in order of preference.
    pub(crate) independent: Vec<usize>,
    /// All others, in the order of solution.
    pub(crate) blocks: Vec<Block>,
    /// Has every block a closed form?
    pub(crate) closed: bool,
    /// The cost of the blocks that have one.
    pub(crate) cost: u32,
}

/// Sets of `freedom` independent coordinates that determine all unknowns `0..n`, the best first: all blocks closed, then the smallest
/// largest block, then cost, then preference.
///
/// `candidates` are distinct unknowns in order of preference. `cost` of a block is `None` where no closed form is
/// known. With rows in excess no set is complete and none is returned, so redundant rows must be gone before.
///
/// A candidate that stands in no equation is always one. Of the others, all sets are tried if they are few;
/// otherwise a set is grown greedily, and listed with all sets that differ from it by one coordinate. The growth completes
/// wherever a complete set exists, since sets of independent coordinates are independent sets of a matroid (J. Edmonds,
/// D. R. Fulkerson, Transversals and matroid partition, J. Res. NBS 69B, 1965).
pub(crate) fn independent_sets(
    n: usize,
    equations: &[Equation],
    freedom: usize,
    candidates: &[usize],
    cost: &dyn Fn(&Block) -> Option<u32>,
) -> Vec<Choice> {
    let system = System::new(n, equations);
    let (forced, open): (Vec<usize>, Vec<usize>) =
        (0..candidates.len()).partition(|&place| system.holders[candidates[place]].is_empty());
    let search = Search { system, candidates, cost, forced, open };
    let Some(wanted) = freedom.checked_sub(search.forced.len()) else { return Vec::new() };
    let sets = if count(search.open.len(), wanted) <= MOST_SETS {
        combinations(&search.open, wanted)
    } else {
        search.greedy(wanted)
    };
    let mut ranked: Vec<(Rank, Choice)> =
        sets.into_iter().filter_map(|set| search.choice(&set)).collect_vec();
    sort_by(&mut ranked, |a, b| a.0.cmp(&b.0));
    ranked.into_iter().map(|(_, choice)| choice).collect_vec()
}

/// Rank of a set, the lesser being the better: how it solves, then its places in the preference.
type Rank = (Score, Vec<usize>);

/// How well a set of independent coordinates solves, the lesser the better: is a block not closed, the unknowns of the largest block,
/// the cost.
type Score = (bool, usize, u32);

struct Search<'a> {
    system: System<'a>,
    candidates: &'a [usize],
    cost: &'a dyn Fn(&Block) -> Option<u32>,
    /// Places, among the candidates, of those that no equation holds.
    forced: Vec<usize>,
    /// The other places.
    open: Vec<usize>,
}

impl Search<'_> {
    /// The choice of some open places, if it determines everything.
    fn choice(&self, set: &[usize]) -> Option<(Rank, Choice)> {
        let places = self.with_forced(set);
        let independent = self.unknowns(&places);
        let split = self.system.split(&independent);
        if !split.free.is_empty() || !split.excess.is_empty() {
            return None;
        }
        let score = self.score(&split.blocks);
        let choice = Choice { independent, blocks: split.blocks, closed: !score.0, cost: score.2 };
        Some(((score, places), choice))
    }

    fn score(&self, blocks: &[Block]) -> Score {
        let largest = blocks.iter().map(|block| block.unknowns.len()).max().unwrap_or(0);
        let costs: Vec<Option<u32>> = blocks.iter().map(self.cost).collect_vec();
        let cost = costs.iter().flatten().fold(0, |sum: u32, &cost| sum.saturating_add(cost));
        (costs.contains(&None), largest, cost)
    }

    /// A set that is grown by the candidate which, with those before, keeps all blocks closed if that can be, and then
    /// leaves the fewest unknowns free; and its neighbours; nothing if the candidates cannot determine everything.
    fn greedy(&self, wanted: usize) -> Vec<Vec<usize>> {
        let mut set: Vec<usize> = Vec::with_capacity(wanted);
        while set.len() < wanted {
            let free = self.system.split(&self.unknowns(&self.with_forced(&set))).free;
            let can_drive = |place: &usize| free.binary_search(&self.candidates[*place]).is_ok();
            let best = self.open.iter().copied().filter(can_drive).min_by_key(|&place| {
                let split = self.system.split(&self.unknowns(&self.with_forced(&with(&set, place))));
                let (unclosed, largest, cost) = self.score(&split.blocks);
                (unclosed, split.free.len(), largest, cost, place)
            });
            let Some(best) = best else { return Vec::new() };
            set = with(&set, best);
        }
        let mut sets = vec![set.clone()];
        for gone in &set {
            let rest: Vec<usize> = set.iter().copied().filter(|place| place != gone).collect_vec();
            let others = self.open.iter().filter(|&place| !set.contains(place));
            sets.push_all(others.map(|&place| with(&rest, place)));
        }
        sets
    }

    fn with_forced(&self, set: &[usize]) -> Vec<usize> {
        let mut places: Vec<usize> = self.forced.iter().chain(set).copied().collect_vec();
        places.sort_unstable();
        places
    }

    fn unknowns(&self, places: &[usize]) -> Vec<usize> {
        places.iter().map(|&place| self.candidates[place]).collect_vec()
    }
}

fn with(set: &[usize], place: usize) -> Vec<usize> {
    let mut set = set.to_vec();
    set.push(place);
    set
}

/// The number of sets of `k` out of `n`, no further than a little above [`MOST_SETS`].
fn count(n: usize, k: usize) -> usize {
    if k > n {
        return 0;
    }
    let mut count: usize = 1;
    for factor in 0..k.min(n - k) {
        count = count * (n - factor) / (factor + 1);
        if count > MOST_SETS {
            break;
        }
    }
    count
}

/// All sets of `k` out of `items`, in the order of the items.
fn combinations(items: &[usize], k: usize) -> Vec<Vec<usize>> {
    let mut sets = Vec::new();
    if k > items.len() {
        return sets;
    }
    let mut chosen: Vec<usize> = (0..k).collect_vec();
    loop {
        sets.push(chosen.iter().map(|&place| items[place]).collect_vec());
        let Some(moved) = (0..k).rev().find(|&slot| chosen[slot] < items.len() - k + slot) else {
            return sets;
        };
        let next = chosen[moved] + 1;
        for slot in moved..k {
            chosen[slot] = next + slot - moved;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes::{
        andrews, double_butterfly, four_bar, ladder, quadrorhomb, stephenson_iii, three_cranks,
    };
    use super::*;

    /// Only monads and dyads are closed.
    fn dyads(block: &Block) -> Option<u32> {
        let size = block.unknowns.len() as u32;
        (size <= 2).then_some(size)
    }

    fn all(n: usize, equations: &[Equation], freedom: usize) -> Vec<Choice> {
        independent_sets(n, equations, freedom, &(0..n).collect::<Vec<_>>(), &dyads)
    }

    fn closed(choices: &[Choice]) -> Vec<&[usize]> {
        choices.iter().filter(|choice| choice.closed).map(|choice| choice.independent.as_slice()).collect()
    }

    /// Closed from the crank and from the four bars that form dyads with it and the ground; from every other bar, the
    /// cell must be solved at once.
    #[test]
    fn quadrorhomb_is_driven_by_its_crank() {
        let choices = all(13, &quadrorhomb().closures(), 1);
        assert_eq!(choices.len(), 13);
        assert_eq!(choices[0].independent, [0]);
        assert_eq!((choices[0].blocks.len(), choices[0].cost), (6, 12));
        assert_eq!(closed(&choices), [[0], [1], [2], [3], [4]]);
    }
    #[test]
    fn every_bar_of_a_four_bar_drives_it() {
        let choices = all(3, &four_bar().closures(), 1);
        assert_eq!(closed(&choices), [[0], [1], [2]]);
        let preferred = independent_sets(3, &four_bar().closures(), 1, &[2, 0], &dyads);
        assert_eq!(closed(&preferred), [[2], [0]]);
    }

    /// From the bars of the first loop alone: from K4 to K7 a first loop of three bars stays.
    #[test]
    fn andrews_is_driven_by_the_bars_of_its_first_loop() {
        let choices = all(7, &andrews().closures(), 1);
        assert_eq!(choices.len(), 7);
        assert_eq!(closed(&choices), [[0], [1], [2]]);
        assert_eq!(choices[0].blocks.len(), 3);
    }

    #[test]
    fn stephenson_iii_is_driven_by_its_four_bar() {
        let choices = all(5, &stephenson_iii().closures(), 1);
        assert_eq!(closed(&choices), [[0], [1], [2]]);
        assert!(choices[3..].iter().all(|choice| choice.blocks.len() == 1));
    }

    #[test]
    fn no_bar_drives_the_double_butterfly_in_closed_form() {
        let choices = all(7, &double_butterfly().closures(), 1);
        assert_eq!((choices.len(), closed(&choices).len()), (7, 0));
        assert_eq!((choices[0].independent[0], choices[0].cost), (0, 0));
    }

    #[test]
    fn every_bar_drives_a_ladder() {
        let choices = all(21, &ladder(10).closures(), 1);
        assert_eq!(closed(&choices).len(), 21);
    }

    /// Cost decides between sets that are closed: here couplers are dear.
    #[test]
    fn the_cheaper_block_wins() {
        let dear = |block: &Block| Some(if block.unknowns.contains(&1) { 5 } else { 3 });
        let choices = independent_sets(3, &four_bar().closures(), 1, &[0, 1, 2], &dear);
        assert_eq!(
            choices.iter().map(|choice| (choice.independent[0], choice.cost)).collect::<Vec<_>>(),
            [(1, 3), (0, 5), (2, 5)]
        );
    }

    /// Two four-bars and a bar in no loop: one coordinate in each, and the bar.
    #[test]
    fn sets_take_a_coordinate_from_each_part() {
        let pair = |unknowns: [usize; 3]| Equation { unknowns: unknowns.to_vec(), rows: 2 };
        let both = [pair([0, 1, 2]), pair([4, 5, 6])];
        let choices = all(7, &both, 3);
        assert_eq!(choices.len(), 9);
        assert_eq!(choices[0].independent, [0, 3, 4]);
        assert!(choices.iter().all(|choice| choice.closed && choice.independent.contains(&3)));
        assert!(all(7, &both, 2).is_empty());
        assert!(all(7, &both, 4).is_empty());
    }

    #[test]
    fn a_truss_needs_no_coordinate_and_a_redundant_loop_has_none() {
        let closures = three_cranks().closures();
        assert_eq!(all(4, &closures, 0).len(), 1);
        assert!(all(4, &closures, 1).is_empty());
    }

    /// Ten Stephenson III linkages have too many sets to try. Their bars are listed with the two that close no dyad
    /// first, which are to be passed over.
    #[test]
    fn greedy_growth_finds_closed_blocks_among_many() {
        let one = stephenson_iii().closures();
        let copies = (0..10).flat_map(|copy| {
            one.iter().map(move |closure| Equation {
                unknowns: closure.unknowns.iter().map(|unknown| unknown + 5 * copy).collect(),
                rows: 2,
            })
        });
        let equations: Vec<Equation> = copies.collect();
        let mut candidates: Vec<usize> = (0..50).collect();
        candidates.sort_by_key(|unknown| unknown % 5 < 3);
        assert!(count(50, 10) > MOST_SETS);
        let choices = independent_sets(50, &equations, 10, &candidates, &dyads);
        assert_eq!(choices[0].independent, (0..10).map(|copy| 5 * copy).collect::<Vec<_>>());
        assert_eq!(closed(&choices).len(), 1 + 10 * 2);
    }

    #[test]
    fn all_combinations_in_order() {
        assert_eq!(combinations(&[4, 5, 6], 2), [[4, 5], [4, 6], [5, 6]]);
        assert_eq!(combinations(&[4], 0), [Vec::<usize>::new()]);
        assert!(combinations(&[4], 2).is_empty());
        assert_eq!((count(7, 3), count(5, 0), count(2, 3)), (35, 1, 0));
        assert_eq!(combinations(&[0, 1, 2, 3, 4, 5, 6], 3).len(), 35);
    }
}

//! Trees and loops of the graph of a mechanism: bodies are nodes, joints are edges, node 0 is the ground.

use crate::collect::CollectVec;
use std::collections::VecDeque;

/// An edge that is walked, and whether it is walked from its first node to its second.
pub(crate) type Step = (usize, bool);

/// A closed walk; each step starts where the one before ends, the first where the last ends.
pub(crate) type Cycle = Vec<Step>;

/// A tree in each component of a graph.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Forest {
    /// The edge by which each node is reached, and the node from which; `None` at a root.
    pub(crate) parent: Vec<Option<(usize, usize)>>,
    /// All nodes, tree by tree, each after its parent.
    pub(crate) order: Vec<usize>,
    /// The ground, and the lowest node of every component that floats.
    pub(crate) roots: Vec<usize>,
    /// The edges outside the trees, ascending; each closes one loop.
    pub(crate) chords: Vec<usize>,
}

/// The shortest way from the ground to every node, and likewise from one node of each component that floats.
///
/// `edges` may be parallel or join a node to itself. Among ways of one length, the edge of lowest index is taken.
pub(crate) fn spanning_forest(nodes: usize, edges: &[(usize, usize)]) -> Forest {
    let near = neighbours(nodes, edges);
    let mut grown = Growth::new(nodes);
    let mut roots = Vec::new();
    for root in 0..nodes {
        if grown.branch[root].is_none() {
            roots.push(root);
            grown.grow(root, &near);
        }
    }
    let chords = (0..edges.len()).filter(|&edge| !grown.holds(edge, edges[edge])).collect_vec();
    Forest { parent: grown.parent, order: grown.order, roots, chords }
}

/// Independent loops of least total length: `edges - nodes + components` of them, the shortest first.
///
/// The shortest cycles through a node are two shortest ways from it and the edge between their ends; of all of these,
/// taken by length, those are kept that are no sum of others (J. D. Horton, A polynomial-time algorithm to find the
/// shortest cycle basis of a graph, SIAM J. Comput. 16, 1987). Which of several shortest ways is taken does not
/// matter where all edges count alike: two ways to a node differ by a sum of cycles no longer than the one at hand,
/// and these are candidates themselves or shorter. Among equal lengths, loops through the ground come first.
pub(crate) fn shortest_cycle_basis(nodes: usize, edges: &[(usize, usize)]) -> Vec<Cycle> {
    let chords = spanning_forest(nodes, edges).chords;
    if chords.is_empty() {
        return Vec::new();
    }
    let near = neighbours(nodes, edges);
    let mut trees = Vec::with_capacity(nodes);
    let mut by_length: Vec<Vec<(usize, usize)>> = vec![Vec::new(); nodes + 1];
    for root in 0..nodes {
        let mut tree = Growth::new(nodes);
        tree.grow(root, &near);
        for (edge, &ends) in edges.iter().enumerate() {
            if let Some(length) = tree.cycle_length(edge, ends) {
                by_length[length].push((root, edge));
            }
        }
        trees.push(tree);
    }
    let mut space = CycleSpace::new(edges.len(), &chords);
    let mut basis = Vec::with_capacity(chords.len());
    for (root, edge) in by_length.into_iter().flatten() {
        let cycle = trees[root].cycle(edge, edges);
        if space.extend(&cycle) {
            basis.push(cycle);
            if basis.len() == chords.len() {
                break;
            }
        }
    }
    basis
}

/// The edges at each node, ascending, with the node at their other end.
fn neighbours(nodes: usize, edges: &[(usize, usize)]) -> Vec<Vec<(usize, usize)>> {
    let mut near = vec![Vec::new(); nodes];
    for (edge, &(a, b)) in edges.iter().enumerate() {
        near[a].push((edge, b));
        near[b].push((edge, a));
    }
    near
}

/// Trees that grow breadth first.
struct Growth {
    parent: Vec<Option<(usize, usize)>>,
    depth: Vec<usize>,
    /// The root's child above each node, the root at itself; `None` where nothing has grown yet.
    branch: Vec<Option<usize>>,
    order: Vec<usize>,
}

impl Growth {
    fn new(nodes: usize) -> Growth {
        let order = Vec::with_capacity(nodes);
        Growth { parent: vec![None; nodes], depth: vec![0; nodes], branch: vec![None; nodes], order }
    }

    fn grow(&mut self, root: usize, near: &[Vec<(usize, usize)>]) {
        self.branch[root] = Some(root);
        let mut queue = VecDeque::from([root]);
        while let Some(node) = queue.pop_front() {
            self.order.push(node);
            for &(edge, next) in &near[node] {
                if self.branch[next].is_none() {
                    self.parent[next] = Some((edge, node));
                    self.depth[next] = self.depth[node] + 1;
                    self.branch[next] = if node == root { Some(next) } else { self.branch[node] };
                    queue.push_back(next);
                }
            }
        }
    }

    /// Does the tree go through this edge?
    fn holds(&self, edge: usize, (a, b): (usize, usize)) -> bool {
        [a, b].iter().any(|&node| self.parent[node].is_some_and(|(by, _)| by == edge))
    }

    /// The length of the cycle that `edge` closes, if the root lies on it.
    fn cycle_length(&self, edge: usize, (a, b): (usize, usize)) -> Option<usize> {
        let (left, right) = (self.branch[a]?, self.branch[b]?);
        let at_root = a == b && self.depth[a] == 0;
        ((left != right && !self.holds(edge, (a, b))) || at_root).then(|| self.depth[a] + 1 + self.depth[b])
    }

    /// From the root to the edge's first node, over the edge, and back.
    fn cycle(&self, edge: usize, edges: &[(usize, usize)]) -> Cycle {
        let (a, b) = edges[edge];
        let mut cycle: Cycle =
            self.way_up(a, edges).iter().map(|&(edge, along)| (edge, !along)).collect_vec();
        cycle.reverse();
        cycle.push((edge, true));
        cycle.extend(self.way_up(b, edges));
        cycle
    }

    /// The steps from a node to the root.
    fn way_up(&self, mut node: usize, edges: &[(usize, usize)]) -> Vec<Step> {
        let mut steps = Vec::new();
        while let Some((edge, above)) = self.parent[node] {
            steps.push((edge, edges[edge].0 == node));
            node = above;
        }
        steps
    }
}

/// A space of cycles over GF(2). A cycle is known by its chords, of which a word holds 64.
struct CycleSpace {
    /// The place of each edge among the chords.
    place: Vec<Option<usize>>,
    /// Independent vectors by their lowest chord.
    rows: Vec<Option<Vec<u64>>>,
}

impl CycleSpace {
    fn new(edges: usize, chords: &[usize]) -> CycleSpace {
        let mut place = vec![None; edges];
        for (k, &chord) in chords.iter().enumerate() {
            place[chord] = Some(k);
        }
        CycleSpace { place, rows: vec![None; chords.len()] }
    }

    /// Adds a cycle; false if it lies in the space already.
    fn extend(&mut self, cycle: &[Step]) -> bool {
        let mut vector = vec![0_u64; self.rows.len().div_ceil(64)];
        for chord in cycle.iter().filter_map(|&(edge, _)| self.place[edge]) {
            vector[chord / 64] ^= 1 << (chord % 64);
        }
        while let Some(word) = vector.iter().position(|&word| word != 0) {
            let lowest = 64 * word + vector[word].trailing_zeros() as usize;
            let Some(row) = &self.rows[lowest] else {
                self.rows[lowest] = Some(vector);
                return true;
            };
            for (to, from) in vector.iter_mut().zip(row) {
                *to ^= from;
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes::{
        Linkage, Random, andrews, double_butterfly, floating_four_bar, four_bar, ladder, quadrorhomb,
        stephenson_iii,
    };
    use super::*;

    /// The basis of a graph, after checking that it is one: closed walks, independent, as many as the theory says.
    fn lengths(nodes: usize, edges: &[(usize, usize)]) -> Vec<usize> {
        let forest = spanning_forest(nodes, edges);
        let basis = shortest_cycle_basis(nodes, edges);
        assert_eq!(basis.len(), edges.len() + forest.roots.len() - nodes);
        let mut space = CycleSpace::new(edges.len(), &forest.chords);
        for cycle in &basis {
            let ends =
                |&(edge, along): &Step| if along { edges[edge] } else { (edges[edge].1, edges[edge].0) };
            let next = cycle.iter().cycle().skip(1);
            assert!(cycle.iter().zip(next).all(|(step, next)| ends(step).1 == ends(next).0), "{cycle:?}");
            assert!(space.extend(cycle));
        }
        basis.iter().map(Vec::len).collect()
    }

    fn of(linkage: &Linkage) -> Vec<usize> {
        lengths(linkage.nodes(), &linkage.edges())
    }

    /// The length of a shortest basis from all elements of the cycle space, the lightest first (a matroid's greedy).
    fn least_length(nodes: usize, edges: &[(usize, usize)]) -> usize {
        let chords = spanning_forest(nodes, edges).chords;
        let mut elements: Vec<Vec<usize>> = (1_u32..1 << edges.len())
            .map(|set| (0..edges.len()).filter(|edge| set >> edge & 1 == 1).collect())
            .filter(|set: &Vec<usize>| {
                let mut odd = vec![false; nodes];
                for &edge in set {
                    odd[edges[edge].0] ^= true;
                    odd[edges[edge].1] ^= true;
                }
                !odd.contains(&true)
            })
            .collect();
        elements.sort_by_key(Vec::len);
        let mut space = CycleSpace::new(edges.len(), &chords);
        let as_cycle = |set: &Vec<usize>| -> Cycle { set.iter().map(|&edge| (edge, true)).collect() };
        elements.iter().filter(|set| space.extend(&as_cycle(set))).map(Vec::len).sum()
    }

    #[test]
    fn loops_of_linkages() {
        assert_eq!(of(&four_bar()), [4]);
        assert_eq!(of(&andrews()), [4, 5, 5]);
        assert_eq!(of(&quadrorhomb()), [4, 4, 4, 4, 4, 5]);
        assert_eq!(of(&ladder(40)), [4; 40]);
        assert_eq!(of(&stephenson_iii()), [4, 5]);
        assert_eq!(of(&floating_four_bar()), [4]);
    }

    /// The double butterfly is among the eight-bar chains without a loop of four.
    #[test]
    fn no_loop_of_the_double_butterfly_is_shorter_than_five() {
        assert_eq!(of(&double_butterfly()), [5, 5, 5]);
    }

    /// Girths and bases of known graphs: K4, K3,3, the cube and Petersen's graph.
    #[test]
    fn known_graphs() {
        let k4 = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        assert_eq!(lengths(4, &k4), [3; 3]);
        let k33: Vec<(usize, usize)> = (0..9).map(|k| (k / 3, 3 + k % 3)).collect();
        assert_eq!(lengths(6, &k33), [4; 4]);
        let cube: Vec<(usize, usize)> =
            (0..8).flat_map(|a| [1, 2, 4].map(|bit| (a, a ^ bit))).filter(|(a, b)| a < b).collect();
        assert_eq!(lengths(8, &cube), [4; 5]);
        let petersen: Vec<(usize, usize)> =
            (0..5).flat_map(|k| [(k, (k + 1) % 5), (k, 5 + k), (5 + k, 5 + (k + 2) % 5)]).collect();
        assert_eq!(lengths(10, &petersen), [5; 6]);
    }

    #[test]
    fn parallel_joints_and_joints_of_a_body_with_itself_close_loops() {
        assert_eq!(lengths(2, &[(0, 1), (1, 0), (0, 0), (1, 1)]), [1, 1, 2]);
        assert_eq!(shortest_cycle_basis(2, &[(0, 1), (1, 0)]), [[(0, true), (1, true)]]);
        assert_eq!(shortest_cycle_basis(2, &[(0, 1), (0, 1)]), [[(1, true), (0, false)]]);
    }

    #[test]
    fn random_graphs_have_bases_of_least_length() {
        let mut random = Random(2);
        for _ in 0..300 {
            let nodes = 2 + random.below(6);
            let edges: Vec<(usize, usize)> =
                (0..=random.below(11)).map(|_| (random.below(nodes), random.below(nodes))).collect();
            assert_eq!(
                lengths(nodes, &edges).iter().sum::<usize>(),
                least_length(nodes, &edges),
                "{edges:?}"
            );
        }
    }

    #[test]
    fn a_forest_reaches_every_node_by_the_shortest_way() {
        let edges = [(2, 1), (0, 1), (2, 0), (4, 3), (5, 5), (3, 4)];
        let forest = spanning_forest(6, &edges);
        assert_eq!(forest.parent, [None, Some((1, 0)), Some((2, 0)), None, Some((3, 3)), None]);
        assert_eq!(forest.order, [0, 1, 2, 3, 4, 5]);
        assert_eq!(forest.roots, [0, 3, 5]);
        assert_eq!(forest.chords, [0, 4, 5]);
    }

    #[test]
    fn a_chain_has_no_loops() {
        let edges: Vec<(usize, usize)> = (0..64).map(|k| (k, k + 1)).collect();
        assert_eq!(shortest_cycle_basis(65, &edges), Vec::<Cycle>::new());
        assert_eq!(spanning_forest(65, &edges).order, (0..65).collect::<Vec<_>>());
    }
}

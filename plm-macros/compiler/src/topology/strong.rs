//! Strongly connected components.

/// The strongly connected components of a directed graph, `next[node]` being the nodes to which a node leads; each
/// component comes after all to which it leads, its nodes ascending.
///
/// R. Tarjan, Depth-first search and linear graph algorithms, SIAM J. Comput. 1, 1972, with a stack of its own.
pub(super) fn strongly_connected(next: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut search = Search {
        number: vec![0; next.len()],
        low: vec![0; next.len()],
        entered: 0,
        open: Vec::new(),
        is_open: vec![false; next.len()],
        components: Vec::new(),
    };
    for root in 0..next.len() {
        if search.number[root] == 0 {
            search.visit(root, next);
        }
    }
    search.components
}

struct Search {
    /// When each node was entered, counted from 1; 0 before.
    number: Vec<usize>,
    /// The lowest number of an open node that is known to be reached from each node.
    low: Vec<usize>,
    entered: usize,
    /// Nodes whose component is not complete.
    open: Vec<usize>,
    is_open: Vec<bool>,
    components: Vec<Vec<usize>>,
}

impl Search {
    fn visit(&mut self, root: usize, next: &[Vec<usize>]) {
        self.enter(root);
        let mut path = vec![(root, 0)];
        while let Some((node, tried)) = path.last_mut() {
            let node = *node;
            if let Some(&to) = next[node].get(*tried) {
                *tried += 1;
                if self.number[to] == 0 {
                    self.enter(to);
                    path.push((to, 0));
                } else if self.is_open[to] {
                    self.low[node] = self.low[node].min(self.number[to]);
                }
            } else {
                path.pop();
                if let Some(&(above, _)) = path.last() {
                    self.low[above] = self.low[above].min(self.low[node]);
                }
                self.close(node);
            }
        }
    }

    fn enter(&mut self, node: usize) {
        self.entered += 1;
        self.number[node] = self.entered;
        self.low[node] = self.entered;
        self.open.push(node);
        self.is_open[node] = true;
    }

    /// Completes the component of a node from which no earlier node can be reached.
    fn close(&mut self, node: usize) {
        if self.low[node] != self.number[node] {
            return;
        }
        let first = self.open.iter().rposition(|&other| other == node).unwrap_or(0);
        let mut component = self.open.split_off(first);
        component.sort_unstable();
        for &member in &component {
            self.is_open[member] = false;
        }
        self.components.push(component);
    }
}

#[cfg(test)]
mod tests {
    use super::strongly_connected;

    #[test]
    fn what_leads_back_is_one_component() {
        let next = [vec![1], vec![2], vec![0, 3], vec![4], vec![3], vec![]];
        assert_eq!(strongly_connected(&next), [vec![3, 4], vec![0, 1, 2], vec![5]]);
    }

    #[test]
    fn components_come_after_those_to_which_they_lead() {
        let next = [vec![1, 2], vec![3], vec![3], vec![]];
        assert_eq!(strongly_connected(&next), [vec![3], vec![1], vec![2], vec![0]]);
    }

    #[test]
    fn a_long_path_needs_no_deep_stack() {
        let n = 200_000;
        let next: Vec<Vec<usize>> = (0..n).map(|k| if k + 1 < n { vec![k + 1] } else { vec![] }).collect();
        assert_eq!(strongly_connected(&next).len(), n);
    }
}

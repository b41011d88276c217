"""The longest and the shortest path through a graph with loops."""

from program import NotUnderstood


class Cost:
    """Instructions of a path, and how many of them are in which function that is called on it."""

    def __init__(self, count, shares=None):
        self.count, self.shares = count, shares or {}

    def plus(self, other, times=1):
        """The cost of going on by `other`, so many times."""
        shares = self.shares
        if other.shares and times:
            shares = dict(shares)
            for name, count in other.shares.items():
                shares[name] = shares.get(name, 0) + times * count
        return Cost(self.count + times * other.count, shares)

    def in_function(self, name):
        """The same, with what is in no function that is called as a share of this one."""
        return Cost(0, self.shares).plus(Cost(self.count, {name: self.count - sum(self.shares.values())}))


NOTHING = Cost(0)


class Graph:
    """Nodes with costs, and edges. `rounds` tells how often at most the head of a loop is come to, of the loop's graph, its
    head and its nodes."""

    def __init__(self, successors, cost, rounds, longest, depth=0):
        self.successors, self.cost, self.rounds, self.longest = successors, cost, rounds, longest
        # In so many loops.
        self.depth = depth

    def best(self, costs):
        """The longest, or the shortest."""
        return (max if self.longest else min)(costs, key=lambda cost: cost.count)

    def paths(self, entry, nodes):
        """The best costs from the entry to the nodes that it leads to, both ends included."""
        costs, into = {}, {entry: [NOTHING]}
        for part in components(entry, nodes, self.successors):
            heads = [node for node in part if node in into]
            # After a loop that cannot be entered.
            if not heads:
                continue
            if len(heads) > 1:
                raise NotUnderstood(f"a loop that is entered at {', '.join(map(hex, heads))}")
            before = self.best(into[heads[0]])
            for node, inside in self._within(heads[0], part).items():
                costs[node] = before.plus(inside)
                for target in self.successors(node):
                    if target in nodes and target not in part:
                        into.setdefault(target, []).append(costs[node])
        return costs

    def _within(self, head, part):
        """The best costs from the head of a component to its nodes, all rounds included."""
        if part == {head} and head not in self.successors(head):
            return {head: self.cost(head)}
        rounds = self.rounds(self, head, part)
        if rounds < 1:
            return {}
        once = self.once(head, part)
        around = self.best([once[node] for node in once if head in self.successors(node)])
        # The shortest path goes through it once.
        before = NOTHING.plus(around, rounds - 1 if self.longest else 0)
        return {node: before.plus(cost) for node, cost in once.items()}

    def once(self, head, loop):
        """The best costs from the head of a loop to its nodes in one round."""
        edges = {node: [target for target in self.successors(node) if target != head] for node in loop}
        return Graph(edges.__getitem__, self.cost, self.rounds, self.longest, self.depth + 1).paths(head, loop)


def components(entry, nodes, successors):
    """Strongly connected components that the entry leads to, each before those that it leads to (R. Tarjan, Depth-first search
    and linear graph algorithms, SIAM J. Comput. 1, 1972)."""
    number, low, open_nodes, closed, parts = {}, {}, [], set(), []
    # In place of recursion: nodes on the way, with what is left of their edges.
    way = []

    def enter(node):
        number[node] = low[node] = len(number)
        open_nodes.append(node)
        way.append((node, iter(successors(node))))

    enter(entry)
    while way:
        node, edges = way[-1]
        target = next((target for target in edges if target in nodes and target not in closed), None)
        if target in number:
            low[node] = min(low[node], number[target])
        elif target is not None:
            enter(target)
        else:
            way.pop()
            if way:
                low[way[-1][0]] = min(low[way[-1][0]], low[node])
            if low[node] == number[node]:
                part = set()
                while node not in part:
                    part.add(open_nodes.pop())
                closed |= part
                parts.append(part)
    return parts[::-1]

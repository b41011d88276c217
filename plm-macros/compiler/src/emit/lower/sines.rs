//! Sines and cosines, of several angles at once where they fill a vector.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::{Op, Ref, Tape};

use super::Lowering;
use super::fragment::Fragment;
use super::statement::Statement;

/// Numbers of angles whose sines and cosines fill a vector.
const WHOLE_VECTORS: [usize; 2] = [8, 4];
/// Two or three angles that are left over go into a vector too where sines are most of the work: up to so many operations
/// an angle. In longer code the way into vectors and back stands on a critical path that has room for sines one by one
/// (per step, in vectors or not: double pendulum 77 ns or 96; four-bar linkage in absolute coordinates 414 or 330).
const SHORT: usize = 40;

impl Lowering<'_> {
    /// Sine and cosine of an angle, with all angles of its group.
    pub(super) fn bind_sines(&mut self, index: usize, angle: Ref) {
        if let Some(at) = self.groups.iter().position(|group| group.contains(&index)) {
            let sines = self.groups.swap_remove(at);
            self.bind_group(&sines);
            return;
        }
        let by = if self.is_direct(angle) { "sin_cos_by::<DIRECT>" } else { "sin_cos" };
        let angle = self.fragments[angle.index()].clone();
        let (sine, cosine) = self.local_pair(&angle);
        let pattern = format!("({}, {})", sine.text, cosine.text);
        let value = format!("{}.{by}()", angle.within(4));
        let makes = vec![sine.reads[0], cosine.reads[0]];
        self.lines.statements.push(Statement::Let { makes, pattern, value, reads: angle.reads });
        self.early.insert(index, sine);
        self.early.insert(index + 1, cosine);
    }

    /// `let ([sin_a, sin_b], [cos_a, cos_b]) = S::sin_cos_all([a, b]);`
    fn bind_group(&mut self, sines: &[usize]) {
        let (mut makes, mut reads) = (Vec::new(), Vec::new());
        let mut angles = sines.iter().filter_map(|&index| self.tape.ops[index].op.operands().next());
        let by = if angles.all(|angle| self.is_direct(angle)) {
            "sin_cos_all_by::<DIRECT, _>"
        } else {
            "sin_cos_all"
        };
        let mut texts: [Vec<String>; 3] = Default::default();
        for &index in sines {
            let Some(angle) = self.tape.ops[index].op.operands().next() else { continue };
            let angle = self.angle(angle.index());
            let (sine, cosine) = self.local_pair(&angle);
            makes.push_all([sine.reads[0], cosine.reads[0]]);
            for (list, fragment) in texts.iter_mut().zip([&sine, &cosine, &angle]) {
                list.push(fragment.text.clone());
            }
            reads.extend(angle.reads);
            self.early.insert(index, sine);
            self.early.insert(index + 1, cosine);
        }
        let [sines, cosines, angles] = texts.map_each(|list| list.join(", "));
        let pattern = format!("([{sines}], [{cosines}])");
        let value = format!("{}::{by}([{angles}])", self.scalar);
        self.lines.statements.push(Statement::Let { makes, pattern, value, reads });
    }

    /// Is an angle one that `DIRECT` tells of?
    fn is_direct(&self, angle: Ref) -> bool {
        let angles = self.direct.unwrap_or_default();
        matches!(self.tape.ops[angle.index()].op, Op::Symbol(symbol) if angles.contains(&symbol))
    }

    /// A coordinate, before its turn if need be.
    fn angle(&mut self, index: usize) -> Fragment {
        if let Some(fragment) = self.fragments.get(index).or_else(|| self.early.get(&index)) {
            return fragment.clone();
        }
        let fragment = self.fragment(self.tape.ops[index].op);
        let bound = self.bind(index, fragment);
        self.early.insert(index, bound.clone());
        bound
    }

    fn local_pair(&mut self, angle: &Fragment) -> (Fragment, Fragment) {
        let suffix =
            if angle.strength == 4 && angle.reads.len() == 1 { angle.text.as_str() } else { "angle" };
        (self.local(&format!("sin_{suffix}")), self.local(&format!("cos_{suffix}")))
    }
}

/// Is this a sine that is wanted with the cosine after it?
pub(crate) fn is_pair(tape: &Tape, uses: &[u32], index: usize) -> bool {
    let next = tape.ops.get(index + 1).map(|next| next.op);
    let same = matches!((tape.ops[index].op, next), (Op::Sin(a), Some(Op::Cos(b))) if a == b);
    same && uses[index] > 0 && uses[index + 1] > 0
}

/// Sines whose angles are inputs of the function, in groups that are computed together.
pub(super) fn angle_groups(tape: &Tape, uses: &[u32]) -> Vec<Vec<usize>> {
    let of_symbol = |index: &usize| match tape.ops[*index].op {
        Op::Sin(angle) => matches!(tape.ops[angle.index()].op, Op::Symbol(_)) && is_pair(tape, uses, *index),
        _ => false,
    };
    let sines: Vec<usize> = (0..tape.ops.len()).filter(of_symbol).collect_vec();
    let (mut groups, mut rest) = (Vec::new(), sines.as_slice());
    for lanes in WHOLE_VECTORS {
        while let Some((group, others)) = rest.split_at_checked(lanes) {
            groups.push(group.to_vec());
            rest = others;
        }
    }
    if rest.len() > 1 && tape.count().total() <= SHORT * sines.len() {
        groups.push(rest.to_vec());
    }
    groups
}

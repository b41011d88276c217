//! Which equation determines which unknown.

use crate::collect::{CollectVec, PushAll};
use std::collections::VecDeque;

use super::blocks::System;

/// As many unknowns as possible, each determined by an equation that holds it.
pub(super) struct Matching<'a> {
    system: &'a System<'a>,
    known: Vec<bool>,
    /// The equation that determines each unknown.
    owner: Vec<Option<usize>>,
    /// Rows of each equation that determine nothing.
    idle: Vec<usize>,
}

impl<'a> Matching<'a> {
    pub(super) fn new(system: &'a System<'a>, known: &[usize]) -> Matching<'a> {
        let n = system.holders.len();
        let mut is_known = vec![false; n];
        for &unknown in known {
            is_known[unknown] = true;
        }
        let idle = system.equations.iter().map(|equation| equation.rows).collect_vec();
        let mut matching = Matching { system, known: is_known, owner: vec![None; n], idle };
        for equation in 0..system.equations.len() {
            while matching.idle[equation] > 0 && matching.augment(equation) {
                matching.idle[equation] -= 1;
            }
        }
        matching
    }

    /// Gives an equation one more unknown, if others can take theirs elsewhere: breadth first along alternating paths.
    fn augment(&mut self, equation: usize) -> bool {
        let mut reached_by: Vec<Option<usize>> = vec![None; self.owner.len()];
        let mut entered_by: Vec<Option<usize>> = vec![None; self.idle.len()];
        let mut queue = VecDeque::from([equation]);
        while let Some(from) = queue.pop_front() {
            for &unknown in &self.system.equations[from].unknowns {
                if self.known[unknown] || reached_by[unknown].is_some() {
                    continue;
                }
                reached_by[unknown] = Some(from);
                let Some(owner) = self.owner[unknown] else {
                    self.shift(unknown, &reached_by, &entered_by);
                    return true;
                };
                if owner != equation && entered_by[owner].is_none() {
                    entered_by[owner] = Some(unknown);
                    queue.push_back(owner);
                }
            }
        }
        false
    }

    /// Hands `unknown` to the equation that reached it, what that gives up for it to the one before, and so on.
    fn shift(&mut self, unknown: usize, reached_by: &[Option<usize>], entered_by: &[Option<usize>]) {
        let mut given = Some(unknown);
        while let Some(unknown) = given {
            self.owner[unknown] = reached_by[unknown];
            given = reached_by[unknown].and_then(|equation| entered_by[equation]);
        }
    }

    /// The other equations whose unknowns an equation needs.
    pub(super) fn needs(&self, equation: usize) -> impl Iterator<Item = usize> {
        let unknowns = &self.system.equations[equation].unknowns;
        unknowns.iter().filter_map(|&unknown| self.owner[unknown]).filter(move |&owner| owner != equation)
    }

    /// The unknowns that an equation determines.
    fn owned(&self, equation: usize) -> impl Iterator<Item = usize> {
        let unknowns = &self.system.equations[equation].unknowns;
        unknowns.iter().copied().filter(move |&unknown| self.owner[unknown] == Some(equation))
    }

    pub(super) fn solved_by(&self, equations: &[usize]) -> Vec<usize> {
        let mut unknowns: Vec<usize> =
            equations.iter().flat_map(|&equation| self.owned(equation)).collect_vec();
        unknowns.sort_unstable();
        unknowns
    }

    /// Unknowns that some matching of this size leaves out, and by equation whether it holds one.
    pub(super) fn undetermined(&self) -> (Vec<usize>, Vec<bool>) {
        let left_out = |&unknown: &usize| self.owner[unknown].is_none() && !self.known[unknown];
        let mut free: Vec<usize> = (0..self.owner.len()).filter(left_out).collect_vec();
        let mut under = vec![false; self.idle.len()];
        let mut done = 0;
        while let Some(&unknown) = free.get(done) {
            done += 1;
            for &equation in &self.system.holders[unknown] {
                if !under[equation] {
                    under[equation] = true;
                    free.push_all(self.owned(equation));
                }
            }
        }
        free.sort_unstable();
        (free, under)
    }

    /// By equation, whether some matching of this size leaves one of its rows idle.
    pub(super) fn overdetermined(&self) -> Vec<bool> {
        let mut stack: Vec<usize> = (0..self.idle.len()).filter(|&k| self.idle[k] > 0).collect_vec();
        let mut over: Vec<bool> = self.idle.iter().map(|&rows| rows > 0).collect_vec();
        while let Some(equation) = stack.pop() {
            for owner in self.needs(equation) {
                if !over[owner] {
                    over[owner] = true;
                    stack.push(owner);
                }
            }
        }
        over
    }
}

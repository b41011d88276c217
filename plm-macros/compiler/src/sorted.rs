//! Maps and sets as sorted vectors, and how vectors are sorted.
//!
//! Whoever uses plm builds this crate without optimisation, and each pair of types in a tree of the standard library costs
//! ten times the code of these few loops. What is entered in ascending order is entered at the end; the rest moves
//! what stands after it.
//!
//! `benches/first_build.sh` prints what the first build costs a user.

use std::borrow::Borrow;
use std::cmp::Ordering;
use std::ops::Index;

use crate::collect::{CollectVec, PushAll};

/// Values by key, in the order of keys.
#[derive(Clone, Debug)]
pub struct SortedMap<K, V>(Vec<(K, V)>);

/// Values in order, each of them once.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct SortedSet<T>(Vec<T>);

/// Keys and values, by key.
pub type Entries<'a, K, V> = std::iter::Map<std::slice::Iter<'a, (K, V)>, fn(&'a (K, V)) -> (&'a K, &'a V)>;

/// Index of the key in a list of this length; if it is absent, the index at which it belongs, as `Err`. `compare` compares the entry at an
/// index with the key.
fn place(length: usize, mut compare: impl FnMut(usize) -> Ordering) -> Result<usize, usize> {
    let (mut low, mut high) = (0, length);
    // What is new mostly belongs at the end.
    let mut middle = length.saturating_sub(1);
    while low < high {
        match compare(middle) {
            Ordering::Less => low = middle + 1,
            Ordering::Equal => return Ok(middle),
            Ordering::Greater => high = middle,
        }
        middle = usize::midpoint(low, high);
    }
    Err(low)
}

/// Sorts a list by a key; what has the same key stays in its order.
pub(crate) fn sort_by_key<T, K: Ord>(items: &mut Vec<T>, key: impl Fn(&T) -> K) {
    sort_by(items, |a, b| key(a).cmp(&key(b)));
}

/// Sorts a list; what is equal stays in its order.
pub(crate) fn sort_by<T>(items: &mut Vec<T>, compare: impl Fn(&T, &T) -> Ordering) {
    let order = in_order(items.len(), &|a, b| compare(&items[a], &items[b]));
    let mut unsorted = std::mem::take(items).into_iter().map(Some).collect_vec();
    for k in order {
        items.push_all(unsorted[k].take());
    }
}

/// Places `0..count` in the order of what stands there. All lists are sorted by this one instance of the standard library's
/// sort, which has 2200 lines of LLVM's code for each closure.
fn in_order(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut places = (0..count).collect_vec();
    places.sort_by(|&a, &b| compare(a, b));
    places
}

impl<K: Ord, V> SortedMap<K, V> {
    /// A map without entries.
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// Entries in any order; of those with the same key the last.
    pub fn of(mut entries: Vec<(K, V)>) -> Self {
        sort_by(&mut entries, |a, b| a.0.cmp(&b.0));
        let mut map = Self::new();
        for (key, value) in entries {
            map.insert(key, value);
        }
        map
    }

    fn place<Q: Ord + ?Sized>(&self, key: &Q) -> Result<usize, usize>
    where
        K: Borrow<Q>,
    {
        place(self.0.len(), |k| self.0[k].0.borrow().cmp(key))
    }

    /// Enters a value; the one that the key had before is returned.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        match self.place(&key) {
            Ok(k) => Some(std::mem::replace(&mut self.0[k].1, value)),
            Err(k) => {
                self.0.insert(k, (key, value));
                None
            }
        }
    }

    /// The value of the key, which is entered where there is none.
    pub fn or_insert(&mut self, key: K, value: V) -> &mut V {
        let k = self.place(&key).unwrap_or_else(|k| {
            self.0.insert(k, (key, value));
            k
        });
        &mut self.0[k].1
    }

    /// The value of the key.
    pub fn get<Q: Ord + ?Sized>(&self, key: &Q) -> Option<&V>
    where
        K: Borrow<Q>,
    {
        let k = self.place(key).ok()?;
        Some(&self.0[k].1)
    }

    /// The value of the key, to be changed.
    pub fn get_mut<Q: Ord + ?Sized>(&mut self, key: &Q) -> Option<&mut V>
    where
        K: Borrow<Q>,
    {
        let k = self.place(key).ok()?;
        Some(&mut self.0[k].1)
    }

    /// True if the key has a value.
    pub fn contains_key<Q: Ord + ?Sized>(&self, key: &Q) -> bool
    where
        K: Borrow<Q>,
    {
        self.place(key).is_ok()
    }

    /// Takes out the value of the key.
    pub fn remove<Q: Ord + ?Sized>(&mut self, key: &Q) -> Option<V>
    where
        K: Borrow<Q>,
    {
        let k = self.place(key).ok()?;
        Some(self.0.remove(k).1)
    }

    /// Keys and values, by key.
    pub fn iter(&self) -> Entries<'_, K, V> {
        self.into_iter()
    }

    /// Keys and values, to be changed.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = (&K, &mut V)> {
        self.0.iter_mut().map(|(key, value)| (&*key, value))
    }

    /// Takes out the entries that are not to be kept.
    pub fn retain(&mut self, mut keep: impl FnMut(&K, &V) -> bool) {
        self.0.retain(|(key, value)| keep(key, value));
    }

    /// The keys, ascending.
    pub fn keys(&self) -> impl DoubleEndedIterator<Item = &K> + ExactSizeIterator {
        self.0.iter().map(|(key, _)| key)
    }

    /// The values, by key.
    pub fn values(&self) -> impl DoubleEndedIterator<Item = &V> + ExactSizeIterator {
        self.0.iter().map(|(_, value)| value)
    }

    /// How many entries there are.
    pub const fn len(&self) -> usize {
        self.0.len()
    }

    /// True if there are no entries.
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<T: Ord> SortedSet<T> {
    /// A set without values.
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    fn place<Q: Ord + ?Sized>(&self, value: &Q) -> Result<usize, usize>
    where
        T: Borrow<Q>,
    {
        place(self.0.len(), |k| self.0[k].borrow().cmp(value))
    }

    /// Enters a value; whether it is new.
    pub fn insert(&mut self, value: T) -> bool {
        let place = self.place(&value);
        if let Err(k) = place {
            self.0.insert(k, value);
        }
        place.is_err()
    }

    /// True if the value is among them.
    pub fn contains<Q: Ord + ?Sized>(&self, value: &Q) -> bool
    where
        T: Borrow<Q>,
    {
        self.place(value).is_ok()
    }

    /// Takes a value out; whether it was there.
    pub fn remove<Q: Ord + ?Sized>(&mut self, value: &Q) -> bool
    where
        T: Borrow<Q>,
    {
        let place = self.place(value);
        if let Ok(k) = place {
            self.0.remove(k);
        }
        place.is_ok()
    }

    /// Takes out the least value.
    pub fn pop_first(&mut self) -> Option<T> {
        if self.0.is_empty() { None } else { Some(self.0.remove(0)) }
    }

    /// The values, ascending.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.0.iter()
    }

    /// How many values there are.
    pub const fn len(&self) -> usize {
        self.0.len()
    }

    /// True if there are no values.
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<K, V> Default for SortedMap<K, V> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T> Default for SortedSet<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<K: Ord + Borrow<Q>, Q: Ord + ?Sized, V> Index<&Q> for SortedMap<K, V> {
    type Output = V;

    fn index(&self, key: &Q) -> &V {
        self.get(key).expect("the key has a value")
    }
}

impl<K: Ord, V> FromIterator<(K, V)> for SortedMap<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        let mut map = Self::new();
        map.extend(entries);
        map
    }
}

impl<K: Ord, V> Extend<(K, V)> for SortedMap<K, V> {
    fn extend<I: IntoIterator<Item = (K, V)>>(&mut self, entries: I) {
        for (key, value) in entries {
            self.insert(key, value);
        }
    }
}

impl<T: Ord> FromIterator<T> for SortedSet<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        let mut set = Self::new();
        set.extend(values);
        set
    }
}

impl<T: Ord> Extend<T> for SortedSet<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, values: I) {
        for value in values {
            self.insert(value);
        }
    }
}

impl<K, V> IntoIterator for SortedMap<K, V> {
    type Item = (K, V);
    type IntoIter = std::vec::IntoIter<(K, V)>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<T> IntoIterator for SortedSet<T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'a, K, V> IntoIterator for &'a SortedMap<K, V> {
    type Item = (&'a K, &'a V);
    type IntoIter = Entries<'a, K, V>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter().map(|(key, value)| (key, value))
    }
}

impl<'a, T> IntoIterator for &'a SortedSet<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::{BTreeMap, BTreeSet};

    /// Numbers below 64 by Lehmer's generator, from a seed.
    fn numbers(seed: u64) -> impl Iterator<Item = u64> {
        std::iter::successors(Some(seed), |last| Some(last * 48_271 % 2_147_483_647))
            .map(|number| number % 64)
    }

    #[test]
    fn maps_and_sets_are_those_of_the_standard_library() {
        let (mut map, mut set) = (SortedMap::new(), SortedSet::new());
        let (mut known_map, mut known_set) = (BTreeMap::new(), BTreeSet::new());
        for (step, key) in numbers(7).take(2000).enumerate() {
            match step % 5 {
                0 | 1 => assert_eq!(map.insert(key, step), known_map.insert(key, step), "step {step}"),
                2 => {
                    assert_eq!(map.or_insert(key, step), known_map.entry(key).or_insert(step), "step {step}");
                }
                3 => assert_eq!(map.remove(&key), known_map.remove(&key), "step {step}"),
                _ => assert_eq!(map.get(&key), known_map.get(&key), "step {step}"),
            }
            match step % 3 {
                0 => assert_eq!(set.remove(&key), known_set.remove(&key), "step {step}"),
                _ => assert_eq!(set.insert(key), known_set.insert(key), "step {step}"),
            }
        }
        assert!(map.iter().eq(&known_map) && set.iter().eq(&known_set));
        assert_eq!(set.pop_first(), known_set.pop_first());
    }

    #[test]
    fn what_has_the_same_key_stays_in_its_order() {
        let mut found = numbers(3).enumerate().take(200).collect_vec();
        let mut known = found.clone();
        sort_by_key(&mut found, |&(_, number)| number);
        known.sort_by_key(|&(_, number)| number);
        assert_eq!(found, known);
    }
}

//! Compression of long tables: the short forms from which the runtime's `compact` makes them.

use proc_macro2::TokenStream;

use super::{Emission, number, quoted};
use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use crate::sorted::SortedMap;

/// Entries of a table from which on it is written in short.
const LONG: usize = 100;
/// Numbers of the longest row that is looked for.
const LONGEST: usize = 256;
/// Repetitions, and numbers in all, that are worth a run.
const LEAST: (usize, usize) = (4, 24);
/// How many numbers are left out, where nothing repeats itself, before the next look.
const FARTHEST: usize = 64;

/// Names in an array.
pub(super) fn names(emission: &Emission, names: &[String]) -> TokenStream {
    if names.len() < LONG {
        let names = emission.text(quoted(names));
        return quote!([#names]);
    }
    let count = number(names.len());
    let lengths: Vec<u32> = names.iter().map(|name| name.len() as u32).collect_vec();
    let [text, lengths] =
        [format!("{:?}", names.concat()), runs(&lengths)].map_each(|text| emission.text(text));
    quote!(rt::compact::names::<#count>(#text, &[#lengths]))
}

/// Numbers in an array.
pub(super) fn numbers(emission: &Emission, numbers: &[u32]) -> TokenStream {
    let (count, runs) = (number(numbers.len()), emission.text(runs(numbers)));
    quote!(rt::compact::numbers::<#count>(&[#runs]))
}

/// Numbers as runs.
fn runs(numbers: &[u32]) -> String {
    let runs = runs_of(numbers).into_iter().map(|Run { first, length, count }| {
        let row = &numbers[first..first + length];
        let steps = if count == 1 { Vec::new() } else { steps(numbers, first, length) };
        let steps = if steps.iter().all(|step| *step == 0) { Vec::new() } else { steps };
        format!("({count}, &{row:?}, &{steps:?})")
    });
    runs.collect_vec().join(",\n")
}

/// Is a table of so many entries written in short?
pub(super) fn is_long(entries: usize) -> bool {
    entries >= LONG
}

/// Element of a table of texts: the text that all share, or else an element of an array, which is made by the text
/// before it.
pub(super) fn element(name: &str, texts: &[String], index: &str) -> (String, String) {
    let Some(first) = texts.first() else { return (String::new(), String::new()) };
    if texts.iter().all(|text| text == first) {
        return (String::new(), first.clone());
    }
    let literals = texts.iter().map(|text| text.strip_prefix("lit(")?.strip_suffix(')'));
    let literals: Option<Vec<&str>> = literals.collect();
    match literals.filter(|all| all.iter().all(|literal| !literal.contains('('))) {
        Some(literals) => {
            let name = name.to_uppercase();
            let before = format!("const {name}: [f64; {}] = {};\n", literals.len(), constants(&literals));
            (before, format!("lit(rt::Vector::at(&{name}, {index}))"))
        }
        None => {
            (format!("let {name} = [{}];\n", texts.join(", ")), format!("rt::Vector::at(&{name}, {index})"))
        }
    }
}

/// An array of constants.
pub(super) fn constants<T: AsRef<str>>(literals: &[T]) -> String {
    let mut known: SortedMap<&str, u32> = SortedMap::new();
    let (mut values, mut which) = (Vec::new(), Vec::new());
    for literal in literals {
        let next = values.len() as u32;
        let number = *known.or_insert(literal.as_ref(), next);
        if number == next {
            values.push(literal.as_ref());
        }
        which.push(number);
    }
    let (count, short) = (literals.len(), runs(&which));
    if !is_long(count) || values.len() + short.len() / 8 > count / 4 {
        let all: Vec<&str> = literals.iter().map(AsRef::as_ref).collect_vec();
        return format!("[{}]", all.join(", "));
    }
    let values = values.join(", ");
    format!("rt::compact::chosen::<{count}>(&[{values}], &rt::compact::numbers::<{count}>(&[{short}]))")
}

/// `count` repetitions of `length` numbers.
#[derive(Clone, Copy)]
struct Run {
    first: usize,
    length: usize,
    count: usize,
}

/// How much larger the numbers are a row later.
fn steps(numbers: &[u32], first: usize, length: usize) -> Vec<u32> {
    (first..first + length).map(|at| numbers[at + length].wrapping_sub(numbers[at])).collect_vec()
}

/// Runs from the beginning on, each the longest that begins where it does.
fn runs_of(numbers: &[u32]) -> Vec<Run> {
    let (mut runs, mut single, mut at, mut skip) = (Vec::new(), 0, 0, 1);
    while at < numbers.len() {
        if let Some(run) = longest(numbers, at) {
            if single < at {
                runs.push(Run { first: single, length: at - single, count: 1 });
            }
            runs.push(run);
            at += run.length * run.count;
            (single, skip) = (at, 1);
        } else {
            at += skip;
            skip = FARTHEST.min(skip + 1);
        }
    }
    if single < numbers.len() {
        runs.push(Run { first: single, length: numbers.len() - single, count: 1 });
    }
    runs
}

fn longest(numbers: &[u32], first: usize) -> Option<Run> {
    let mut best: Option<Run> = None;
    for length in 1..=LONGEST {
        let count = repeated(numbers, first, length);
        let is_longer = best.is_none_or(|best| count * length > best.count * best.length);
        if count >= LEAST.0 && count * length >= LEAST.1 && is_longer {
            best = Some(Run { first, length, count });
            // A longer row is not worth the look.
            if count * length > 8 * LONGEST {
                break;
            }
        }
    }
    best
}

/// How often a row repeats itself.
fn repeated(numbers: &[u32], first: usize, length: usize) -> usize {
    let mut at = first + length;
    while at < numbers.len() {
        let is_even = at < first + 2 * length
            || numbers[at].wrapping_sub(numbers[at - length])
                == numbers[at - length].wrapping_sub(numbers[at - 2 * length]);
        if !is_even {
            break;
        }
        at += 1;
    }
    (at - first) / length
}

#[cfg(test)]
mod tests {
    use super::{Run, constants, element, runs_of, steps};

    /// The runtime's expansion of runs.
    fn unrolled(numbers: &[u32]) -> (Vec<u32>, usize) {
        let (mut all, runs) = (Vec::new(), runs_of(numbers));
        let written = runs.iter().map(|run| run.length).sum();
        for Run { first, length, count } in runs {
            let steps = if count > 1 { steps(numbers, first, length) } else { vec![0; length] };
            for repetition in 0..count as u32 {
                let row = numbers[first..first + length].iter().zip(&steps);
                all.extend(row.map(|(number, step)| number.wrapping_add(step.wrapping_mul(repetition))));
            }
        }
        (all, written)
    }

    #[test]
    fn runs_hold_what_repeats_itself_and_what_does_not() {
        let irregular = |k: u32| k.wrapping_mul(2_654_435_761).rotate_left(7) % 1000;
        let even = |k: u32| if k % 7 == 3 { u32::MAX } else { 40_000 - 3 * (k / 7) + 5 * (k % 7) };
        let tables: [(Vec<u32>, usize); 5] = [
            (Vec::new(), 0),
            (vec![5; 1000], 1),
            ((0..7000).map(even).collect(), 7),
            ((0..50).map(irregular).chain((0..7000).map(even)).chain((0..33).map(irregular)).collect(), 200),
            ((0..300).map(irregular).collect(), 300),
        ];
        for (numbers, most) in tables {
            let (all, written) = unrolled(&numbers);
            assert_eq!(all, numbers);
            assert!(written <= most, "{written} of {} numbers are written", numbers.len());
        }
    }

    #[test]
    fn constants_that_repeat_themselves_are_written_once() {
        let literals: Vec<&str> = (0..300).map(|k| if k % 3 == 1 { "0.5" } else { "-1e-3" }).collect();
        let short = "rt::compact::chosen::<300>(&[-1e-3, 0.5], &rt::compact::numbers::<300>(&[(100, &[0, 1, 0], &[])]))";
        assert_eq!(constants(&literals), short);
        assert_eq!(constants(&["1.0", "2.0"]), "[1.0, 2.0]");
    }

    #[test]
    fn what_all_share_needs_no_table() {
        let of = |texts: [&str; 2]| element("x", &texts.map(str::to_owned), "k");
        assert_eq!(of(["lit(1.0)", "lit(1.0)"]), (String::new(), "lit(1.0)".to_owned()));
        let (table, value) = of(["lit(1.0)", "lit(2.0)"]);
        assert_eq!((&*table, &*value), ("const X: [f64; 2] = [1.0, 2.0];\n", "lit(rt::Vector::at(&X, k))"));
        let (table, value) = of(["length", "lit(2.0) * length"]);
        assert_eq!((&*table, &*value), ("let x = [length, lit(2.0) * length];\n", "rt::Vector::at(&x, k)"));
    }
}

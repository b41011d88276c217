//! What is done to a file: to its entries with their meaning, and to its bytes without.

use serde_json::Value;

use super::archive::Archive;
use super::random::Random;

/// Numbers at which readers stumble.
const LENGTHS: [&str; 18] = [
    "0",
    "1",
    "2",
    "3",
    "8",
    "9",
    "10",
    "255",
    "65536",
    "4294967295",
    "4294967296",
    "2305843009213693952",
    "4611686018427387904",
    "9223372036854775807",
    "18446744073709551615",
    "18446744073709551616",
    "-1",
    "1e3",
];

/// Changes one entry, or which there are.
pub(crate) fn change(random: &mut Random, archive: &mut Archive) {
    let entries = &mut archive.0;
    let at = random.below(entries.len());
    let other = random.below(entries.len());
    let Some((name, bytes)) = entries.get_mut(at) else { return };
    match (random.below(10), name.as_str()) {
        (0..=6, "plm.json") => json(random, bytes),
        (0..=4, _) => header(random, bytes),
        (5, _) => bytes.truncate(random.below(bytes.len() + 1)),
        (6, _) => bytes.extend(0.5_f64.to_le_bytes().repeat(random.below(6))),
        (7, _) => drop(entries.remove(at)),
        (8, _) => entries.swap(at, other),
        _ => {
            let name = entries[other].0.clone();
            entries[at].0 = name;
        }
    }
}

/// Changes a text in the header of an array; its length is made to fit in most cases.
fn header(random: &mut Random, bytes: &mut Vec<u8>) {
    const BEGIN: usize = 10;
    let Some(length) =
        bytes.get(8..BEGIN).map(|length| usize::from(length[0]) + 256 * usize::from(length[1]))
    else {
        return;
    };
    let end = (BEGIN + length).min(bytes.len());
    let text = String::from_utf8_lossy(&bytes[BEGIN..end]);
    let text = match random.below(8) {
        0..=3 => with_another_number(random, &text),
        4 => text.replace("<f8", random.of(&["<f4", ">f8", "<i8", "|O", "<f8'", ""])),
        5 => text.replace("False", random.of(&["True", "", "false"])),
        6 => {
            let from = random.of(&["'shape'", "'descr'", "(", ")", ",", "{", ", )"]);
            text.replace(from, random.of(&["", "(", "'shape':"]))
        }
        _ => text.replace('(', random.of(&["(1, ", "(0, ", "(4611686018427387904, 4611686018427387904, "])),
    };
    bytes.splice(BEGIN..end, text.bytes());
    match random.below(8) {
        0 => bytes[6] = random.of(&[0, 1, 2, 3, 255]),
        1 => bytes[8] ^= random.next() as u8,
        _ => {
            let [low, high] = (text.len() as u16).to_le_bytes();
            (bytes[8], bytes[9]) = (low, high);
        }
    }
}

/// Puts a length in place of one of the numbers of the shape.
fn with_another_number(random: &mut Random, text: &str) -> String {
    let Some(from) = text.find('(') else { return text.to_owned() };
    let is_start = |at: &usize| {
        let digit = |at: usize| text.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
        digit(*at) && !digit(at - 1)
    };
    let starts: Vec<usize> = (from + 1..text.len()).filter(is_start).collect();
    if starts.is_empty() {
        return text.to_owned();
    }
    let start = random.of(&starts);
    let rest = text[start..].trim_start_matches(|letter: char| letter.is_ascii_digit());
    format!("{}{}{rest}", &text[..start], random.of(&LENGTHS))
}

/// Changes something in plm.json, which stays JSON.
fn json(random: &mut Random, bytes: &mut Vec<u8>) {
    let Ok(mut value) = serde_json::from_slice::<Value>(bytes) else { return };
    let lists = ["/runs", "/runs/0/columns", "/runs/0/mechanism/bodies", "/runs/0/mechanism/ground"];
    match value.pointer_mut(random.of(&lists)) {
        // What arrays have to be as wide as.
        Some(list) if random.below(3) == 0 => repeat(random, list),
        _ => {
            let depth = random.below(9);
            let at = below(random, &mut value, depth);
            mutate(random, at);
        }
    }
    *bytes = serde_json::to_vec(&value).unwrap();
}

/// A value somewhere in another, so deep or where there is nothing below.
fn below<'a>(random: &mut Random, value: &'a mut Value, depth: usize) -> &'a mut Value {
    let length = match value {
        Value::Array(list) => list.len(),
        Value::Object(map) => map.len(),
        _ => 0,
    };
    if depth == 0 || length == 0 {
        return value;
    }
    let index = random.below(length);
    let inner = match value {
        Value::Array(list) => list.get_mut(index),
        Value::Object(map) => map.values_mut().nth(index),
        _ => None,
    };
    below(random, inner.unwrap(), depth - 1)
}

fn mutate(random: &mut Random, value: &mut Value) {
    match (random.below(6), value) {
        (0, list @ Value::Array(_)) => repeat(random, list),
        (1, Value::Array(list)) if !list.is_empty() => drop(list.remove(random.below(list.len()))),
        (0 | 1, Value::Object(map)) if !map.is_empty() => {
            let key = map.keys().nth(random.below(map.len())).unwrap().clone();
            map.remove(&key);
        }
        (2, value) => *value = (0..200).fold(Value::Null, |inner, _| Value::Array(vec![inner])),
        (3, value) => *value = Value::Null,
        (4, value) => *value = serde_json::from_str(random.of(&LENGTHS)).unwrap_or_default(),
        (_, value) => *value = Value::String("x".repeat(random.below(40))),
    }
}

/// Makes a list longer by one of its members.
fn repeat(random: &mut Random, list: &mut Value) {
    let Value::Array(list) = list else { return };
    if !list.is_empty() {
        let twin = random.of(list);
        list.extend(std::iter::repeat_n(twin, 1 + random.below(300)));
    }
}

/// Changes bytes.
pub(crate) fn damage(random: &mut Random, bytes: &mut Vec<u8>) {
    let at = random.below(bytes.len());
    // The directory is a small part of a file, and all depends on it.
    let at = if random.below(2) == 0 { at } else { bytes.len().saturating_sub(1 + random.below(300)) };
    match (random.below(6), bytes.get_mut(at)) {
        (0 | 1, Some(byte)) => *byte ^= 1 << random.below(8),
        (2, Some(byte)) => *byte = random.of(&[0, 1, 255, b'P', 0x7f]),
        (3, _) => bytes.truncate(at),
        (4, _) => {
            let piece = bytes[at..(at + random.below(40)).min(bytes.len())].to_vec();
            let to = random.below(bytes.len() + 1);
            bytes.splice(to..to, piece);
        }
        _ => drop(bytes.splice(at..(at + random.below(40)).min(bytes.len()), [])),
    }
}

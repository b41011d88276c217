//! Output queue of a client: the simulation fills it and the client's own thread empties it.

use std::net::{Shutdown, TcpStream};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use serde::Serialize;

/// So many rows wait at most; of more, every second one goes.
const MOST_ROWS: usize = 64;
/// A client that leaves so many other events waiting is given up; it finds its way back by itself.
const MOST_TEXTS: usize = 256;

/// The guard of what no thread leaves half done.
pub(super) fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[derive(Clone, Debug)]
pub(super) enum Item {
    /// Numbers of a moment.
    Row(Arc<[f64]>),
    /// Another event, as JSON.
    Text(Arc<str>),
}

/// One that listens.
#[derive(Debug, Default)]
pub(super) struct Client {
    waiting: Mutex<Waiting>,
    comes: Condvar,
    /// Its connection, to be closed from outside.
    connection: Option<TcpStream>,
}

#[derive(Debug, Default)]
struct Waiting {
    items: Vec<Item>,
    rows: usize,
    is_over: bool,
    is_given_up: bool,
}

/// Rows after each other, as the page takes them.
#[derive(Serialize)]
struct Rows<'a> {
    kind: &'static str,
    width: usize,
    numbers: Vec<&'a f64>,
}

impl Client {
    pub(super) fn new(connection: TcpStream) -> Self {
        Self { connection: Some(connection), ..Self::default() }
    }

    /// Adds an item, without waiting; false if the client is given up.
    pub(super) fn push(&self, item: Item) -> bool {
        let mut waiting = locked(&self.waiting);
        waiting.push(item);
        self.comes.notify_one();
        !waiting.is_given_up
    }

    /// Ends the queue: nothing more will come, or the client has left.
    pub(super) fn end(&self) {
        let mut waiting = locked(&self.waiting);
        waiting.is_over = true;
        self.comes.notify_one();
    }

    /// It gets nothing any more, and its connection is free at once: a write that waits for it ends.
    pub(super) fn give_up(&self) {
        locked(&self.waiting).is_given_up = true;
        self.end();
        if let Some(connection) = &self.connection {
            // It may be closed already.
            drop(connection.shutdown(Shutdown::Both));
        }
    }

    /// The waiting items, as text of server-sent events; a comment after a second without any; `None` at the end.
    pub(super) fn take(&self) -> Option<String> {
        let waiting = locked(&self.waiting);
        let is_idle = |waiting: &mut Waiting| waiting.items.is_empty() && !waiting.is_over;
        let waited = self.comes.wait_timeout_while(waiting, Duration::from_secs(1), is_idle);
        let (mut waiting, _) = waited.unwrap_or_else(PoisonError::into_inner);
        if waiting.is_given_up || (waiting.is_over && waiting.items.is_empty()) {
            return None;
        }
        let items = std::mem::take(&mut waiting.items);
        waiting.rows = 0;
        drop(waiting);
        Some(if items.is_empty() { ":\n\n".to_owned() } else { text(&items) })
    }
}

impl Waiting {
    fn push(&mut self, item: Item) {
        self.rows += usize::from(matches!(item, Item::Row(_)));
        self.items.push(item);
        if self.items.len() - self.rows > MOST_TEXTS {
            self.is_given_up = true;
        }
        if self.is_given_up {
            self.items.clear();
            self.rows = 0;
        }
        if self.rows > MOST_ROWS {
            // The last row stays.
            let mut left = self.rows;
            self.items.retain(|item| {
                let is_row = matches!(item, Item::Row(_));
                left -= usize::from(is_row);
                !is_row || left.is_multiple_of(2)
            });
            self.rows = self.rows.div_ceil(2);
        }
    }
}

/// Server-sent events; rows that follow each other are one.
fn text(items: &[Item]) -> String {
    let mut text = String::new();
    for group in items.chunk_by(|a, b| matches!((a, b), (Item::Row(a), Item::Row(b)) if a.len() == b.len())) {
        let mut event = |json: &str| {
            text.push_str("data: ");
            text.push_str(json);
            text.push_str("\n\n");
        };
        if let [Item::Text(json)] = group {
            event(json);
            continue;
        }
        let rows =
            || group.iter().filter_map(|item| if let Item::Row(row) = item { Some(row) } else { None });
        let width = rows().next().map_or(0, |row| row.len());
        event(&json(&Rows { kind: "rows", width, numbers: rows().flat_map(|row| row.iter()).collect() }));
    }
    text
}

/// As JSON on one line; NaN and infinities are `null`.
pub(super) fn json(value: &impl Serialize) -> String {
    // Nothing that is sent has keys other than names, so that writing it does not fail.
    serde_json::to_string(value).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::{Client, Item, MOST_ROWS, MOST_TEXTS};

    fn row(number: f64) -> Item {
        Item::Row([number, f64::NAN].into())
    }

    #[test]
    fn rows_that_follow_each_other_are_one_event() {
        let client = Client::default();
        for item in [row(0.1), row(0.2), Item::Text("{}".into()), row(2.5)] {
            assert!(client.push(item));
        }
        let expected = "data: {\"kind\":\"rows\",\"width\":2,\"numbers\":[0.1,null,0.2,null]}\n\ndata: {}\n\n\
                        data: {\"kind\":\"rows\",\"width\":2,\"numbers\":[2.5,null]}\n\n";
        assert_eq!(client.take().as_deref(), Some(expected));
        client.end();
        assert_eq!(client.take(), None);
    }

    #[test]
    fn a_client_that_is_slow_gets_fewer_rows_and_the_last() {
        let client = Client::default();
        for k in 0..100_001 {
            assert!(client.push(row(f64::from(k))));
        }
        let text = client.take().unwrap_or_default();
        let count = text.matches("null").count();
        assert!(count <= MOST_ROWS && count > MOST_ROWS / 4, "{count}");
        assert!(text.contains("100000.0,null]"), "{text}");
    }

    #[test]
    fn a_client_that_takes_nothing_is_given_up() {
        let client = Client::default();
        let stays = (0..2 * MOST_TEXTS).filter(|_| client.push(Item::Text("{}".into()))).count();
        assert_eq!(stays, MOST_TEXTS);
        assert_eq!(client.take(), None);
    }
}

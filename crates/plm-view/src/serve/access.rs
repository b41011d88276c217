//! Who may ask: the page that is served, and what asks without a browser.

use super::request::{Refusal, Request};

/// The names of this machine for itself: a page of another name has been led here (DNS rebinding).
pub(super) fn names(port: u16) -> Vec<String> {
    let names = ["127.0.0.1", "localhost"];
    let mut all: Vec<String> = names.iter().map(|name| format!("{name}:{port}")).collect();
    if port == 80 {
        all.extend(names.map(str::to_owned));
    }
    all
}

/// Does the browser say that another page asks? A link in one may lead to the page as a whole, where nothing is done yet; its
/// images and scripts have no business here.
fn is_foreign(Request { method, path, fetch, .. }: &Request) -> bool {
    let says = |what: &Option<String>, word: &str| what.as_deref() == Some(word);
    let is_own = ["same-origin", "none"].iter().any(|word| says(&fetch.site, word));
    let is_link = says(&fetch.mode, "navigate") && says(&fetch.dest, "document");
    let is_of_page = method == "GET" && path == "/";
    fetch.site.is_some() && !is_own && !(is_link && is_of_page)
}

/// Only a page of ours may ask.
///
/// # Errors
/// The answer to another one.
pub(super) fn check(request: &Request, names: &[String]) -> Result<(), Refusal> {
    let is_ours = |origin: &str| {
        origin.strip_prefix("http://").is_some_and(|host| names.iter().any(|name| name == host))
    };
    if !names.contains(&request.host) {
        Err(Refusal(403, "this program answers to localhost and 127.0.0.1 with its port alone"))
    } else if request.origin.as_deref().is_some_and(|origin| !is_ours(origin)) || is_foreign(request) {
        Err(Refusal(403, "this program answers to its own page alone"))
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{check, names};
    use crate::serve::request::{Fetch, Request};

    fn is_let_in(path: &str, [site, mode, dest]: [&str; 3]) -> bool {
        let said = |word: &str| (!word.is_empty()).then(|| word.to_owned());
        let request = Request {
            method: if path == "/message" { "POST" } else { "GET" }.to_owned(),
            path: path.to_owned(),
            host: "localhost:81".to_owned(),
            origin: None,
            fetch: Fetch { site: said(site), mode: said(mode), dest: said(dest) },
            body: Vec::new(),
        };
        check(&request, &names(81)).is_ok()
    }

    /// As browsers send them: what the page fetches, an address that was typed, a link, and what another page may try.
    #[test]
    fn requests_of_other_pages_are_refused() {
        for (path, fetch, expected) in [
            ("/", ["", "", ""], true),
            ("/", ["none", "navigate", "document"], true),
            ("/", ["same-origin", "navigate", "document"], true),
            ("/events", ["same-origin", "cors", "empty"], true),
            ("/message", ["same-origin", "cors", "empty"], true),
            // A link in a page of documentation, or of another port.
            ("/", ["cross-site", "navigate", "document"], true),
            ("/", ["same-site", "navigate", "document"], true),
            ("/", ["cross-site", "navigate", "iframe"], false),
            ("/", ["cross-site", "no-cors", "image"], false),
            ("/events", ["cross-site", "navigate", "document"], false),
            ("/events", ["cross-site", "no-cors", "image"], false),
            ("/events", ["same-site", "cors", "empty"], false),
            ("/message", ["cross-site", "navigate", "document"], false),
            ("/message", ["cross-site", "no-cors", "empty"], false),
            ("/message", ["something", "", ""], false),
        ] {
            assert_eq!(is_let_in(path, fetch), expected, "{path} {fetch:?}");
        }
    }
}

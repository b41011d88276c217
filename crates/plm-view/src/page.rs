//! Results, and the mechanism itself, as one HTML file that moves: everything in it, nothing asked of a network.

mod bundle;
mod dense;
mod link;

use std::io::{self, Write};
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::DeflateEncoder;

use crate::error::{Error, write_file};
use crate::markup::escape;
use bundle::Kind;
use dense::dense;
pub use link::playground_link;

/// The page before anything is put into it.
const TEMPLATE: &str = include_str!("../page/page.html");
const STYLE: &str = include_str!("../page/style.css");
/// Style of the editor of declarations.
const STYLE_OF_EDITOR: &str = include_str!("../page/playground.css");
/// Style and script stand deflated in a page that is a file, which makes the file smaller by a fifth or more; this starts it.
const UNPACK: &str = include_str!("../page/unpack.js");
/// Reads the letters in which they stand.
const UNDENSE: &str = include_str!("../page/src/dense.js");
/// The start of a page with an editor, whose script is compressed further.
const UNPACK_FURTHER: &str = include_str!("../page/unpackfurther.js");
const UNLZMA: &str = include_str!("../page/src/lzma.js");
/// The style until then.
const UNSEEN: &str = "body > :not(noscript) { visibility: hidden; }";

/// A page that shows results: one HTML file for any browser, without network.
///
/// ```
/// use plm_view::Page;
///
/// let html = Page::new(&[], "Nothing yet").to_html();
/// assert!(html.starts_with("<!doctype html>"));
/// ```
#[derive(Clone, Debug)]
pub struct Page {
    results: Vec<u8>,
    title: String,
    module: Vec<u8>,
    editor: Option<Editor>,
    book: String,
}

/// The editor of a page in which declarations are typed.
#[derive(Clone, Debug)]
struct Editor {
    /// The script of the editor and of the page, compressed.
    script: Vec<u8>,
    /// The module, compressed.
    module: Vec<u8>,
    /// Names and texts to begin with, as JSON.
    gallery: String,
}

impl Page {
    /// A page for the bytes of a results file (`.npz`) under a title, which may hold any text.
    ///
    /// The bytes are not checked: the page itself reports what is wrong with them. Without bytes it waits for a file to be opened or
    /// dropped.
    pub fn new(results: &[u8], title: impl Into<String>) -> Self {
        Self {
            results: results.to_vec(),
            title: title.into(),
            module: Vec::new(),
            editor: None,
            book: String::new(),
        }
    }

    /// Adds a live mechanism: the bytes of a module of WebAssembly, as [`Module::build`] gives them.
    ///
    /// The first run of the results must describe the module: its mechanism, and as its columns all observed quantities in SI. The bytes
    /// are not checked; the page reports a module that is none, or another mechanism's.
    ///
    /// [`Module::build`]: crate::live::Module::build
    #[must_use]
    pub fn with_module(mut self, module: &[u8]) -> Self {
        self.module = module.to_vec();
        self
    }

    /// Adds an editor in which declarations are typed; its module compiles mechanisms from texts (`examples/playground`).
    ///
    /// `script` defines `plmEditor`, made of the folder `page/editor`, and goes on with [`editor_script`](Self::editor_script); it and
    /// `module` are compressed by `xz --format=lzma`. `gallery` has names and texts to begin with, and the page opens with the first.
    #[must_use]
    pub fn with_editor(mut self, script: &[u8], module: &[u8], gallery: &[(String, String)]) -> Self {
        let texts = gallery.iter().map(|(name, text)| serde_json::json!({ "name": name, "text": text }));
        let gallery = texts.collect::<serde_json::Value>().to_string();
        self.editor = Some(Editor { script: script.to_vec(), module: module.to_vec(), gallery });
        self
    }

    /// The script of a page with an editor, behind that of the editor.
    pub fn editor_script() -> String {
        bundle::script(Kind::Playground)
    }

    /// Adds links from codes of diagnostics to their pages in the book, which stands at this address: `./` for the folder of the page.
    #[must_use]
    pub fn with_book(mut self, address: &str) -> Self {
        address.clone_into(&mut self.book);
        self
    }

    /// The text of the file.
    pub fn to_html(&self) -> String {
        let (style, script, unpack) = if let Some(editor) = &self.editor {
            let unpack = [UNDENSE, UNLZMA, UNPACK_FURTHER].map(bundle::without_noise).concat();
            (STYLE.to_owned() + STYLE_OF_EDITOR, editor.script.clone(), unpack)
        } else {
            let kind = if self.module.is_empty() { Kind::Results } else { Kind::Live };
            let unpack = [UNDENSE, UNPACK].map(bundle::without_noise).concat();
            (STYLE.to_owned(), deflated(bundle::script(kind).as_bytes()), unpack)
        };
        let mut packed = held("packed-style", &dense(&deflated(style.as_bytes())));
        packed += &held("packed", &dense(&script));
        if let Some(editor) = &self.editor {
            packed += &held("packed-gallery", &dense(&deflated(editor.gallery.as_bytes())));
            packed += &held("packed-module", &dense(&editor.module));
        }
        if !self.book.is_empty() {
            packed += &held("book", &escape(&self.book));
        }
        if !self.module.is_empty() {
            packed += &held("module", &STANDARD.encode(deflated(&self.module)));
        }
        self.filled(UNSEEN, &unpack, &packed)
    }

    /// The text of the page as a running program serves it.
    pub(crate) fn to_served_html(&self) -> String {
        self.filled(STYLE, &bundle::script(Kind::Served), "")
    }

    /// The template with everything in its places.
    fn filled(&self, style: &str, script: &str, packed: &str) -> String {
        let results = STANDARD.encode(&self.results);
        let mut html =
            String::with_capacity(TEMPLATE.len() + style.len() + script.len() + packed.len() + results.len());
        let mut rest = TEMPLATE;
        // In one pass, so that braces in a title stay what they are.
        while let Some((before, (name, after))) = next_place(rest) {
            html.push_str(before);
            match name {
                "title" => html.push_str(&escape(&self.title)),
                "style" => html.push_str(style),
                "script" => html.push_str(script),
                "results" => html.push_str(&results),
                "packed" => html.push_str(packed),
                other => html.push_str(other),
            }
            rest = after;
        }
        html.push_str(rest);
        html
    }

    /// Writes the page as a file and makes the folders above it where they are missing.
    ///
    /// # Errors
    /// If the file cannot be written; the error names it.
    pub fn write_html(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        write_file(path.as_ref(), io::Result::Ok(self.to_html().into_bytes()))
    }
}

/// Bytes deflated, as the page inflates them.
fn deflated(bytes: &[u8]) -> Vec<u8> {
    let mut deflated = DeflateEncoder::new(Vec::new(), Compression::best());
    // Writing into memory does not fail.
    deflated.write_all(bytes).and_then(|()| deflated.finish()).unwrap_or_default()
}

/// An element that holds a text, which has no `<` in front of a slash.
fn held(id: &str, text: &str) -> String {
    format!("<script type=\"text/plain\" id=\"{id}\">{text}</script>\n")
}

/// The text before the next `{{name}}`, the name, and the text after it.
fn next_place(text: &str) -> Option<(&str, (&str, &str))> {
    let (before, from) = text.split_once("{{")?;
    Some((before, from.split_once("}}")?))
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use flate2::read::DeflateDecoder;

    use super::*;

    fn between<'a>(html: &'a str, from: &str, to: &str) -> &'a str {
        html.split_once(from).and_then(|(_, rest)| rest.split_once(to)).map_or("", |(inner, _)| inner)
    }

    #[test]
    fn results_come_back_to_the_byte() {
        let bytes: Vec<u8> = (0..=255).collect();
        let html = Page::new(&bytes, "x").to_html();
        let text = between(&html, "id=\"results\">", "</script>");
        assert_eq!(STANDARD.decode(text).ok(), Some(bytes));
    }

    #[test]
    fn a_module_comes_back_to_the_byte() {
        let bytes: Vec<u8> = (0..=255).cycle().take(20_000).collect();
        let html = Page::new(&[], "x").with_module(&bytes).to_html();
        let packed = STANDARD.decode(between(&html, "id=\"module\">", "</script>")).unwrap_or_default();
        assert!(packed.len() < 1000, "{} bytes", packed.len());
        let mut found = Vec::new();
        let read = DeflateDecoder::new(packed.as_slice()).read_to_end(&mut found);
        assert!(read.is_ok() && found == bytes);
        // Without one, there is no element.
        assert!(!Page::new(&[], "x").to_html().contains("id=\"module\""));
    }

    #[test]
    fn the_address_of_the_book_is_there_where_it_is_known() {
        let page = Page::new(&[], "x");
        assert!(!page.to_html().contains("id=\"book\""));
        let html = page.with_book("./</script>").to_html();
        assert_eq!(between(&html, "id=\"book\">", "</script>"), "./&lt;/script&gt;");
    }

    #[test]
    fn a_title_is_text_and_nothing_else() {
        let html = Page::new(&[], "</title><script>alert('a & \"b\"')</script> {{results}}").to_html();
        let title = "&lt;/title&gt;&lt;script&gt;alert('a &amp; &quot;b&quot;')&lt;/script&gt; {{results}}";
        assert_eq!(between(&html, "<title>", "</title>"), title);
        assert_eq!(between(&html, "<h1>", "</h1>"), title);
    }

    #[test]
    fn every_place_of_the_template_is_filled() {
        let mut names = Vec::new();
        let mut rest = TEMPLATE;
        while let Some((_, (name, after))) = next_place(rest) {
            names.push(name);
            rest = after;
        }
        assert_eq!(names, ["title", "style", "title", "results", "packed", "script"]);
        assert!(!STYLE.contains("</"), "a style that would end its element");
    }

    #[test]
    fn nothing_is_asked_of_a_network() {
        // Style and script stand packed in it.
        let html = Page::new(&[], "x").with_module(&[0]).to_html()
            + STYLE
            + &[Kind::Results, Kind::Live].map(bundle::script).concat();
        let addresses: Vec<&str> = html.split("http").skip(1).collect();
        // The name of a vocabulary, which is never fetched.
        assert!(addresses.iter().all(|text| text.starts_with("://www.w3.org/2000/svg")), "{addresses:?}");
        for word in
            ["src=", "@import url", "url(//", "fetch(", "XMLHttpRequest", "WebSocket", "importScripts"]
        {
            assert!(!html.contains(word), "{word}");
        }
        // A served page asks the program that serves it, by names without a host.
        let served = Page::new(&[], "x").to_served_html();
        for (word, ours) in [("fetch(", "fetch(\"message\""), ("EventSource(", "EventSource(\"events\"")] {
            assert!(
                served.contains(ours) && served.matches(word).count() == served.matches(ours).count(),
                "{word}"
            );
        }
    }
}

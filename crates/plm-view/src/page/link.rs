//! Links to the playground that hold a declaration: deflated, in the letters that addresses may have (`page/src/packedtext.js`).

use std::io::Write;

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::write::DeflateEncoder;

/// Letters of a packed text that the page reads, at most (`LONGEST_LINK` there).
const LONGEST: usize = 1 << 16;

/// Link that opens a declaration in the playground at an address: `https://…/playground.html`, or that of a file. The text stands
/// after `#`, which a browser sends to no server. A fragment that the address has is replaced. `None` of an empty text, and of one
/// that is longer than 65 536 letters when it is packed, which the page does not read.
///
/// ```
/// let link = plm_view::playground_link("playground.html", "pub Bar { body bar { } }").unwrap();
/// assert!(link.starts_with("playground.html#text="));
/// ```
pub fn playground_link(address: &str, text: &str) -> Option<String> {
    let page = address.split_once('#').map_or(address, |(page, _)| page);
    let mut deflated = DeflateEncoder::new(Vec::new(), Compression::best());
    deflated.write_all(text.as_bytes()).ok()?;
    let packed = URL_SAFE_NO_PAD.encode(deflated.finish().ok()?);
    let is_read = !text.is_empty() && packed.len() <= LONGEST;
    is_read.then(|| format!("{page}#text={packed}"))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use std::path::Path;
    use std::process::{Command, Stdio};

    use super::*;

    /// Text of a link as the page reads it, by its own modules; `None` without node.
    fn opened(link: &str) -> Option<String> {
        let module = Path::new(env!("CARGO_MANIFEST_DIR")).join("page/src/packedtext.js");
        let script = format!(
            "import {{ unpackText }} from {:?};
             const [, hash] = process.argv[1].split('#');
             const text = await unpackText(new URLSearchParams(hash).get('text') ?? '');
             process.stdout.write(JSON.stringify(text));",
            module.display().to_string()
        );
        let mut node = Command::new("node");
        node.args(["--input-type=module", "--eval", &script, link]).stdin(Stdio::null());
        let output = node.output().ok()?;
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice::<Option<String>>(&output.stdout).unwrap()
    }

    #[test]
    fn the_page_reads_what_a_link_holds() {
        let text = "// Größe: 1 m², ∑ 🙂\npub Bar {\n    body bar { port pin: (0, 0) m; }\n}\n".repeat(40);
        let link = playground_link("https://example.org/playground.html?a=1#text=old", &text).unwrap();
        let (page, packed) = link.split_once("#text=").unwrap();
        assert_eq!(page, "https://example.org/playground.html?a=1");
        assert!(packed.bytes().all(|letter| letter.is_ascii_alphanumeric() || b"-_".contains(&letter)));
        if Command::new("node").arg("--version").output().is_err() {
            println!("skipped: node is not installed (apt-get install nodejs)");
            return;
        }
        assert_eq!(opened(&link), Some(text));
        // Noise does not get shorter: the page reads a long link; a longer one is none.
        let mut seed = 1_u32;
        let mut letter = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            char::from(b' ' + (seed >> 24) as u8 % 95)
        };
        let noise: String = (0..80_000).map(|_| letter()).collect();
        let long = playground_link("", &noise[..55_000]).unwrap();
        assert!(long.len() > 50_000, "{}", long.len());
        assert_eq!(opened(&long).as_deref(), Some(&noise[..55_000]));
        assert_eq!(playground_link("", &noise), None);
        assert_eq!(playground_link("playground.html", ""), None);
    }
}

//! The modules of the page as one script: imports and exports, comments and indentation are left out.
//!
//! All modules share one scope then, so no two of them may declare the same name at the top, and a module stands
//! after those that it imports. Tests hold the modules to that.

/// The modules of every page, each after those that it imports.
const MODULES: &[(&str, &str)] = &[
    ("numbers", include_str!("../../page/src/numbers.js")),
    ("text", include_str!("../../page/src/text.js")),
    ("ticks", include_str!("../../page/src/ticks.js")),
    ("decimation", include_str!("../../page/src/decimation.js")),
    ("zip", include_str!("../../page/src/zip.js")),
    ("npy", include_str!("../../page/src/npy.js")),
    ("format", include_str!("../../page/src/format.js")),
    ("units", include_str!("../../page/src/units.js")),
    ("run", include_str!("../../page/src/run.js")),
    ("results", include_str!("../../page/src/results.js")),
    ("outline", include_str!("../../page/src/outline.js")),
    ("view", include_str!("../../page/src/view.js")),
    ("levels", include_str!("../../page/src/levels.js")),
    ("solid", include_str!("../../page/src/solid.js")),
    ("looks", include_str!("../../page/src/looks.js")),
    ("pieces", include_str!("../../page/src/pieces.js")),
    ("scene", include_str!("../../page/src/scene.js")),
    ("palette", include_str!("../../page/src/palette.js")),
    ("pen", include_str!("../../page/src/pen.js")),
    ("place", include_str!("../../page/src/place.js")),
    ("draw", include_str!("../../page/src/draw.js")),
    ("pick", include_str!("../../page/src/pick.js")),
    ("arrows", include_str!("../../page/src/arrows.js")),
    ("traces", include_str!("../../page/src/traces.js")),
    ("decor", include_str!("../../page/src/decor.js")),
    ("player", include_str!("../../page/src/player.js")),
    ("opening", include_str!("../../page/src/opening.js")),
    ("centres", include_str!("../../page/src/centres.js")),
    ("measure", include_str!("../../page/src/measure.js")),
    ("ghosts", include_str!("../../page/src/ghosts.js")),
    ("tools", include_str!("../../page/src/tools.js")),
    ("tooldraw", include_str!("../../page/src/tooldraw.js")),
    ("say", include_str!("../../page/src/say.js")),
    ("history", include_str!("../../page/src/history.js")),
    ("runview", include_str!("../../page/src/runview.js")),
    ("fault", include_str!("../../page/src/fault.js")),
    ("app", include_str!("../../page/src/app.js")),
    ("dom", include_str!("../../page/src/dom.js")),
    ("picture", include_str!("../../page/src/picture.js")),
    ("toolpick", include_str!("../../page/src/toolpick.js")),
    ("polar", include_str!("../../page/src/polar.js")),
    ("toolcommands", include_str!("../../page/src/toolcommands.js")),
    ("icons", include_str!("../../page/src/icons.js")),
    ("commands", include_str!("../../page/src/commands.js")),
    ("keys", include_str!("../../page/src/keys.js")),
    ("pointer", include_str!("../../page/src/pointer.js")),
    ("timeline", include_str!("../../page/src/timeline.js")),
    ("axes", include_str!("../../page/src/axes.js")),
    ("chart", include_str!("../../page/src/chart.js")),
    ("charts", include_str!("../../page/src/charts.js")),
    ("polarpanel", include_str!("../../page/src/polarpanel.js")),
    ("curves", include_str!("../../page/src/curves.js")),
    ("objects", include_str!("../../page/src/objects.js")),
    ("runs", include_str!("../../page/src/runs.js")),
    ("model", include_str!("../../page/src/model.js")),
    ("panel", include_str!("../../page/src/panel.js")),
    ("toolbar", include_str!("../../page/src/toolbar.js")),
    ("menu", include_str!("../../page/src/menu.js")),
    ("dialogs", include_str!("../../page/src/dialogs.js")),
    ("gif", include_str!("../../page/src/gif.js")),
    ("movie", include_str!("../../page/src/movie.js")),
    ("stretch", include_str!("../../page/src/stretch.js")),
    ("moviedialog", include_str!("../../page/src/moviedialog.js")),
    ("toolpanel", include_str!("../../page/src/toolpanel.js")),
    ("files", include_str!("../../page/src/files.js")),
    ("stage", include_str!("../../page/src/stage.js")),
    ("settings", include_str!("../../page/src/settings.js")),
    ("address", include_str!("../../page/src/address.js")),
    ("frames", include_str!("../../page/src/frames.js")),
    ("main", include_str!("../../page/src/main.js")),
];

/// After them, in a page of results.
const RESULTS: &[(&str, &str)] = &[("start", include_str!("../../page/src/start.js"))];

/// After them, in a page whose mechanism goes on.
const LIVE: &[(&str, &str)] = &[
    ("shape", include_str!("../../page/src/shape.js")),
    ("write", include_str!("../../page/src/write.js")),
    ("machine", include_str!("../../page/src/machine.js")),
    ("worker", include_str!("../../page/src/worker.js")),
    ("startworker", include_str!("../../page/src/startworker.js")),
    ("followcamera", include_str!("../../page/src/followcamera.js")),
    ("keptstates", include_str!("../../page/src/keptstates.js")),
    ("live", include_str!("../../page/src/live.js")),
    ("dials", include_str!("../../page/src/dials.js")),
    ("livepanel", include_str!("../../page/src/livepanel.js")),
    ("drag", include_str!("../../page/src/drag.js")),
];

/// After these, in a page that holds the mechanism itself.
const LIVE_ENTRY: &[(&str, &str)] = &[("liveentry", include_str!("../../page/src/liveentry.js"))];

/// After those of a live page, in one in which declarations are typed.
const PLAYGROUND: &[(&str, &str)] = &[
    ("packedtext", include_str!("../../page/src/packedtext.js")),
    ("takehome", include_str!("../../page/src/takehome.js")),
    ("pencil", include_str!("../../page/src/pencil.js")),
    ("snap", include_str!("../../page/src/snap.js")),
    ("exchange", include_str!("../../page/src/exchange.js")),
    ("language", include_str!("../../page/src/language.js")),
    ("editorpane", include_str!("../../page/src/editorpane.js")),
    ("equations", include_str!("../../page/src/equations.js")),
    ("strokes", include_str!("../../page/src/strokes.js")),
    ("heldpin", include_str!("../../page/src/heldpin.js")),
    ("sketch", include_str!("../../page/src/sketch.js")),
    ("sketchdraw", include_str!("../../page/src/sketchdraw.js")),
    ("sketchkeys", include_str!("../../page/src/sketchkeys.js")),
    ("sketchbar", include_str!("../../page/src/sketchbar.js")),
    ("dense", include_str!("../../page/src/dense.js")),
    ("lzma", include_str!("../../page/src/lzma.js")),
    ("playground", include_str!("../../page/src/playground.js")),
];

/// After these, in a page that a running program serves.
const SERVED: &[(&str, &str)] = &[
    ("program", include_str!("../../page/src/program.js")),
    ("servedlive", include_str!("../../page/src/servedlive.js")),
    ("served", include_str!("../../page/src/served.js")),
];

/// Kind of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Results alone.
    Results,
    /// The mechanism in it.
    Live,
    /// A program that serves it.
    Served,
    /// A declaration that is typed.
    Playground,
}

/// The script of a page.
pub(super) fn script(kind: Kind) -> String {
    let ends: [&[(&str, &str)]; 2] = match kind {
        Kind::Results => [RESULTS, &[]],
        Kind::Live => [LIVE, LIVE_ENTRY],
        Kind::Served => [LIVE, SERVED],
        Kind::Playground => [LIVE, PLAYGROUND],
    };
    MODULES.iter().chain(ends.into_iter().flatten()).map(|(_, text)| without_noise(text)).collect()
}

/// The code of a module alone, line by line.
pub(super) fn without_noise(text: &str) -> String {
    let mut code = String::new();
    for line in without_comments(&without_imports(text)).lines() {
        let line = line.trim();
        let line = line.strip_prefix("export ").unwrap_or(line);
        if !line.is_empty() {
            code.push_str(line);
            code.push('\n');
        }
    }
    code
}

/// A module without its import statements, which end with a semicolon.
fn without_imports(text: &str) -> String {
    let mut kept = String::new();
    let mut in_import = false;
    for line in text.lines() {
        in_import |= line.starts_with("import ");
        if !in_import {
            kept.push_str(line);
            kept.push('\n');
        }
        in_import &= !line.ends_with(';');
    }
    kept
}

/// Without comments of documentation, wherever they are, and without lines that are nothing but a comment.
fn without_comments(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some((before, (_, after))) =
        rest.split_once("/**").and_then(|(before, from)| Some((before, from.split_once("*/")?)))
    {
        kept.push_str(before);
        rest = after;
    }
    kept.push_str(rest);
    kept.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::fs;

    use super::*;

    fn all() -> Vec<(&'static str, &'static str)> {
        [MODULES, LIVE, LIVE_ENTRY, PLAYGROUND, SERVED, RESULTS].concat()
    }

    #[test]
    fn every_module_is_in_the_list() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/page/src");
        let mut found: Vec<String> = fs::read_dir(folder)
            .map(|entries| entries.flatten().filter_map(|e| e.file_name().into_string().ok()).collect())
            .unwrap_or_default();
        let mut listed: Vec<String> = all().iter().map(|(name, _)| format!("{name}.js")).collect();
        found.sort();
        listed.sort();
        assert_eq!(found, listed);
    }

    #[test]
    fn a_module_stands_after_those_that_it_imports() {
        let all = all();
        for (position, (name, text)) in all.iter().enumerate() {
            for import in
                text.lines().filter(|line| line.starts_with("import ") || line.starts_with("} from "))
            {
                let Some((_, from)) = import.split_once("\"./") else { continue };
                let other = from.trim_end_matches(".js\";");
                assert!(
                    all[..position].iter().any(|(earlier, _)| *earlier == other),
                    "{name} imports {other}"
                );
                assert!(
                    !import.contains(" as ") && !import.contains('*'),
                    "{name} renames an import: {import}"
                );
            }
        }
    }

    /// The name that a line at the top of a module declares.
    fn declared(line: &str) -> Option<&str> {
        let line = line.strip_prefix("export ").unwrap_or(line);
        let line = line.strip_prefix("async ").unwrap_or(line);
        let rest =
            ["function ", "const ", "let ", "class "].iter().find_map(|word| line.strip_prefix(word))?;
        rest.split(|c: char| !c.is_alphanumeric() && c != '_').next()
    }

    #[test]
    fn no_two_modules_declare_the_same_name() {
        let mut owners = BTreeMap::new();
        for (module, text) in all() {
            for name in text.lines().filter_map(declared) {
                if let Some(other) = owners.insert(name, module) {
                    unreachable!("{name} is declared by {other} and by {module}");
                }
            }
        }
        assert!(owners.len() > 100, "the reader of names found only {owners:?}");
    }

    #[test]
    fn no_text_goes_over_lines() {
        // Indentation would be part of it.
        for (module, text) in all() {
            for line in text.lines() {
                assert!(line.matches('`').count() % 2 == 0, "{module}: {line}");
            }
        }
    }

    #[test]
    fn the_script_is_code_alone() {
        let [plain, live, served, typed] =
            [Kind::Results, Kind::Live, Kind::Served, Kind::Playground].map(script);
        for line in [&plain, &live, &served, &typed].into_iter().flat_map(|script| script.lines()) {
            assert!(!line.starts_with("import ") && !line.starts_with("export "), "{line}");
            assert!(!line.starts_with("//") && !line.starts_with('*') && !line.contains("/**"), "{line}");
        }
        // Either would end or hide the script in the page.
        for script in [&plain, &live, &served, &typed] {
            assert!(!script.contains("</script") && !script.contains("<!--"));
        }
        assert!(plain.ends_with("startPage(null);\n") && live.ends_with("startPage(wake);\n"));
        assert!(served.ends_with("startPage(listen);\n") && typed.ends_with("startPage(beginPlay);\n"));
        // What a page has no use for is not in it.
        assert!(!plain.contains("WebAssembly"));
    }

    #[test]
    fn comments_and_imports_are_left_out() {
        let text = "// one\nimport {\n  a,\n} from \"./b.js\";\n\n/** two\n * three */\nexport const c = /** @type {D} */ (a);\n";
        assert_eq!(without_comments(&without_imports(text)).trim(), "export const c =  (a);");
    }
}

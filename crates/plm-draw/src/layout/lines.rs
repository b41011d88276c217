//! Lines and their indentation.

use crate::lexer::Kind;

/// Columns of a level.
const LEVEL: usize = 4;
/// Blanks between the longest line and the comments after neighbouring lines; after a line alone there is one.
const BEFORE_COMMENTS: usize = 4;

/// An open bracket, or the whole text.
struct Frame {
    /// Indentation of elements: items of a block, arguments in brackets.
    inside: usize,
    /// Indentation of the bracket that closes.
    close: usize,
    is_block: bool,
    /// Indentation of the line in which the present element began; `None` between elements.
    element: Option<usize>,
}

/// A line that is done.
struct Line {
    code: String,
    /// `// …` after the code.
    comment: Option<String>,
}

/// Lines so far.
pub(super) struct Lines {
    done: Vec<Line>,
    present: Line,
    /// Indentation of the present line.
    indent: usize,
    frames: Vec<Frame>,
    /// Did a `}` end an item that may go on, with `else` or `;`?
    ended: bool,
    /// Is the last unit a comment up to the end of its line?
    needs_break: bool,
    /// Does the last unit open a bracket?
    opened: bool,
}

fn is_close(word: &str, kind: Kind) -> bool {
    kind == Kind::Mark && [")", "]", "}"].contains(&word)
}

impl Lines {
    /// Text that begins in a line of this indentation.
    pub(super) fn new(indent: usize) -> Lines {
        Lines {
            done: Vec::new(),
            present: Line { code: String::new(), comment: None },
            indent,
            frames: vec![Frame { inside: indent, close: indent, is_block: true, element: None }],
            ended: false,
            needs_break: false,
            opened: false,
        }
    }

    /// Would a unit after so many line breaks begin a line?
    pub(super) fn begins_line(&self, breaks: usize) -> bool {
        breaks > 0 && !self.is_empty()
    }

    fn is_empty(&self) -> bool {
        self.done.is_empty() && self.present.code.is_empty() && self.present.comment.is_none()
    }

    /// Appends a unit after line breaks, or after a blank.
    pub(super) fn push(&mut self, word: &str, kind: Kind, breaks: usize, is_apart: bool) {
        let closes = is_close(word, kind);
        let breaks = if self.is_empty() { 0 } else { breaks.max(usize::from(self.needs_break)) };
        let is_new_line = breaks > 0;
        if is_new_line {
            self.break_line(breaks > 1 && !self.opened && !closes, closes);
        }
        self.opened = false;
        self.needs_break = kind == Kind::LineComment;
        if kind.is_comment() {
            self.comment(word, kind, is_new_line);
            return;
        }
        self.ended = false;
        self.code(word, is_apart && !is_new_line);
        self.structure(word, kind);
    }

    fn frame(&mut self) -> Option<&mut Frame> {
        self.frames.last_mut()
    }

    /// Ends the present item if a `}` may have ended it.
    pub(super) fn end_item(&mut self) {
        if self.ended
            && let Some(frame) = self.frame()
        {
            frame.element = None;
        }
    }

    fn break_line(&mut self, with_empty_line: bool, closes: bool) {
        let line = std::mem::replace(&mut self.present, Line { code: String::new(), comment: None });
        self.done.push(line);
        if with_empty_line {
            self.done.push(Line { code: String::new(), comment: None });
        }
        let indent = self.frames.last().map_or(0, |frame| match frame.element {
            _ if closes => frame.close,
            Some(element) => element + LEVEL,
            None => frame.inside,
        });
        self.indent = indent;
        self.present.code = " ".repeat(indent);
    }

    fn comment(&mut self, word: &str, kind: Kind, is_new_line: bool) {
        let is_alone = is_new_line || self.present.code.trim().is_empty();
        if kind == Kind::LineComment && !is_alone {
            self.present.comment = Some(word.to_owned());
        } else {
            self.code(word, !is_alone);
        }
    }

    fn code(&mut self, word: &str, is_apart: bool) {
        let is_apart = is_apart && !self.present.code.is_empty() && !self.present.code.ends_with(' ');
        self.present.code.push_str(if is_apart { " " } else { "" });
        self.present.code.push_str(word);
    }

    /// Follows brackets and ends of elements.
    fn structure(&mut self, word: &str, kind: Kind) {
        let indent = self.indent;
        let word = if kind == Kind::Mark { word } else { "" };
        if is_close(word, kind) && self.frames.len() > 1 {
            self.frames.pop();
            self.ended = word == "}" && self.frames.last().is_some_and(|frame| frame.is_block);
            return;
        }
        let Some(frame) = self.frame() else { return };
        let separates = if frame.is_block { word == ";" } else { word == "," };
        if separates {
            frame.element = None;
            return;
        }
        let element = *frame.element.get_or_insert(indent);
        match word {
            "{" => self.open(element, true),
            "(" | "[" => self.open(indent, false),
            _ => {}
        }
    }

    fn open(&mut self, indent: usize, is_block: bool) {
        self.frames.push(Frame { inside: indent + LEVEL, close: indent, is_block, element: None });
        self.opened = true;
    }

    /// All lines, with comments of neighbouring lines in a column, and without an end of line at the end.
    pub(super) fn finish(mut self) -> String {
        let last = std::mem::replace(&mut self.present, Line { code: String::new(), comment: None });
        self.done.push(last);
        let mut made = String::new();
        for run in self.done.chunk_by(|one, other| one.comment.is_some() == other.comment.is_some()) {
            let blanks = if run.len() > 1 { BEFORE_COMMENTS } else { 1 };
            let width = run.iter().map(|line| line.code.chars().count()).max().unwrap_or(0) + blanks;
            for line in run {
                made.push_str(line.code.trim_end());
                if let Some(comment) = &line.comment {
                    let blanks = width - line.code.trim_end().chars().count();
                    made.push_str(&" ".repeat(blanks));
                    made.push_str(comment);
                }
                made.push('\n');
            }
        }
        made.truncate(made.trim_end_matches('\n').len());
        made
    }
}

//! The layout of declarations: what `plm fmt` and editors make of a text.
//!
//! Line breaks are the author's, as are comments; blanks, indentation and empty lines are not. So an item may stand in one line or in
//! several, and two layouts of the same lines are one. The tokens stay as they are.

mod lines;
mod spacing;

use std::ops::Range;

use crate::lexer::{Kind, Token, tokens};
use lines::Lines;
use spacing::Spacing;

/// A declaration in its layout; lines end as on Unix.
///
/// # Errors
/// A bracket, a string or a comment has no end: a message with its line.
pub fn formatted(text: &str) -> Result<String, String> {
    let made = laid_out(text, 0..text.len(), 0)?;
    Ok(if made.is_empty() { made } else { made + "\n" })
}

/// A range of a text in its layout; it begins in a line of this indentation.
///
/// # Errors
/// As [`formatted`].
pub fn laid_out(text: &str, range: Range<usize>, indent: usize) -> Result<String, String> {
    let part = &text[range.clone()];
    let line = |at: usize| text[..range.start + at].matches('\n').count() + 1;
    let all = tokens(part);
    if let Some(token) = all.iter().find(|token| token.kind == Kind::Unclosed) {
        let begin: String = token.text(part).chars().take(2).collect();
        return Err(format!("line {}: `{begin}` is not closed", line(token.range.start)));
    }
    if let Some(at) = unpaired(part, &all) {
        return Err(format!("line {}: the bracket `{}` has no partner", line(at), &part[at..=at]));
    }
    let mut lines = Lines::new(indent);
    let mut spacing = Spacing::default();
    let mut end = 0;
    let units = spacing::units(part, &all);
    let goes_on = goes_on(part, &units);
    for (unit, goes_on) in units.iter().zip(goes_on) {
        let gap = &part[end..unit.range.start];
        let breaks = gap.matches('\n').count();
        let is_apart = spacing.take(part, unit, !gap.is_empty(), lines.begins_line(breaks));
        if !goes_on {
            lines.end_item();
        }
        lines.push(unit.text(part), unit.kind, breaks, is_apart);
        end = unit.range.end;
    }
    let made = lines.finish();
    if same(part, &made) {
        Ok(made)
    } else {
        Err("this is a bug in plm: the layout has other tokens".to_owned())
    }
}

/// True for each unit at which an item that ended with `}` goes on, with `else` or `;` after comments.
fn goes_on(text: &str, units: &[spacing::Unit]) -> Vec<bool> {
    let (mut goes_on, mut all) = (false, Vec::new());
    for unit in units.iter().rev() {
        if !unit.kind.is_comment() {
            goes_on = ["else", ";"].contains(&unit.text(text));
        }
        all.push(goes_on);
    }
    all.reverse();
    all
}

/// Have two texts the same tokens and comments?
fn same(one: &str, other: &str) -> bool {
    let texts = |text: &str| tokens(text).iter().map(|token| token.text(text).to_owned()).collect::<Vec<_>>();
    texts(one) == texts(other)
}

/// Position of a bracket without its partner.
fn unpaired(text: &str, all: &[Token]) -> Option<usize> {
    let mut open: Vec<(char, usize)> = Vec::new();
    for token in all.iter().filter(|token| token.kind == Kind::Mark) {
        let mark = token.text(text).chars().next()?;
        match mark {
            '(' => open.push((')', token.range.start)),
            '[' => open.push((']', token.range.start)),
            '{' => open.push(('}', token.range.start)),
            ')' | ']' | '}' if open.pop().is_none_or(|(close, _)| close != mark) => {
                return Some(token.range.start);
            }
            _ => {}
        }
    }
    open.pop().map(|(_, at)| at)
}

#[cfg(test)]
mod tests {
    use super::formatted;

    fn made(text: &str) -> String {
        let made = formatted(text).unwrap_or_else(|why| why);
        assert_eq!(formatted(&made).as_ref(), Ok(&made), "twice");
        made
    }

    #[test]
    fn blanks_are_those_of_the_language() {
        let cases = [
            ("port a:( -0.5 ,0 )m ;", "port a: (-0.5, 0) m;"),
            ("inertia: 1 kg * m ^ 2 / ( 12*3 ) ;", "inertia: 1 kg*m^2/(12*3);"),
            ("let a=b+c*-d-(-e) ;", "let a = b + c*-d - (-e);"),
            ("revolute pin [i] (bar[i-1] . b,bar [ i ].a){}", "revolute pin[i](bar[i - 1].b, bar[i].a) {}"),
            ("repeat i in 0 .. 8{body b[i]{mass:1 kg ;}}", "repeat i in 0..8 { body b[i] { mass: 1 kg; } }"),
            (
                "friction f:rate( x )within -2 N..3 N{static:0..4 N;}",
                "friction f: rate(x) within -2 N .. 3 N { static: 0 .. 4 N; }",
            ),
            (
                "let a=if(b>=-1)and not(c)then(1)else -t;",
                "let a = if (b >= -1) and not (c) then (1) else -t;",
            ),
            ("choice face:roller|flat=flat;", "choice face: roller | flat = flat;"),
            ("pub( crate )P{}", "pub(crate) P {}"),
            ("crate=::plm ::sub;", "crate = ::plm::sub;"),
            (
                "picture mark on a:turn((0,-3))for k in 0..=n;",
                "picture mark on a: turn((0, -3)) for k in 0..=n;",
            ),
        ];
        for (text, expected) in cases {
            assert_eq!(made(text), format!("{expected}\n"));
        }
    }

    #[test]
    fn lines_are_the_authors_and_their_indentation_is_not() {
        let text = "\n\n/// Doc.\npub P {\n\n\n  // begin\n body b { mass: 1 kg;  // of steel\ninertia: 1 kg*m^2;\n   \n\n port longer: (0, 0) m; // here\n // end\n }\n\
                    let a = if x > 0\n then max(1,\n 2)\n else 3;\n given a { x: 1; } else {\n y: 2;\n }}\n\n";
        let expected = "/// Doc.\npub P {\n    // begin\n    body b { mass: 1 kg; // of steel\n        inertia: 1 kg*m^2;\n\n        \
                        port longer: (0, 0) m; // here\n        // end\n    }\n    let a = if x > 0\n        then max(1,\n            2)\n        \
                        else 3;\n    given a { x: 1; } else {\n        y: 2;\n    }}\n";
        assert_eq!(made(text), expected);
    }

    #[test]
    fn comments_after_neighbouring_lines_stand_in_a_column() {
        let text =
            "mass: 1 kg; // a\ncentre: (0, 0) m; /* b */\ninertia: 1 kg*m^2;// c\n/* d\n   e */ hole: x;";
        let expected =
            "mass: 1 kg; // a\ncentre: (0, 0) m; /* b */\ninertia: 1 kg*m^2; // c\n/* d\n   e */ hole: x;\n";
        assert_eq!(made(text), expected);
        assert_eq!(made("a: 1; // b\nlonger: 2; // c"), "a: 1;         // b\nlonger: 2;    // c\n");
    }

    #[test]
    fn a_text_without_brackets_in_pairs_has_no_layout() {
        for (text, expected) in [
            ("pub P {\n(1; }", "line 2: the bracket `}` has no partner"),
            ("a {\n", "line 1: the bracket `{` has no partner"),
            ("\n/* a", "line 2: `/*` is not closed"),
        ] {
            assert_eq!(formatted(text), Err(expected.to_owned()));
        }
        assert_eq!(formatted(" \n"), Ok(String::new()));
    }
}

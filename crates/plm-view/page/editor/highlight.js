// Colours of declarations, by the grammar that editors of other kinds use too.

import { HighlightStyle, StreamLanguage, indentService } from "@codemirror/language";
import { tags } from "@lezer/highlight";
import grammar from "../../../../editors/vscode/syntaxes/plm.tmLanguage.json";

/** What a name of the grammar is called here, by its first words. */
const NAMES = /** @type {const} */ ([
  ["comment.line.documentation", "docComment"],
  ["comment", "comment"],
  ["string", "string"],
  ["constant.numeric", "number"],
  ["constant.language", "atom"],
  ["support.function", "function"],
  ["keyword.other.unit", "unit"],
  ["keyword", "keyword"],
  ["variable.other.member", "propertyName"],
  ["variable.parameter", "definition"],
  ["entity.name.type", "typeName"],
]);

/** Patterns of one line: what matches first at a place gives the colour. */
const patterns = grammar.patterns.flatMap(({ name, match }) => {
  const found = NAMES.find(([start]) => name?.startsWith(start));
  return match === undefined || found === undefined ? [] : [{ match: new RegExp(match, "y"), colour: found[1] }];
});

/** What a line is read on with: the depth of block comments. */
const start = () => ({ depth: 0 });

/** @param {import("@codemirror/language").StringStream} stream @param {{depth: number}} state */
function token(stream, state) {
  if (state.depth > 0) return comment(stream, state);
  if (stream.eatSpace()) return null;
  if (stream.match("/*")) {
    state.depth = 1;
    return comment(stream, state);
  }
  if (stream.match(/^"[^"]*"?/)) return "string";
  for (const { match, colour } of patterns) {
    match.lastIndex = stream.pos;
    const found = match.exec(stream.string);
    if (found !== null && found[0] !== "") {
      stream.pos += found[0].length;
      return colour;
    }
  }
  if (!stream.match(/^\w+/)) stream.next();
  return null;
}

/** Block comments nest. @param {import("@codemirror/language").StringStream} stream @param {{depth: number}} state */
function comment(stream, state) {
  while (state.depth > 0 && !stream.eol()) {
    if (stream.match("*/")) state.depth -= 1;
    else if (stream.match("/*")) state.depth += 1;
    else stream.next();
  }
  return "comment";
}

export const declarations = StreamLanguage.define({
  name: "plm",
  startState: start,
  copyState: (state) => ({ ...state }),
  token,
  languageData: { commentTokens: { line: "//", block: { open: "/*", close: "*/" } }, closeBrackets: { brackets: ["(", "[", "{", '"'] } },
  tokenTable: {
    docComment: tags.docComment,
    definition: tags.definition(tags.propertyName),
    function: tags.function(tags.variableName),
    unit: tags.unit,
  },
});

/** A line stands as the one before, deeper after what opens, less where it closes. */
export const indentation = indentService.of((context, at) => {
  const { text, from } = context.lineAt(at, 1);
  if (from === 0) return 0;
  const before = context.lineAt(from - 1, -1);
  const depth = before.text.search(/\S|$/);
  return Math.max(0, depth + (/[{(]\s*$/.test(before.text) ? context.unit : 0) - (/^\s*[})]/.test(text) ? context.unit : 0));
});

/** The page gives the colours, light and dark. */
export const colours = HighlightStyle.define([
  { tag: tags.comment, class: "code-comment" },
  { tag: tags.docComment, class: "code-comment" },
  { tag: tags.string, class: "code-text" },
  { tag: tags.number, class: "code-number" },
  { tag: tags.atom, class: "code-number" },
  { tag: tags.unit, class: "code-unit" },
  { tag: tags.keyword, class: "code-word" },
  { tag: tags.function(tags.variableName), class: "code-function" },
  { tag: tags.propertyName, class: "code-member" },
  { tag: tags.definition(tags.propertyName), class: "code-field" },
  { tag: tags.typeName, class: "code-part" },
]);

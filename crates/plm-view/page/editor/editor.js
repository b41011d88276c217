// The editor of declarations: CodeMirror, with what the language server says.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab, isolateHistory, redo, undo, undoDepth } from "@codemirror/commands";
import { bracketMatching, foldGutter, foldKeymap, indentOnInput, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState } from "@codemirror/state";
import { EditorView, drawSelection, highlightActiveLine, highlightSpecialChars, hoverTooltip, keymap, lineNumbers } from "@codemirror/view";
import { colours, declarations, indentation } from "./highlight.js";

/** @import {Text} from "@codemirror/state" */
/** @import {Completion, CompletionContext, CompletionResult} from "@codemirror/autocomplete" */
/** @import {Diagnostic} from "@codemirror/lint" */
/** @import {Edit, Language as LanguageClient, Place, Problem} from "../src/language.js" */

/** What the language server is asked. @typedef {Pick<LanguageClient, "complete" | "hover">} Language */

/** Kinds of the protocol, as the list of completions shows them. @type {Record<number, string>} */
const KINDS = { 3: "function", 5: "property", 6: "variable", 7: "class", 10: "property", 11: "constant", 14: "keyword", 21: "constant" };

/**
 * Hears of steps that can be undone, and undoes: the page has one history for the text and the picture.
 * @typedef {{stepped: () => void, undo: () => void, redo: () => void}} Steps
 */

/** Keys of the page's history. @param {Steps} steps */
const stepKeys = (steps) =>
  [
    { key: "Mod-z", act: steps.undo },
    { key: "Mod-y", act: steps.redo },
    { key: "Mod-Shift-z", act: steps.redo },
  ].map(({ key, act }) => ({ key, run: () => (act(), true), preventDefault: true }));

/** @param {Text} text @param {Place} place */
function offset(text, { line, character }) {
  const { from, length } = text.line(Math.min(line + 1, text.lines));
  return from + Math.min(character, length);
}

/** @param {Text} text @param {number} at @returns {Place} */
function place(text, at) {
  const { number, from } = text.lineAt(at);
  return { line: number - 1, character: at - from };
}

/** @param {Text} text @param {Edit[]} edits */
const changes = (text, edits) => edits.map(({ range, newText }) => ({ from: offset(text, range.start), to: offset(text, range.end), insert: newText }));

/** @param {Language} language */
function completions(language) {
  return async (/** @type {CompletionContext} */ context) => {
    const word = context.matchBefore(/\w*/);
    const follows = context.matchBefore(/\.\w*/) !== null;
    if (!context.explicit && !follows && (word === null || word.from === word.to)) return null;
    const found = await language.complete(place(context.state.doc, context.pos));
    /** @type {Completion[]} */
    const options = found.map(({ label, kind, detail, documentation }, index) => ({
      label,
      // Of those that fit as well, in the order of the server.
      boost: Math.max(-99, 99 - index),
      type: KINDS[kind] ?? "text",
      detail,
      ...(documentation === "" ? {} : { info: documentation }),
    }));
    return /** @type {CompletionResult} */ ({ from: word?.from ?? context.pos, options, validFor: /^\w*$/ });
  };
}

/** @param {Language} language */
function values(language) {
  return hoverTooltip(async (view, at) => {
    const { doc } = view.state;
    const found = await language.hover(place(doc, at));
    if (found === null) return null;
    return {
      pos: offset(doc, found.range.start),
      end: offset(doc, found.range.end),
      above: true,
      create: () => ({ dom: shown(found.text) }),
    };
  });
}

/** Text of the language server: code between fences, and plain lines. @param {string} text */
function shown(text) {
  const root = document.createElement("div");
  root.className = "editor-hover";
  for (const [at, part] of text.split("```").entries()) {
    const plain = at % 2 === 1 ? part.replace(/^\w*\n/, "") : part;
    if (plain.trim() === "") continue;
    const piece = document.createElement(at % 2 === 1 ? "pre" : "p");
    piece.textContent = plain.trim().replaceAll("`", "");
    root.append(piece);
  }
  return root;
}

/**
 * An editor in an element.
 * @param {HTMLElement} parent
 * @param {string} text
 * @param {Language} language
 * @param {(text: string) => void} changed called after every change
 * @param {Steps} steps
 */
export function makeEditor(parent, text, language, changed, steps) {
  const view = new EditorView({
    parent,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        foldGutter(),
        history(),
        drawSelection(),
        EditorView.lineWrapping,
        highlightSpecialChars(),
        highlightActiveLine(),
        highlightSelectionMatches(),
        indentUnit.of("    "),
        indentOnInput(),
        bracketMatching(),
        closeBrackets(),
        declarations,
        indentation,
        syntaxHighlighting(colours),
        autocompletion({ override: [completions(language)] }),
        values(language),
        EditorView.contentAttributes.of({ "aria-label": "Declaration" }),
        EditorView.updateListener.of((update) => {
          if (!update.docChanged) return;
          const isBack = update.transactions.some((each) => each.isUserEvent("undo") || each.isUserEvent("redo"));
          if (!isBack && undoDepth(update.state) !== undoDepth(update.startState)) steps.stepped();
          changed(update.state.doc.toString());
        }),
        keymap.of([
          ...stepKeys(steps),
          ...closeBracketsKeymap,
          ...completionKeymap,
          ...lintKeymap,
          ...searchKeymap,
          ...historyKeymap,
          ...foldKeymap,
          ...defaultKeymap,
          indentWithTab,
        ]),
      ],
    }),
  });
  // A keyboard on the screen takes half of it: the line that is typed stays in sight.
  globalThis.visualViewport?.addEventListener("resize", () => {
    if (!view.hasFocus) return;
    view.dispatch({ effects: EditorView.scrollIntoView(view.state.selection.main.head, { y: "center" }) });
    view.dom.scrollIntoView({ block: "nearest" });
  });
  /** Marks what is wrong, with what mends it. @param {Problem[]} problems */
  const mark = (problems) => {
    const { doc } = view.state;
    const diagnostics = problems.map(({ range, severity, code, message }) => {
      const [from, to] = [offset(doc, range.start), offset(doc, range.end)];
      /** @type {Diagnostic} */
      const diagnostic = { from, to: Math.max(from, to), severity: severity === 1 ? "error" : "warning", message };
      if (code !== undefined) diagnostic.source = code;
      return diagnostic;
    });
    view.dispatch(setDiagnostics(view.state, diagnostics));
  };
  return {
    view,
    mark,
    text: () => view.state.doc.toString(),
    /** Another text, which can be undone. @param {string} other */
    replace: (other) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: other }, selection: { anchor: 0 }, annotations: isolateHistory.of("full") }),
    /** Edits of one deed of a hand: one step, which is shown. @param {Edit[]} edits */
    gesture: (edits) => {
      const made = view.state.changes(changes(view.state.doc, edits));
      const [last] = edits.slice(-1);
      const at = last === undefined ? null : made.mapPos(offset(view.state.doc, last.range.start), 1);
      view.dispatch({ changes: made, annotations: isolateHistory.of("full"), ...(at === null ? {} : { effects: EditorView.scrollIntoView(at, { y: "nearest" }) }) });
    },
    undo: () => undo(view),
    redo: () => redo(view),
    /** Edits of the language server. @param {Edit[]} edits */
    edit: (edits) => view.dispatch({ changes: changes(view.state.doc, edits) }),
    /** A place that is shown, with the cursor there. @param {Place} at */
    goTo: (at) => {
      const anchor = offset(view.state.doc, at);
      view.dispatch({ selection: { anchor }, effects: EditorView.scrollIntoView(anchor, { y: "center" }) });
      view.focus();
    },
  };
}

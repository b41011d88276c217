// Colours of declarations, in blocks of the language `plm` and within `mechanism!{…}` and `parts!{…}` of Rust. The patterns stand
// in words.js. Blocks that have such code are coloured once more, since the book's own script has run before this one.
(() => {
  const items = hljs => [
    hljs.C_LINE_COMMENT_MODE,
    hljs.C_BLOCK_COMMENT_MODE,
    hljs.QUOTE_STRING_MODE,
    ...plmPatterns.map(([className, begin]) => ({ className: className || undefined, begin, relevance: 0 })),
  ];
  hljs.registerLanguage("plm", hljs => ({ name: "plm", contains: items(hljs) }));

  const rust = hljs.getLanguage("rust").rawDefinition;
  hljs.registerLanguage("rust", hljs => {
    const braces = { begin: /\{/, end: /\}/ };
    braces.contains = [braces, ...items(hljs)];
    const name = { className: "built_in", begin: /\b(?:mechanism|parts)!/ };
    const macro = { begin: /\b(?:mechanism|parts)!\s*\{/, end: /\}/, returnBegin: true };
    macro.contains = [name, { ...braces, endsParent: true }];
    const definition = rust(hljs);
    return { ...definition, contains: [macro, ...definition.contains] };
  });

  for (const block of document.querySelectorAll("code.language-plm, code.language-rust")) {
    const isDeclared = block.matches(".language-plm") || /\b(?:mechanism|parts)!/.test(block.textContent);
    // Lines that are hidden at first have elements of their own, and stay as they are.
    if (isDeclared && !block.querySelector(".boring")) {
      block.textContent = block.textContent;
      hljs.highlightBlock(block);
    }
  }
})();

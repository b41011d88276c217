// Writes the manifest of the npm package: `node package.mjs VERSION REPOSITORY`.

const [version, repository] = process.argv.slice(2);
const manifest = {
  name: "plm-mechanism",
  version,
  description: "An element for pages: a planar mechanism moves, of the declaration that stands in it",
  keywords: ["mechanism", "linkage", "simulation", "multibody", "web-component"],
  license: "MIT OR Apache-2.0",
  ...(repository ? { repository: { type: "git", url: `git+${repository}.git` } } : {}),
  type: "module",
  main: "./plm-mechanism.js",
  types: "./plm-mechanism.d.ts",
  exports: {
    ".": { types: "./plm-mechanism.d.ts", default: "./plm-mechanism.js" },
    "./plm.wasm": "./plm.wasm",
  },
  // To import it defines the element.
  sideEffects: true,
  files: ["plm-mechanism.js", "plm-mechanism.d.ts", "plm.wasm", "LICENSE-*"],
};
process.stdout.write(`${JSON.stringify(manifest, null, 2)}\n`);

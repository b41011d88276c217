// Runs texts in the module under node, and prints the bits of every moment: `node run.mjs MODULE FILE…`.
import { readFileSync } from "node:fs";
import { instanceOf } from "../../crates/plm-view/page/src/machine.js";

const module = new WebAssembly.Module(readFileSync(process.argv[2]));
for (const file of process.argv.slice(3)) {
    const plm = instanceOf(module);
    const text = (at) => new TextDecoder().decode(new Uint8Array(plm.memory.buffer, at, plm.plm_text_length()));
    // The memory may grow while it is read.
    const line = (at, length) =>
        [...new BigUint64Array(plm.memory.buffer, at, length)].map((word) => word.toString(16)).join(" ");
    const declaration = readFileSync(file);
    const room = plm.plm_room(declaration.length);
    new Uint8Array(plm.memory.buffer, room, declaration.length).set(declaration);
    const begin = performance.now();
    if (plm.plm_compile() !== 1) {
        console.log(text(plm.plm_message()));
        continue;
    }
    console.error(`${file}: text to mechanism ${(performance.now() - begin).toFixed(0)} ms`);
    console.log(`${file.split("/").at(-1)} ${plm.plm_results_length()}`);
    const shape = plm.plm_shape();
    console.log(line(shape, plm.plm_shape_length()));
    for (let k = 0; k < 100; k++) {
        if (k === 50) plm.plm_pull(0, 0.1, 0.2, 1, -2);
        const done = plm.plm_step(0.01) === 1;
        const at = plm.plm_read();
        console.log(`${done} ${line(at, plm.plm_length())}`);
    }
    console.log(text(plm.plm_trouble()));
}

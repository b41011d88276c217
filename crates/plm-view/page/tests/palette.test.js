// Colours of bodies: no two are alike, for eyes without one of the three kinds of cones either; none is red, none like the ground.

import assert from "node:assert/strict";
import { test } from "node:test";
import { DARK, LIGHT } from "../src/palette.js";

/**
 * What eyes see that lack a kind of cones, in linear RGB: G. M. Machado, M. M. Oliveira and L. A. F. Fernandes, A physiologically-based
 * model for simulation of color vision deficiency, IEEE Transactions on Visualization and Computer Graphics 15 (2009), page 1291.
 */
const EYES = {
  all: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  "no red cones": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  "no green cones": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  "no blue cones": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};

const times = (matrix, vector) => matrix.map((row) => row.reduce((sum, part, at) => sum + part * vector[at], 0));
const linear = (part) => (part / 255 <= 0.04045 ? part / 255 / 12.92 : ((part / 255 + 0.055) / 1.055) ** 2.4);

/** Lightness and two hues of equal steps: B. Ottosson, A perceptual color space for image processing (2020). */
function oklab(rgb) {
  const cones = times([[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566], [0.0883024619, 0.2817188376, 0.6299787005]], rgb);
  return times([[0.2104542553, 0.793617785, -0.0040720468], [1.9779984951, -2.428592205, 0.4505937099], [0.0259040371, 0.7827717662, -0.808675766]], cones.map(Math.cbrt));
}

const seen = (rgb, eye) => oklab(times(EYES[eye], rgb.map(linear)).map((part) => Math.min(Math.max(part, 0), 1)));
const distance = (a, b, eye) => Math.hypot(...seen(a, eye).map((part, at) => part - seen(b, eye)[at]));
const hex = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));

for (const { name, bodies, tones, background } of [LIGHT, DARK]) {
  test(`bodies differ from one another, from the ground and from what is behind them: ${name}`, () => {
    for (const eye of Object.keys(EYES)) {
      bodies.forEach((rgb, at) => {
        for (const other of [...bodies.slice(0, at), tones.mount, hex(background)]) {
          const found = distance(rgb, other, eye);
          assert.ok(found > 0.07, `${eye}: ${rgb} and ${other} are ${found.toFixed(3)} apart`);
        }
      });
    }
  });

  test(`red is for faults: ${name}`, () => {
    for (const [r, g, b] of [...bodies, ...Object.values(tones)]) assert.ok(r < 1.8 * g || r < b, `${r} ${g} ${b}`);
  });
}

// Colours of pictures and curves, for light and dark backgrounds.

/** @import {Tone} from "./solid.js" */

/** @typedef {number[]} Rgb 0 to 255 */
/**
 * @typedef {{name: "light" | "dark", background: string, ink: string, faint: string, grid: string, edge: Rgb,
 *   tones: {[tone in Tone]: Rgb}, select: string, force: string, velocity: string, trace: string[], curves: string[],
 *   bodies: Rgb[], ghosts: Rgb[], fault: string}} Palette
 */

// Red is for faults alone. Bodies have colours that differ for eyes without red, green or blue cones, too
// (tests/palette.test.js); the ground is grey.

/** @type {Palette} */
export const LIGHT = {
  name: "light",
  background: "#f7f8fa",
  ink: "#1d2430",
  faint: "#5c6675",
  grid: "#dfe3ea",
  edge: [24, 48, 92],
  tones: {
    body: [108, 158, 224],
    ground: [104, 110, 120],
    joint: [44, 52, 66],
    mount: [170, 176, 186],
    cylinder: [126, 138, 156],
    rod: [204, 210, 219],
    groove: [238, 241, 246],
    spring: [70, 84, 106],
  },
  bodies: [[108, 158, 224], [236, 176, 60], [153, 119, 167], [128, 213, 141], [220, 197, 252], [183, 118, 16], [180, 244, 170]],
  select: "#e08700",
  force: "#c2185b",
  velocity: "#00796b",
  trace: ["#7b1fa2", "#00838f", "#b26a00", "#ad1457", "#2e7d32", "#4527a0"],
  // Okabe and Ito's colours, darkened where they would be faint on white.
  curves: ["#0067b1", "#d55e00", "#008a63", "#b8578f", "#a07800", "#1283b8", "#8a2be2", "#444444"],
  ghosts: [[226, 150, 70], [84, 172, 130], [178, 128, 200], [150, 150, 84], [206, 116, 138], [90, 170, 190]],
  fault: "#c62828",
};

/** @type {Palette} */
export const DARK = {
  name: "dark",
  background: "#161a21",
  ink: "#e6eaf1",
  faint: "#9aa5b6",
  grid: "#2c333f",
  edge: [10, 16, 30],
  tones: {
    body: [96, 146, 214],
    ground: [150, 157, 168],
    joint: [222, 228, 238],
    mount: [108, 116, 130],
    cylinder: [128, 140, 158],
    rod: [196, 203, 214],
    groove: [34, 40, 50],
    spring: [176, 188, 206],
  },
  bodies: [[96, 146, 214], [234, 176, 47], [41, 213, 205], [190, 124, 28], [139, 181, 134], [103, 175, 232], [144, 105, 59]],
  select: "#ffb74d",
  force: "#ff6f9f",
  velocity: "#4dd0b8",
  trace: ["#ce93d8", "#4dd0e1", "#ffca6a", "#f48fb1", "#a5d6a7", "#b39ddb"],
  curves: ["#5fb0f0", "#ff9a56", "#3fd0a0", "#e79ac4", "#e8c34a", "#9ad7ff", "#c79bff", "#c8ccd4"],
  ghosts: [[214, 142, 70], [76, 158, 120], [164, 118, 186], [148, 148, 84], [190, 106, 128], [84, 158, 178]],
  fault: "#ff7b72",
};

/**
 * A palette that can be read on a background of the user's choice.
 * @param {Palette} palette
 * @param {string | null} background `#rrggbb`
 * @returns {Palette}
 */
export function onBackground(palette, background) {
  if (background === null) return palette;
  const base = luminance(background) > 0.35 ? LIGHT : DARK;
  return { ...base, background };
}

/** @param {string} colour `#rrggbb` @returns {number} 0 black to 1 white, as WCAG 2 defines it */
export function luminance(colour) {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const part = parseInt(colour.slice(at, at + 2), 16) / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/**
 * @param {Rgb} rgb
 * @param {number} [light] 1 leaves the colour as it is, 0 is black, more is brighter
 */
export function rgbText(rgb, light = 1) {
  const shade = (/** @type {number} */ part) => Math.round(light <= 1 ? part * light : part + (255 - part) * (light - 1));
  return `rgb(${shade(rgb[0])},${shade(rgb[1])},${shade(rgb[2])})`;
}

/**
 * Style of a drawing in the light palette, for readers who prefer a dark scheme: each colour that occurs in it becomes that of
 * the dark palette. Shaded walls stay as they are.
 * @param {string} drawing SVG elements
 */
export function darkStyle(drawing) {
  const [light, dark] = [LIGHT, DARK].map(coloursOf);
  const used = light.filter((colour, at) => light.indexOf(colour) === at && drawing.includes(`"${colour}"`));
  const rules = used.map((colour) => {
    const instead = dark[light.indexOf(colour)];
    return `[fill="${colour}"]{fill:${instead}}[stroke="${colour}"]{stroke:${instead}}`;
  });
  return `<style>@media(prefers-color-scheme:dark){${rules.join("")}}</style>`;
}

/** All colours of a palette in its order, as they stand in a file. @param {Palette} palette @returns {string[]} */
function coloursOf(palette) {
  const isRgb = (/** @type {unknown} */ value) => Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);
  /** @type {(value: any) => string[]} */
  const flat = (value) => {
    if (typeof value === "string") return [value];
    return isRgb(value) ? [rgbText(value)] : Object.values(value).flatMap(flat);
  };
  const { name: _, ...colours } = palette;
  return flat(colours);
}

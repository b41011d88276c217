// Outlines: closed polygons as flat lists x0 y0 x1 y1 …, to the left around their inside.

/** Corners of a full circle; round ends have their share. */
const ROUND = 24;

/** @typedef {number[]} Outline */

/**
 * Around `points` at the distance `radius`: a disc, a bar with round ends, or a plate with round corners.
 * @param {number[][]} points
 * @param {number} radius
 * @returns {Outline}
 */
export function roundedHull(points, radius) {
  const hull = convexHull(points);
  if (hull.length === 1) return circleOutline(hull[0][0], hull[0][1], radius);
  const outline = [];
  for (let index = 0; index < hull.length; index++) {
    const [before, at, after] = [-1, 0, 1].map((step) => hull[(index + step + hull.length) % hull.length]);
    const from = Math.atan2(at[1] - before[1], at[0] - before[0]) - Math.PI / 2;
    let turn = Math.atan2(after[1] - at[1], after[0] - at[0]) - Math.PI / 2 - from;
    turn -= 2 * Math.PI * Math.floor(turn / (2 * Math.PI));
    const steps = Math.max(1, Math.round((ROUND * turn) / (2 * Math.PI)));
    for (let step = 0; step <= steps; step++) {
      const angle = from + (turn * step) / steps;
      outline.push(at[0] + radius * Math.cos(angle), at[1] + radius * Math.sin(angle));
    }
  }
  return outline;
}

/**
 * The corners of the smallest convex polygon around points: A. M. Andrew, Another efficient algorithm for convex hulls in
 * two dimensions, Information Processing Letters 9 (1979), page 216.
 * @param {number[][]} points
 * @returns {number[][]}
 */
export function convexHull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const distinct = sorted.filter((point, at) => at === 0 || !isNear(point, sorted[at - 1]));
  if (distinct.length < 3) return distinct;
  const half = (/** @type {number[][]} */ list) => {
    /** @type {number[][]} */
    const chain = [];
    for (const point of list) {
      while (chain.length > 1 && bendOf(chain[chain.length - 2], chain[chain.length - 1], point) <= 0) chain.pop();
      chain.push(point);
    }
    chain.pop();
    return chain;
  };
  return [...half(distinct), ...half(distinct.reverse())];
}

/** @param {number[]} a @param {number[]} b */
function isNear(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1]) < 1e-12;
}

/** @param {number[]} a @param {number[]} b @param {number[]} c */
function bendOf(a, b, c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/**
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 * @param {number} [corners]
 * @returns {Outline}
 */
export function circleOutline(x, y, radius, corners = ROUND) {
  const outline = [];
  for (let step = 0; step < corners; step++) {
    const angle = (2 * Math.PI * step) / corners;
    outline.push(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
  }
  return outline;
}

/**
 * @param {number} left
 * @param {number} right
 * @param {number} low
 * @param {number} high
 * @returns {Outline}
 */
export function boxOutline(left, right, low, high) {
  return [left, low, right, low, right, high, left, high];
}

/**
 * A contour as it was given, turned so that its inside is on the left. With holes each of them and the contour itself is a ring
 * that ends where it begins, and no numbers stand after it.
 * @param {number[][]} contour
 * @param {number[][][]} [holes]
 * @returns {Outline}
 */
export function contourOutline(contour, holes = []) {
  if (holes.length > 0) {
    return [contour, ...holes].flatMap((ring, at) => {
      const turned = areaOf(ring.flat()) < 0 === at > 0 ? ring : ring.toReversed();
      return [...turned, turned[0], [NaN, NaN]].flat();
    });
  }
  const outline = contour.flat();
  return areaOf(outline) < 0 ? contour.toReversed().flat() : outline;
}

/**
 * Twice the area of a polygon, negative if its inside is on the right.
 * @param {ArrayLike<number>} outline
 */
export function areaOf(outline) {
  let area = 0;
  for (let at = 0, before = outline.length - 2; at < outline.length; before = at, at += 2) {
    area += outline[before] * outline[at + 1] - outline[at] * outline[before + 1];
  }
  return area;
}

/**
 * A coil spring from x = 0 to `length` along the x axis, as an open line.
 * @param {number} length
 * @param {number} halfWidth
 * @param {number} turns
 */
export function coilLine(length, halfWidth, turns) {
  const lead = 0.12 * length;
  const line = [0, 0, lead, 0];
  for (let half = 0; half < 2 * turns; half++) {
    const x = lead + ((half + 0.5) / (2 * turns)) * (length - 2 * lead);
    line.push(x, half % 2 === 0 ? halfWidth : -halfWidth);
  }
  line.push(length - lead, 0, length, 0);
  return line;
}

/**
 * Turned by an angle, then moved.
 * @param {ArrayLike<number>} outline
 * @param {ArrayLike<number>} pose x y θ
 * @returns {Outline}
 */
export function movedOutline(outline, pose) {
  const [x, y] = [pose[0], pose[1]];
  const [cos, sin] = [Math.cos(pose[2]), Math.sin(pose[2])];
  const moved = new Array(outline.length);
  for (let at = 0; at < outline.length; at += 2) {
    moved[at] = x + cos * outline[at] - sin * outline[at + 1];
    moved[at + 1] = y + sin * outline[at] + cos * outline[at + 1];
  }
  return moved;
}

/**
 * Whether a point lies inside of a polygon.
 * @param {ArrayLike<number>} outline
 * @param {number} x
 * @param {number} y
 */
export function isInside(outline, x, y) {
  let inside = false;
  for (let at = 0, before = outline.length - 2; at < outline.length; before = at, at += 2) {
    const [xa, ya, xb, yb] = [outline[before], outline[before + 1], outline[at], outline[at + 1]];
    if (ya > y !== yb > y && x < xa + ((y - ya) / (yb - ya)) * (xb - xa)) inside = !inside;
  }
  return inside;
}

/**
 * How far a point is from a line of points.
 * @param {ArrayLike<number>} line
 * @param {number} x
 * @param {number} y
 */
export function distanceToLine(line, x, y) {
  let nearest = Infinity;
  for (let at = 2; at < line.length; at += 2) {
    const [xa, ya] = [line[at - 2], line[at - 1]];
    const [dx, dy] = [line[at] - xa, line[at + 1] - ya];
    const square = dx * dx + dy * dy;
    const share = square > 0 ? Math.min(1, Math.max(0, ((x - xa) * dx + (y - ya) * dy) / square)) : 0;
    const distance = Math.hypot(x - xa - share * dx, y - ya - share * dy);
    if (distance < nearest) nearest = distance;
  }
  return nearest;
}

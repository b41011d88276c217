// Icons of the buttons: lines in a square of 20.

const CUBE = "M10 2.5 16.5 6v8L10 17.5 3.5 14V6z";
const CUBE_FRONT = "M3.5 6 10 9.5 16.5 6M10 9.5v8";
const CUBE_BACK = "M3.5 14 10 10.5 16.5 14M10 10.5v-8";

/** Lines; an entry of two has a face that is filled, too. @type {{[name: string]: string | [string, string]}} */
const ICON_PATHS = {
  open: "M2.5 16V4.5h5l1.5 2h7V9M2.5 16l2.5-7h13l-2.5 7z",
  reload: "M16 6.5A7 7 0 1 0 17 11M16.5 2.5v4.5H12",
  clear: "M5 2.5h7l3 3v12H5zM7.5 8.5l5 5M12.5 8.5l-5 5",
  exit: "M8 3H3.5v14H8M8 10h9M13.5 6.5 17 10l-3.5 3.5",
  pan: "M10 2v16M2 10h16M7.5 4.5 10 2l2.5 2.5M7.5 15.5 10 18l2.5-2.5M4.5 7.5 2 10l2.5 2.5M15.5 7.5 18 10l-2.5 2.5",
  orbit: "M10 6.5a3.5 3.5 0 1 0 .01 0M2 10c0-2 3.5-3.6 8-3.6s8 1.6 8 3.6-3 3.4-6.5 3.6M13.5 11.5l-2.2 2.2 2.2 2.2",
  zoom: "M8.5 3a5.5 5.5 0 1 0 .01 0M12.5 12.5 17.5 17.5M6 8.5h5M8.5 6v5",
  window: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M7.5 7.5h5v5h-5z",
  info: "M10 2.5a7.5 7.5 0 1 0 .01 0M10 9v5.5M10 6v.5",
  extents: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M6.5 10h7M10 6.5v7",
  isometric: `${CUBE}${CUBE_FRONT}`,
  front: [`${CUBE}${CUBE_FRONT}`, "M3.5 6 10 9.5v8L3.5 14z"],
  right: [`${CUBE}${CUBE_FRONT}`, "M16.5 6 10 9.5v8l6.5-3.5z"],
  top: [`${CUBE}${CUBE_FRONT}`, "M10 2.5 16.5 6 10 9.5 3.5 6z"],
  back: [`${CUBE}${CUBE_BACK}`, "M16.5 14 10 10.5v-8L16.5 6z"],
  left: [`${CUBE}${CUBE_BACK}`, "M3.5 14 10 10.5v-8L3.5 6z"],
  bottom: [`${CUBE}${CUBE_BACK}`, "M10 17.5 16.5 14 10 10.5 3.5 14z"],
  wire: "M3 13.5 7 5l10 3-5 8zM3 13.5 17 8M7 5l5 11",
  forces: "M3 17 15 5M9.5 4.5H15.5V10.5",
  velocities: "M2.5 6h5M2.5 10h3.5M2.5 14h5M10 10h7.5M14 6.5 17.5 10 14 13.5",
  png: "M3 4h14v12H3zM3 13l4-4 4 4 2-2 4 4M13 7.5v.5",
  svg: "M3 4h14v12H3zM5.5 13c2-8 3 0 5-4s2.5 1 4-2",
  theme: ["M10 2.5a7.5 7.5 0 1 0 .01 0", "M10 2.5a7.5 7.5 0 0 1 0 15z"],
  options: "M3 5h7M14 5h3M12 3v4M3 10h2M9 10h8M7 8v4M3 15h9M16 15h1M14 13v4",
  help: "M10 2.5a7.5 7.5 0 1 0 .01 0M7.5 8c0-3.5 5-3.5 5-.500 0 2-2.5 2-2.5 4M10 14.5v.5",
  panel: "M3 4h14v12H3zM12 4v12",
  draw: ["M3 17l1-4 9.500-9.500 3 3L7 16zM12 5l3 3", ""],
  pull: ["M6 14 13.5 6.5M9 6h5v5", "M5 13a2.500 2.500 0 1 0 .01 0z"],
  place: "M4 16h12M6 13 9 4h4l-2 9zM3 8h3M14.500 8h3",
  restart: "M4.500 4v5h5M4.800 9A6 6 0 1 1 4.500 12",
  record: ["M10 2.500a7.500 7.500 0 1 0 .01 0", "M10 6a4 4 0 1 0 .01 0z"],
  start: ["M4 4v12", "M16 4v12L7 10z"],
  back1: ["M14.5 4v12", "M11.5 4v12L4 10z"],
  undo: "M4 4v5h5M4.500 9A6.500 6.500 0 1 1 6 15",
  redo: "M16 4v5h-5M15.500 9A6.500 6.500 0 1 0 14 15",
  distance: "M3 5v10M17 5v10M3 10h14M6 7l-3 3 3 3M14 7l3 3-3 3",
  angle: "M16 16H3L14 4M9.500 16a6 6 0 0 0-2-4.500",
  centres: "M4 4l12 12M16 4 4 16",
  centrodes: "M2.500 14a8 8 0 0 1 15 0M10 6.500a3.500 3.500 0 1 0 .01 0",
  ghosts: ["M4 16 8 4M8 16l4-12", "M12 16l4-12 1.500.500-4 12z"],
  polar: "M10 2.500a7.500 7.500 0 1 0 .01 0M2.500 10h15M10 2.500v15M10 10c6-7 8 2 0 0",
  movie: ["M2.500 5h11v10h-11zM13.500 9l4-3v8l-4-3", "M6.500 7.500v5l4-2.500z"],
  menu: "M3 5h14M3 10h14M3 15h14",
  pause: ["", "M5 4h3.500v12H5zM11.500 4H15v12h-3.500z"],
  play: ["", "M5 3.5 16.5 10 5 16.5z"],
  stop: ["", "M5 5h10v10H5z"],
  forward1: ["M5.5 4v12", "M8.5 4v12l7.5-6z"],
  end: ["M16 4v12", "M4 4v12l9-6z"],
  loop: "M4 9V7.5A2.5 2.5 0 0 1 6.5 5H16M13.5 2.5 16 5l-2.5 2.5M16 11v1.5A2.5 2.5 0 0 1 13.5 15H4M6.5 12.5 4 15l2.5 2.5",
};

const SVG_SPACE = "http://www.w3.org/2000/svg";

/** @param {string} name */
export function iconOf(name) {
  const icon = document.createElementNS(SVG_SPACE, "svg");
  icon.setAttribute("viewBox", "0 0 20 20");
  icon.setAttribute("aria-hidden", "true");
  const paths = ICON_PATHS[name] ?? "";
  const [line, face] = typeof paths === "string" ? [paths, ""] : paths;
  for (const [path, kind] of [[face, "face"], [line, "line"]]) {
    if (path === "") continue;
    const made = document.createElementNS(SVG_SPACE, "path");
    made.setAttribute("d", path);
    made.setAttribute("class", kind);
    icon.append(made);
  }
  return icon;
}

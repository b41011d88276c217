// Pictures that come in two colours follow the theme that the reader picks; by themselves they follow the system. Drawings in SVG
// follow the theme without help.
(() => {
  const html = document.documentElement;
  const sources = [...document.querySelectorAll("picture > source[media*=prefers-color-scheme]")];
  const wanted = sources.map((source) => source.media.includes("dark"));
  const follow = () => {
    const isDark = getComputedStyle(html).colorScheme.includes("dark");
    sources.forEach((source, index) => {
      source.media = wanted[index] === isDark ? "all" : "not all";
    });
  };
  if (sources.length > 0) {
    follow();
    new MutationObserver(follow).observe(html, { attributes: true, attributeFilter: ["class"] });
  }
})();

// The one palette of all toys, in the page's two themes. Toys and models name a colour by the hex
// string of the light theme; `tint` turns it into that of the theme on screen when something is
// drawn.
globalThis.course.palette = (() => {
  "use strict";

  // Lines have a contrast of at least 3 with the background, and words one of 4.5. `words` is the
  // darker shade for words in the light theme; a colour without `dark` looks the same in both
  // themes.
  const PALETTE = {
    // Lines and words.
    blue: { light: "#0072b2", dark: "#56a8de" },
    orange: { light: "#b87a00", dark: "#e69f00", words: "#8a5f00" },
    green: { light: "#009e73", dark: "#33c79c", words: "#007a59" },
    purple: { light: "#9b4f7f", dark: "#d08ab5" },
    violet: { light: "#7a1fa2", dark: "#cf9ae6" },
    red: { light: "#d55e00", dark: "#f0863a", words: "#b84f00" },
    crimson: { light: "#b2182b", dark: "#f2667a" },
    grey: { light: "#6b7177", dark: "#b3bac1" },
    black: { light: "#222222", dark: "#e7eaee" },
    // Links and joints of arms.
    steel: { light: "#7f8891", dark: "#8d959e" },
    link: { light: "#d96a12", dark: "#f07818" },
    dark: { light: "#2f3338", dark: "#69727c" },
    charcoal: { light: "#5b6168", dark: "#7d858e" },
    pale: { light: "#56b4e9" },
    white: { light: "#e8eaed" },
    aluminium: { light: "#8d959e" },
    amber: { light: "#e69f00" },
    // What stands behind.
    ground: { light: "#f7f8fa", dark: "#14171b" },
    grid: { light: "#dde1e6", dark: "#2a3037" },
    floor: { light: "#e9ecef", dark: "#2a3037" },
    lines: { light: "#c9ced4", dark: "#414a54" },
    shade: { light: "#1a1f26", dark: "#000000" },
    globe: { light: "#e4e7ea", dark: "#4a535d" },
    spot: { light: "#f4f5f6" },
    // Five steps from a small to a large error.
    tiny: { light: "#2166ac", dark: "#4393d0" },
    small: { light: "#92c5de" },
    medium: { light: "#f7e6c4" },
    large: { light: "#f4a582" },
    huge: { light: "#b01a2a", dark: "#d6404f" },
  };
  const shades = Object.values(PALETTE);
  const COLOURS = Object.fromEntries(
    Object.entries(PALETTE).map(([name, { light }]) => [name, light]),
  );
  // {hex string of the light theme: the one that replaces it}
  const IN_DARK = new Map(
    shades.filter(({ dark }) => dark).map(({ light, dark }) => [light, dark]),
  );
  const AS_WORDS = new Map(
    shades.filter(({ words }) => words).map(({ light, words }) => [light, words]),
  );

  /** Whether the page, or JupyterLab, shows its dark theme. */
  function isDark() {
    const isDarkPage = document.documentElement.dataset.theme === "dark";
    return isDarkPage || document.body.dataset.jpThemeLight === "false";
  }

  /**
   * The colour of lines and areas in the theme on screen.
   * @param {string} colour a hex string of the light theme; one that the palette lacks is returned
   *   as it is
   */
  function tint(colour) {
    if (!isDark()) return colour;
    return IN_DARK.get(colour.toLowerCase()) ?? colour;
  }

  /** The colour of words in the theme on screen, with more contrast than `tint` gives to lines. */
  function wordTint(colour) {
    if (isDark()) return tint(colour);
    return AS_WORDS.get(colour.toLowerCase()) ?? colour;
  }

  /**
   * Call `change` whenever the page (data-theme) or JupyterLab changes to its other theme.
   * @returns {() => void} ends that
   */
  function onTheme(change) {
    let wasDark = isDark();
    const observer = new MutationObserver(() => {
      if (isDark() === wasDark) return;
      wasDark = isDark();
      change();
    });
    observer.observe(document.documentElement, { attributeFilter: ["data-theme"] });
    observer.observe(document.body, { attributeFilter: ["data-jp-theme-light"] });
    return () => observer.disconnect();
  }

  return { PALETTE, COLOURS, isDark, tint, wordTint, onTheme };
})();

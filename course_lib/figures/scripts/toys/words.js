// Numbers, vectors and matrices as a toy writes them, and the elements that hold them.
globalThis.course.parts = {};
(() => {
  "use strict";
  const P = globalThis.course.parts;
  const MINUS = "\u2212";

  /** Radians in a degree. */
  P.rad = Math.PI / 180;

  /**
   * A number with a minus sign in place of a hyphen, and 0 in place of -0.
   * @param {number} x
   * @param {number} digits behind the point
   */
  P.number = (x, digits = 2) => {
    const text = x.toFixed(digits);
    const isMinusZero = /^-0(\.0+)?$/.test(text);
    return isMinusZero ? text.slice(1) : text.replace("-", MINUS);
  };
  P.list = (values, digits) => values.map((x) => P.number(x, digits)).join(", ");
  P.metres = (point) => `${P.list(point)} m`;

  /** An angle that is given in radians, in degrees. */
  P.degrees = (angle, digits = 0) => `${P.number(angle / P.rad, digits)}°`;

  /** An angle that is given in degrees. */
  P.inDegrees = (angle) => `${P.number(angle, 0)}°`;
  P.percent = (share) => `${Math.round(100 * share)} %`;

  /** A length that is given in metres, in millimetres; below one metre whole ones do. */
  P.millimetres = (x) => `${P.number(1000 * x, x < 1 ? 1 : 0)} mm`;

  /** A letter with its index as a subscript: sub("q", 2) is q₂. */
  P.sub = (letter, index) => {
    const digits = String(index).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉"[digit]);
    return letter + digits;
  };

  /** A number as a power of ten: power(2e-7) is 2·10⁻⁷. */
  P.power = (x) => {
    const [digits, exponent] = x.toExponential(0).split("e");
    const raised = exponent
      .replace("+", "")
      .replace("-", "⁻")
      .replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
    return `${digits}·10${raised}`;
  };

  /** Text as HTML that shows it. */
  P.escape = (text) => text.replace(/[&<>"]/g, (character) => `&#${character.charCodeAt(0)};`);

  /**
   * HTML of a matrix.
   * @param {number[][]} rows
   * @param {{digits?: number, highlighted?: number}} options highlighted: the index of a column
   */
  P.matrix = (rows, { digits = 3, highlighted = -1 } = {}) => {
    const words = rows.map((row) => row.map((x) => P.number(x, digits)));
    const cell = (word, column) =>
      `<span${column === highlighted ? " class=chosen" : ""}>${word}</span>`;
    const cells = words.flatMap((row) => row.map(cell)).join("");
    const spoken = words.map((row) => row.join(" ")).join("; ");
    const columns = `grid-template-columns:repeat(${rows[0].length},auto)`;
    const look = `role="img" aria-label="${spoken}" style="${columns}"`;
    return `<span class="matrix" ${look}>${cells}</span>`;
  };

  /**
   * A new element.
   * @param {string} name of its tag
   * @param {Record<string, string>} attributes
   * @param {Element} [parent] to which it is appended
   * @param {string} [text] that it holds
   */
  P.element = (name, attributes, parent, text) => {
    const node = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    if (text !== undefined) node.textContent = text;
    parent?.append(node);
    return node;
  };
})();

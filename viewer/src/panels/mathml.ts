/**
 * MathML from polhode, rebuilt element by element. Only the listed names and attributes enter the
 * page, whatever the text contains. The parser's document is inert and discarded.
 */
const SPACE = "http://www.w3.org/1998/Math/MathML";

const ELEMENTS = new Set(
  (
    "math mrow mi mn mo mtext mspace mfrac msqrt mroot mstyle mpadded mphantom mfenced menclose " +
    "msub msup msubsup munder mover munderover mmultiscripts mprescripts mtable mtr mtd"
  ).split(" "),
);
const ATTRIBUTES = new Set(
  (
    "display displaystyle scriptlevel mathvariant stretchy fence separator form lspace rspace accent accentunder largeop " +
    "movablelimits symmetric width height depth linethickness columnalign columnspacing rowspacing open close separators"
  ).split(" "),
);

/** Returns the formula; null if it contains anything other than plain MathML. */
export function safeMath(source: string): Element | null {
  const parsed = new DOMParser().parseFromString(source, "text/html").body;
  const [root, ...more] = [...parsed.children];
  if (!root || more.length > 0 || root.localName !== "math") return null;
  const made = copy(root);
  if (made instanceof Element && source.includes("display=") === false) made.setAttribute("display", "block");
  return made;
}

function copy(from: Element): Element | null {
  if (from.namespaceURI !== SPACE || !ELEMENTS.has(from.localName)) return null;
  const to = document.createElementNS(SPACE, from.localName);
  for (const { name, value } of from.attributes) {
    if (name === "xmlns") continue;
    if (!ATTRIBUTES.has(name)) return null;
    to.setAttribute(name, value);
  }
  for (const child of from.childNodes) {
    if (child instanceof Text || child.nodeType === Node.TEXT_NODE) {
      to.append(child.textContent ?? "");
    } else if (child.nodeType === Node.ELEMENT_NODE) {
      const copied = copy(child as Element);
      if (!copied) return null;
      to.append(copied);
    } else if (child.nodeType !== Node.COMMENT_NODE) {
      return null;
    }
  }
  return to;
}

/** Information about the page, its conventions, and the licences of its parts. */
import { element } from "../dom";
import OFL from "../../../crates/polhode-document/assets/stix-two-math.OFL.txt";

declare const THREE_VERSION: string;
declare const UPLOT_VERSION: string;
declare const OMGGIF_VERSION: string;
declare const FFLATE_VERSION: string;
declare const XZ_VERSION: string;
/** Version of CodeMirror's view in the page of `polhode live`; empty in the single-file page. */
declare const CODEMIRROR_VERSION: string;

const WHAT =
  CODEMIRROR_VERSION === ""
    ? "This page is one file. It needs no network and asks for none; it can be sent and kept as it is."
    : "This page is polhode’s own, on this computer: it asks nobody else. To keep a motion, save its scenario, or write a page with polhode simulate --html.";

const MIT =
  "Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation files " +
  "(the “Software”), to deal in the Software without restriction, including without limitation the rights to use, copy, modify, merge, " +
  "publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is furnished to do " +
  "so, subject to the following conditions:\n\n" +
  "The above copyright notice and this permission notice shall be included in all copies or substantial portions of the Software.\n\n" +
  "THE SOFTWARE IS PROVIDED “AS IS”, WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF " +
  "MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE " +
  "FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN " +
  "CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.";

export function about(host: HTMLElement, source: string): void {
  host.append(
    element("p", {}, WHAT),
    element("p", { class: "hint" }, "Made by: ", element("code", {}, source)),
    element("h3", {}, "Conventions"),
    list([
      "Space axes X Y Z do not move; body axes x y z are fixed in the body as it was described; principal axes 1 2 3 have ascending moments.",
      "ω is the body’s angular velocity relative to space, in body axes; L = Iω and the torque N are about the point that the body turns about.",
      "Products of inertia are minus the integrals, so that L = Iω.",
      "Euler angles are 3-1-3: precession φ about Z, nutation θ, spin ψ about z.",
      "Arrows of one kind keep one scale through the motion; arrows of different kinds have scales of their own. In the rolling pictures L shows a direction only.",
    ]),
    element("h3", {}, "Licences"),
    element("p", {}, "polhode: MIT or Apache 2.0, at your choice."),
    element("p", {}, `three.js ${THREE_VERSION}: MIT licence, copyright © 2010–2026 three.js authors.`),
    element("p", {}, `uPlot ${UPLOT_VERSION}: MIT licence, copyright © 2022 Leon Sorokin.`),
    element("p", {}, `omggif ${OMGGIF_VERSION}: MIT licence, copyright © 2013 Dean McNamee.`),
    element("p", {}, `fflate ${FFLATE_VERSION}: MIT licence, copyright © 2026 Arjun Barrett.`),
    ...(CODEMIRROR_VERSION === "" ? [] : [element("p", {}, `xz-decompress ${XZ_VERSION}: MIT licence, copyright © Steve Sanderson and others; contains XZ Embedded, public domain.`), element("p", {}, `CodeMirror ${CODEMIRROR_VERSION} with style-mod, w3c-keyname, crelt, Lezer and find-cluster-break: MIT licence, copyright © 2018–2026 Marijn Haverbeke and others.`)]),
    element("p", {}, "STIX Two Math, a part of it: SIL Open Font License 1.1, copyright © 2001–2021 The STIX Fonts Project Authors."),
    element("details", {}, element("summary", {}, "The MIT licence"), element("p", { class: "licence" }, MIT)),
    element("details", {}, element("summary", {}, "The SIL Open Font License"), element("p", { class: "licence" }, OFL)),
  );
}

function list(items: string[]): HTMLElement {
  return element("ul", {}, ...items.map((text) => element("li", {}, text)));
}

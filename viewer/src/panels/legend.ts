/** The pictures of the 3-D view, and what each shows: the legend is made of switches. */
import { byId, element } from "../dom";
import type { Picture } from "../scene/layers";
import type { View } from "../scene/scene";
import type { Trailed } from "../scene/trails";

const PICTURES: Record<Picture, string> = {
  body: "Body",
  poinsot: "Poinsot",
  cones: "Cones",
  sphere: "Momentum sphere",
};
const TRAILS: Record<Trailed, string> = { "axis-1": "x axis", "axis-2": "y axis", "axis-3": "z axis", omega: "tip of ω" };

/** Returns what shows a picture. */
export function legend(view: View): (picture: Picture) => void {
  const bar = byId("pictures");
  const host = byId("legend");
  const ride = byId<HTMLButtonElement>("ride");
  const show = (picture: Picture): void => {
    if (!view.pictures.includes(picture)) return;
    view.show(picture);
    for (const button of bar.querySelectorAll("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.picture === picture));
    }
    fill(host, view);
    name(ride, view);
  };
  for (const picture of view.pictures) {
    const button = element("button", { type: "button", click: () => show(picture) }, PICTURES[picture]);
    button.dataset.picture = picture;
    bar.append(button);
  }
  bar.hidden = view.pictures.length < 2;
  ride.addEventListener("click", () => {
    view.rides = view.rides === "space" ? "body" : "space";
    view.invalidate();
    name(ride, view);
  });
  byId("home").addEventListener("click", () => view.orbit.home());
  show("body");
  return show;
}

function name(ride: HTMLButtonElement, view: View): void {
  ride.textContent = view.rides === "space" ? "Seen from space" : "Seen from the body";
}

function fill(host: HTMLElement, view: View): void {
  host.replaceChildren();
  for (const layer of view.layers) {
    if (layer.on[view.picture] === undefined) continue;
    const swatch = element("span", { class: `swatch ${layer.look}` });
    const axes = layer.id.endsWith("-axes") && layer.id !== "space-axes";
    const ink = layer.id === "trail" ? view.trailed : layer.ink;
    swatch.style.color = `var(--${ink ?? "solid"})`;
    if (axes) swatch.classList.add("axes");
    const button = element("button", { type: "button", id: `layer-${layer.id}` }, swatch, layer.label);
    button.setAttribute("aria-pressed", String(layer.on[view.picture]));
    button.addEventListener("click", () => {
      view.toggle(layer);
      button.setAttribute("aria-pressed", String(layer.on[view.picture]));
    });
    host.append(button);
    if (layer.id === "trail") host.append(trailChoice(host, view));
  }
}

function trailChoice(host: HTMLElement, view: View): HTMLElement {
  const choice = element("select", { "aria-label": "What leaves the trail", id: "trail-of" });
  for (const [value, text] of Object.entries(TRAILS)) choice.append(element("option", { value }, text));
  choice.value = view.trailed;
  choice.addEventListener("change", () => {
    view.trailed = choice.value as Trailed;
    view.invalidate();
    fill(host, view);
    host.querySelector<HTMLElement>("#trail-of")?.focus();
  });
  return choice;
}

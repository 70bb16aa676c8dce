/** The pictures of the 3-D view, a line on each, and what it shows: the legend is made of switches. */
import type { SceneData } from "../data";
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
export function legend(view: View, captions: SceneData["captions"]): (picture: Picture) => void {
  const bar = byId("pictures");
  const host = byId("legend");
  const caption = byId("caption");
  const ride = byId<HTMLButtonElement>("ride");
  const show = (picture: Picture): void => {
    if (!view.pictures.includes(picture)) return;
    view.show(picture);
    for (const button of bar.querySelectorAll("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.picture === picture));
    }
    caption.textContent = captions[picture] ?? "";
    fill(host, view);
    name(ride, view);
  };
  // Room for the tallest of them: nothing is cut off, and the picture does not jump.
  const reserve = (): void => {
    const shown = view.picture;
    let [tall, long] = [0, 0];
    host.style.height = "";
    caption.style.height = "";
    for (const picture of view.pictures) {
      view.picture = picture;
      caption.textContent = captions[picture] ?? "";
      fill(host, view);
      tall = Math.max(tall, host.offsetHeight);
      long = Math.max(long, caption.offsetHeight);
    }
    view.picture = shown;
    caption.textContent = captions[shown] ?? "";
    fill(host, view);
    host.style.height = `${tall}px`;
    caption.style.height = `${long}px`;
  };
  let width = 0;
  new ResizeObserver(() => {
    if (host.clientWidth === width) return;
    width = host.clientWidth;
    reserve();
  }).observe(host);
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
  reserve();
  return show;
}

function name(ride: HTMLButtonElement, view: View): void {
  ride.textContent = view.rides === "space" ? "From space" : "From the body";
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
    // The choice stays beside its switch.
    host.append(layer.id === "trail" ? element("span", { class: "pair" }, button, trailChoice(host, view)) : button);
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

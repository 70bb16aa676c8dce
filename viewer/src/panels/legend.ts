/** Pictures of the 3-D view with their captions, and the legend, which consists of switches. */
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

export interface Legend {
  show: (picture: Picture) => void;
  /** Updates the captions for another motion. */
  update: (captions: SceneData["captions"]) => void;
}

export function legend(view: View, first: SceneData["captions"]): Legend {
  let captions = first;
  const bar = byId("pictures");
  const host = byId("legend");
  const caption = byId("caption");
  const ride = byId<HTMLButtonElement>("ride");
  const show = (picture: Picture): void => {
    if (!view.pictures.includes(picture)) return;
    view.show(picture);
    name(ride, view);
    refresh();
  };
  const refresh = (): void => {
    for (const button of bar.querySelectorAll("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.picture === view.picture));
    }
    caption.textContent = captions[view.picture] ?? "";
    fill(host, view);
    filled = signature(view);
  };
  let filled = "";
  // Reserves space for the tallest caption, so that nothing is cut off and the picture does not
  // move.
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
  const offer = (): void => {
    if (bar.children.length === view.pictures.length) return;
    bar.replaceChildren();
    for (const picture of view.pictures) {
      const button = element("button", { type: "button", click: () => show(picture) }, PICTURES[picture]);
      button.dataset.picture = picture;
      bar.append(button);
    }
    bar.hidden = view.pictures.length < 2;
  };
  offer();
  ride.addEventListener("click", () => {
    view.rides = view.rides === "space" ? "body" : "space";
    view.invalidate();
    name(ride, view);
  });
  byId("home").addEventListener("click", () => view.orbit.home());
  show("body");
  reserve();
  let [next, isRefilled] = [0, false];
  const update = (said: SceneData["captions"]): void => {
    captions = said;
    offer();
    const words = captions[view.picture] ?? "";
    if (filled !== signature(view)) {
      refresh();
      isRefilled = true;
    } else if (caption.textContent !== words) caption.textContent = words;
    else return;
    // In the next frame, in which the layout is computed in any case.
    cancelAnimationFrame(next);
    next = requestAnimationFrame(() => {
      if (isRefilled || caption.scrollHeight > caption.clientHeight) reserve();
      isRefilled = false;
    });
  };
  return { show, update };
}

/** Returns a short key for the contents of the legend. */
function signature({ layers, picture, trailed }: View): string {
  return `${picture} ${trailed} ${layers.filter(({ on }) => on[picture] !== undefined).map(({ id, label, on }) => `${id} ${label} ${on[picture]}`).join()}`;
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
    swatch.style.color = `var(--${ink ?? "part-1"})`;
    if (axes) swatch.classList.add("axes");
    const button = element("button", { type: "button", id: `layer-${layer.id}` }, swatch, layer.label);
    button.setAttribute("aria-pressed", String(layer.on[view.picture]));
    button.addEventListener("click", () => {
      // The layer of the current motion.
      const now = view.layers.find(({ id }) => id === layer.id);
      if (!now) return;
      view.toggle(now);
      button.setAttribute("aria-pressed", String(now.on[view.picture]));
    });
    // The choice stays next to its switch.
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

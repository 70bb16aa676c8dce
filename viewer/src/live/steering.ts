/**
 * Pointer on the track of a knob. A press on the thumb takes it where it is, a press elsewhere
 * brings it there; with Shift it moves ten times slower than the pointer.
 */
import { PLACES } from "./range";

/** Distance from the thumb's centre within which a press takes it, px. */
const GRIP = 14;
const FINE = 0.1;

/** Callbacks of a track. Places are slider positions from 0 to PLACES. */
export interface Steered {
  place: () => number;
  begin: () => void;
  go: (place: number, isFine: boolean) => void;
  end: () => void;
  type: () => void;
}

export class Steering {
  readonly #slider: HTMLInputElement;
  readonly #steered: Steered;
  #pointer: number | null = null;
  #x = 0;
  /** Place under the pointer; beyond the ends, the thumb waits there. */
  #place = 0;

  constructor(track: HTMLElement, slider: HTMLInputElement, steered: Steered) {
    this.#slider = slider;
    this.#steered = steered;
    track.addEventListener("pointerdown", (event) => this.#press(track, event));
    track.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"] as const) track.addEventListener(end, (event) => this.#release(event));
    track.addEventListener("dblclick", () => steered.type());
  }

  /** Diameter of the thumb, px. */
  get #thumb(): number {
    return Number.parseFloat(getComputedStyle(this.#slider).getPropertyValue("--thumb"));
  }

  get #length(): number {
    return Math.max(this.#slider.getBoundingClientRect().width - this.#thumb, 1);
  }

  #press(track: HTMLElement, event: PointerEvent): void {
    if (event.button !== 0 || this.#pointer !== null) return;
    // The focus stays with the slider, which has the keys.
    event.preventDefault();
    this.#slider.focus();
    track.setPointerCapture(event.pointerId);
    this.#pointer = event.pointerId;
    const place = this.#steered.place();
    this.#x = event.clientX;
    this.#place = place;
    this.#steered.begin();
    const box = this.#slider.getBoundingClientRect();
    const pressed = (PLACES * (event.clientX - box.left - this.#thumb / 2)) / this.#length;
    if (event.shiftKey || Math.abs(pressed - place) <= (PLACES * GRIP) / this.#length) return;
    this.#place = pressed;
    this.#go(false);
  }

  #move(event: PointerEvent): void {
    if (event.pointerId !== this.#pointer || event.clientX === this.#x) return;
    this.#place += ((event.shiftKey ? FINE : 1) * PLACES * (event.clientX - this.#x)) / this.#length;
    this.#x = event.clientX;
    this.#go(event.shiftKey);
  }

  #go(isFine: boolean): void {
    this.#steered.go(Math.min(Math.max(this.#place, 0), PLACES), isFine);
  }

  #release(event: PointerEvent): void {
    if (event.pointerId !== this.#pointer) return;
    this.#pointer = null;
    this.#steered.end();
  }
}

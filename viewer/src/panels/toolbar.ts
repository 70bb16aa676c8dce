/** Controls of the time: play, step, scrub, loop and speed. */
import type { Clock } from "../clock";
import { byId, icon } from "../dom";
import { number, powerOfTen, timeUnit } from "../format";

export function toolbar(clock: Clock): void {
  const play = byId<HTMLButtonElement>("play");
  const loop = byId<HTMLButtonElement>("loop");
  const scrub = byId<HTMLInputElement>("scrub");
  const now = byId("time");
  const speed = byId("speed");
  scrub.step = "any";
  scrub.addEventListener("input", () => {
    // Read before the clock sets this control back to the old time.
    const time = Number(scrub.value);
    clock.pause();
    clock.set(time);
  });
  play.addEventListener("click", () => clock.toggle());
  loop.addEventListener("click", () => clock.setLoop(!clock.loop));
  byId("step-back").addEventListener("click", () => clock.step(-1));
  byId("step-on").addEventListener("click", () => clock.step(1));
  byId("slower").addEventListener("click", () => clock.changeSpeed(-1));
  byId("faster").addEventListener("click", () => clock.changeSpeed(1));

  let times: Float64Array | null = null;
  let format = String as (seconds: number) => string;
  let unit = timeUnit(1);
  const fit = (): void => {
    times = clock.times;
    unit = timeUnit(Math.max(Math.abs(clock.end), Math.abs(clock.start)));
    const { name, seconds: size } = unit;
    const digits = Math.min(Math.max(3 - Math.floor(Math.log10((clock.end - clock.start) / size || 1)), 0), 6);
    format = (seconds) => (seconds / size).toFixed(digits).replace("-", "−");
    scrub.min = String(clock.start);
    scrub.max = String(clock.end);
    byId("time-end").textContent = `/ ${format(clock.end)} ${name}`;
    now.style.minWidth = `${Math.max(format(clock.end).length, format(clock.start).length)}ch`;
  };
  let shown: boolean | null = null;
  const update = (): void => {
    if (times !== clock.times) fit();
    if (shown !== clock.playing) {
      shown = clock.playing;
      play.replaceChildren(icon(shown ? "pause" : "play"));
      play.setAttribute("aria-label", shown ? "Pause" : "Play");
    }
    loop.setAttribute("aria-pressed", String(clock.loop));
    scrub.value = String(clock.time);
    const part = clock.end > clock.start ? (clock.time - clock.start) / (clock.end - clock.start) : 0;
    scrub.style.setProperty("--part", `${(100 * part).toFixed(2)}%`);
    now.textContent = format(clock.time);
    scrub.setAttribute("aria-valuetext", `${format(clock.time)} ${unit.name}`);
    speed.textContent = factor(clock.speed);
  };
  clock.subscribe(update);
  update();
}

/** Formats a speed: ×0.3, ×2000, ×5×10⁶, ×10⁻¹². */
function factor(speed: number): string {
  if (speed >= 1e-3 && speed < 1e5) return `×${number(speed, 1)}`;
  const isPower = Number(speed.toExponential().split("e")[0]) === 1;
  return `×${isPower ? powerOfTen(speed) : number(speed, 1)}`;
}

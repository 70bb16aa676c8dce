/** A picture of the 3-D view: the output of the renderer, with labels. */
import { ink as colour } from "../theme";
import type { PlacedLabel } from "./labels";

/**
 * Draws with `pen`, at `ratio` pixels for one of the page, on paper or on a transparent background.
 */
export function compose(pen: CanvasRenderingContext2D, drawn: HTMLCanvasElement, names: PlacedLabel[], ratio: number, paper: boolean): void {
  const { width, height } = drawn;
  pen.resetTransform();
  pen.clearRect(0, 0, width, height);
  if (paper) {
    pen.fillStyle = colour("paper");
    pen.fillRect(0, 0, width, height);
  }
  pen.drawImage(drawn, 0, 0);
  pen.scale(ratio, ratio);
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (const { text, ink, x, y, led, isOn, tipX, tipY, endX, endY } of names) {
    pen.font = [...text].length <= 2 ? '19px "Polhode Math"' : "600 13px system-ui, sans-serif";
    pen.fillStyle = colour(ink);
    pen.strokeStyle = colour(ink);
    if (led) {
      pen.globalAlpha = 0.6;
      pen.beginPath();
      pen.moveTo(tipX, tipY);
      pen.lineTo(endX, endY);
      pen.stroke();
      pen.globalAlpha = 1;
    }
    if (isOn) {
      pen.strokeStyle = colour("paper");
      pen.lineWidth = 4;
      pen.lineJoin = "round";
      pen.strokeText(text, x, y);
      pen.lineWidth = 1;
    }
    pen.fillText(text, x, y);
  }
}

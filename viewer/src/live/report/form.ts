/** Questions about a table: its kind, the options of its command, and the scenario of a run. */
import { element } from "../../dom";
import type { Field, Options, TableContent, TableKind } from "../protocol";

/** Asks of which kind a table is, and says what each means. */
export function kindQuestion(name: string, { kinds }: TableContent, chosen: TableKind | null, choose: (kind: TableKind) => void): HTMLElement {
  const options = kinds.map(({ kind, what }) => {
    const input = element("input", { type: "radio", name: "table-kind", value: kind });
    input.checked = kind === chosen;
    input.addEventListener("change", () => choose(kind));
    return element("label", {}, input, element("span", {}, what));
  });
  return element("fieldset", { class: "table-kind" }, element("legend", {}, `What is ${name}?`), ...options);
}

/**
 * Creates the fields of a command's options. `changed` is called after each change of `options`.
 * `areNeeded` shows them.
 */
export function optionFields(fields: Field[], options: Options, areNeeded: boolean, changed: () => void): HTMLElement {
  const rows = fields.map((field) => {
    const { key, what } = field;
    const id = `option-${key}`;
    const input = control(field, options[key]);
    input.id = id;
    input.setAttribute("aria-describedby", `${id}-what`);
    input.addEventListener("change", () => {
      const value = valueOf(field, input);
      if (value === null) delete options[key];
      else options[key] = value;
      changed();
    });
    return element("div", { class: "option" }, element("label", { for: id }, key), input, element("p", { class: "hint", id: `${id}-what` }, what));
  });
  return element("details", { class: "options", open: areNeeded || Object.keys(options).length > 0 }, element("summary", {}, "Options"), ...rows);
}

function control({ form, choices }: Field, value: string | number | boolean | undefined): HTMLInputElement | HTMLSelectElement {
  if (form === "choice") {
    const select = element("select", {}, element("option", { value: "" }, "–"), ...choices.map((one) => element("option", { value: one }, one)));
    select.value = String(value ?? "");
    return select;
  }
  const types = { text: "text", integer: "number", flag: "checkbox" };
  const input = element("input", { type: types[form], autocomplete: "off", spellcheck: "false" });
  if (form === "flag") input.checked = value === true;
  else input.value = String(value ?? "");
  return input;
}

/** Returns the value of a control; null if it has none. */
function valueOf({ form }: Field, input: HTMLInputElement | HTMLSelectElement): string | number | boolean | null {
  if (input instanceof HTMLInputElement && form === "flag") return input.checked || null;
  const text = input.value.trim();
  if (text === "") return null;
  return form === "integer" ? Number(text) : text;
}

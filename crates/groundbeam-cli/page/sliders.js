// A slider and an input field for every number of the model file.

const MOST = 60;
const STEPS = 1000;
/// Ranges stay fixed while a slider moves, so that the slider follows the pointer.
const ranges = new Map();
let signature = "";
let rows = [];
let edits = null;
let shown = null;

export function sliders(answer, made) {
  shown = answer;
  edits = made;
  const numbers = answer.numbers.slice(0, MOST);
  const now = numbers.map((n) => `${n.table}${n.which}${n.key}`).join("|") + addable().join("|");
  if (now !== signature) {
    signature = now;
    build(numbers);
  }
  rows.forEach((row, i) => update(row, numbers[i]));
}

const valueOf = ({ from, to, decimal }) =>
  decimal?.[0] ?? Number(shown.text.slice(from, to).replaceAll("_", "").replace("\u2212", "-"));

/// The unit that a slider writes.
const unitOf = ({ unit, decimal }) => decimal?.[1] ?? unit;

/// Frequent keys that the file leaves out.
function addable() {
  const has = (table, key) => shown.numbers.some((n) => n.table === table && n.key === key);
  const wants = [];
  if (!has("[beam]", "axial_force")) wants.push("axial_force");
  const soil = shown.numbers.some((n) => n.table === "[foundation.soil]");
  if (!has("[foundation]", "mu") && !has("[foundation]", "C2") && !soil) wants.push("mu");
  return wants;
}

function build(numbers) {
  const groups = new Map();
  const counts = new Map();
  rows = numbers.map((number, i) => {
    const group = `${number.table}${number.which > 0 ? ` ${number.which}` : ""}`;
    if (!groups.has(group)) {
      const set = document.createElement("fieldset");
      const legend = document.createElement("legend");
      legend.textContent = group;
      set.append(legend);
      groups.set(group, set);
    }
    const row = document.createElement("div");
    row.className = "number";
    const label = document.createElement("span");
    label.textContent = number.key.replaceAll("_", " ");
    const slider = Object.assign(document.createElement("input"), { type: "range", min: 0, max: STEPS, step: "any" });
    const field = Object.assign(document.createElement("input"), { type: "text", spellcheck: false });
    for (const input of [slider, field]) input.setAttribute("aria-label", `${group} ${label.textContent}`);
    // Each number of a list has its own range.
    const key = `${number.table}${number.which || ""}.${number.key}`;
    const count = (counts.get(key) ?? 0) + 1;
    counts.set(key, count);
    slider.dataset.key = count > 1 ? `${key} ${count}` : key;
    let gesture = null;
    slider.addEventListener("input", () => {
      gesture ??= edits.begin();
      if (gesture) edits.set(gesture, i, from(slider.value / STEPS, ranges.get(slider.dataset.key)));
    });
    for (const end of ["change", "blur"]) {
      slider.addEventListener(end, () => {
        gesture = null;
      });
    }
    field.addEventListener("change", () => typed(field, i));
    row.append(label, slider, field);
    groups.get(group).append(row);
    return { slider, field, isHeld: () => gesture !== null };
  });
  for (const key of addable()) {
    const group = groups.get(key === "mu" ? "[foundation]" : "[beam]");
    if (group) group.append(adder(key));
  }
  document.getElementById("sliders").replaceChildren(...groups.values());
}

/// A button that adds a missing quantity as zero below the heading of its table.
function adder(key) {
  const button = document.createElement("button");
  button.textContent = key === "mu" ? "add μ, a shear layer" : "add P, an axial force";
  button.addEventListener("click", () => {
    const gesture = edits.begin();
    const heading = key === "mu" ? /^\[foundation\][^\n]*\n/m : /^\[beam\][^\n]*\n/m;
    const found = gesture && heading.exec(gesture.text);
    if (!found) return;
    const at = found.index + found[0].length;
    edits.replace(gesture, at, at, `${key} = ${shown.has_units ? `"0 ${shown.force}"` : "0"}\n`);
  });
  return button;
}

/// Replaces number and unit by the typed text, valid or not.
function typed(field, i) {
  const gesture = edits.begin();
  if (!gesture) return;
  const { from, to, unit } = gesture.numbers[i];
  const end = unit === "" ? to : gesture.text.indexOf(unit, to) + unit.length;
  // In a string with double quotes, the sign of inches is escaped.
  const isBasic = gesture.text.slice(0, from).trimEnd().endsWith('"');
  edits.replace(gesture, from, end, isBasic ? field.value.trim().replaceAll('"', '\\"') : field.value.trim());
}

function update({ slider, field, isHeld }, number) {
  const value = valueOf(number);
  const key = slider.dataset.key;
  let range = ranges.get(key);
  if (!range || range.unit !== unitOf(number) || value < range.low || value > range.high) {
    range = rangeOf(number, value);
    ranges.set(key, range);
  }
  if (!isHeld()) slider.value = STEPS * to(value, range);
  const words = [shown.text.slice(number.from, number.to), number.unit].filter(Boolean).join(" ").replaceAll('\\"', '"');
  slider.setAttribute("aria-valuetext", words);
  if (document.activeElement !== field) field.value = words;
}

/// The range of a slider, from the sign and body that the server reports, and from the value.
function rangeOf(number, value) {
  const { size, sign, place, usual } = number;
  const unit = unitOf(number);
  if (place) {
    // The ground extends beyond the beam.
    const beside = place === "ground" ? (0.5 * shown.length) / size : 0;
    return { unit, low: Math.min(-beside, value), high: Math.max(shown.length / size + beside, value) };
  }
  if (sign === "positive") return { unit, low: value / 10, high: value * 10, log: true };
  const high = value === 0 ? wide(usual / size, size) : 3 * Math.abs(value);
  return { unit, low: sign === "any" ? -high : 0, high };
}

/// The upper limit for a number that is zero. Without units, the sum of the loads gives the scale.
function wide(usual, size) {
  if (shown.has_units) return 5 * usual;
  return (5 * Math.abs(shown.document.characteristics?.resultant?.force ?? 0)) / size || 100;
}

const to = (value, { low, high, log }) =>
  log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low || 1);

/// The value at a fraction of the slider, rounded to the resolution of the slider.
function from(share, { low, high, log }) {
  if (log) return Number((low * (high / low) ** share).toPrecision(3));
  const value = low + share * (high - low);
  const step = 10 ** Math.floor(Math.log10((high - low) / 200));
  return Number((Math.round(value / step) * step).toPrecision(8));
}

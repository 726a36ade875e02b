// The page: a model text, its picture, and controls that change the text. The server solves the model and draws it.

import { Picture } from "./picture.js";
import { keep, packed, unpacked } from "./share.js";
import { sliders } from "./sliders.js";
import { Text } from "./text.js";

const the = (id) => document.getElementById(id);
const note = (words) => {
  the("note").textContent = words;
};

let name = "model";
/// Units and digits of the command line; null without such an option.
const printed = { units: null, digits: null };
/// The part of the file that is shown. `train` is an index or "all"; null until a response lists the trains.
const choice = { combination: null, train: null, firstAxle: null };
/// The last response, with its text.
let shown = null;
let wanted = false;
/// The open request: its start time, and its abort controller.
let request = null;
/// A new request aborts an open one that is older than this [ms]. The limit doubles with every abort until a response
/// arrives, so that a drag on a slow model still shows pictures.
const ABORT_AFTER = 300;
let abortAfter = ABORT_AFTER;

const text = new Text(() => {
  the("undo").disabled = !text.canUndo;
  the("redo").disabled = !text.canRedo;
  look();
});
const picture = new Picture({ begin, position, move, grow });

/// The choice as a query. A report covers the whole file, so it has no train.
function query(form) {
  const asked = new URLSearchParams();
  if (form === "view" && picture.width > 0) asked.set("width", picture.width);
  for (const key of ["units", "digits"]) if (printed[key] !== null) asked.set(key, printed[key]);
  if (choice.combination) asked.set("combination", choice.combination);
  if (choice.train !== null && form !== "html") {
    asked.set("train", choice.train);
    if (choice.firstAxle !== null && choice.train !== "all") asked.set("first_axle", choice.firstAxle);
  }
  return asked;
}

class Unreachable extends Error {}

async function post(address, body, signal) {
  try {
    return await fetch(address, { method: "POST", headers: { "Content-Type": "application/toml" }, body, signal });
  } catch {
    throw new Unreachable("the server of this page has stopped; start `groundbeam serve` again");
  }
}

/// Sends one request at a time. Of the changes that happen meanwhile, only the last one is sent.
async function look() {
  wanted = true;
  document.body.dataset.state = "waiting";
  if (request) return replaceRequest();
  while (wanted) {
    wanted = false;
    await ask(text.value);
  }
  document.body.dataset.state = "settled";
}

async function ask(asked) {
  const controller = new AbortController();
  request = { controller, began: performance.now(), timer: null };
  try {
    const reply = await post(`/api/view?${query("view")}`, asked, controller.signal);
    show(await answerOf(reply), asked);
    abortAfter = ABORT_AFTER;
  } catch (error) {
    if (controller.signal.aborted) abortAfter *= 2;
    else verdict(error instanceof Unreachable ? "No connection" : "No response", error.message, "wrong");
  } finally {
    clearTimeout(request.timer);
    request = null;
  }
}

/// Aborts the open request when it is older than the limit.
function replaceRequest() {
  const { controller, began } = request;
  clearTimeout(request.timer);
  request.timer = setTimeout(() => controller.abort(), began + abortAfter - performance.now());
}

/// The JSON of a response. Any other response gives an error with its status and text.
async function answerOf(reply) {
  const words = await reply.text();
  try {
    return JSON.parse(words);
  } catch {
    throw new Error(`the server responded with ${reply.status} ${reply.statusText}: ${words.slice(0, 300)}`);
  }
}

function verdict(head, words, state) {
  const bold = document.createElement("b");
  bold.textContent = `${head}: `;
  the("verdict").replaceChildren(bold, words);
  document.body.classList.toggle("wrong", state === "wrong");
  document.body.classList.toggle("lost", state === "lost");
}

function show(answer, asked) {
  if (answer.status === "refused") return refused(answer);
  if (answer.status === "wrong-model") {
    const faults = answer.diagnostics ?? [];
    const first = faults[0];
    const words = first ? `line ${first.line}: ${first.message}` : answer.message;
    verdict("Error in the model file", words, "wrong");
    text.show(faults);
    return;
  }
  const wasLost = document.body.classList.contains("lost");
  shown = { ...answer, text: asked, document: JSON.parse(answer.document) };
  text.show([]);
  const heads = { solved: "In equilibrium", "no-equilibrium": "No equilibrium", "not-converged": "Not converged" };
  const states = { solved: "right", "no-equilibrium": "lost", "not-converged": "wrong" };
  verdict(heads[answer.status], answer.sentence, states[answer.status]);
  if (answer.picture?.svg) picture.show(answer.picture, answer.length, answer.shown_in);
  if (answer.status === "no-equilibrium" && !wasLost) picture.tip();
  the("hint").hidden = !answer.picture?.handles.length;
  results(answer.rows);
  the("report").textContent = answer.report;
  document.title = answer.title ? `${answer.title}: groundbeam` : "groundbeam";
  choices(answer);
  sliders(shown, { begin, set: setNumber, replace });
}

/// Resets a choice that is no longer in the text, and units that a text without units cannot have. Shows any other refusal.
function refused({ query: at, message }) {
  if (at?.key === "units" && printed.units !== null) {
    printed.units = null;
    wanted = true;
    return;
  }
  const forget = { combination: ["combination"], train: ["train", "firstAxle"], first_axle: ["firstAxle"] }[at?.key] ?? [];
  if (forget.every((key) => choice[key] === null)) return verdict("Invalid request", message, "wrong");
  for (const key of forget) choice[key] = null;
  wanted = true;
}

function results(rows) {
  const cell = (kind, words) => Object.assign(document.createElement(kind), { textContent: words });
  the("results").tBodies[0].replaceChildren(
    ...rows.map(([label, words]) => {
      const row = document.createElement("tr");
      row.append(cell("th", label), cell("td", words));
      return row;
    }),
  );
}

/// Fills the lists of combinations and trains.
function choices({ combinations, trains, shown_in: shownIn }) {
  const fill = (select, entries, chosen) => {
    const made = entries.map(([value, words]) => new Option(words, value, false, value === chosen));
    if (JSON.stringify(entries) !== select.dataset.entries) {
      select.replaceChildren(...made);
      select.dataset.entries = JSON.stringify(entries);
    }
    select.value = chosen;
  };
  if (choice.combination && !combinations.includes(choice.combination)) choice.combination = null;
  if (combinations.length > 0 && choice.combination === null) {
    choice.combination = combinations[0];
    wanted = true;
  }
  fill(
    the("combination"),
    [["", `all ${combinations.length}: the envelope`], ...combinations.map((name) => [name, name])],
    choice.combination ?? "",
  );
  if (trains.length > 0) choice.train ??= 0;
  const onWay = trains.map((train, i) => [`${i}`, `${train.name}, at one position`]);
  fill(the("train"), [...onWay, ["all", "all positions: the envelope"]], `${choice.train}`);
  const train = trains[choice.train];
  the("combination-choice").hidden = combinations.length === 0;
  the("train-choice").hidden = trains.length === 0;
  the("axle-choice").hidden = !train;
  the("choices").hidden = combinations.length + trains.length === 0;
  if (!train) return;
  const at = Math.min(train.to, Math.max(train.from, choice.firstAxle ?? 0.5 * (train.from + train.to)));
  const axle = the("axle");
  axle.value = Math.round((1000 * (at - train.from)) / (train.to - train.from));
  const words = `${Number((at / shownIn.size).toPrecision(4))} ${shownIn.name}`.trim();
  axle.setAttribute("aria-valuetext", words);
  the("axle-at").textContent = words;
}

let latest = null;

/// Begins a gesture, which changes numbers of the text relative to its start. Returns null while the response to typed
/// text is outstanding. A gesture that follows before the response to the last one continues it.
function begin() {
  if (shown?.text === text.value) {
    latest = { text: shown.text, numbers: shown.numbers, edits: new Map() };
  } else if (latest?.now !== text.value) {
    return null;
  }
  return latest;
}

/// Replaces the text between two positions of the initial text.
function replace(gesture, from, to, words) {
  gesture.edits.set(from, { from, to, words });
  const backward = [...gesture.edits.values()].sort((a, b) => b.from - a.from);
  gesture.now = backward.reduce((made, edit) => made.slice(0, edit.from) + edit.words + made.slice(edit.to), gesture.text);
  text.set(gesture.now, gesture);
}

function setNumber(gesture, index, value) {
  const { from, to, decimal } = gesture.numbers[index];
  replace(gesture, from, to, decimal ? `${value} ${decimal[1]}` : `${value}`);
}

function valueOf(gesture, index) {
  const { from, to, decimal } = gesture.numbers[index];
  const edited = gesture.edits.get(from)?.words;
  if (decimal) return edited ? Number.parseFloat(edited) : decimal[0];
  const words = edited ?? gesture.text.slice(from, to);
  return Number(words.replaceAll("_", "").replace("\u2212", "-"));
}

function position(gesture, handle) {
  return valueOf(gesture, handle.position) * gesture.numbers[handle.position].size;
}

function move(gesture, handle, x) {
  setNumber(gesture, handle.position, Number((x / gesture.numbers[handle.position].size).toPrecision(10)));
}

function grow(gesture, handle, factor) {
  if (handle.size === null) return;
  setNumber(gesture, handle.size, Number((valueOf(gesture, handle.size) * factor).toPrecision(4)));
}

function open(model) {
  Object.assign(choice, { combination: null, train: null, firstAxle: null });
  name = model.name.replace(/\.toml$/, "").replace(/[^\w.-]+/g, "-") || "model";
  text.set(model.text);
}

async function download(form) {
  note("");
  if (form === "toml") return keep(new Blob([text.value], { type: "application/toml" }), `${name}.toml`);
  try {
    const reply = await post(`/api/file/${form}?${query(form)}`, text.value);
    if (reply.ok) keep(await reply.blob(), `${name}.${form}`);
    else note((await answerOf(reply)).message);
  } catch (error) {
    note(error.message);
  }
}

async function share() {
  history.replaceState(null, "", await packed(text.value));
  try {
    await navigator.clipboard.writeText(location.href);
    note("address copied");
  } catch {
    note("the address bar now contains the model");
  }
}

async function fromAddress() {
  try {
    const model = await unpacked(location.hash);
    if (model !== null) open({ name: "model", text: model });
    return model !== null;
  } catch (error) {
    note(`the model in this address cannot be read: ${error.message}`);
    return false;
  }
}

async function start() {
  const { start, examples, units, digits } = await (await fetch("/api/start")).json();
  Object.assign(printed, { units, digits });
  the("examples").append(new Option("…", ""), ...examples.map(({ name }, i) => new Option(name, i)));
  the("examples").addEventListener("change", ({ target }) => {
    if (target.value !== "") open(examples[target.value]);
    target.value = "";
  });
  if (!(await fromAddress())) open(start ?? examples[0]);
}

the("undo").addEventListener("click", () => text.undo());
the("redo").addEventListener("click", () => text.redo());
the("share").addEventListener("click", share);
the("downloads").addEventListener("click", ({ target }) => target.dataset.form && download(target.dataset.form));
the("combination").addEventListener("change", ({ target }) => {
  choice.combination = target.value;
  look();
});
the("train").addEventListener("change", ({ target }) => {
  choice.train = target.value === "all" ? "all" : Number(target.value);
  choice.firstAxle = null;
  look();
});
the("axle").addEventListener("input", ({ target }) => {
  const { from, to } = shown.trains[choice.train];
  choice.firstAxle = Math.min(to, from + ((to - from) * target.value) / 1000);
  look();
});
document.addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return;
  event.preventDefault();
  if (key === "y" || event.shiftKey) text.redo();
  else text.undo();
});
window.addEventListener("hashchange", fromAddress);
let resized = 0;
window.addEventListener("resize", () => {
  clearTimeout(resized);
  resized = setTimeout(look, 150);
});
start();

// The editor: the model's text, its undo history, and the faults at their lines.

const PAUSE = 700; // Typing with shorter pauses [ms] is undone as one change.

const escape = (words) => words.replace(/[&<>]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;" })[c]);

export class Text {
  #area = document.getElementById("text");
  #gutter = document.getElementById("gutter");
  #behind = document.getElementById("behind");
  #faults = [];
  #past = [];
  #future = [];
  #gesture = null;
  #changed;

  constructor(changed) {
    this.#changed = changed;
    this.#area.addEventListener("input", () => {
      const now = performance.now();
      const goesOn = this.#gesture?.kind === "typing" && now - this.#gesture.at < PAUSE;
      this.#take(this.#area.value, goesOn ? this.#gesture : { kind: "typing" });
      this.#gesture.at = now;
    });
    this.#area.addEventListener("scroll", () => this.#scroll());
  }

  get value() {
    return this.#last ?? "";
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  #last = null;

  /// Changes the text. Changes of one gesture are undone together.
  set(value, gesture = {}) {
    this.#take(value, gesture);
    this.#area.value = value;
  }

  #take(value, gesture) {
    if (value === this.#last) return;
    if (this.#last !== null && gesture !== this.#gesture) {
      this.#past.push(this.#last);
      if (this.#past.length > 500) this.#past.shift();
    }
    this.#future = [];
    this.#gesture = gesture;
    this.#last = value;
    this.#draw();
    this.#changed();
  }

  undo() {
    this.#swap(this.#past, this.#future);
  }

  redo() {
    this.#swap(this.#future, this.#past);
  }

  #swap(from, to) {
    if (from.length === 0) return;
    to.push(this.#last);
    this.#last = from.pop();
    this.#gesture = null;
    this.#area.value = this.#last;
    this.#draw();
    this.#changed();
  }

  /// Shows faults with line, column, message and hint; the list may be empty.
  show(faults) {
    this.#faults = faults;
    this.#draw();
    const list = document.getElementById("faults");
    list.replaceChildren(
      ...faults.slice(0, 20).map((fault) => {
        const item = document.createElement("li");
        const place = document.createElement("button");
        place.textContent = `line ${fault.line}`;
        place.addEventListener("click", () => this.#goTo(fault));
        const hint = fault.hint ? `. ${fault.hint}` : "";
        item.append(place, `${fault.message}${hint} (${fault.code})`);
        return item;
      }),
    );
  }

  #goTo(fault) {
    const lines = this.value.split("\n");
    const before = lines.slice(0, fault.line - 1).reduce((sum, line) => sum + line.length + 1, 0);
    const skipped = [...(lines[fault.line - 1] ?? "")].slice(0, fault.column - 1).join("").length;
    this.#area.focus();
    this.#area.setSelectionRange(before + skipped, before + skipped);
  }

  #draw() {
    const lines = this.value.split("\n");
    const at = new Map(this.#faults.map((fault) => [fault.line, fault]).reverse());
    this.#gutter.innerHTML = lines
      .map((_, i) => (at.has(i + 1) ? `<span class="fault">${i + 1}</span>` : `${i + 1}`))
      .join("\n");
    this.#behind.innerHTML = lines
      .map((line, i) => {
        const fault = at.get(i + 1);
        if (!fault) return `<div>${escape(line) || " "}</div>`;
        return `<div class="fault">${escape(line)}<span class="says">${escape(fault.message)}</span></div>`;
      })
      .join("");
    this.#scroll();
  }

  #scroll() {
    const { scrollTop, scrollLeft } = this.#area;
    this.#gutter.scrollTop = scrollTop;
    this.#behind.style.transform = `translate(${-scrollLeft}px, ${-scrollTop}px)`;
  }
}

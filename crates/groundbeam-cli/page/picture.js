// The picture that the server draws, and the handles on top of it.

const SVG = "http://www.w3.org/2000/svg";

const element = (name, attributes = {}) => {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
};

export class Picture {
  #drawing = document.getElementById("drawing");
  #grips = element("svg", { class: "grips" });
  #shown = null;
  #held = null;
  #edits;

  /// `edits` changes the text: it begins a gesture, returns the position of a handle, moves it, and changes its size.
  constructor(edits) {
    this.#edits = edits;
    this.#drawing.append(this.#grips);
    this.#grips.addEventListener("pointermove", (event) => this.#drag(event));
    for (const end of ["pointerup", "pointercancel"]) {
      this.#grips.addEventListener(end, (event) => this.#release(event));
    }
  }

  get width() {
    return this.#drawing.clientWidth;
  }

  /// Positions are said in the unit `shownIn`.
  show(picture, length, shownIn) {
    this.#shown = { ...picture, length, shownIn };
    const parsed = new DOMParser().parseFromString(picture.svg, "image/svg+xml").documentElement;
    const drawn = document.importNode(parsed, true);
    drawn.removeAttribute("width");
    drawn.removeAttribute("height");
    // The handles remain in the document, because removed elements lose focus and pointer capture.
    const before = this.#drawing.querySelector("svg:not(.grips)");
    if (before) before.replaceWith(drawn);
    else this.#drawing.prepend(drawn);
    this.#grips.setAttribute("viewBox", drawn.getAttribute("viewBox"));
    picture.handles.forEach((handle, i) => this.#place(handle, i));
    while (this.#grips.children.length > picture.handles.length) this.#grips.lastChild.remove();
  }

  /// Animates the beam from its unloaded position to the drawn one.
  tip() {
    const moves = this.#drawing.querySelector(".moves[data-still]");
    if (!moves || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    const lying = { transform: moves.dataset.still, transformOrigin: "0 0" };
    moves.animate([lying, { transform: "matrix(1, 0, 0, 1, 0, 0)", transformOrigin: "0 0" }], {
      duration: 900,
      easing: "cubic-bezier(.45, 0, .9, .6)",
    });
  }

  /// Reuses existing elements, so that a drag keeps its pointer capture when the picture changes.
  #place(handle, i) {
    let grip = this.#grips.children[i];
    if (!grip) {
      grip = element("g", { class: "grip", tabindex: "0", role: "slider" });
      grip.append(element("circle", { r: "15" }));
      grip.addEventListener("pointerdown", (event) => this.#take(event, i));
      grip.addEventListener("keydown", (event) => this.#key(event, i));
      this.#grips.append(grip);
    }
    const { name, size } = this.#shown.shownIn;
    const attributes = {
      transform: `translate(${handle.x} ${handle.y})`,
      "aria-label": handle.name,
      "aria-valuemin": handle.range[0],
      "aria-valuemax": handle.range[1],
      "aria-valuenow": handle.at,
      "aria-valuetext": `at ${Number((handle.at / size).toPrecision(5))} ${name}`.trim(),
    };
    for (const [key, value] of Object.entries(attributes)) grip.setAttribute(key, value);
  }

  #at(event) {
    const box = this.#grips.getBoundingClientRect();
    return ((event.clientX - box.left) * this.#shown.width) / box.width;
  }

  #take(event, i) {
    const handle = this.#shown.handles[i];
    const gesture = this.#edits.begin();
    if (!gesture) return;
    // `off`: distance of the pointer from the handle.
    this.#held = { i, gesture, handle, off: this.#at(event) - handle.x };
    this.#grips.setPointerCapture(event.pointerId);
    this.#grips.children[i].classList.add("held");
    this.#grips.children[i].focus();
    event.preventDefault();
  }

  #drag(event) {
    if (!this.#held) return;
    const { gesture, handle, off } = this.#held;
    const { left, scale } = this.#shown;
    this.#edits.move(gesture, handle, this.#rounded((this.#at(event) - off - left) / scale, handle));
  }

  #release() {
    if (!this.#held) return;
    this.#grips.children[this.#held.i]?.classList.remove("held");
    this.#held = null;
  }

  /// A round number near x, with a step of about one pixel.
  #rounded(x, { range }) {
    const { width, scale } = this.#shown;
    const pixel = width / (this.#grips.getBoundingClientRect().width || width) / scale;
    const power = 10 ** Math.floor(Math.log10(pixel));
    const step = [1, 2, 5, 10].map((lead) => lead * power).find((s) => s >= pixel);
    return Math.min(range[1], Math.max(range[0], Number((Math.round(x / step) * step).toPrecision(12))));
  }

  #key(event, i) {
    const { length } = this.#shown;
    const fine = event.shiftKey ? 0.001 : 0.01;
    const moves = { ArrowLeft: -fine, ArrowRight: fine, Home: -Infinity, End: Infinity };
    const grows = { ArrowUp: 1.05, ArrowDown: 1 / 1.05 };
    const handle = this.#shown.handles[i];
    if (!(event.key in moves) && !(event.key in grows)) return;
    event.preventDefault();
    const gesture = this.#edits.begin();
    if (!gesture) return;
    if (event.key in moves) {
      const at = this.#edits.position(gesture, handle);
      const x = Math.min(handle.range[1], Math.max(handle.range[0], at + moves[event.key] * length));
      this.#edits.move(gesture, handle, Number(x.toPrecision(8)));
    } else {
      this.#edits.grow(gesture, handle, grows[event.key]);
    }
  }
}

// The slider with plots over all frames of the page.
const plotHeight = 56;
const plotTicks = 6; // labels below the plot

const mostColumns = 1500; // More frames than this share columns of the plot.

const plotNames = ["speed", "objects", "steering", "throttle", "brake", "yawRate", "acceleration", ...data.indicatorTable.map(([name]) => name)];

/** What can be plotted: name, label, value of a frame or null. */
function plots() {
  const known = name => [0, 1, 2].some(index => index < source.known && source.value(name, index) !== null);
  const ego = (name, label) => known(name) ? [[name, label, index => source.value(name, index)]] : [];
  const hasLanes = data.indicatorTable.some(([name]) => { for (let i = 0; i < Math.min(source.known, 2000); i++) if (source.value(name, i) !== null) return true; return false; });
  return [
    ["speed", "Speed, km/h", index => { const speed = source.value("speed", index); return speed === null ? null : speed * 3.6; }],
    ["objects", "Objects", index => matchCounts[index] ?? null],
    ...ego("steering", "Steering, -1 to 1"), ...ego("throttle", "Throttle, 0 to 1"), ...ego("brake", "Brake, 0 to 1"),
    ...ego("yawRate", "Yaw rate, rad/s"), ...ego("acceleration", "Acceleration, m/s²"),
    ...(hasLanes ? data.indicatorTable.map(([name, unit]) => [name, `${name}, ${unit}`, index => source.value(name, index)]) : []),
  ];
}

const plotted = () => plots().find(([name]) => name === state.plot) ?? plots()[0];

/** Draws the plot with gaps where there is no value, and below it where the followed object and filtered objects appear. */
function drawTimeline() {
  const [, label, valueOf] = plotted();
  const size = Math.max(1, Math.ceil(source.count / mostColumns));
  let least = Infinity, greatest = -Infinity;
  const columns = [];
  for (let first = 0; first < source.known; first += size) {
    let low = Infinity, high = -Infinity;
    for (let index = first; index < Math.min(first + size, source.known); index++) {
      const value = valueOf(index);
      if (value !== null) { low = Math.min(low, value); high = Math.max(high, value); }
    }
    columns.push([low, high]);
    least = Math.min(least, low);
    greatest = Math.max(greatest, high);
  }
  const hasValues = least <= greatest;
  const span = greatest - least || 1;
  const heightOf = value => (plotHeight - 4 - (value - least) / span * (plotHeight - 8)).toFixed(1);
  let path = "", isDrawing = false;
  columns.forEach(([low, high], column) => {
    const x = column * size + size / 2;
    if (low <= high) path += `${isDrawing ? "L" : "M"}${x} ${heightOf(high)}${low < high ? `V${heightOf(low)}` : "h.01"}`;
    isDrawing = low <= high;
  });
  const seen = state.chosen === null ? [] : source.sightings(state.chosen).map(({ index }) => index);
  const matched = isFiltered() ? matchCounts.flatMap((count, index) => count > 0 ? [index] : []) : [];
  const bars = [["matches", matched], ["followed", seen]].filter(([, indices]) => indices.length > 0)
    .map(([name, indices], row) => shape("path", { d: runsOf(indices, size).map(([from, to]) => `M${from} ${plotHeight + 4 + 6 * row}H${to}`).join(""), class: `bar ${name}` }));
  const drawing = byId("plot");
  drawing.setAttribute("viewBox", `0 0 ${Math.max(1, source.count)} ${plotHeight + 12}`);
  drawing.setAttribute("aria-label", hasValues ? `${label}: ${fixed(least, 2)} to ${fixed(greatest, 2)}` : `${label}: no values`);
  const lines = hasValues ? [greatest, (least + greatest) / 2, least] : [];
  const grid = lines.map(value => shape("line", { x1: 0, x2: Math.max(1, source.count), y1: heightOf(value), y2: heightOf(value), class: "grid" }));
  drawAxes(lines);
  drawing.replaceChildren(...grid, shape("path", { d: path, class: "values" }), ...bars, shape("line", { id: "cursor", y1: 0, y2: plotHeight + 12, class: "cursor" }));
  byId("plot-range").textContent = hasValues ? `${fixed(least, 2)} to ${fixed(greatest, 2)}` : "no values";
  moveCursor();
}

/** Labels the values at the lines of the plot, and frames below it. The plot itself is stretched, which would distort letters. */
function drawAxes(lines) {
  const shown = new Set(lines.map(value => fixed(value, 1))).size < lines.length ? lines.slice(0, 1) : lines;
  byId("plot-values").replaceChildren(...shown.map(value => element("span", {}, fixed(value, 1))));
  const ticks = Math.min(plotTicks, Math.max(1, source.count));
  const places = Array.from({ length: ticks }, (_, tick) => ticks === 1 ? 0 : Math.round(tick * (source.count - 1) / (ticks - 1)));
  byId("plot-frames").replaceChildren(...places.map((index, tick) => element("span", {}, `${tick === 0 ? "frame " : ""}${source.number(index)}`)));
}

/** Ascending places as runs from a place to the one after the last; runs that are closer than a column are one. */
function runsOf(indices, size) {
  const runs = [];
  for (const index of indices) {
    if (runs.length > 0 && index - runs.at(-1)[1] < size) runs.at(-1)[1] = index + 1;
    else runs.push([index, index + 1]);
  }
  return runs;
}

function moveCursor() {
  for (const end of ["x1", "x2"]) byId("cursor")?.setAttribute(end, state.index + 0.5);
  const [, , valueOf] = plotted();
  byId("plot-value").textContent = fixed(valueOf(state.index), 2).replace("not determined", "none");
}

function offerPlots() {
  byId("plot-name").replaceChildren(...plots().map(([name, label]) => element("option", { value: name }, label)));
  byId("plot-name").value = plotted()[0];
}

/** Makes a strip that shows all frames from left to right go to the one that is pressed. */
function seekAlong(strip) {
  const seek = event => {
    const box = strip.getBoundingClientRect();
    play(false);
    show(Math.min(source.count - 1, Math.max(0, Math.floor((event.clientX - box.left) / box.width * source.count))));
  };
  strip.addEventListener("pointerdown", event => { strip.setPointerCapture(event.pointerId); seek(event); });
  strip.addEventListener("pointermove", event => { if (event.buttons & 1) seek(event); });
}

function listenToTimeline() {
  offerPlots();
  byId("plot-name").addEventListener("change", event => { state.plot = event.target.value; drawTimeline(); remember(); });
  seekAlong(byId("plot"));
}

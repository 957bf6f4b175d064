// The slider with plots over all frames of the page.
const plotHeight = 56;

/** What can be plotted: name, label, value of a frame or null. */
function plots() {
  const ego = (name, label) => data.frames.some(frame => typeof frame.ego[name] === "number") ? [[name, label, frame => frame.ego[name] ?? null]] : [];
  return [
    ["speed", "Speed, km/h", frame => frame.speed * 3.6], ["objects", "Objects", frame => frame.objects.filter(passes).length],
    ...ego("steering", "Steering, -1 to 1"), ...ego("throttle", "Throttle, 0 to 1"), ...ego("brake", "Brake, 0 to 1"),
    ...ego("yawRate", "Yaw rate, rad/s"), ...ego("acceleration", "Acceleration, m/s²"),
    ...(data.frames.some(frame => frame.indicators) ? data.indicatorTable.map(([name, unit], index) => [name, `${name}, ${unit}`, frame => frame.indicators?.[index] ?? null]) : []),
  ];
}

/** Draws the plot with gaps where there is no value, and below it where the followed object and filtered objects appear. */
function drawTimeline() {
  const [, label, valueOf] = plots().find(([name]) => name === state.plot);
  const values = data.frames.map(valueOf);
  const known = values.filter(value => value !== null);
  const [least, greatest] = known.length ? [Math.min(...known), Math.max(...known)] : [0, 0];
  const span = greatest - least || 1;
  let path = "", isDrawing = false;
  values.forEach((value, index) => {
    if (value !== null) path += `${isDrawing ? "L" : "M"}${index + 0.5} ${(plotHeight - 4 - (value - least) / span * (plotHeight - 8)).toFixed(1)}h.01`;
    isDrawing = value !== null;
  });
  const bars = [
    ...(isFiltered() ? [["matches", frame => frame.objects.some(passes)]] : []),
    ...(state.chosen === null ? [] : [["followed", frame => frame.objects.some(object => object.id === state.chosen)]]),
  ].map(([name, has], row) => shape("path", {
    d: data.frames.map((frame, index) => has(frame) ? `M${index} ${plotHeight + 4 + 6 * row}h1` : "").join(""), class: `bar ${name}` }));
  const drawing = byId("plot");
  drawing.setAttribute("viewBox", `0 0 ${Math.max(1, data.frames.length)} ${plotHeight + 12}`);
  drawing.setAttribute("aria-label", known.length ? `${label}: ${fixed(least, 2)} to ${fixed(greatest, 2)}` : `${label}: no values`);
  drawing.replaceChildren(shape("path", { d: path, class: "values" }), ...bars, shape("line", { id: "cursor", y1: 0, y2: plotHeight + 12, class: "cursor" }));
  byId("plot-range").textContent = known.length ? `${fixed(least, 2)} to ${fixed(greatest, 2)}` : "no values";
  moveCursor();
}

function moveCursor() {
  for (const end of ["x1", "x2"]) byId("cursor")?.setAttribute(end, state.index + 0.5);
  const [, , valueOf] = plots().find(([name]) => name === state.plot);
  byId("plot-value").textContent = fixed(valueOf(current()), 2).replace("not determined", "none");
}

function listenToTimeline() {
  byId("plot-name").replaceChildren(...plots().map(([name, label]) => element("option", { value: name }, label)));
  byId("plot-name").addEventListener("change", event => { state.plot = event.target.value; drawTimeline(); remember(); });
  const seek = event => {
    const box = byId("plot").getBoundingClientRect();
    play(false);
    show(Math.min(data.frames.length - 1, Math.max(0, Math.floor((event.clientX - box.left) / box.width * data.frames.length))));
  };
  byId("plot").addEventListener("pointerdown", event => { byId("plot").setPointerCapture(event.pointerId); seek(event); });
  byId("plot").addEventListener("pointermove", event => { if (event.buttons & 1) seek(event); });
}

// The statistics of the whole session.
function counts() {
  const rows = Object.entries(data.classes).map(([name, entry]) => {
    const mark = element("i");
    mark.style.background = entry.colour;
    return [[mark, words(name)], entry.labels, entry.objects, entry.parts, `${fixed(entry.nearest)} m`, `${fixed(entry.medianDistance)} m`, percent(entry.meanOcclusion)];
  });
  const sum = key => Object.values(data.classes).reduce((total, entry) => total + entry[key], 0);
  table("counts", ["Class", "Labels", "Objects", "Parts", "Nearest", "Median distance", "Mean occlusion"], rows,
    ["all", sum("labels"), sum("objects"), sum("parts"), "", "", ""]);
}

function indicators() {
  const rows = Object.entries(data.indicators).map(([name, span]) =>
    [name, span.frames, `${fixed(span.least, 2)} ${span.unit}`, `${fixed(span.greatest, 2)} ${span.unit}`]);
  table("indicators", ["Lane indicator", "Frames", "Min", "Max"], rows);
  byId("lanes").hidden = rows.length === 0;
  table("lane-sources", ["Lane geometry", "Frames", "Lines"], data.laneSources);
  byId("lane-geometry").hidden = data.laneSources.length === 0;
}

/** The events of the session, which only a report has; the number of one that a shown frame has leads to that frame. */
function eventRows() {
  const all = data.eventRows ?? [];
  const rows = all.map(([index, number, ...cells]) => {
    if (index === null) return [number, ...cells];
    const button = element("button", { type: "button", class: "plain" }, number);
    button.addEventListener("click", () => { play(false); show(index); });
    return [[button], ...cells];
  });
  table("event-rows", ["Event", "Kind", "Begins", "Lasts", "Who", "Measured", "End"], rows);
  byId("event-table").hidden = all.length === 0;
  byId("event-note").textContent = all.length < (data.eventCount ?? 0)
    ? `The first ${all.length} of ${data.eventCount} events; events.jsonl has all.`
    : "Times are those of the game; units are those of events.jsonl.";
}

function histogram(chart) {
  const width = 320, height = 150, foot = 18, most = Math.max(1, ...chart.counts), step = width / chart.counts.length;
  const last = chart.counts.length - 1;
  const end = bin => bin < last ? chart.starts[bin + 1] : chart.end;
  const range = bin => end(bin) === null ? `${chart.starts[bin]} ${chart.unit} or more` : `${chart.starts[bin]} to ${end(bin)} ${chart.unit}`;
  const drawing = shape("svg", { viewBox: `0 0 ${width} ${height + foot}`, role: "img", "aria-label": chart.title });
  chart.counts.forEach((count, index) => {
    const tall = count / most * (height - 14);
    const bar = shape("rect", { x: index * step + 1, y: height - tall, width: Math.max(1, step - 2), height: tall });
    bar.append(shape("title", {}, `${range(index)}: ${count}`));
    drawing.append(bar);
  });
  drawing.append(shape("line", { x1: 0, x2: width, y1: height, y2: height }));
  drawing.append(shape("text", { x: 0, y: 10 }, `max ${most}`));
  const middle = Math.ceil(last / 2);
  [[0, "start", 0], [middle, "middle", middle * step], [last, "end", width]].forEach(([bin, anchor, x]) => drawing.append(shape("text", {
    x, y: height + 14, "text-anchor": anchor }, `${end(bin) === null ? "≥ " : ""}${chart.starts[bin]} ${chart.unit}`)));
  byId("histograms").append(element("figure", {}, element("figcaption", {}, chart.title), drawing));
}

function showStatistics() {
  for (const id of ["counts", "comparison", "histograms", "weathers", "hours", "indicators", "lane-sources", "event-rows"]) byId(id).replaceChildren();
  counts();
  table("comparison", ["Comparison", "This session", data.comparison.name], data.comparison.rows);
  data.histograms.forEach(histogram);
  table("weathers", ["Weather", "Frames"], Object.entries(data.weathers));
  table("hours", ["Hour", "Frames"], Object.entries(data.hours));
  indicators();
  eventRows();
}

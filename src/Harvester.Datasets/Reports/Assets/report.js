"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
for (const frame of data.frames) frame.objects = frame.objects.map(seen => ({ amodal: seen.box, ...data.objects[seen.id], ...seen }));
const corners = [[0, 1], [0, 2], [0, 4], [1, 3], [1, 5], [2, 3], [2, 6], [3, 7], [4, 5], [4, 6], [5, 7], [6, 7]]; // at the ends of each edge
const byId = id => document.getElementById(id);
const svgNamespace = "http://www.w3.org/2000/svg";
const framesPerSecond = 8;
const hiddenFading = 0.7; // The more of an object is hidden, the fainter its box.
const kinds = [["box", "2D box"], ["amodal", "amodal box"], ["edges", "3D box"]];
const state = { index: 0, shown: new Set(["box"]), hidden: new Set(), chosen: null, timer: null };
const pictures = new Map();

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

function shape(name, attributes, text = "") {
  const made = document.createElementNS(svgNamespace, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

const fixed = (value, digits = 1) => value === null ? "not determined" : value.toFixed(digits);
const percent = value => value === null ? "not determined" : `${Math.round(value * 100)} %`;
const words = name => name.replace(/[A-Z]/g, capital => ` ${capital.toLowerCase()}`);
// The cameras of a rig have images of their own sizes.
const sizeOf = frame => frame.size ?? [data.width, data.height];
const colour = object => data.classes[object.class].colour;

function describe(list, entries, grouped) {
  list.replaceChildren(...entries.flatMap(([term, text]) => {
    const pair = [element("dt", {}, term), element("dd", {}, String(text))];
    return grouped ? [element("div", {}, ...pair)] : pair;
  }));
}

function picture(index) {
  if (!pictures.has(index)) {
    const stored = byId(`image-${index}`);
    const image = element("img", { alt: `Frame ${data.frames[index].frame}`, width: sizeOf(data.frames[index])[0], height: sizeOf(data.frames[index])[1] });
    image.src = stored.dataset.href ?? `data:${stored.dataset.type};base64,${stored.textContent.trim()}`;
    pictures.set(index, image);
  }
  return pictures.get(index);
}

async function show(index) {
  state.index = index;
  const image = picture(index);
  try { await image.decode(); } catch { /* A picture that cannot be decoded is shown as the browser shows it. */ }
  if (state.index !== index) return;
  const old = byId("stage").querySelector("img");
  if (old) old.replaceWith(image); else byId("stage").prepend(image);
  byId("slider").value = index;
  const frame = data.frames[index];
  byId("position").textContent = `frame ${frame.frame}${frame.view ? ` (${frame.view})` : ""}, ${fixed(frame.time, 2)} s`;
  describe(byId("caption"), [
    ["Weather", frame.weather], ["Time of day", frame.timeOfDay], ["Ego speed", `${fixed(frame.speed * 3.6, 0)} km/h`],
    ["Camera position", frame.camera.position.map(value => fixed(value)).join(", ") + " m"], ["Heading", `${fixed(frame.camera.heading, 0)}°`],
    ["Vertical field of view", `${frame.camera.fov}°`], ["Objects", frame.objects.length],
  ], true);
  draw();
  if (index + 1 < data.frames.length) picture(index + 1);
}

function draw() {
  const overlay = byId("overlay");
  overlay.setAttribute("viewBox", `0 0 ${sizeOf(data.frames[state.index]).join(" ")}`);
  // The farthest first, so that the nearest lies on top and is the one pointed at.
  const objects = data.frames[state.index].objects.filter(object => !state.hidden.has(object.class)).sort((a, b) => b.distance - a.distance);
  overlay.replaceChildren(...objects.flatMap(drawObject));
  const followed = objects.find(object => object.id === state.chosen);
  if (followed || state.chosen === null) detail(followed);
}

function drawObject(object) {
  const drawn = [];
  const rectangle = (box, attributes) =>
    shape("rect", { x: box[0], y: box[1], width: box[2] - box[0], height: box[3] - box[1], stroke: colour(object), "stroke-opacity": 1 - hiddenFading * (object.occluded ?? 0), ...attributes });
  if (state.shown.has("amodal")) drawn.push(rectangle(object.amodal, { class: "amodal" }));
  if (state.shown.has("edges")) {
    const edges = object.edges ?? corners.map(ends => ends.flatMap(end => object.corners.slice(2 * end, 2 * end + 2)));
    const path = edges.map(edge => `M${edge[0]} ${edge[1]}L${edge[2]} ${edge[3]}`).join("");
    drawn.push(shape("path", { d: path, class: "edges", stroke: colour(object) }));
  }
  const chosen = object.id === state.chosen;
  const box = rectangle(object.box, { class: chosen ? "box chosen" : "box" });
  if (!state.shown.has("box")) box.setAttribute("stroke", "transparent");
  box.addEventListener("pointerenter", () => detail(object));
  box.addEventListener("pointerleave", () => draw());
  box.addEventListener("click", () => { state.chosen = chosen ? null : object.id; draw(); });
  drawn.push(box);
  if (chosen) drawn.push(shape("text", { x: object.box[0], y: Math.max(12, object.box[1] - 6), class: "tag", fill: colour(object) }, `${words(object.class)} ${object.id}`));
  return drawn;
}

function detail(object) {
  byId("hint").hidden = Boolean(object);
  describe(byId("details"), !object ? [] : [
    ["Class", words(object.class)], ["Model", object.model], ...(object.name ? [["Name", object.name]] : []), ["Object ID", object.id],
    ["Distance", `${fixed(object.distance)} m`], ["Speed", `${fixed(object.speed * 3.6, 0)} km/h`],
    ["Length × width × height", object.size.map(value => fixed(value)).join(" × ") + " m"],
    ["Truncation", percent(object.truncated)], ["Occlusion", percent(object.occluded)], ["Occlusion from", words(object.method)],
    ["2D box", object.box.map(value => fixed(value)).join(", ") + " px"],
  ], false);
}

function switches(parent, entries) {
  parent.replaceChildren(...entries.map(({ label, swatch, count, isOn, toggle }) => {
    const button = element("button", { type: "button", "aria-pressed": isOn() });
    if (swatch) { const mark = element("i"); mark.style.background = swatch; button.append(mark); }
    button.append(label);
    if (count !== undefined) button.append(element("small", {}, String(count)));
    button.addEventListener("click", () => { toggle(); button.setAttribute("aria-pressed", isOn()); draw(); });
    return button;
  }));
}

const flip = (set, value) => set.has(value) ? set.delete(value) : set.add(value);

function play(on) {
  clearInterval(state.timer);
  state.timer = on ? setInterval(() => show((state.index + 1) % data.frames.length), 1000 / framesPerSecond) : null;
  byId("play-shape").setAttribute("d", on ? "M3 1h4v14H3zM9 1h4v14H9z" : "M3 1l12 7-12 7z");
  byId("play").setAttribute("aria-label", on ? "Pause" : "Play");
}

function table(id, columns, rows, foot) {
  const row = ([name, ...cells]) => element("tr", {}, element("th", { scope: "row" }, ...[name].flat()), ...cells.map(cell => element("td", {}, String(cell))));
  byId(id).append(
    element("thead", {}, element("tr", {}, ...columns.map(column => element("th", { scope: "col" }, column)))),
    element("tbody", {}, ...rows.map(row)),
    ...(foot ? [element("tfoot", {}, row(foot))] : []));
}

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

// report.html#120 opens at frame 120, or the first one after it that the page holds.
function firstFrame() {
  const wanted = Number(location.hash.slice(1));
  return Math.max(0, data.frames.findIndex(frame => frame.frame >= wanted));
}

document.title = `${data.title}: session report`;
byId("title").textContent = data.title;
describe(byId("facts"), Object.entries(data.facts), true);
byId("note").textContent = data.note;
switches(byId("kinds"), kinds.map(([kind, label]) => ({ label, isOn: () => state.shown.has(kind), toggle: () => flip(state.shown, kind) })));
switches(byId("classes"), Object.entries(data.classes).map(([name, entry]) => ({
  label: words(name), swatch: entry.colour, count: entry.labels, isOn: () => !state.hidden.has(name), toggle: () => flip(state.hidden, name) })));
counts();
table("comparison", ["Comparison", "This session", data.comparison.name], data.comparison.rows);
data.histograms.forEach(histogram);
table("weathers", ["Weather", "Frames"], Object.entries(data.weathers));
table("hours", ["Hour", "Frames"], Object.entries(data.hours));
indicators();
byId("slider").max = Math.max(0, data.frames.length - 1);
byId("slider").addEventListener("input", event => { play(false); show(Number(event.target.value)); });
byId("play").addEventListener("click", () => play(state.timer === null));
document.addEventListener("keydown", event => {
  if (event.target.matches("button, input") && event.key !== "Escape") return;
  const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (step) show((state.index + step + data.frames.length) % data.frames.length);
  if (event.key === " ") { event.preventDefault(); play(state.timer === null); }
  if (event.key === "Escape") { state.chosen = null; draw(); }
});
play(false);
if (data.frames.length > 0) show(firstFrame());

// Predictions in the picture, which frames have the most errors, and precision and recall; nothing without predictions.
const evaluation = byId("predictions") ? JSON.parse(byId("predictions").textContent) : null;
const outcomes = { matched: "matched", false: "false positive", ignored: "in an ignore region", missed: "missed" };
const figure = value => value === null ? "none" : value.toFixed(3);
const share = (part, whole) => whole === 0 ? "none" : (part / whole).toFixed(3);

if (evaluation) {
  layers.push(["predictions", "predictions"]);
  state.shown.add("predictions");
  state.shown.delete("box"); // Its colours are those of classes.
}

/** KITTI's types begin with a capital. */
const isHidden = name => state.hidden.has(name) || state.hidden.has(name.toLowerCase());

/** The predictions of the frame and the objects that they miss, told apart by colour and by style of line. */
function drawPredictions() {
  if (!evaluation) return [];
  const frame = evaluation.frames[state.index];
  const counted = kind => frame.boxes.filter(box => box.outcome === kind).length;
  byId("outcomes-here").textContent = `This frame: ${counted("matched")} matched, ${frame.missed.length} missed, ${counted("false")} false.`;
  if (!state.shown.has("predictions")) return [];
  return [...frame.missed.map(box => ({ ...box, outcome: "missed" })), ...frame.boxes]
    .filter(({ class: place }) => !isHidden(evaluation.classes[place].name)).map(drawPrediction);
}

function drawPrediction({ box: [left, top, right, bottom], class: place, score, outcome, object }) {
  const mark = shape("rect", { x: left, y: top, width: right - left, height: bottom - top, class: `prediction ${outcome}` });
  const name = `${words(evaluation.classes[place].name)}${object === undefined ? "" : ` ${object}`}`;
  mark.append(shape("title", {}, outcome === "missed" ? `missed: ${name}` : `${outcomes[outcome]}: ${name}, score ${score}`));
  if (object !== undefined && current().objects.some(item => item.id === object)) {
    mark.addEventListener("click", () => choose(object === state.chosen ? null : object));
  }
  return mark;
}

const worstLink = ({ frame, misses, false: wrong }) => {
  const link = element("a", { href: `#frame=${frame}` }, `Frame ${frame}`);
  link.addEventListener("click", () => byId("viewer").scrollIntoView());
  return [link, `: ${misses} missed, ${wrong} false`];
};

/** Goes to the next frame in the list of those with the most errors. */
function stepToWorst() {
  const place = evaluation.worst.findIndex(({ frame }) => frame === current().frame);
  const next = evaluation.worst[(place + 1) % evaluation.worst.length];
  if (next) show(data.frames.findIndex(({ frame }) => frame === next.frame));
}

function curves({ name, ap, curve50, curve75 }) {
  const width = 320, height = 180, foot = 30, left = 30;
  const line = (values, kind) => shape("polyline", {
    points: values.map((value, step) => `${(left + step * (width - left) / 100).toFixed(1)},${(height - value * (height - 8)).toFixed(1)}`).join(" "), class: `curve ${kind}` });
  const drawing = shape("svg", { viewBox: `0 0 ${width} ${height + foot}`, role: "img",
    "aria-label": `Precision over recall of ${words(name)}; at recall 0.5, ${curve50[50].toFixed(2)} at overlap 0.5 and ${curve75[50].toFixed(2)} at overlap 0.75` });
  for (const tick of [0, 0.5, 1]) {
    const x = left + tick * (width - left), y = height - tick * (height - 8);
    drawing.append(shape("line", { x1: left, x2: width, y1: y, y2: y }), shape("text", { x: left - 4, y: y + 4, "text-anchor": "end" }, String(tick)),
      shape("text", { x, y: height + 14, "text-anchor": tick === 1 ? "end" : "middle" }, String(tick)));
  }
  drawing.append(shape("text", { x: (left + width) / 2, y: height + 28, "text-anchor": "middle" }, "recall"), line(curve75, "strict"), line(curve50, ""));
  return element("figure", {}, element("figcaption", {}, `${words(name)}, AP ${figure(ap)}`), drawing);
}

function countTable(id, title, counts, hasFalse) {
  table(id, [title, "Matched", "Missed", "Recall", ...(hasFalse ? ["False positives", "Precision"] : [])], counts.map(count => [
    count.name, count.matches, count.misses, share(count.matches, count.matches + count.misses),
    ...(hasFalse ? [count.false, share(count.matches, count.matches + count.false)] : [])]));
}

function showEvaluation() {
  const { figures, classes, minScore } = evaluation;
  const key = ["matched", "false", "missed"].map(kind => element("span", {}, element("i", { class: `key ${kind}` }), outcomes[kind]));
  const next = element("button", { type: "button", class: "plain", id: "next-worst" }, "Next by errors (w)");
  next.addEventListener("click", stepToWorst);
  next.hidden = evaluation.worst.length === 0;
  byId("tools").firstElementChild.after(element("section", {}, element("h2", {}, "Predictions"), element("p", { class: "outcome-key" }, ...key),
    element("p", { class: "hint" }, element("span", { id: "outcomes-here" }), " ", next)));
  const held = id => element("div", { class: "table" }, element("table", { id }));
  const seen = classes.filter(kind => kind.objects || kind.false);
  byId("evaluation").append(element("h2", {}, `Predictions (${evaluation.format})`),
    element("div", { class: "panels wide" }, held("precisions"), element("div", {}, element("h2", {}, "Frames with the most errors"),
      element("ol", { class: "worst" }, ...evaluation.worst.map(entry => element("li", {}, ...worstLink(entry)))))),
    element("p", { class: "hint" }, `AP and AR are COCO's: precision at 101 recalls, averaged over overlaps of 0.5 to 0.95, with all predictions. Matched, missed and false positives are counted at overlap 0.5 for scores of ${minScore} or more. Curves: solid at overlap 0.5, dashed at 0.75.`),
    element("div", { class: "panels" }, ...seen.filter(kind => kind.objects).map(curves)),
    element("div", { class: "panels counts" }, held("by-class"), held("by-size"), held("by-distance"), held("by-occlusion"), held("figures")));
  table("precisions", ["Class", "Objects", "AP", "AP50", "AP75", "AP small", "AP medium", "AP large", "AR100"], seen.map(kind => {
    const mark = element("i");
    mark.style.background = kind.colour;
    return [[mark, words(kind.name)], kind.objects, ...[kind.ap, kind.ap50, kind.ap75, kind.small, kind.medium, kind.large, kind.recall].map(figure)];
  }), ["mean", classes.reduce((sum, kind) => sum + kind.objects, 0), ...["AP", "AP50", "AP75", "APsmall", "APmedium", "APlarge", "AR100"].map(name => figure(figures[name]))]);
  table("figures", ["COCO's figures", "Mean over classes"], Object.entries(figures).map(([name, value]) => [name, figure(value)]));
  countTable("by-class", "Class", [...seen.map(kind => ({ ...kind, name: words(kind.name) })), ...evaluation.all], true);
  countTable("by-size", "Size", evaluation.sizes, true);
  countTable("by-distance", "Distance", evaluation.distances, false);
  countTable("by-occlusion", "Occlusion", evaluation.occlusions, false);
  byId("evaluation").hidden = false;
}

const predictionKeys = !evaluation ? {} : {
  x: ["show or hide: predictions", () => { flip(state.shown, "predictions"); refilter(); }], w: ["next frame by number of errors", stepToWorst],
};
if (evaluation) showEvaluation();

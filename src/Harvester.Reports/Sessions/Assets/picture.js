// The picture with what is drawn on it.
const hiddenFading = 0.7; // The more of an object is hidden, the fainter its box.
const corners = [[0, 1], [0, 2], [0, 4], [1, 3], [1, 5], [2, 3], [2, 6], [3, 7], [4, 5], [4, 6], [5, 7], [6, 7]]; // at the ends of each edge
// From each joint to the next one up the body, in the order of the labels.
const bones = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 6], [2, 7], [7, 8], [8, 9], [9, 10], [2, 11], [11, 12], [12, 13], [13, 14], [14, 15], [15, 16], [16, 17], [17, 18], [15, 19], [19, 20], [20, 21]];
const pictures = new Map();
const zoom = { scale: 1, x: 0, y: 0 };

/** The picture of a frame, decoded once it has been asked for. */
function picture(index) {
  if (!pictures.has(index)) {
    const image = new Image();
    image.src = source.picture(index);
    pictures.set(index, image);
    if (pictures.size > 60) pictures.delete(pictures.keys().next().value); // The memory of a page stays small.
  }
  return pictures.get(index);
}

/** What a picture shows, in words, for those who do not see it. */
function summary(frame) {
  const seen = frame.objects.filter(object => object.parent === undefined && passes(object));
  const counts = Map.groupBy(seen, object => object.class);
  const nearest = seen.reduce((best, object) => !best || object.distance < best.distance ? object : best, null);
  return `Frame ${frame.frame}: ${[...counts].map(([name, list]) => `${list.length} ${words(name)}`).join(", ") || "no objects"}`
    + (nearest ? `; nearest: ${words(nearest.class)} at ${fixed(nearest.distance, 0)} m` : "");
}

function drawPicture() {
  const frame = current();
  const [width, height] = sizeOf(frame);
  byId("stage").style.setProperty("--aspect", width / height);
  for (const [key, value] of Object.entries({ href: picture(state.index).src, width, height, "aria-label": summary(frame) })) byId("image").setAttribute(key, value);
  for (const image of document.querySelectorAll("#overlay .raster")) for (const [key, value] of [["width", width], ["height", height]]) image.setAttribute(key, value);
  const view = [zoom.x, zoom.y, width / zoom.scale, height / zoom.scale];
  byId("overlay").setAttribute("viewBox", view.join(" "));
  // The farthest first, so that the nearest lies on top and is the one pointed at.
  const objects = frame.objects.filter(isDrawn).sort((a, b) => b.distance - a.distance);
  byId("marks").replaceChildren(...(state.shown.has("lanes") ? (frame.lines ?? []).flatMap(drawLine) : []), ...objects.flatMap(drawObject), ...drawPredictions());
}

/** A line in runs that are visible or hidden; a dashed marking is dashed, a hidden run faint. */
function drawLine(line) {
  const runs = [];
  for (let i = 0; i + 1 < line.pixels.length / 2; i++) {
    const isHidden = Boolean(line.hidden && line.hidden[i] && line.hidden[i + 1]);
    if (runs.length === 0 || runs.at(-1).isHidden !== isHidden) runs.push({ isHidden, points: line.pixels.slice(2 * i, 2 * i + 2) });
    runs.at(-1).points.push(line.pixels[2 * i + 2], line.pixels[2 * i + 3]);
  }
  const kind = `line ${line.colour ?? ""} ${line.style?.toLowerCase().includes("dash") ? "dashed" : ""}`;
  return runs.map(run => shape("polyline", { points: run.points.join(" "), class: run.isHidden ? `${kind} unseen` : kind }));
}

function drawObject(object) {
  const drawn = [];
  const opacity = 1 - hiddenFading * (object.occluded ?? 0);
  const rectangle = (box, attributes) => shape("rect", {
    x: box[0], y: box[1], width: box[2] - box[0], height: box[3] - box[1], stroke: colour(object), "stroke-opacity": opacity, ...attributes });
  if (state.shown.has("amodal")) drawn.push(rectangle(object.amodal, { class: "amodal" }));
  if (state.shown.has("visible") && object.visible) drawn.push(rectangle(object.visible, { class: "visible" }));
  if (state.shown.has("edges")) {
    const edges = object.edges ?? corners.map(ends => ends.flatMap(end => object.corners.slice(2 * end, 2 * end + 2)));
    drawn.push(shape("path", { d: edges.map(edge => `M${edge[0]} ${edge[1]}L${edge[2]} ${edge[3]}`).join(""), class: "edges", stroke: colour(object) }));
  }
  if (state.shown.has("joints") && object.joints) {
    const ends = bones.map(([from, to]) => [object.joints[from], object.joints[to]]).filter(([from, to]) => from && to);
    drawn.push(shape("path", { d: ends.map(([from, to]) => `M${from[0]} ${from[1]}L${to[0]} ${to[1]}`).join(""), class: "bones", stroke: colour(object) }));
    for (const joint of object.joints) if (joint) drawn.push(shape("circle", { cx: joint[0], cy: joint[1], r: 1.6 / zoom.scale, class: joint[2] ? "joint" : "joint unseen", stroke: colour(object) }));
  }
  const isChosen = object.id === state.chosen;
  const box = rectangle(object.box, { class: isChosen ? "box chosen" : "box" });
  if (!state.shown.has("box") && !isChosen) box.setAttribute("stroke", "transparent");
  attend(box, object);
  drawn.push(box);
  if (isChosen) {
    const size = 12 / Math.sqrt(zoom.scale);
    drawn.push(shape("text", { x: object.box[0], y: Math.max(size, object.box[1] - 6), class: "tag", fill: colour(object), "font-size": size }, `${words(object.class)} ${object.id}`));
  }
  return drawn;
}

/** Makes a mark of an object show it when pointed at, and follow it when clicked. */
function attend(mark, object) {
  mark.dataset.object = object.id;
  mark.addEventListener("pointerenter", () => detail(object));
  mark.addEventListener("pointerleave", () => detail(chosenObject()));
  mark.addEventListener("click", () => choose(object.id === state.chosen ? null : object.id));
}

/** Zooms by a factor about a point of the picture, or about its middle. */
function zoomBy(factor, at) {
  const [width, height] = sizeOf(current());
  const scale = Math.min(32, Math.max(1, zoom.scale * factor));
  const [x, y] = at ?? [zoom.x + width / zoom.scale / 2, zoom.y + height / zoom.scale / 2];
  panTo(x - (x - zoom.x) * zoom.scale / scale, y - (y - zoom.y) * zoom.scale / scale, scale);
}

function panTo(x, y, scale = zoom.scale) {
  const [width, height] = sizeOf(current());
  zoom.scale = scale;
  zoom.x = Math.min(width - width / scale, Math.max(0, x));
  zoom.y = Math.min(height - height / scale, Math.max(0, y));
  drawPicture();
}

function listenToPicture() {
  const overlay = byId("overlay");
  const perPixel = () => sizeOf(current())[0] / zoom.scale / overlay.getBoundingClientRect().width;
  overlay.addEventListener("wheel", event => {
    event.preventDefault();
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(overlay.getScreenCTM().inverse());
    zoomBy(2 ** (-event.deltaY / 300), [point.x, point.y]);
  }, { passive: false });
  overlay.addEventListener("pointermove", event => {
    if (event.buttons & 1 && zoom.scale > 1) panTo(zoom.x - event.movementX * perPixel(), zoom.y - event.movementY * perPixel());
  });
  overlay.addEventListener("dblclick", () => panTo(0, 0, 1));
}

// Filters, and all that is known about the object that is pointed at or followed.
const chosenObject = () => current().objects.find(object => object.id === state.chosen);

function detail(object) {
  byId("hint").hidden = Boolean(object);
  byId("follow").hidden = state.chosen === null;
  const parent = object?.parent === undefined ? [] : [["Part of", `object ${object.parent}`]];
  describe(byId("details"), !object ? [] : [
    ["Class", words(object.class)], ["Model", object.model], ...(object.name ? [["Name", object.name]] : []), ["Object ID", object.id], ...parent,
    ...(object.mutcd ? [["MUTCD code", object.mutcd]] : []), ...(object.light ? [["Light", words(object.light)]] : []),
    ...(object.lamps ? [["Lamps lit", object.lamps.join(", ") || "none"]] : []),
    ["Distance", `${fixed(object.distance)} m`], ["Speed", `${fixed(object.speed * 3.6, 0)} km/h`],
    ["Length × width × height", object.size.map(value => fixed(value)).join(" × ") + " m"],
    ["Truncation", percent(object.truncated)], ["Occlusion", percent(object.occluded)], ["Occlusion from", words(object.method)],
    ["Visible area", `${fixed((object.box[2] - object.box[0]) * (object.box[3] - object.box[1]) * (1 - (object.occluded ?? 0)), 0)} px²`],
    ["2D box", object.box.map(value => fixed(value)).join(", ") + " px"],
  ], false);
}

/** Follows an object from frame to frame; null for none. */
function choose(id) {
  state.chosen = id;
  crops();
  draw();
  drawTimeline();
}

/** Pictures of the followed object over time, at most eight of the frames that show it. */
function crops() {
  const seen = state.chosen === null ? [] : source.sightings(state.chosen);
  const chosen = seen.filter((_, number) => number % Math.ceil(seen.length / 8) === 0);
  byId("crops").replaceChildren(...chosen.map(({ index, box: [left, top, right, bottom] }) => {
    const margin = 0.15 * Math.max(right - left, bottom - top) + 2;
    const crop = shape("svg", { viewBox: `${left - margin} ${top - margin} ${right - left + 2 * margin} ${bottom - top + 2 * margin}` });
    const [width, height] = source.size(index);
    crop.append(shape("image", { href: picture(index).src, width, height }));
    const button = element("button", { type: "button", "aria-label": `Frame ${source.number(index)}` }, crop);
    button.addEventListener("click", () => { play(false); show(index); });
    return button;
  }));
}

/** Follows the next object of the frame, by distance. */
function chooseNext(step) {
  const ids = current().objects.filter(isDrawn).sort((a, b) => a.distance - b.distance).map(object => object.id);
  if (ids.length === 0) return;
  const place = ids.indexOf(state.chosen);
  choose(ids[place < 0 ? (step > 0 ? 0 : ids.length - 1) : (place + step + ids.length) % ids.length]);
}

function switches(parent, entries) {
  parent.replaceChildren(...entries.map(({ label, swatch, count, isOn, toggle }) => {
    const button = element("button", { type: "button", "aria-pressed": isOn() });
    if (swatch) { const mark = element("i"); mark.style.background = swatch; button.append(mark); }
    button.append(label);
    if (count !== undefined) button.append(element("small", {}, String(count)));
    button.addEventListener("click", () => { toggle(); refilter(); });
    return button;
  }));
}

/** The switches and limits as the state has them, and how much they let through. */
function showFilters() {
  const offered = layers.filter(([kind]) => !rasterKinds.includes(kind) || rastersSeen.has(kind));
  switches(byId("kinds"), offered.map(([kind, label]) => ({ label, isOn: () => state.shown.has(kind), toggle: () => flip(state.shown, kind) })));
  switches(byId("classes"), Object.entries(data.classes ?? {}).map(([name, entry]) => ({
    label: words(name), swatch: entry.colour, count: entry.labels, isOn: () => !state.hidden.has(name), toggle: () => flip(state.hidden, name) })));
  for (const name in limits) if (document.activeElement !== byId(name)) byId(name).value = state[name] ?? "";
  if (document.activeElement !== byId("text")) byId("text").value = state.text;
  byId("paint").value = state.paint;
  byId("opacity").value = state.opacity;
  byId("raster-options").hidden = !rastersSeen.has("mask") && !rastersSeen.has("depth");
  describeMatches();
}

function refilter() {
  const focused = document.activeElement?.closest("#kinds, #classes") ? [document.activeElement.parentElement.id, [...document.activeElement.parentElement.children].indexOf(document.activeElement)] : null;
  countMatches();
  showFilters();
  if (focused) byId(focused[0]).children[focused[1]].focus();
  draw();
  drawTimeline();
  drawBars();
}

function listenToFilters() {
  for (const name in limits) {
    byId(name).addEventListener("input", event => { state[name] = event.target.value === "" ? null : Number(event.target.value); refilter(); });
  }
  byId("text").addEventListener("input", event => { state.text = event.target.value; refilter(); });
  byId("clear").addEventListener("click", () => {
    state.hidden.clear();
    state.text = "";
    for (const name in limits) state[name] = null;
    refilter();
  });
  byId("follow").addEventListener("click", () => choose(null));
  byId("paint").addEventListener("change", event => { state.paint = event.target.value; drawRasters(); remember(); });
  byId("opacity").addEventListener("input", event => { state.opacity = Number(event.target.value); fadeRasters(); remember(); });
}

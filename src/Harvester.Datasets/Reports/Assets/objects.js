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
  const seen = data.frames.flatMap((frame, index) => frame.objects.filter(object => object.id === state.chosen).map(object => ({ index, object })));
  const chosen = seen.filter((_, number) => number % Math.ceil(seen.length / 8) === 0);
  byId("crops").replaceChildren(...chosen.map(({ index, object }) => {
    const [left, top, right, bottom] = object.box;
    const margin = 0.15 * Math.max(right - left, bottom - top) + 2;
    const crop = shape("svg", { viewBox: `${left - margin} ${top - margin} ${right - left + 2 * margin} ${bottom - top + 2 * margin}` });
    const [width, height] = sizeOf(data.frames[index]);
    crop.append(shape("image", { href: picture(index).src, width, height }));
    const button = element("button", { type: "button", "aria-label": `Frame ${data.frames[index].frame}` }, crop);
    button.addEventListener("click", () => { play(false); show(index); });
    return button;
  }));
}

/** Follows the next object of the frame, by distance. */
function chooseNext(step) {
  const ids = current().objects.filter(passes).sort((a, b) => a.distance - b.distance).map(object => object.id);
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
  switches(byId("kinds"), layers.map(([kind, label]) => ({ label, isOn: () => state.shown.has(kind), toggle: () => flip(state.shown, kind) })));
  switches(byId("classes"), Object.entries(data.classes).map(([name, entry]) => ({
    label: words(name), swatch: entry.colour, count: entry.labels, isOn: () => !state.hidden.has(name), toggle: () => flip(state.hidden, name) })));
  for (const name of ["farthest", "smallest", "mostOccluded"]) {
    if (document.activeElement !== byId(name)) byId(name).value = state[name] ?? "";
  }
  if (document.activeElement !== byId("text")) byId("text").value = state.text;
  const labels = data.frames.reduce((sum, frame) => sum + frame.objects.length, 0);
  const passed = data.frames.map(frame => frame.objects.filter(passes).length);
  byId("matches").textContent = `${passed.reduce((sum, count) => sum + count, 0)} of ${labels} labels in ${passed.filter(count => count > 0).length} of ${data.frames.length} frames`;
}

function refilter() {
  const focused = document.activeElement?.closest("#kinds, #classes") ? [document.activeElement.parentElement.id, [...document.activeElement.parentElement.children].indexOf(document.activeElement)] : null;
  showFilters();
  if (focused) byId(focused[0]).children[focused[1]].focus();
  draw();
  drawTimeline();
}

function listenToFilters() {
  for (const name of ["farthest", "smallest", "mostOccluded"]) {
    byId(name).addEventListener("input", event => { state[name] = event.target.value === "" ? null : Number(event.target.value); refilter(); });
  }
  byId("text").addEventListener("input", event => { state.text = event.target.value; refilter(); });
  byId("clear").addEventListener("click", () => {
    state.hidden.clear();
    state.text = "";
    state.farthest = state.smallest = state.mostOccluded = null;
    refilter();
  });
  byId("follow").addEventListener("click", () => choose(null));
}

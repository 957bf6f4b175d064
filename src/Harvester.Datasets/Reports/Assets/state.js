// What the page shows. The address always describes it, so that a link to it shows the same.
const data = JSON.parse(byId("data").textContent);
for (const frame of data.frames) frame.objects = frame.objects.map(seen => ({ amodal: seen.box, ...data.objects[seen.id], ...seen }));

const layers = [["box", "2D box"], ["visible", "visible box"], ["amodal", "amodal box"], ["edges", "3D box"], ["lanes", "lane lines"], ["joints", "joints"]];
const state = {
  index: 0, shown: new Set(["box", "lanes", "joints"]), hidden: new Set(), chosen: null,
  farthest: null, smallest: null, mostOccluded: null, text: "", plot: "speed", framesPerSecond: 8, timer: null,
};

const current = () => data.frames[state.index];
// The cameras of a rig have images of their own sizes.
const sizeOf = frame => frame.size ?? [data.width, data.height];
const colour = object => data.classes[object.class].colour;

/** Whether the filters let an object through. */
function passes(object) {
  return !state.hidden.has(object.class)
    && (state.farthest === null || object.distance <= state.farthest)
    && (state.smallest === null || object.box[3] - object.box[1] >= state.smallest)
    && (state.mostOccluded === null || (object.occluded ?? 0) * 100 <= state.mostOccluded)
    && (state.text === "" || `${object.id} ${object.class} ${object.model} ${object.name ?? ""} ${object.mutcd ?? ""}`.toLowerCase().includes(state.text.toLowerCase()));
}

const isFiltered = () => state.hidden.size > 0 || state.text !== "" || [state.farthest, state.smallest, state.mostOccluded].some(limit => limit !== null);

/** The address that describes what is shown: #frame=120&object=7. */
function address() {
  const parts = new URLSearchParams();
  const frame = current();
  if (frame) parts.set("frame", frame.frame);
  if (state.chosen !== null) parts.set("object", state.chosen);
  parts.set("show", [...state.shown].join(","));
  if (state.hidden.size > 0) parts.set("hide", [...state.hidden].join(","));
  for (const name of ["farthest", "smallest", "mostOccluded"]) if (state[name] !== null) parts.set(name, state[name]);
  if (state.text !== "") parts.set("text", state.text);
  if (state.plot !== "speed") parts.set("plot", state.plot);
  return `#${parts}`;
}

/** Takes over what an address describes. #120 alone is frame 120; a frame that the page lacks is the one after it. */
function restore(hash) {
  const text = hash.slice(1);
  const parts = new URLSearchParams(/^[0-9]+$/.test(text) ? `frame=${text}` : text);
  const number = name => parts.has(name) && parts.get(name).trim() !== "" && Number.isFinite(Number(parts.get(name))) ? Number(parts.get(name)) : null;
  const list = name => (parts.get(name) ?? "").split(",");
  if (parts.has("show")) state.shown = new Set(layers.map(([name]) => name).filter(name => list("show").includes(name)));
  state.hidden = new Set(Object.keys(data.classes).filter(name => list("hide").includes(name)));
  state.chosen = number("object");
  for (const name of ["farthest", "smallest", "mostOccluded"]) state[name] = number(name);
  state.text = parts.get("text") ?? "";
  if (plots().some(([name]) => name === parts.get("plot"))) state.plot = parts.get("plot");
  state.index = Math.max(0, data.frames.findIndex(frame => frame.frame >= (number("frame") ?? 0)));
}

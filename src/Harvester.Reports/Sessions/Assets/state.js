// What the page shows. The address always describes it, so that a link to it shows the same.
const data = JSON.parse(byId("data").textContent);

const layers = [
  ["box", "2D box"], ["visible", "visible box"], ["amodal", "amodal box"], ["edges", "3D box"], ["lanes", "lane lines"], ["joints", "joints"],
  ["posts", "posts of signs and lights"], ["mask", "mask"], ["depth", "depth"], ["points", "LiDAR points"],
];
// The name of each limit in the address, and how it judges an object.
const limits = {
  farthest: (object, limit) => object.distance <= limit,
  smallest: (object, limit) => object.box[3] - object.box[1] >= limit,
  mostOccluded: (object, limit) => (object.occluded ?? 0) * 100 <= limit,
  mostTruncated: (object, limit) => object.truncated * 100 <= limit,
  leastSeen: (object, limit) => (object.box[2] - object.box[0]) * (object.box[3] - object.box[1]) * (1 - (object.occluded ?? 0)) >= limit,
};
const state = {
  index: 0, frame: null, shown: new Set(["box", "lanes", "joints", ...(data.posts ? ["posts"] : [])]), hidden: new Set(), chosen: null,
  ...Object.fromEntries(Object.keys(limits).map(name => [name, null])),
  text: "", plot: "speed", paint: "instance", opacity: 50, framesPerSecond: 8, timer: null,
};

const current = () => state.frame;
// The cameras of a rig have images of their own sizes.
const sizeOf = frame => frame.size ?? [data.width, data.height];
const colour = object => data.colours[object.class];

const textPasses = new Map(); // By the numbers of objects, for the text in force.
let passedText = "";

function passesText(id) {
  if (state.text === "") return true;
  if (state.text !== passedText) textPasses.clear();
  passedText = state.text;
  if (!textPasses.has(id)) {
    const { class: kind, model, name, mutcd } = data.objects[id] ?? {};
    textPasses.set(id, `${id} ${kind} ${model} ${name ?? ""} ${mutcd ?? ""}`.toLowerCase().includes(state.text.toLowerCase()));
  }
  return textPasses.get(id);
}

/** Whether the filters let an object through. */
function passes(object) {
  for (const name in limits) if (state[name] !== null && !limits[name](object, state[name])) return false;
  return !state.hidden.has(object.class) && passesText(object.id);
}

/** Whether an object is drawn: it passes the filters, and a post is asked for or followed. */
const isDrawn = object => passes(object) && (!object.post || state.shown.has("posts") || object.id === state.chosen);

const isFiltered = () => state.hidden.size > 0 || state.text !== "" || Object.keys(limits).some(name => state[name] !== null);

/** The address that describes what is shown: #frame=120&object=7. */
function address() {
  const parts = new URLSearchParams();
  const frame = current();
  if (frame) parts.set("frame", frame.frame);
  if (state.chosen !== null) parts.set("object", state.chosen);
  parts.set("show", [...state.shown].join(","));
  if (state.hidden.size > 0) parts.set("hide", [...state.hidden].join(","));
  for (const name in limits) if (state[name] !== null) parts.set(name, state[name]);
  if (state.text !== "") parts.set("text", state.text);
  if (state.plot !== "speed") parts.set("plot", state.plot);
  if (state.paint !== "instance") parts.set("paint", state.paint);
  if (state.opacity !== 50) parts.set("opacity", state.opacity);
  return `#${parts}`;
}

/** Takes over what an address describes. #120 alone is frame 120; a frame that the page lacks is the one after it. */
async function restore(hash) {
  const text = hash.slice(1);
  const parts = new URLSearchParams(/^[0-9]+$/.test(text) ? `frame=${text}` : text);
  const number = name => parts.has(name) && parts.get(name).trim() !== "" && Number.isFinite(Number(parts.get(name))) ? Number(parts.get(name)) : null;
  const list = name => (parts.get(name) ?? "").split(",");
  if (parts.has("show")) state.shown = new Set(layers.map(([name]) => name).filter(name => list("show").includes(name)));
  state.hidden = new Set(Object.keys(data.colours).filter(name => list("hide").includes(name)));
  state.chosen = number("object");
  for (const name in limits) state[name] = number(name);
  state.text = parts.get("text") ?? "";
  if (plotNames.includes(parts.get("plot"))) state.plot = parts.get("plot");
  state.paint = parts.get("paint") === "class" ? "class" : "instance";
  const opacity = number("opacity");
  state.opacity = opacity === null ? 50 : Math.min(100, Math.max(0, opacity));
  const index = number("frame") > 0 ? await source.indexOf(Math.floor(number("frame"))) : 0;
  state.index = index < source.count ? index : 0;
}

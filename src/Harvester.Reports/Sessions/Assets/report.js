// Puts the parts together: which frame is shown, the keys, and the address.
const speeds = [1, 2, 4, 8, 15, 30]; // frames per second

async function show(index) {
  state.index = index;
  let frame;
  try { [frame] = await Promise.all([source.load(index), decoded(index)]); } catch (error) { return complain(error); }
  if (state.index !== index) return;
  state.frame = frame;
  complain(null);
  byId("slider").value = index;
  byId("slider").setAttribute("aria-valuetext", `frame ${frame.frame}`);
  byId("position").textContent = `frame ${frame.frame}${frame.view ? ` (${frame.view})` : ""}, ${fixed(frame.time, 2)} s`;
  describe(byId("caption"), [
    ["Weather", frame.weather], ["Time of day", frame.timeOfDay], ["Ego speed", `${fixed(frame.speed * 3.6, 0)} km/h`],
    ...(frame.ego.manoeuvre ? [["Manoeuvre", words(frame.ego.manoeuvre)]] : []), ...(frame.laneStatus ? [["Lanes", words(frame.laneStatus)]] : []),
    ["Camera position", frame.camera.position.map(value => fixed(value)).join(", ") + " m"], ["Heading", `${fixed(frame.camera.heading, 0)}°`],
    ["Vertical field of view", `${frame.camera.fov}°`], ["Objects", frame.objects.length],
  ], true);
  showViews();
  draw();
  moveCursor();
  drawThumbnails();
  prefetch(index);
}

/** Shows what went wrong until the next frame is shown; null when one is. */
function complain(error) {
  const message = byId("message");
  if (error === null && message.dataset.isError) message.textContent = "";
  if (error !== null) message.textContent = error.message;
  if (error === null) delete message.dataset.isError; else message.dataset.isError = "true";
}

/** A picture that cannot be decoded is shown as the browser shows it. */
const decoded = index => picture(index).decode().catch(() => {});

/** Asks for the neighbours of a frame, so that they appear at once. */
function prefetch(index) {
  for (const next of [index + 1, index + 2, index - 1]) {
    if (next < 0 || next >= source.count) continue;
    decoded(next);
    source.load(next).catch(() => {});
  }
}

function draw() {
  drawPicture();
  drawGround();
  drawRasters();
  detail(chosenObject());
  remember();
}

const remember = () => history.replaceState(null, "", address());

/** The views of a rig at this moment, side by side; none for a single camera. */
function showViews() {
  const views = [];
  const near = data.views.length;
  if (current().view) for (let index = Math.max(0, state.index - near); index < Math.min(source.known, state.index + near + 1); index++) {
    if (source.moment(index) === current().moment) views.push(index);
  }
  byId("views").replaceChildren(...views.map(index => {
    const button = element("button", { type: "button", "aria-pressed": index === state.index }, element("img", { src: picture(index).src, alt: "" }), source.view(index));
    button.addEventListener("click", () => show(index));
    return button;
  }));
}

const step = by => show((state.index + by + source.count) % source.count);

/** Goes to the next frame in which an object passes the filters. */
function stepToMatch(by) {
  for (let tried = 1; tried <= source.count; tried++) {
    const index = (state.index + by * tried + source.count * tried) % source.count;
    if (matchCounts[index] > 0) return show(index);
  }
}

function play(on) {
  clearInterval(state.timer);
  state.timer = on ? setInterval(() => step(1), 1000 / state.framesPerSecond) : null;
  byId("play-shape").setAttribute("d", on ? "M3 1h4v14H3zM9 1h4v14H9z" : "M3 1l12 7-12 7z");
  byId("play").setAttribute("aria-label", on ? "Pause" : "Play");
}

function setSpeed(framesPerSecond) {
  state.framesPerSecond = framesPerSecond;
  byId("speed").value = framesPerSecond;
  if (state.timer !== null) play(true);
}

async function copyLink() {
  let says = "Link copied";
  try { await navigator.clipboard.writeText(location.href); } catch { says = "The browser does not let the page copy; the address bar has the link"; }
  byId("message").textContent = says;
}

const nearSpeed = by => setSpeed(speeds[Math.min(speeds.length - 1, Math.max(0, speeds.indexOf(state.framesPerSecond) + by))]);
const layerKeys = { b: "box", v: "visible", a: "amodal", d: "edges", l: "lanes", j: "joints", o: "posts", k: "mask", t: "depth", r: "points" };
const keys = {
  ArrowRight: ["next frame", () => step(1)], ArrowLeft: ["previous frame", () => step(-1)],
  PageDown: ["ten frames on", () => step(10 % source.count)], PageUp: ["ten frames back", () => step(-10 % source.count)],
  Home: ["first frame", () => show(0)], End: ["last frame", () => show(source.count - 1)], " ": ["play or pause", () => play(state.timer === null)],
  "[": ["play slower", () => nearSpeed(-1)], "]": ["play faster", () => nearSpeed(1)],
  n: ["follow the next object, by distance", () => chooseNext(1)], p: ["follow the previous object", () => chooseNext(-1)],
  Escape: ["follow nothing", () => choose(null)], m: ["next frame that passes the filters", () => stepToMatch(1)],
  e: ["next event", stepToEvent],
  ...Object.fromEntries(Object.entries(layerKeys).map(([key, layer]) =>
    [key, [`show or hide: ${layers.find(([name]) => name === layer)[1]}`, () => { flip(state.shown, layer); refilter(); }]])),
  ...predictionKeys,
  "+": ["zoom in", () => zoomBy(1.5)], "-": ["zoom out", () => zoomBy(1 / 1.5)], 0: ["whole picture", () => panTo(0, 0, 1)],
  "/": ["go to the text filter", () => byId("text").focus()], c: ["copy a link to what is shown", copyLink], "?": ["this help", () => byId("help").showModal()],
};

function listenToKeys() {
  const names = { ArrowRight: "→", ArrowLeft: "←", " ": "Space" };
  table("keys", ["Key", "What it does"], Object.entries(keys).map(([key, [what]]) => [element("kbd", {}, names[key] ?? key), what]));
  document.addEventListener("keydown", event => {
    const isTyping = event.target.matches("input:not([type=range]), select");
    if (event.ctrlKey || event.metaKey || event.altKey || byId("help").open || state.frame === null) return;
    if (event.key === "Escape" && isTyping) return event.target.blur();
    // Buttons and sliders have keys of their own.
    if (isTyping || (event.target.matches("button") && event.key === " ") || (event.target.matches("input") && event.key.length > 1)) return;
    const action = keys[event.key]?.[1];
    if (action) { event.preventDefault(); action(); }
  });
}

/** Draws what depends on all frames. */
function drawAll() {
  showFilters();
  crops();
  offerPlots();
  drawTimeline();
  drawBars();
}

let isBegun = false;

/** Shows the frames for the first time. */
async function begin() {
  isBegun = true;
  listenToFilters();
  listenToPicture();
  listenToTimeline();
  listenToStrips();
  byId("slider").addEventListener("input", event => { play(false); show(Number(event.target.value)); });
  byId("play").addEventListener("click", () => play(state.timer === null));
  byId("speed").replaceChildren(...speeds.map(speed => element("option", { value: speed }, `${speed}/s`)));
  byId("speed").addEventListener("change", event => setSpeed(Number(event.target.value)));
  window.addEventListener("hashchange", async () => {
    await restore(location.hash);
    countMatches();
    drawAll();
    show(state.index);
  });
  byId("viewer").hidden = byId("tools").hidden = false;
  byId("slider").max = source.count - 1;
  setSpeed(state.framesPerSecond);
  play(false);
  const isLayersAsked = new URLSearchParams(location.hash.slice(1)).has("show");
  await restore(location.hash);
  countMatches();
  await show(state.index);
  if (state.frame && !isLayersAsked && source.has(state.index, "mask")) {
    state.shown.add("mask");
    draw();
  }
  performance.mark("first frame");
  if (state.frame) drawAll();
}

const redrawGrowth = 1.2; // What depends on all frames is drawn again only after this growth, so that a page that still reads stays responsive.
let drawnKnown = 0;

/** Takes over that more frames are known. */
async function grow({ problems, problem, limit }) {
  byId("slider").max = source.count - 1;
  byId("note").textContent = [
    data.note, source.known < source.count ? `${source.known} of ${source.count} frames are read for filters, plots and statistics.` : "",
    problem ? `${problems} lines cannot be read. ${problem}` : "", limit ?? ""].filter(text => text !== "").join(" ");
  if (!isBegun && source.count > 0) await begin();
  if (!state.frame || (source.known < source.count && source.known < drawnKnown * redrawGrowth)) return;
  drawnKnown = source.known;
  countMatches(matchCounts.length);
  drawAll();
  showViews();
  drawGround();
  drawThumbnails();
}

/** Takes over statistics and events of the frames that are known. */
function takeFigures(figures) {
  Object.assign(data, figures);
  describe(byId("facts"), Object.entries(data.facts), true);
  showStatistics();
}

byId("title").textContent = data.title;
byId("note").textContent = data.note;
listenToKeys();
byId("help-open").addEventListener("click", () => byId("help").showModal());
byId("viewer").hidden = byId("tools").hidden = true;
if (data.facts) takeFigures(data);
if (source.count > 0) begin();
source.follow(grow, takeFigures).catch(error => { byId("message").textContent = `The viewer has stopped. ${error.message}`; });

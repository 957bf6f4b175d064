// Puts the parts together: which frame is shown, the keys, and the address.
const speeds = [1, 2, 4, 8, 15, 30]; // frames per second
const hasFrames = data.frames.length > 0;

async function show(index) {
  state.index = index;
  const image = picture(index);
  try { await image.decode(); } catch { /* A picture that cannot be decoded is shown as the browser shows it. */ }
  if (state.index !== index) return;
  const frame = current();
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
  if (index + 1 < data.frames.length) picture(index + 1);
}

function draw() {
  drawPicture();
  drawGround();
  detail(chosenObject());
  remember();
}

const remember = () => history.replaceState(null, "", address());

/** The views of a rig at this moment, side by side; none for a single camera. */
function showViews() {
  const views = current().view ? data.frames.map((frame, index) => ({ frame, index })).filter(({ frame }) => frame.moment === current().moment) : [];
  byId("views").replaceChildren(...views.map(({ frame, index }) => {
    const button = element("button", { type: "button", "aria-pressed": index === state.index }, element("img", { src: picture(index).src, alt: "" }), frame.view);
    button.addEventListener("click", () => show(index));
    return button;
  }));
}

const step = by => show((state.index + by + data.frames.length) % data.frames.length);

/** Goes to the next frame in which an object passes the filters. */
function stepToMatch(by) {
  for (let tried = 1; tried <= data.frames.length; tried++) {
    const index = (state.index + by * tried + data.frames.length * tried) % data.frames.length;
    if (data.frames[index].objects.some(passes)) return show(index);
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
const layerKeys = { b: "box", v: "visible", a: "amodal", d: "edges", l: "lanes", j: "joints" };
const keys = {
  ArrowRight: ["next frame", () => step(1)], ArrowLeft: ["previous frame", () => step(-1)],
  PageDown: ["ten frames on", () => step(10 % data.frames.length)], PageUp: ["ten frames back", () => step(-10 % data.frames.length)],
  Home: ["first frame", () => show(0)], End: ["last frame", () => show(data.frames.length - 1)], " ": ["play or pause", () => play(state.timer === null)],
  "[": ["play slower", () => nearSpeed(-1)], "]": ["play faster", () => nearSpeed(1)],
  n: ["follow the next object, by distance", () => chooseNext(1)], p: ["follow the previous object", () => chooseNext(-1)],
  Escape: ["follow nothing", () => choose(null)], m: ["next frame that passes the filters", () => stepToMatch(1)],
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
    if (event.ctrlKey || event.metaKey || event.altKey || byId("help").open || !hasFrames) return;
    if (event.key === "Escape" && isTyping) return event.target.blur();
    // Buttons and sliders have keys of their own.
    if (isTyping || (event.target.matches("button") && event.key === " ") || (event.target.matches("input") && event.key.length > 1)) return;
    const action = keys[event.key]?.[1];
    if (action) { event.preventDefault(); action(); }
  });
}

document.title = `${data.title}: session report`;
byId("title").textContent = data.title;
describe(byId("facts"), Object.entries(data.facts), true);
byId("note").textContent = data.note;
listenToKeys();
byId("help-open").addEventListener("click", () => byId("help").showModal());
showStatistics();
byId("viewer").hidden = byId("tools").hidden = !hasFrames;
if (hasFrames) {
  restore(location.hash);
  listenToFilters();
  listenToPicture();
  listenToTimeline();
  byId("plot-name").value = state.plot;
  byId("slider").max = data.frames.length - 1;
  byId("slider").addEventListener("input", event => { play(false); show(Number(event.target.value)); });
  byId("play").addEventListener("click", () => play(state.timer === null));
  byId("speed").replaceChildren(...speeds.map(speed => element("option", { value: speed }, `${speed}/s`)));
  byId("speed").addEventListener("change", event => setSpeed(Number(event.target.value)));
  window.addEventListener("hashchange", () => { restore(location.hash); showFilters(); crops(); drawTimeline(); show(state.index); });
  setSpeed(state.framesPerSecond);
  play(false);
  showFilters();
  crops();
  drawTimeline();
  show(state.index);
}

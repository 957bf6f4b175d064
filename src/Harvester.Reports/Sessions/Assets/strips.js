// Two strips along the timeline: small pictures, and bars of classes and events.
const thumbnails = { height: 36, made: new Map(), wanted: [] };
const barHeight = 4;

/** The frames of the small pictures: evenly spaced, and of the camera that is shown. */
function thumbnailFrames() {
  const width = Math.max(40, Math.round(thumbnails.height * sizeOf(current())[0] / sizeOf(current())[1]));
  const number = Math.max(1, Math.min(source.count, Math.floor(byId("thumbs").clientWidth / (width + 2))));
  const views = Math.max(1, data.views.length);
  const ofView = index => {
    for (let other = index; other < Math.min(source.known, index + views); other++) if (source.view(other) === current().view) return other;
    return index;
  };
  return [...new Set(Array.from({ length: number }, (_, place) => ofView(Math.floor((place + 0.5) * source.count / number))))];
}

/** Draws the strip; pictures that it lacks are made one after the other, so that the frame itself never waits long. */
function drawThumbnails() {
  const frames = thumbnailFrames();
  const signature = frames.join();
  if (byId("thumbs").dataset.frames !== signature) {
    byId("thumbs").dataset.frames = signature;
    byId("thumbs").replaceChildren(...frames.map(index => {
      const button = element("button", { type: "button", tabindex: -1, "aria-label": `Go to frame ${source.number(index)}`, "data-index": index });
      button.append(thumbnails.made.get(index) ?? element("canvas", { height: thumbnails.height, width: 1 }));
      button.addEventListener("click", () => { play(false); show(index); });
      return button;
    }));
    const isIdle = thumbnails.wanted.length === 0;
    thumbnails.wanted = frames.filter(index => !thumbnails.made.has(index));
    if (isIdle) makeThumbnails();
  }
  for (const button of byId("thumbs").children) button.classList.toggle("passed", Number(button.dataset.index) <= state.index);
}

async function makeThumbnails() {
  while (thumbnails.wanted.length > 0) {
    const index = thumbnails.wanted[0];
    const image = new Image();
    image.src = source.picture(index);
    try {
      await image.decode();
      const width = Math.round(thumbnails.height * image.naturalWidth / image.naturalHeight);
      const canvas = element("canvas", { width, height: thumbnails.height });
      canvas.getContext("2d").drawImage(image, 0, 0, width, thumbnails.height);
      keepThumbnail(index, canvas);
    } catch { /* A picture that cannot be decoded has no small one. */ }
    thumbnails.wanted = thumbnails.wanted.filter(other => other !== index);
  }
}

function keepThumbnail(index, canvas) {
  thumbnails.made.set(index, canvas);
  if (thumbnails.made.size > 400) thumbnails.made.delete(thumbnails.made.keys().next().value);
  byId("thumbs").querySelector(`[data-index="${index}"]`)?.replaceChildren(canvas);
}

/** Draws, for each class, a bar that is the stronger the more labels pass, and a row of ticks for events. */
function drawBars() {
  const canvas = byId("bars");
  const names = Object.keys(data.classes ?? {});
  const columns = Math.max(1, Math.min(source.count, 1000));
  canvas.width = columns;
  canvas.height = (names.length + 1) * barHeight;
  canvas.style.height = `${canvas.height}px`;
  const counts = names.map(() => new Uint32Array(columns));
  const places = new Map(names.map((name, row) => [name, row]));
  for (let index = 0; index < source.known; index++) {
    const column = Math.floor(index * columns / source.count);
    for (const object of source.objects(index)) if (places.has(object.class) && passes(object)) counts[places.get(object.class)][column]++;
  }
  const context = canvas.getContext("2d");
  counts.forEach((row, place) => {
    const most = row.reduce((a, b) => Math.max(a, b), 0);
    context.fillStyle = data.colours[names[place]];
    row.forEach((count, column) => {
      if (count === 0) return;
      context.globalAlpha = 0.25 + 0.75 * count / most;
      context.fillRect(column, place * barHeight, 1, barHeight - 1);
    });
  });
  context.globalAlpha = 1;
  context.fillStyle = getComputedStyle(canvas).color;
  for (const [index] of data.events ?? []) context.fillRect(Math.floor(index * columns / source.count), names.length * barHeight, Math.max(1, columns / 400), barHeight);
  canvas.setAttribute("aria-label", `Labels over time of ${names.map(words).join(", ") || "no class"}; ${(data.events ?? []).length} events`);
}

/** What the bars show at a place: the class of the row, or the nearest event. */
function explainBars(event) {
  const box = byId("bars").getBoundingClientRect();
  const names = Object.keys(data.classes ?? {});
  const row = Math.floor((event.clientY - box.top) / box.height * (names.length + 1));
  const index = (event.clientX - box.left) / box.width * source.count;
  const nearest = (data.events ?? []).reduce((best, entry) => !best || Math.abs(entry[0] - index) < Math.abs(best[0] - index) ? entry : best, null);
  byId("bars").title = row < names.length ? words(names[row])
    : nearest && Math.abs(nearest[0] - index) < Math.max(2, source.count / 100) ? `Frame ${source.number(nearest[0])}: ${nearest[1]}` : "Events";
}

function listenToStrips() {
  seekAlong(byId("bars"));
  byId("bars").addEventListener("pointermove", explainBars);
  window.addEventListener("resize", drawThumbnails);
}

/** Goes to the next event. */
function stepToEvent() {
  const events = data.events ?? [];
  const next = events.find(([index]) => index > state.index) ?? events[0];
  if (next) { byId("message").textContent = `Frame ${source.number(next[0])}: ${next[1]}`; show(next[0]); }
}

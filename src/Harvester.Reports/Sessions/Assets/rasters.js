// What belongs to the pixels of a picture: instance masks, depth maps, and the points of LiDARs.
const rasterKinds = ["mask", "depth", "points"];
const rastersSeen = new Set(); // Kinds that some frame has had.
const farthestShown = 80; // metres; everything farther has the last colour
const drawnRasters = new Map(); // kind: { key, href }
let groundHref = null;

/** The grey values of a PNG of 8 or 16 bits without interlacing. A canvas would drop the lower byte. */
async function decodeGrey(bytes) {
  const view = new DataView(bytes);
  const [width, height, bits, kind] = [view.getUint32(16), view.getUint32(20), view.getUint8(24), view.getUint8(25)];
  if (view.getUint32(0) !== 0x89504e47 || kind !== 0 || ![8, 16].includes(bits) || view.getUint8(28) !== 0) throw new Error("The map is not a greyscale PNG of 8 or 16 bits.");
  const parts = [];
  for (let at = 8; at + 12 <= bytes.byteLength; at += 12 + view.getUint32(at)) {
    if (view.getUint32(at + 4) === 0x49444154) parts.push(new Uint8Array(bytes, at + 8, view.getUint32(at))); // IDAT
  }
  const raw = new Uint8Array(await new Response(new Blob(parts).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer());
  const step = bits / 8, stride = width * step;
  if (raw.length < height * (stride + 1)) throw new Error("The map is shorter than its header says.");
  const values = new Uint16Array(width * height);
  let above = new Uint8Array(stride), row = new Uint8Array(stride);
  for (let y = 0; y < height; y++) {
    const start = y * (stride + 1);
    unfilter(raw[start], raw.subarray(start + 1, start + 1 + stride), above, row, step);
    for (let x = 0; x < width; x++) values[y * width + x] = step === 2 ? row[2 * x] << 8 | row[2 * x + 1] : row[x];
    [above, row] = [row, above];
  }
  return { width, height, values };
}

/** Undoes the filter of a row, as the PNG specification defines it. */
function unfilter(filter, from, above, to, step) {
  for (let i = 0; i < from.length; i++) {
    const left = i < step ? 0 : to[i - step], up = above[i], corner = i < step ? 0 : above[i - step];
    let guess = 0;
    if (filter === 1) guess = left;
    else if (filter === 2) guess = up;
    else if (filter === 3) guess = left + up >> 1;
    else if (filter === 4) {
      const sum = left + up - corner, [a, b, c] = [Math.abs(sum - left), Math.abs(sum - up), Math.abs(sum - corner)];
      guess = a <= b && a <= c ? left : b <= c ? up : corner;
    }
    to[i] = from[i] + guess;
  }
}

/** A hue in degrees as red, green and blue, 0 to 255, of full saturation. */
function rgbOf(hue, light = 0.5) {
  const part = shift => { const k = (shift + hue / 30) % 12; return Math.round(255 * (light - Math.min(light, 1 - light) * Math.max(-1, Math.min(k - 3, 9 - k, 1)))); };
  return [part(0), part(8), part(4)];
}

// Near is red, far is blue.
const rangeColours = Array.from({ length: 256 }, (_, place) => rgbOf(240 * place / 255));
const colourOfRange = metres => rangeColours[Math.min(255, Math.round(metres / farthestShown * 255))];
// Successive ids have hues far apart.
const colourOfId = id => rgbOf(id * 137.508 % 360, 0.4 + id % 3 * 0.12);
const colourOfClass = id => (hex => [hex >> 16, hex >> 8 & 255, hex & 255])(parseInt((data.colours[data.objects[id]?.class] ?? "#ffffff").slice(1), 16));

/** Paints a map; a value without colour stays clear. */
function paint({ width, height, values }, colourOf) {
  const canvas = element("canvas", { width, height });
  const context = canvas.getContext("2d");
  const pixels = context.createImageData(width, height);
  const words32 = new Uint32Array(pixels.data.buffer);
  const known = new Map([[0, 0]]);
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    if (!known.has(value)) {
      const [red, green, blue] = colourOf(value);
      known.set(value, (0xff000000 | blue << 16 | green << 8 | red) >>> 0);
    }
    words32[i] = known.get(value);
  }
  context.putImageData(pixels, 0, 0);
  return canvas.toDataURL();
}

function paintPoints(points, width, height, size, placeOf) {
  const canvas = element("canvas", { width, height });
  const context = canvas.getContext("2d");
  for (let i = points.length - 5; i >= 0; i -= 5) {
    const [x, y] = placeOf(points[i], points[i + 1], points[i + 2], points[i + 3]);
    if (!(x >= 0 && y >= 0 && x < width && y < height)) continue;
    context.fillStyle = `rgb(${colourOfRange(points[i + 4])})`;
    context.fillRect(x - size / 2, y - size / 2, size, size);
  }
  return canvas.toDataURL();
}

async function render(kind, index, frame) {
  const bytes = await source.bytes(index, kind);
  if (kind === "mask") return { href: paint(await decodeGrey(bytes), state.paint === "class" ? colourOfClass : colourOfId) };
  if (kind === "depth") return { href: paint(await decodeGrey(bytes), value => colourOfRange(value / 256)) };
  const points = new Float32Array(bytes);
  const [width, height] = sizeOf(frame);
  const enlarged = Math.max(1, Math.min(2, 1600 / width));
  const { ahead, behind, side } = groundReach;
  const perMetre = 8;
  return {
    href: paintPoints(points, width * enlarged, height * enlarged, Math.max(2, width * enlarged / 400), (u, v) => [u * enlarged, v * enlarged]),
    ground: paintPoints(points, 2 * side * perMetre, (ahead + behind) * perMetre, 2, (u, v, x, y) => [(x + side) * perMetre, (y + ahead) * perMetre]),
  };
}

/** Shows the maps and points that are switched on; each is read once it is asked for. */
async function drawRasters() {
  const [index, frame] = [state.index, current()];
  fadeRasters();
  const seenBefore = rastersSeen.size;
  for (const kind of rasterKinds) if (source.has(index, kind)) rastersSeen.add(kind);
  if (rastersSeen.size > seenBefore) showFilters();
  for (const kind of rasterKinds) {
    const image = byId(`raster-${kind}`);
    const key = state.shown.has(kind) && source.has(index, kind) ? `${index} ${state.paint}` : null;
    if (drawnRasters.get(kind)?.key === key) continue;
    let drawn = { href: null };
    try { if (key !== null) drawn = await render(kind, index, frame); } catch (error) { complain(error); }
    if (state.index !== index) return;
    drawnRasters.set(kind, { key, ...drawn });
    if (drawn.href) image.setAttribute("href", drawn.href); else image.removeAttribute("href");
    if (kind === "points") { groundHref = drawn.ground ?? null; drawGround(); }
  }
  byId("stage").dataset.rasters = `${index}:${rasterKinds.filter(kind => drawnRasters.get(kind)?.href).join()}`;
}

function fadeRasters() {
  for (const kind of ["mask", "depth"]) byId(`raster-${kind}`).setAttribute("opacity", state.opacity / 100);
}

/** The points of LiDARs on the ground, if they are shown. */
function groundPoints() {
  const { ahead, behind, side } = groundReach;
  return groundHref && state.shown.has("points") ? [shape("image", { href: groundHref, x: -side, y: -ahead, width: 2 * side, height: ahead + behind })] : [];
}

// The frames of a report, which the page contains. served.js has the same for a viewer.
for (const frame of data.frames) frame.objects = frame.objects.map(seen => ({ amodal: seen.box, ...data.objects[seen.id], ...seen }));

const source = {
  count: data.frames.length,
  /** Frames of which the numbers for plots and filters are known. */
  known: data.frames.length,

  /** A frame, with all its objects. */
  load: async index => data.frames[index],
  /** The address of a frame's picture. */
  picture(index) {
    const stored = byId(`image-${index}`);
    return stored.dataset.href ?? `data:${stored.dataset.type};base64,${stored.textContent.trim()}`;
  },
  /** Whether a frame has a mask, a depth map or points. */
  has: (index, kind) => kind === "mask" && byId(`mask-${index}`) !== null,
  /** The bytes of one of these. */
  bytes: async (index, kind) => Uint8Array.from(atob(byId(`${kind}-${index}`).textContent.trim()), character => character.charCodeAt(0)).buffer,
  /** The place of a frame, or of the one after it. */
  indexOf: async frame => data.frames.findIndex(other => other.frame >= frame),

  number: index => data.frames[index].frame,
  moment: index => data.frames[index].moment,
  view: index => data.frames[index].view,
  size: index => sizeOf(data.frames[index]),
  ego: index => data.frames[index].ego.at,
  objects: index => data.frames[index].objects,
  /** The frames that show an object, with its box in each. */
  sightings: id => data.frames.flatMap((frame, index) => frame.objects.filter(object => object.id === id).map(({ box }) => ({ index, box }))),
  /** A number of a frame by the name of its plot; null for none. */
  value(name, index) {
    const frame = data.frames[index];
    const indicator = data.indicatorTable.findIndex(([known]) => known === name);
    const value = name === "speed" ? frame.speed : indicator < 0 ? frame.ego[name] : frame.indicators?.[indicator];
    return value === undefined || value === null ? null : Math.fround(value); // The viewer has it in single precision.
  },
  /** Calls back when more becomes known; a report knows all. */
  async follow() {},
};

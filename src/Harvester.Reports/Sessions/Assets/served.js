// The frames of a session, which the server has: each is asked for when it is shown, and the numbers of all frames in blocks. embedded.js
// has the same for a report.
const valueNames = ["time", "speed", "x", "y", "heading", "yawRate", "acceleration", "steering", "throttle", "brake", ...data.indicatorTable.map(([name]) => name)];
const labelNames = ["distance", "truncated", "occluded", "left", "top", "right", "bottom"];
const blocks = [];
const loaded = new Map();

/** The response to a request for something of the session; an error has the server's words. */
async function ask(path) {
  const response = await fetch(path);
  if (!response.ok) throw new Error(await response.text() || `The server answers ${response.status} to ${path}.`);
  return response;
}

/** Splits a block into its columns, as OverviewBlock writes them. */
function decodeBlock(bytes) {
  const [frames, objects] = new Uint32Array(bytes, 0, 2);
  let at = 8;
  const column = (type, length) => { const made = new type(bytes, at, length); at += made.byteLength; return made; };
  const block = { frames, values: Object.fromEntries(valueNames.map(name => [name, column(Float32Array, frames)])) };
  for (const name of ["frame", "moment", "view", "count"]) block[name] = column(Uint32Array, frames);
  for (const name of labelNames) block[name] = column(Float32Array, objects);
  block.id = column(Uint16Array, objects);
  block.start = new Uint32Array(frames + 1);
  for (let i = 0; i < frames; i++) block.start[i + 1] = block.start[i] + block.count[i];
  return block;
}

const blockOf = index => blocks[Math.floor(index / data.blockFrames)];
const within = index => index % data.blockFrames;
const keepIn = (cache, key, value, most) => { cache.set(key, value); if (cache.size > most) cache.delete(cache.keys().next().value); return value; };

async function loadFrame(index) {
  const answer = await (await ask(`frame/${index}`)).json();
  Object.assign(data.objects, answer.objects);
  answer.frame.objects = answer.frame.objects.map(seen => ({ amodal: seen.box, ...data.objects[seen.id], ...seen }));
  answer.frame.rasters = answer.rasters;
  answer.frame.map = answer.map;
  return answer.frame;
}

const source = {
  count: data.count,
  known: 0,

  /** A promise of a frame; one that failed is asked for again. */
  load: index => loaded.get(index) ?? keepIn(loaded, index, loadFrame(index).catch(error => { loaded.delete(index); throw error; }), 64),
  picture: index => `image/${index}`,
  has: (_, kind) => current().rasters.includes(kind),
  bytes: async (index, kind) => (await ask(`${kind}/${index}`)).arrayBuffer(),
  indexOf: async frame => (await ask(`index/${frame}`)).json(),

  number: index => blockOf(index)?.frame[within(index)] ?? index,
  moment: index => blockOf(index)?.moment[within(index)],
  view: index => data.views[(blockOf(index)?.view[within(index)] ?? 0) - 1]?.name,
  size: index => data.views[(blockOf(index)?.view[within(index)] ?? 0) - 1]?.size ?? [data.width, data.height],
  ego: index => [source.value("x", index), source.value("y", index)],
  /** The labels of a frame. They are valid until the next is asked for. */
  *objects(index) {
    const block = blockOf(index);
    if (!block) return;
    const row = { box: [0, 0, 0, 0] };
    for (let i = block.start[within(index)]; i < block.start[within(index) + 1]; i++) {
      row.id = block.id[i];
      row.class = data.objects[row.id]?.class;
      row.distance = block.distance[i];
      row.truncated = block.truncated[i];
      row.occluded = Number.isNaN(block.occluded[i]) ? null : block.occluded[i];
      for (let side = 0; side < 4; side++) row.box[side] = block[labelNames[3 + side]][i];
      yield row;
    }
  },
  sightings(id) {
    const seen = [];
    blocks.forEach((block, number) => {
      for (let i = 0, frame = 0; i < block.id.length; i++) {
        if (block.id[i] !== id) continue;
        while (block.start[frame + 1] <= i) frame++;
        seen.push({ index: number * data.blockFrames + frame, box: labelNames.slice(3).map(side => block[side][i]) });
      }
    });
    return seen;
  },
  value(name, index) {
    const value = blockOf(index)?.values[name]?.[within(index)];
    return value === undefined || Number.isNaN(value) ? null : value;
  },

  /** Reads what the server knows, and calls back when there is more, until a closed session is read whole. */
  async follow(grow, figures) {
    let pause = 100;
    for (let isOver = false; !isOver;) {
      const status = await (await ask("state")).json();
      const isRead = status.isIndexed && (status.read === status.frames || status.limit !== null);
      isOver = status.isClosed && isRead;
      const before = source.count + source.known;
      for (let number = Math.floor(source.known / data.blockFrames); source.known < status.read; number++) {
        const [objects, block] = await Promise.all([ask(`objects/${number}`).then(found => found.json()), ask(`block/${number}`).then(found => found.arrayBuffer())]);
        Object.assign(data.objects, objects.objects);
        blocks[number] = decodeBlock(block);
        source.known = number * data.blockFrames + blocks[number].frames;
        if (blocks[number].frames < data.blockFrames) break;
      }
      source.count = status.frames;
      if (source.count + source.known > before) {
        if (isRead) figures(await (await ask("figures")).json());
        grow(status);
      }
      await new Promise(later => setTimeout(later, pause));
      pause = isRead ? 1000 : 100;
    }
  },
};

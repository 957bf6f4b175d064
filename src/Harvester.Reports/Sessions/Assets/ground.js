// The bird's-eye view: the ego looks up, the picture's field of view is a wedge.
const groundReach = { ahead: 80, behind: 20, side: 40 }; // metres

/** Turns a place in the world into metres right of the ego and, downwards, behind it. */
function fromEgo(frame, [x, y]) {
  const angle = frame.ego.heading * Math.PI / 180; // anticlockwise from north
  const [east, north] = [x - frame.ego.at[0], y - frame.ego.at[1]];
  return [east * Math.cos(angle) + north * Math.sin(angle), east * Math.sin(angle) - north * Math.cos(angle)];
}

const pathOf = (frame, points) => points.map((point, index) => `${index ? "L" : "M"}${fromEgo(frame, point).map(value => value.toFixed(2)).join(" ")}`).join("");
const pairs = values => Array.from({ length: values.length / 2 }, (_, index) => [values[2 * index], values[2 * index + 1]]);

function drawGround() {
  const frame = current();
  const { ahead, behind, side } = groundReach;
  byId("ground").setAttribute("viewBox", `${-side} ${-ahead} ${2 * side} ${ahead + behind}`);
  const drawn = [];
  for (let ring = 20; ring <= ahead; ring += 20) {
    drawn.push(shape("circle", { r: ring, class: "ring" }), shape("text", { x: 0.5, y: -ring - 0.5, class: "metres" }, `${ring} m`));
  }
  drawn.push(fieldOfView(frame), ...mapLanes(frame), ...groundPoints());
  for (const line of frame.lines ?? []) drawn.push(shape("path", { d: pathOf(frame, pairs(line.ground)), class: `ground-line ${line.colour ?? ""}` }));
  drawn.push(shape("path", { d: pathOf(frame, egoPath()), class: "path" }));
  // A part is drawn where what it belongs to is not.
  const objects = frame.objects.filter(isDrawn), ids = new Set(objects.map(object => object.id));
  drawn.push(...objects.filter(object => !ids.has(object.parent)).map(object => footprint(frame, object)));
  drawn.push(shape("path", { d: "M-1 2.2L0 -2.6L1 2.2Z", class: "ego" }));
  byId("ground").replaceChildren(...drawn);
}

/** The lanes of the map; those of the ego and ahead of it are on top. */
function mapLanes(frame) {
  const order = ["way", "lane", "ahead", "own"];
  return [...frame.map ?? []].sort((a, b) => order.indexOf(a.role) - order.indexOf(b.role)).map(lane => {
    const mark = shape("path", { d: `${pathOf(frame, [...pairs(lane.left), ...pairs(lane.right).reverse()])}Z`, class: `map-lane ${lane.role}` });
    mark.append(shape("title", {}, lane.id));
    return mark;
  });
}

/** Where the ego is in the frames around this one, until it jumps to another place. */
function egoPath() {
  const near = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) < groundReach.ahead;
  const places = [current().ego.at];
  for (let i = state.index - 1; i >= 0 && i < source.known && near(source.ego(i), places[0]) && places.length < 200; i--) places.unshift(source.ego(i));
  for (let i = state.index + 1; i < source.known && near(source.ego(i), places.at(-1)) && places.length < 400; i++) places.push(source.ego(i));
  return places;
}

function fieldOfView(frame) {
  const [width, height] = sizeOf(frame);
  const half = Math.atan(Math.tan(frame.camera.fov * Math.PI / 360) * width / height);
  const facing = (frame.ego.heading - frame.camera.heading) * Math.PI / 180; // clockwise from the ego's direction
  const [x, y] = fromEgo(frame, frame.camera.position);
  const end = angle => `${x + 200 * Math.sin(angle)} ${y - 200 * Math.cos(angle)}`;
  return shape("path", { d: `M${x} ${y}L${end(facing - half)}L${end(facing + half)}Z`, class: "view" });
}

function footprint(frame, object) {
  const [x, y] = fromEgo(frame, object.at);
  const [length, width] = object.size.map(side => Math.max(side, 0.6)); // A plate would be invisible.
  const mark = shape("rect", {
    x: -width / 2, y: -length / 2, width, height: length, transform: `translate(${x} ${y}) rotate(${frame.ego.heading - object.heading})`,
    class: object.id === state.chosen ? "footprint chosen" : "footprint", fill: colour(object) });
  mark.append(shape("title", {}, `${words(object.class)} ${object.id}`));
  attend(mark, object);
  return mark;
}

// How many labels of each frame pass the filters.
let matchCounts = [];
let labelCounts = [];

/** Counts again from a frame on: from the first after a change of filters, from the first new one when more frames become known. */
function countMatches(from = 0) {
  matchCounts.length = labelCounts.length = from;
  for (let index = from; index < source.known; index++) {
    let passed = 0, all = 0;
    for (const object of source.objects(index)) {
      all++;
      if (passes(object)) passed++;
    }
    matchCounts.push(passed);
    labelCounts.push(all);
  }
}

function describeMatches() {
  const sum = counts => counts.reduce((total, count) => total + count, 0);
  byId("matches").textContent = `${sum(matchCounts)} of ${sum(labelCounts)} labels in ${matchCounts.filter(count => count > 0).length} of ${source.known} frames`;
}

"use strict";

const byId = id => document.getElementById(id);
const svgNamespace = "http://www.w3.org/2000/svg";

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

function shape(name, attributes, text = "") {
  const made = document.createElementNS(svgNamespace, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

const fixed = (value, digits = 1) => value === null || value === undefined ? "not determined" : value.toFixed(digits);
const percent = value => value === null ? "not determined" : `${Math.round(value * 100)} %`;
const words = name => name.replace(/[A-Z]/g, capital => ` ${capital.toLowerCase()}`);
const flip = (set, value) => set.has(value) ? set.delete(value) : set.add(value);

function describe(list, entries, grouped) {
  list.replaceChildren(...entries.flatMap(([term, text]) => {
    const pair = [element("dt", {}, term), element("dd", {}, String(text))];
    return grouped ? [element("div", {}, ...pair)] : pair;
  }));
}

function table(id, columns, rows, foot) {
  const row = ([name, ...cells]) => element("tr", {}, element("th", { scope: "row" }, ...[name].flat()), ...cells.map(cell => element("td", {}, String(cell))));
  byId(id).append(
    element("thead", {}, element("tr", {}, ...columns.map(column => element("th", { scope: "col" }, column)))),
    element("tbody", {}, ...rows.map(row)),
    ...(foot ? [element("tfoot", {}, row(foot))] : []));
}

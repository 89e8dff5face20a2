"use strict";
// Tables: a click on a column's name sorts by it, numbers by value, a second click turns it round.
for (const table of document.querySelectorAll("table.sortable")) {
  const heads = [...table.tHead.rows[0].cells], body = table.tBodies[0];
  const value = (row, i) => {
    const text = row.cells[i].textContent.trim(), n = parseFloat(text);
    return text === "-" || text === "" ? null : Number.isNaN(n) ? text.toLowerCase() : n;
  };
  heads.forEach((head, i) => head.firstElementChild.addEventListener("click", () => {
    const sign = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    const rows = [...body.rows].map(row => [value(row, i), row]);
    const one = (a, b) => a === null ? 1 : b === null ? -1
      : typeof a === typeof b ? sign * (a < b ? -1 : a > b ? 1 : 0) : typeof a === "number" ? -1 : 1;
    rows.sort((a, b) => a[0] === b[0] ? 0 : one(a[0], b[0]));
    body.append(...rows.map(row => row[1]));
    heads.forEach(other => other.setAttribute("aria-sort", "none"));
    head.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
  }));
}
// Replays: poses are displacements and rotations in steps; bodies move as they are.
for (const figure of document.querySelectorAll("figure.replay")) {
  const { blocks, centres, step, turn, times, frames } = JSON.parse(figure.querySelector("script").textContent);
  const all = figure.querySelectorAll(".bodies path"), bodies = blocks.map(i => all[i]);
  const slider = figure.querySelector("input"), button = figure.querySelector("button");
  const output = figure.querySelector("output"), last = frames.length - 1;
  let playing = 0;
  const show = f => {
    frames[f].forEach((_, j, p) => {
      if (j % 3) return;
      const [cx, cy] = centres[j / 3], degrees = p[j + 2] * turn * 180 / Math.PI;
      bodies[j / 3].setAttribute("transform",
        `translate(${p[j] * step} ${p[j + 1] * step}) rotate(${degrees} ${cx} ${cy})`);
    });
    slider.value = f;
    output.textContent = `t = ${times[f].toFixed(1)}`;
    slider.setAttribute("aria-valuetext", output.textContent);
  };
  const stop = () => { cancelAnimationFrame(playing); playing = 0; button.textContent = "Play"; };
  button.addEventListener("click", () => {
    if (playing) return stop();
    const from = +slider.value >= last ? 0 : +slider.value;
    let began;
    const tick = now => {
      began ??= now;
      const f = Math.min(last, from + Math.floor((now - began) / 70));
      if (f !== +slider.value) show(f);
      if (f < last) playing = requestAnimationFrame(tick); else stop();
    };
    if (from === 0) show(0);
    button.textContent = "Pause";
    playing = requestAnimationFrame(tick);
  });
  slider.addEventListener("input", () => { stop(); show(+slider.value); });
  show(last);
}

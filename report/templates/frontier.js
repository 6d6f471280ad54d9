// The chart of speed against error for the scene, scalar and ISA that are picked.
// Drawn in the page's own pixels, so that its words stay readable on a phone.
"use strict";
{
  const data = JSON.parse(document.getElementById("frontier-data").textContent);
  const section = document.getElementById("frontier");
  const plot = document.getElementById("frontier-plot");
  const said = document.getElementById("frontier-row");
  const pick = (name) => document.getElementById(`frontier-${name}`);
  const ALL = "all", ON_FRONTIER = 1, ON_OWN_FRONTIER = 2;
  let marks = [], shown = -1;

  const make = (name, attributes, parent, text) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    if (text !== undefined) element.textContent = text;
    parent?.append(element);
    return element;
  };
  const tag = (name, text, kind = "") => {
    const element = document.createElement(name);
    if (text !== undefined) element.textContent = text;
    if (kind) element.className = kind;
    return element;
  };
  const swatch = (method) => {
    const [colour, hollow] = data.methods[method];
    const dot = tag("span", "", hollow ? "swatch hollow" : "swatch");
    dot.style.setProperty("--c", colour);
    return dot;
  };
  const fill = (select, options, kept) => {
    select.replaceChildren(...options.map(([value, text]) => new Option(text, value)));
    if (options.some(([value]) => value === kept)) select.value = kept;
  };

  // The rows of a pick, the slowest first.
  const rowsOf = (scalar, family, isa) => {
    const { speeds, answers } = data.scalars[scalar];
    const flag = isa === ALL ? ON_FRONTIER : ON_OWN_FRONTIER;
    return speeds.flatMap(([method, own, ns, low, high, time, interval, noise], at) => {
      const answer = answers[family][at];
      if (!answer || (isa !== ALL && isa !== own)) return [];
      const [wrong, of, rateLow, rateHigh, share, flags] = answer;
      return [{ method, isa: own, speed: 1e9 / ns, slow: 1e9 / high, fast: 1e9 / low,
        time, interval, noise, wrong, of, rate: wrong / of, rateLow, rateHigh, share,
        front: (flags & flag) !== 0 }];
    }).sort((a, b) => a.speed - b.speed || b.rate - a.rate);
  };

  // Outlines of the charts' markers, of radius 1.
  const polygon = (corners, turn, inner) => Array.from(
    { length: inner ? 2 * corners : corners }, (_, k) => {
      const angle = turn + (2 * Math.PI * k) / (inner ? 2 * corners : corners);
      const radius = inner && k % 2 ? inner : 1;
      return [radius * Math.sin(angle), -radius * Math.cos(angle)];
    });
  const PLUS = [[-.35, -1], [.35, -1], [.35, -.35], [1, -.35], [1, .35], [.35, .35],
    [.35, 1], [-.35, 1], [-.35, .35], [-1, .35], [-1, -.35], [-.35, -.35]];
  const turned = PLUS.map(([x, y]) => [(x - y) * Math.SQRT1_2, (x + y) * Math.SQRT1_2]);
  const SHAPES = {
    "<": polygon(3, -Math.PI / 2), ">": polygon(3, Math.PI / 2), v: polygon(3, Math.PI),
    p: polygon(5, 0), s: polygon(4, Math.PI / 4), D: polygon(4, 0), h: polygon(6, 0),
    "*": polygon(5, 0, .45), P: PLUS, X: turned, d: [[0, -1], [.6, 0], [0, 1], [-.6, 0]],
  };
  const outline = (marker, x, y, size) => {
    const corners = SHAPES[marker] ?? polygon(16, 0);
    return `M${corners.map(([u, v]) =>
      `${(x + size * u).toFixed(1)},${(y + size * v).toFixed(1)}`).join("L")}Z`;
  };

  const perSecond = (value) => {
    for (const [unit, size] of [["G", 1e9], ["M", 1e6], ["k", 1e3]]) {
      if (value >= .999 * size) return `${+(value / size).toPrecision(3)} ${unit}`;
    }
    return `${value}`;
  };
  const shareTick = (exponent) => exponent >= -3
    ? `${+(100 * 10 ** exponent).toPrecision(1)} %`
    : `${+(1e6 * 10 ** exponent).toPrecision(1)} ppm`;

  // Heights moved apart to `gap`, in their order, the last within `bottom`.
  const apart = (heights, gap, top, bottom) => {
    const moved = [];
    for (const y of heights) moved.push(Math.max(y, (moved.at(-1) ?? top - gap) + gap));
    for (let k = moved.length - 1, most = bottom; k >= 0; --k, most -= gap) {
      moved[k] = Math.min(moved[k], most);
    }
    return moved;
  };

  const draw = () => {
    const scalar = pick("scalar").value, family = pick("family").value;
    const isa = pick("isa").value;
    const width = plot.clientWidth, wide = width > 640;
    const height = Math.round(Math.min(520, Math.max(320, .62 * width)));
    const left = 58, right = width - (wide ? 250 : 14), top = 26, bottom = height - 44;
    const rows = rowsOf(scalar, family, isa);
    marks = []; show(-1);
    const what = `${scalar}, ${data.families[family]}, ` +
      (isa === ALL ? "all instruction sets" : isa);
    const front = rows.filter((row) => row.front);
    const words = front.map((row) => `${row.method} on ${row.isa}: ${row.time} ns a point, ` +
      (row.wrong ? `${row.share} wrong` : "no wrong answer")).join("; ");
    const svg = make("svg", { viewBox: `0 0 ${width} ${height}`, role: "img",
      "aria-label": `Speed against error, ${what}. ${rows.length} marks. ` +
        (words ? `On the frontier: ${words}.` : "No frontier.") });
    plot.replaceChildren(svg);
    legend(new Set(rows.map((row) => row.isa)));
    listFrontier(front, what);
    if (!rows.length) {
      make("text", { x: left, y: height / 2 }, svg, "Nothing was measured for this pick.");
      return;
    }

    const xs = rows.flatMap((row) => [row.slow, row.fast]).map(Math.log10);
    const x0 = Math.min(...xs) - .05, x1 = Math.max(...xs) + .05;
    const x = (v) => left + ((Math.log10(v) - x0) / (x1 - x0)) * (right - left);
    const rates = rows.map((row) => row.rate || row.rateHigh).filter((rate) => rate > 0);
    const floor = Math.floor(Math.log10(Math.min(...rates)));
    const ceiling = Math.min(Math.ceil(Math.log10(Math.max(...rates)) + .05), Math.log10(1.3));
    const zeros = rows.some((row) => !row.wrong);
    const ground = zeros ? bottom - 34 : bottom;
    const y = (rate) => rate > 0
      ? ground - ((Math.log10(rate) - floor) / (ceiling - floor)) * (ground - top)
      : bottom - 14;
    if (zeros) {
      make("rect", { class: "lane", x: left, y: ground + 6, width: right - left,
        height: bottom - ground - 6 }, svg);
      make("text", { x: left - 6, y: bottom - 10, "text-anchor": "end" }, svg, "none");
    }
    const step = Math.ceil((ceiling - floor) / 8);
    for (let e = Math.floor(ceiling); e >= floor; e -= step) {
      const at = y(10 ** e);
      make("line", { class: "grid", x1: left, x2: right, y1: at, y2: at }, svg);
      make("text", { x: left - 6, y: at + 4, "text-anchor": "end" }, svg, shareTick(e));
    }
    const fine = (right - left) / (x1 - x0) > 130;
    for (let e = Math.floor(x0); e <= x1; ++e) {
      for (const m of fine ? [1, 2, 5] : [1]) {
        const value = m * 10 ** e, at = x(value);
        if (at < left || at > right) continue;
        make("line", { class: "grid", x1: at, x2: at, y1: top, y2: bottom }, svg);
        make("text", { x: at, y: bottom + 16, "text-anchor": "middle" }, svg, perSecond(value));
      }
    }
    make("text", { class: "soft", x: 6, y: 15 }, svg, "share wrong (log)   ↓ better");
    make("text", { class: "soft", x: right, y: bottom + 34, "text-anchor": "end" }, svg,
      wide ? "points decided per second (log scale)   better →" : "points per second (log)   better →");

    const known = new Set([...data.classics, ...front.map((row) => row.method)]);
    const order = [...rows.keys()].sort((a, b) => rank(rows[a]) - rank(rows[b]));
    function rank(row) { return row.front ? 2 : known.has(row.method) ? 1 : 0; }
    if (front.length) {
      const path = front.map((row, k) => k
        ? `V${y(row.rate).toFixed(1)}H${x(row.speed).toFixed(1)}`
        : `M${x(row.speed).toFixed(1)},${y(row.rate).toFixed(1)}`).join("");
      make("path", { class: "front", d: path }, svg);
    }
    for (const at of order) {
      const row = rows[at], [colour, hollow] = data.methods[row.method];
      const kind = row.front ? "on" : known.has(row.method) ? "faint" : "other";
      const mark = { row, x: x(row.speed), y: y(row.rate) };
      marks[at] = mark;
      const size = (row.front ? 6.5 : 4.5) * (data.isas[row.isa] === "*" ? 1.4 : 1);
      const path = make("path", { class: `mark ${kind}${hollow ? " hollow" : ""}`,
        d: outline(data.isas[row.isa], mark.x, mark.y, size) }, svg);
      if (kind !== "other") path.style.setProperty("--c", colour);
    }
    if (wide) {
      const best = new Map(front.map((row) => [row.method, row]));
      const named = [...best.values()].sort((a, b) => y(a.rate) - y(b.rate));
      const heights = apart(named.map((row) => y(row.rate)), 15, top, bottom);
      named.forEach((row, k) => {
        make("line", { class: "lead", x1: x(row.speed), y1: y(row.rate), x2: right + 8,
          y2: heights[k] }, svg);
        make("text", { x: right + 11, y: heights[k] + 4 }, svg, row.method);
      });
    }
  };

  // The markers of the ISAs; the row of a mark says its ISA in words.
  const legend = (isas) => {
    document.getElementById("frontier-legend").replaceChildren(
      ...Object.entries(data.isas).filter(([isa]) => isas.has(isa)).map(([isa, marker]) => {
        const entry = tag("span"), icon = make("svg", { width: 14, height: 14 });
        make("path", { class: "key", d: outline(marker, 7, 7, marker === "*" ? 6.5 : 5) }, icon);
        entry.append(icon, isa);
        return entry;
      }));
  };

  const listFrontier = (front, what) => {
    const table = document.getElementById("frontier-table");
    table.caption.textContent = `The frontier of ${what}: the fastest first.`;
    table.tBodies[0].replaceChildren(...[...front].reverse().map((row) => {
      const line = tag("tr"), name = tag("td");
      name.append(swatch(row.method), row.method);
      line.append(name, tag("td", row.isa), tag("td", row.time, "number"),
        tag("td", row.interval), tag("td", row.share, "number"),
        tag("td", row.of.toLocaleString("en"), "number"));
      return line;
    }));
  };

  // Says the row of a mark and rings it; of none: -1.
  const show = (at) => {
    if (at === shown && at >= 0) return;
    shown = at;
    plot.querySelector(".shown")?.remove();
    said.replaceChildren();
    if (at < 0) return;
    const { row, x, y } = marks[at];
    make("circle", { class: "shown", cx: x, cy: y, r: 11 }, plot.querySelector("svg"));
    said.append(swatch(row.method), tag("strong", `${row.method} on ${row.isa}`),
      `: ${row.time} ns a point (${row.interval}), ${perSecond(row.speed)} points per second; ` +
      (row.wrong ? `${row.share} wrong (${row.wrong.toLocaleString("en")} of ` +
        `${row.of.toLocaleString("en")})` : `no wrong answer in ${row.of.toLocaleString("en")}`) +
      (row.front ? "; on the frontier" : "") + (row.noise ? `; noisy: ${row.noise}` : "") + ".");
  };

  plot.addEventListener("pointermove", (event) => {
    const box = plot.querySelector("svg").getBoundingClientRect();
    let near = -1, least = 18;
    marks.forEach((mark, at) => {
      const far = Math.hypot(event.clientX - box.left - mark.x, event.clientY - box.top - mark.y);
      if (far < least) { near = at; least = far; }
    });
    if (near >= 0) show(near);
  });
  plot.addEventListener("focus", () => {
    if (shown < 0 && marks.length) show(Math.max(marks.findLastIndex((m) => m.row.front), 0));
  });
  plot.addEventListener("keydown", (event) => {
    const last = marks.length - 1;
    const to = { ArrowRight: shown + 1, ArrowUp: shown + 1, ArrowLeft: shown - 1,
      ArrowDown: shown - 1, Home: 0, End: last, Escape: -1 }[event.key];
    if (to === undefined || last < 0) return;
    event.preventDefault();
    show(event.key === "Escape" ? -1 : Math.min(Math.max(to, 0), last));
  });

  const offerIsas = () => {
    const own = new Set(data.scalars[pick("scalar").value].speeds.map((row) => row[1]));
    const isas = Object.keys(data.isas).filter((isa) => own.has(isa));
    fill(pick("isa"), [[ALL, "all"], ...isas.map((isa) => [isa, isa])], pick("isa").value);
  };
  const offerFamilies = () => {
    const answers = data.scalars[pick("scalar").value].answers;
    fill(pick("family"), Object.entries(data.families).filter(([key]) => key in answers),
      pick("family").value);
  };
  const scalars = Object.keys(data.scalars);
  if (scalars.length) {
    fill(pick("scalar"), scalars.map((scalar) => [scalar, scalar]));
    offerIsas();
    offerFamilies();
    section.hidden = false;
    for (const name of ["family", "isa"]) pick(name).addEventListener("change", draw);
    pick("scalar").addEventListener("change", () => { offerIsas(); offerFamilies(); draw(); });
    let width = plot.clientWidth;
    draw();
    // In the next frame: a drawing has a height of its own, and to resize what is
    // observed while it is reported is an error.
    new ResizeObserver(() => requestAnimationFrame(() => {
      if (plot.clientWidth !== width) { width = plot.clientWidth; draw(); }
    })).observe(plot);
  }
}

// Sorting and filtering of the tables. A cell is sorted by its data-v if it has
// one, else by its text, in a column of numbers by the number that begins it;
// cells without a value stay last
// in either direction. Rows that are equal keep their order.
"use strict";
for (const table of document.querySelectorAll("table.sortable")) {
  const body = table.tBodies[0];
  const headers = [...table.tHead.rows[0].cells];

  const compare = (column, numeric, direction) => (one, two) => {
    const key = ({ cells: { [column]: cell } }) => cell.dataset.v ??
      (numeric ? parseFloat(cell.firstChild.data) : cell.textContent);
    const a = key(one), b = key(two);
    if (a === "" || b === "") return (a === "") - (b === "");
    return direction * (numeric ? a - b : a.localeCompare(b, "en", { numeric: true }));
  };

  headers.forEach((header, column) => {
    header.querySelector("button").addEventListener("click", () => {
      const up = header.getAttribute("aria-sort") !== "ascending";
      for (const other of headers) other.removeAttribute("aria-sort");
      header.setAttribute("aria-sort", up ? "ascending" : "descending");
      const numeric = header.classList.contains("number");
      const rows = [...body.rows].sort(compare(column, numeric, up ? 1 : -1));
      body.append(...rows);
    });
  });

  const filter = document.querySelector(`input[data-table="${table.id}"]`);
  if (filter) {
    const shown = filter.parentElement.querySelector("output");
    const apply = () => {
      const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
      let count = 0;
      for (const row of body.rows) {
        const text = row.textContent.toLowerCase();
        row.hidden = !words.every((word) => text.includes(word));
        count += !row.hidden;
      }
      shown.textContent = `${count} of ${body.rows.length} rows`;
    };
    filter.addEventListener("input", apply);
    apply();
  }
}

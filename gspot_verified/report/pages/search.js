"use strict";
const form = document.getElementById("filters");
const rows = [...document.querySelectorAll("tr[data-outcome]")];
const texts = rows.map((row) => row.textContent.toLowerCase());
function filter() {
  const wanted = new FormData(form);
  const words = wanted.get("words").toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  rows.forEach((row, i) => {
    const chosen = ["outcome", "rung", "section"].every((key) => !wanted.get(key) || row.dataset[key] === wanted.get(key));
    row.hidden = !(chosen && words.every((word) => texts[i].includes(word)));
    shown += row.hidden ? 0 : 1;
  });
  document.getElementById("shown").textContent = `${shown} of ${rows.length}`;
}
form.hidden = false;
form.addEventListener("input", filter);
form.addEventListener("submit", (event) => event.preventDefault());
filter();

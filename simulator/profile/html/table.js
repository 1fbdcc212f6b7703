// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Tables that are sorted by any column and searched.

/** A sortable table. Each column has a title, value(row) to sort by, cell(row)
 * for its element, and text: true if it is sorted as text. Rows that do not
 * contain the searched text are left out; text(row) is what is searched. */
class SortedTable {
  constructor({ columns, rows, text, onSelect, sortBy = 0, limit = 300,
    empty = "Nothing." }) {
    Object.assign(this, { columns, rows, text, onSelect, limit, empty });
    this.sortColumn = sortBy;
    this.descending = !columns[sortBy].text;
    this.needle = "";
    this.body = el("tbody");
    this.footer = el("p.more");
    this.headings = columns.map((column, index) => el("th", {
      class: column.text || column.left ? "" : "number", title: column.meaning,
    }, el("button", { onclick: () => this.sort(index) }, column.title)));
    this.element = el("div.table", {},
      el("table", {}, el("thead", {}, el("tr", {}, this.headings)), this.body),
      this.footer);
    this.show();
  }

  sort(column) {
    this.descending = column === this.sortColumn
      ? !this.descending : !this.columns[column].text;
    this.sortColumn = column;
    this.show();
  }

  search(needle) {
    this.needle = needle.toLowerCase();
    this.show();
  }

  shownRows() {
    const { value } = this.columns[this.sortColumn];
    const sign = this.descending ? -1 : 1;
    return this.rows
      .filter((row) => this.text(row).toLowerCase().includes(this.needle))
      .map((row) => ({ row, key: value(row) }))
      .sort((a, b) => sign * (a.key < b.key ? -1 : a.key > b.key ? 1 : 0))
      .map(({ row }) => row);
  }

  show() {
    this.headings.forEach((heading, index) => {
      if (index !== this.sortColumn) heading.removeAttribute("aria-sort");
      else heading.setAttribute("aria-sort",
        this.descending ? "descending" : "ascending");
    });
    const rows = this.shownRows();
    this.body.replaceChildren(
      ...rows.slice(0, this.limit).map((row) => this.rowElement(row)));
    const hidden = rows.length - this.limit;
    this.footer.replaceChildren(...(hidden > 0
      ? [`${count(hidden)} more: `, el("button", {
        onclick: () => { this.limit = Infinity; this.show(); },
      }, "show all")]
      : rows.length > 0 ? []
        : [this.needle === "" ? this.empty : "Nothing found."]));
  }

  rowElement(row) {
    const cells = this.columns.map((column) => column.cell(row));
    if (!this.onSelect) return el("tr", {}, cells);
    const select = () => this.onSelect(row);
    return el("tr.selectable", {
      tabindex: 0, onclick: select,
      onkeydown: (event) => {
        if (event.key === "Enter") select();
      },
    }, cells);
  }
}

/** A column of thread-cycles with heat. */
function cyclesColumn(title, value, most, meaning) {
  return {
    title, meaning, value,
    cell: (row) => heatCell(value(row), most, percent(value(row), whole)),
  };
}

/** A column with a plain number. */
function countColumn(title, value, meaning, format = short) {
  return {
    title, meaning, value,
    cell: (row) => el("td.number", { title: count(value(row)) },
      value(row) === 0 ? "" : format(value(row))),
  };
}

/** A column with the bar of uses; sorted by what was lost. */
function barColumn(scale) {
  return {
    title: "issued and lost", left: true, meaning: "sorted by the cycles lost",
    value: (row) => sum(row.counts) - row.counts[0],
    cell: (row) => el("td.bar", {}, usesBar(row.counts, scale)),
  };
}

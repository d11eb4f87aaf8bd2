// The page on which written answers are marked: points and comments by keys, kept in the browser
// until questions.csv has them. All that students wrote is set as text and never as HTML.
(() => {
  const $ = (id) => document.getElementById(id);
  const {
    columns,
    questions,
    rows,
    formula,
    inside,
    mark: byteOrderMark,
  } = JSON.parse($("data").textContent);
  const KEEP = "written-answer ";
  const BANK_KEYS = "asdfg";
  const place = Object.fromEntries(columns.map((name, index) => [name, index]));
  const formulaFirst = new RegExp(formula, "u");
  const formulaInside = new RegExp(inside, "gu");

  // ---- what is kept ----

  let storage = null;
  try {
    localStorage.setItem(`${KEEP}try`, "1");
    localStorage.removeItem(`${KEEP}try`);
    storage = localStorage;
  } catch {} // a browser may forbid it for files

  const answers = rows
    .filter((row) => row.question !== null)
    .map((row) => ({
      row,
      table: { mark: row.mark, comment: row.comment },
      mark: row.mark,
      comment: row.comment,
    }));
  function read(text) {
    try {
      return JSON.parse(text);
    } catch {
      return null;
    }
  }

  let overruled = 0;
  for (const answer of answers) {
    const kept = read(storage?.getItem(KEEP + answer.row.key) ?? "null");
    if (!kept) continue;
    const sameTable =
      kept.table.mark === answer.table.mark && kept.table.comment === answer.table.comment;
    if (sameTable) {
      answer.mark = kept.mark;
      answer.comment = kept.comment;
      continue;
    }
    // The table has changed since: by these points, or by others that were typed into it.
    if (kept.mark !== answer.mark || kept.comment !== answer.comment) overruled += 1;
    storage.removeItem(KEEP + answer.row.key);
  }

  const isChanged = (answer) =>
    answer.mark !== answer.table.mark || answer.comment !== answer.table.comment;
  const hasPoints = (answer) => answer.mark.trim() !== "";
  let unsaved = answers.some(isChanged);

  function keep(answer) {
    unsaved = true;
    const { table, mark, comment } = answer;
    if (isChanged(answer))
      storage?.setItem(KEEP + answer.row.key, JSON.stringify({ table, mark, comment }));
    else storage?.removeItem(KEEP + answer.row.key);
  }

  // ---- where we are ----

  const past = [];
  let shown = answers;
  let at = 0;

  const say = (text) => {
    $("state").textContent = text;
  };

  function choose(question) {
    shown =
      question === ""
        ? answers
        : answers.filter((answer) => answer.row.question === Number(question));
    const first = shown.findIndex((answer) => !hasPoints(answer));
    at = Math.max(first, 0);
    show();
  }

  function go(step) {
    const target = at + step;
    if (target < 0 || target >= shown.length) {
      say(step > 0 ? "This is the last answer." : "This is the first answer.");
      return;
    }
    at = target;
    say("");
    show();
  }

  function goToWaiting() {
    const order = [...shown.keys()];
    const next = [...order.slice(at + 1), ...order.slice(0, at)].find(
      (index) => !hasPoints(shown[index]),
    );
    if (next === undefined) {
      const left = answers.filter((answer) => !hasPoints(answer)).length;
      const here = hasPoints(shown[at])
        ? "All answers here have points."
        : "This is the only one without points.";
      say(left || !unsaved ? here : `${here} Save questions.csv (w).`);
      return;
    }
    at = next;
    say("");
    show();
  }

  function change(what) {
    const answer = shown[at];
    past.push({ answer, mark: answer.mark, comment: answer.comment });
    Object.assign(answer, what);
    keep(answer);
    show();
  }

  function undo() {
    const last = past.pop();
    if (!last) {
      say("Nothing is left to undo.");
      return;
    }
    Object.assign(last.answer, { mark: last.mark, comment: last.comment });
    keep(last.answer);
    if (!shown.includes(last.answer)) {
      $("question").value = "";
      shown = answers;
    }
    at = shown.indexOf(last.answer);
    show();
  }

  function give(points) {
    const most = questions[shown[at].row.question].of;
    if (points < 0 || points > most) {
      say(`There are 0 to ${most} points.`);
      return;
    }
    say("");
    change({ mark: String(points) });
  }

  function giveHalf() {
    const most = questions[shown[at].row.question].of;
    const points = Number(shown[at].mark.replace(",", ".")) || 0;
    give(points + 0.5 <= most ? points + 0.5 : points - 0.5);
  }

  // ---- comments that were written before ----

  function bank() {
    const counts = new Map();
    for (const answer of answers) {
      if (answer.row.question !== shown[at].row.question) continue;
      for (const line of answer.comment.split("\n").filter((text) => text.trim())) {
        counts.set(line, (counts.get(line) ?? 0) + 1);
      }
    }
    return [...counts.keys()].slice(0, BANK_KEYS.length);
  }

  function toggleComment(line) {
    const lines = shown[at].comment.split("\n").filter((text) => text.trim());
    const without = lines.filter((text) => text !== line);
    change({ comment: (without.length < lines.length ? without : [...lines, line]).join("\n") });
  }

  // ---- what is seen ----

  function button(text, pressed, click) {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = text;
    made.setAttribute("aria-pressed", String(pressed));
    made.addEventListener("click", click);
    return made;
  }

  function show() {
    const answer = shown[at];
    const question = questions[answer.row.question];
    const name = $("names").checked ? answer.row.student : `answer ${at + 1}`;
    $("whose").textContent = `${name}: ${question.question}, ${question.notebook}`;
    $("answer").textContent = answer.row.answer;
    $("picture").hidden = !/!\[|<img/i.test(answer.row.answer);
    $("task").textContent = question.task;
    $("rubric").textContent = question.rubric;
    $("model").textContent = question.model;
    const typed = answer.mark.trim().replace(",", ".");
    const steps = Array.from({ length: 2 * question.of + 1 }, (_, index) => index / 2);
    const focused = $("points").contains(document.activeElement);
    $("points").replaceChildren(
      ...steps.map((points) =>
        button(String(points), typed !== "" && Number(typed) === points, () => give(points)),
      ),
    );
    if (focused) $("points").querySelector('[aria-pressed="true"]')?.focus();
    const valid = typed === "" || (Number(typed) >= 0 && Number(typed) <= question.of);
    $("wrong").textContent = valid
      ? ""
      : `The table has ${answer.mark}, which is not a number from 0 to ${question.of}.`;
    if ($("comment").value !== answer.comment) $("comment").value = answer.comment;
    showBank();
    showProgress();
  }

  function showBank() {
    const lines = shown[at].comment.split("\n");
    $("bank").replaceChildren(
      ...bank().map((line, index) =>
        button(`${BANK_KEYS[index]}  ${line}`, lines.includes(line), () => toggleComment(line)),
      ),
    );
  }

  function showProgress() {
    const done = shown.filter(hasPoints).length;
    $("progress").max = shown.length;
    $("progress").value = done;
    $("count").textContent = `${done} of ${shown.length} have points, this is ${at + 1}`;
    for (const option of $("question").options) {
      const those = answers.filter(
        (answer) => option.value === "" || answer.row.question === Number(option.value),
      );
      const left = those.filter((answer) => !hasPoints(answer)).length;
      option.textContent = `${option.dataset.name} (${left ? `${left} left` : "done"})`;
    }
  }

  // ---- questions.csv ----

  function cell(text) {
    // No spreadsheet is to read a comment as a formula.
    const whole = formulaFirst.test(text) ? `'${text}` : text;
    return whole.replace(formulaInside, "$1'");
  }

  function quoted(text) {
    return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  }

  function table() {
    const changed = new Map(answers.map((answer) => [answer.row, answer]));
    const lines = rows.map((row) => {
      const cells = [...row.cells];
      if (row.question !== null) {
        const { of, cells: shared } = questions[row.question];
        Object.entries(shared).forEach(([name, text]) => {
          cells[place[name]] = text;
        });
        cells[place.of] = String(of);
        cells[place.answer] = row.asCell ?? row.answer;
        cells[place.mark] = changed.get(row).mark;
        cells[place.comment] = cell(changed.get(row).comment);
      }
      return cells.map(quoted).join(",");
    });
    return `${byteOrderMark}${[columns.join(","), ...lines].join("\n")}\n`;
  }

  function save() {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([table()], { type: "text/csv" }));
    link.download = "questions.csv";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    unsaved = false;
    say("Saved questions.csv among this browser's downloads.");
  }

  async function copy() {
    const text = table();
    try {
      await navigator.clipboard.writeText(text);
      say("Copied. Paste it into questions.csv.");
    } catch {
      $("plain").hidden = false;
      $("plain").value = text;
      $("plain").select();
      say("The table is below and selected: press Ctrl+C, and paste it into questions.csv.");
    }
  }

  // ---- keys ----

  const actions = {
    Enter: goToWaiting,
    " ": goToWaiting,
    ArrowRight: () => go(1),
    ArrowLeft: () => go(-1),
    Backspace: () => change({ mark: "" }),
    ".": giveHalf,
    ",": giveHalf,
    c: () => $("comment").focus(),
    u: undo,
    n: () => $("names").click(),
    w: save,
  };

  document.addEventListener("keydown", (event) => {
    if (event.target === $("comment")) {
      if (event.key === "Escape") $("comment").blur();
      if (event.key === "Enter" && event.ctrlKey) {
        $("comment").blur();
        goToWaiting();
      }
      return;
    }
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("select, textarea"))
      return;
    const pressesButton =
      event.target.closest("button, summary, input") &&
      (event.key === "Enter" || event.key === " ");
    if (pressesButton || !answers.length) return;
    const line = bank()[BANK_KEYS.indexOf(event.key)];
    let action = actions[event.key];
    if (/^\d$/.test(event.key)) action = () => give(Number(event.key));
    else if (line !== undefined) action = () => toggleComment(line);
    if (!action) return;
    event.preventDefault();
    action();
  });

  let before = null; // the comment's text when it was entered, so that undo takes back all of it
  $("comment").addEventListener("focus", () => {
    before = { answer: shown[at], mark: shown[at].mark, comment: shown[at].comment };
  });
  $("comment").addEventListener("input", () => {
    shown[at].comment = $("comment").value;
    keep(shown[at]);
  });
  $("comment").addEventListener("blur", () => {
    if (before && before.answer.comment !== before.comment) past.push(before);
    before = null;
    show();
  });
  $("question").addEventListener("change", (event) => {
    choose(event.target.value);
    event.target.blur();
  });
  $("names").addEventListener("change", () => {
    $("names").blur();
    show();
  });
  $("save").addEventListener("click", save);
  $("copy").addEventListener("click", copy);
  $("previous").addEventListener("click", () => go(-1));
  $("next").addEventListener("click", () => go(1));
  $("waiting").addEventListener("click", goToWaiting);
  $("undo").addEventListener("click", undo);
  window.addEventListener("beforeunload", (event) => {
    if (unsaved && !storage) event.preventDefault();
  });

  // ---- the beginning ----

  if (!answers.length) {
    say("There are no written answers.");
    return;
  }
  const names = [
    ["", "all"],
    ...questions.map(({ notebook, question }, index) => [index, `${notebook}: ${question}`]),
  ];
  for (const [value, name] of names) {
    const option = document.createElement("option");
    option.value = value;
    option.dataset.name = name;
    $("question").append(option);
  }
  $("work").hidden = false;
  choose("");
  const news = [];
  if (answers.some(isChanged))
    news.push("Points that are not in the table yet are as you left them here.");
  if (overruled)
    news.push(
      `${overruled} of the points kept here differ from newer ones in the table, which count.`,
    );
  if (!storage) news.push("This browser keeps nothing for files: save before you close the page.");
  say(news.join(" "));
})();

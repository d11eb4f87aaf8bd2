// Answers what the toys' scripts compute: for each line of stdin, a JSON [function, [arguments, ...]], one of stdout.
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import vm from "node:vm";

process.argv.slice(2).forEach((file) => vm.runInThisContext(readFileSync(file, "utf-8")));
const M = globalThis.course.motion;
createInterface({ input: process.stdin }).on("line", (line) => {
  const [name, cases] = JSON.parse(line);
  console.log(JSON.stringify(cases.map((args) => M[name](...args))));
});

// Answers on stdout (JSON) what the toys' scripts compute for the questions on stdin: [[function, arguments], ...].
import { readFileSync } from "node:fs";
import vm from "node:vm";

globalThis.window = globalThis; // of which the scripts know when they run in a page
process.argv.slice(2).forEach((file) => vm.runInThisContext(readFileSync(file, "utf-8")));
const M = globalThis.course.motion;
const asked = JSON.parse(readFileSync(0, "utf-8"));
process.stdout.write(JSON.stringify(asked.map(([name, args]) => M[name](...args))));

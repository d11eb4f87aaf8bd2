// The style of toys: a sheet of its own, because a toy also stands in JupyterLab, where no page
// brings one.
(() => {
  "use strict";
  const P = globalThis.course.parts;
  const { ground } = globalThis.course.palette.PALETTE;
  const ID = "course-toy-style";
  const IN_DARK = ":is([data-theme=dark],[data-jp-theme-light=false])";

  const STYLE = `
.course-toy {
  --ground: #fff; --ink: #222; --edge: #555; --button: #f2f2f2; --pressed: #d9e8f3;
  --numbers: #f2f4f6;
  color-scheme: light; box-sizing: border-box; max-width: 760px; margin: 0 auto; padding: .75rem;
  background: var(--ground); color: var(--ink); font: 14px/1.45 system-ui,sans-serif;
  border-radius: .25rem;
}
.course-stage, .course-toy { --stage: ${ground.light}; --focus: #0b5fff }
${IN_DARK} .course-toy {
  --ground: #1b1f24; --ink: #e7eaee; --edge: #a3abb3; --button: #39414a; --pressed: #1f4a66;
  --numbers: ${ground.dark}; color-scheme: dark;
}
${IN_DARK} :is(.course-stage, .course-toy) { --stage: ${ground.dark}; --focus: #6ea8ff }
.course-toy *, .course-stage * { box-sizing: border-box }
.course-toy p { margin: .4rem 0 0 }
.course-toy .dim { opacity: .72 }
.course-toy mark { background: var(--pressed); color: inherit; padding: 0 .15em }
.course-toy :focus-visible, .course-stage canvas:focus-visible {
  outline: 3px solid var(--focus); outline-offset: -3px
}

.course-toy .views { display: flex; flex-wrap: wrap; gap: .75rem }
.course-toy .views > * { flex: 1 1 300px; min-width: 0; max-width: 100% }
.course-toy .views > .half { flex-basis: 140px }
.course-toy .charts { display: flex; flex-direction: column; gap: .5rem }
.course-toy .charts > * { flex: 1; min-width: 0 }

.course-stage { position: relative; overflow: hidden; border-radius: .25rem }
.course-stage canvas { display: block; width: 100%; background: var(--stage) }
.course-stage .word {
  position: absolute; left: 0; top: 0; pointer-events: none;
  font: 600 14px/18px system-ui,sans-serif;
  white-space: nowrap;
  text-shadow: 0 0 3px var(--stage), 0 0 3px var(--stage), 0 0 2px var(--stage);
}
.course-stage .handle {
  position: absolute; left: -22px; top: -22px; width: 44px; height: 44px; border-radius: 50%;
  cursor: grab;
  touch-action: none; outline: none;
  background: radial-gradient(var(--stage) 6px, var(--colour) 6.5px 9px, transparent 9.5px);
}
.course-stage .handle.small {
  background: radial-gradient(var(--stage) 4px, var(--colour) 4.5px 6.5px, transparent 7px);
}
.course-stage .handle.open {
  background: radial-gradient(transparent 7px, var(--colour) 7.5px 9.5px, transparent 10px);
}
.course-stage .handle:focus-visible { box-shadow: inset 0 0 0 3px var(--focus) }
.course-stage .hint {
  position: absolute; left: 50%; bottom: .5rem; transform: translateX(-50%); width: max-content;
  max-width: calc(100% - 1rem); padding: .25rem .7rem; border-radius: .25rem; pointer-events: none;
  border: 1px solid #ffffff40;
  background: #14171be6; color: #fff; font: 13px/1.4 system-ui,sans-serif;
}

.course-toy .controls { margin-top: .4rem }
.course-toy summary { cursor: pointer; margin-top: .3rem }
.course-toy .settings {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(min(200px, 45%), 1fr));
  gap: .2rem 1.2rem;
}
.course-toy .setting {
  display: flex; flex-wrap: wrap; gap: 0 .5rem; font-size: 13px; align-content: end
}
.course-toy .setting label { flex: 1 }
.course-toy .setting input { flex: 0 0 100%; min-width: 0; margin: 0; order: 3 }
.course-toy .setting output {
  font-variant-numeric: tabular-nums; white-space: nowrap; align-self: end
}
.course-toy .buttons {
  display: flex; flex-wrap: wrap; gap: .4rem .8rem; margin-top: .4rem; align-items: center
}
.course-toy button {
  font: inherit; padding: .2rem .7rem; border: 1px solid var(--edge); border-radius: .25rem;
  background: var(--button); color: inherit;
}
.course-toy button.held {
  min-height: 44px; touch-action: none; user-select: none; -webkit-user-select: none
}
.course-toy .numbers {
  display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; align-items: center; align-content: start;
  margin: .4rem 0 0;
  padding: .3rem .7rem; font-size: 13px; background: var(--numbers); border-radius: .25rem;
  font-variant-numeric: tabular-nums;
}
.course-toy .numbers > div {
  display: flex; flex-wrap: wrap; align-items: center; gap: .2rem .5rem; white-space: pre-line;
}
.course-toy .room { display: grid; margin: .4rem 0 0 }
.course-toy .room > p, .course-toy .room::after { grid-area: 1/1; margin: 0 }
.course-toy .room::after { content: attr(data-longest); visibility: hidden }
.course-toy .matrix {
  display: inline-grid; gap: 0 .7em; padding: .1em .5em; text-align: right;
  border: solid var(--ink);
  border-width: 0 1.5px; border-radius: .6em; font: 13px/1.45 system-ui,sans-serif;
}
.course-toy .matrix .chosen { background: var(--pressed); box-shadow: 0 0 0 .2em var(--pressed) }

.course-toy :is(sub, sup) { font-size: max(.75em, 10px); line-height: 0 }
@media (max-width: 480px) {
  .course-toy { padding: .5rem }
  .course-toy .setting input { min-height: 1.6rem }
  .course-toy .charts { flex-direction: row }
  .course-toy .numbers { padding: .3rem .4rem }
  .course-toy .room { display: grid; margin: .4rem 0 0 }
.course-toy .room > p, .course-toy .room::after { grid-area: 1/1; margin: 0 }
.course-toy .room::after { content: attr(data-longest); visibility: hidden }
.course-toy .matrix { font-size: 12px; gap: 0 .45em }
}
@media (max-width: 360px) {
  .course-toy .room { display: grid; margin: .4rem 0 0 }
.course-toy .room > p, .course-toy .room::after { grid-area: 1/1; margin: 0 }
.course-toy .room::after { content: attr(data-longest); visibility: hidden }
.course-toy .matrix { font-size: 11px; gap: 0 .3em; padding: .1em .3em }
}
/* JupyterLab's dark theme shows plots and charts, whose ground is white in both themes, as cards. */
[data-jp-theme-light=false] .jp-RenderedImage img[width], [data-jp-theme-light=false] .jp-RenderedPlotly {
  box-sizing: content-box; padding: 10px; border-radius: 8px; background: #fff;
}

@media print {
  .course-toy .controls { display: none }
}`;

  /** Put the sheet into the page, once. */
  P.useStyle = () => {
    if (document.getElementById(ID)) return;
    P.element("style", { id: ID }, document.head, STYLE);
  };
})();

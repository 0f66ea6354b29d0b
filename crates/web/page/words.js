// What the page says: each word in the order of LANGUAGES; one that is the same in all of them stands alone.

const LANGUAGES = ["en", "zh"];

const WORDS = {
  other: ["中文", "English"],
  ask: ["Ask", "提问"],
  check: ["Check", "检查"],
  play: ["Play", "试验"],
  tagline: ["Exact polynomials and their polar forms", "精确的多项式及其极形式"],
  ask_lead: ["A polynomial, its polar form, a value, a claim, a picture. Numbers are exact.", "多项式、极形式、取值、论断、图形。所有的数都是精确的。"],
  check_lead: [
    "Paste lecture notes. Every formula gets a verdict; a wrong one a counterexample and the likely repair.",
    "粘贴讲义。每个公式都会得到结论;错误的公式会给出反例与可能的改正。",
  ],
  play_lead: ["Drag the control points. Every point of the algorithm is a value of the polar form.", "拖动控制点。算法中的每一个点都是极形式的一个值。"],
  prompt: ["Query", "查询"],
  run: ["Run", "运行"],
  stop: ["Stop", "停止"],
  clear: ["Clear", "清空"],
  computing: ["computing …", "正在计算……"],
  hint_keys: ["Enter runs, Shift-Enter begins a line, ↑ ↓ go through the history, Tab completes", "Enter 运行,Shift-Enter 换行,↑ ↓ 浏览历史,Tab 补全"],
  examples: ["Try", "试一试"],
  copy_latex: "LaTeX",
  copy_text: ["Text", "文本"],
  copy_svg: "SVG",
  copy_tikz: "TikZ",
  copied: ["Copied", "已复制"],
  to_ask: ["Open in Ask", "在“提问”中打开"],
  copy_link: ["Copy link", "复制链接"],
  notes: ["Lecture notes", "讲义"],
  markdown: "Markdown",
  latex: "LaTeX",
  rst: "reStructuredText",
  notebook: ["Notebook", "笔记本"],
  auto: ["as it looks", "自动识别"],
  auto_is: [(kind) => `as it looks: ${kind}`, (kind) => `自动识别:${kind}`],
  show_all: [(count) => `Show all ${count}`, (count) => `显示全部 ${count} 条`],
  format: ["Format", "格式"],
  example: ["Example", "示例"],
  apply: ["Apply", "采用"],
  apply_all: ["Apply all suggestions", "采用全部建议"],
  all: ["all", "全部"],
  only_wrong: ["wrong only", "仅错误"],
  proved: ["proved", "已证明"],
  sampled: ["holds in all instances tried", "所试各例均成立"],
  refuted: ["refuted", "不成立"],
  undecided: ["undecided", "未定"],
  unread: ["not read", "未能读懂"],
  definition: ["definition", "定义"],
  none: ["no claim", "非论断"],
  counterexample: ["Counterexample", "反例"],
  suggestion: ["Suggestion", "建议"],
  tried: ["Tried", "试过"],
  assumed: ["Assumed", "假定"],
  suspicious: ["Suspicious", "可疑"],
  details: ["Details", "细节"],
  line: [(number) => `line ${number}`, (number) => `第 ${number} 行`],
  empty_check: ["Nothing here yet. Paste a page, or take the example.", "这里还是空的。请粘贴一页讲义,或打开示例。"],
  paste_here: ["# Lecture notes\n\nPaste a page here: formulas stand between $ … $ or $$ … $$.", "# 讲义\n\n把一页讲义粘贴到这里:公式写在 $ … $ 或 $$ … $$ 之间。"],
  no_formula: ["No formula was found. Formulas stand between $ … $ or \\( … \\).", "没有找到公式。公式写在 $ … $ 或 \\( … \\) 之间。"],
  summary: [
    (report) => `${report.words}.`,
    ({ counts: { definition, silent, ...claims } }) => {
      const count = Object.values(claims).reduce((sum, one) => sum + one, 0);
      const parts = Object.entries(claims).filter(([, one]) => one > 0).map(([verdict, one]) => `${one} 个${say(verdict)}`);
      const rest = [[definition, "个定义或条件"], [silent, "个未作论断的公式"]].filter(([one]) => one > 0).map(([one, words]) => `${one} ${words}`);
      return `${count} 个论断${parts.length ? `:${parts.join(",")}` : ""}${rest.map((one) => `;${one}`).join("")}。`;
    },
  ],
  bezier: "Bézier",
  bspline: ["B-spline", "B 样条"],
  curve_kind: ["Kind of curve", "曲线类型"],
  grid: ["Grid", "网格"],
  parameter: ["Parameter t", "参数 t"],
  more: ["Add a point", "增加一点"],
  less: ["Remove a point", "减少一点"],
  degree: ["Degree", "次数"],
  knots: ["Knots", "节点"],
  reset: ["Start again", "重新开始"],
  picture: ["Curve with its control points", "曲线及其控制点"],
  pyramid: ["Every level", "各层的点"],
  values: ["Value and derivative", "取值与导数"],
  point_name: [
    (label, x, y) => `Control point ${label} at (${x}, ${y}). Arrow keys move it.`,
    (label, x, y) => `控制点 ${label},位于 (${x}, ${y})。方向键移动。`,
  ],
  knot_name: [(i, value) => `Knot ${i}: ${value}. Arrow keys move it.`, (i, value) => `节点 ${i}:${value}。方向键移动。`],
  stopped: ["Stopped.", "已停止。"],
  trapped: [(why) => `The computation broke down (${why}) and was started anew.`, (why) => `计算中断(${why}),已重新启动。`],
  session_kept: ["The session is as it was before.", "会话保持原样。"],
  forgotten: [
    (input) => `The session could be restored up to this input, which broke the computation down again: ${input}`,
    (input) => `会话只恢复到这条输入之前,它再次使计算中断:${input}`,
  ],
  link_many: [(count) => `This link brings ${count} more inputs. They have not been run.`, (count) => `此链接还带有 ${count} 条输入,尚未运行。`],
  link_run: ["Run them", "运行"],
  too_long: [(kb, most) => `This has ${kb} kB; more than ${most} kB are not read.`, (kb, most) => `这里有 ${kb} kB;超过 ${most} kB 不予读取。`],
  link_broken: ["This link is damaged, and nothing of it was run:", "链接已损坏,其中的内容没有运行:"],
  link_long: ["The page of notes is too long for a link and was left out of it.", "讲义太长,没有放进链接。"],
  link_short: ["it ends too early or was changed on the way", "链接不完整,或中途被改动"],
  link_foreign: ["it was not made by this page", "链接不是由本页生成的"],
  link_field: [(name) => `what it says of "${name}" has no meaning here`, (name) => `其中的“${name}”在这里没有意义`],
  no_start: ["This browser cannot run polarform: ", "此浏览器无法运行 polarform:"],
  copy_by_hand: ["Copy this:", "请复制:"],
  close: ["Close", "关闭"],
};

let lang = LANGUAGES.find((one) => (navigator.language || "").toLowerCase().startsWith(one)) ?? "en";

/** A word or sentence in the language of the page. */
function say(name, ...values) {
  const entry = WORDS[name];
  const words = Array.isArray(entry) ? entry[LANGUAGES.indexOf(lang)] : entry;
  return typeof words === "function" ? words(...values) : words;
}

/** Puts the language into all that stands in the page; `[data-say]` is text, `[data-name]` a name for screen readers. */
function translate() {
  document.documentElement.lang = lang === "zh" ? "zh-Hans" : "en";
  for (const node of document.querySelectorAll("[data-say]")) node.textContent = say(node.dataset.say);
  for (const node of document.querySelectorAll("[data-name]")) node.setAttribute("aria-label", say(node.dataset.name));
  for (const node of document.querySelectorAll("[data-hint]")) node.placeholder = say(node.dataset.hint);
}

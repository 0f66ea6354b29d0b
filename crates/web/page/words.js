// What the page says, in English and Chinese.

const WORDS = {
  en: {
    other: "中文",
    ask: "Ask", check: "Check", play: "Play",
    tagline: "Exact polynomials and their polar forms",
    ask_lead: "A polynomial, its polar form, a value, a claim, a picture. Numbers are exact.",
    check_lead: "Paste lecture notes. Every formula gets a verdict; a wrong one a counterexample and the likely repair.",
    play_lead: "Drag the control points. Every point of the algorithm is a value of the polar form.",
    prompt: "Query", run: "Run", stop: "Stop", clear: "Clear", computing: "computing …",
    hint_keys: "Enter runs, Shift-Enter begins a line, ↑ ↓ go through the history, Tab completes",
    examples: "Try", copy_latex: "LaTeX", copy_text: "Text", copy_svg: "SVG", copy_tikz: "TikZ", copied: "Copied",
    to_ask: "Open in Ask", copy_link: "Copy link",
    notes: "Lecture notes", markdown: "Markdown", latex: "LaTeX", rst: "reStructuredText", format: "Format",
    example: "Example", apply: "Apply", apply_all: "Apply all suggestions", all: "all", only_wrong: "wrong only",
    proved: "proved", sampled: "holds in all instances tried", refuted: "refuted", undecided: "undecided",
    unread: "not read", definition: "definition", none: "no claim",
    counterexample: "Counterexample", suggestion: "Suggestion", tried: "Tried", assumed: "Assumed", read_as: "Read as",
    suspicious: "Suspicious", details: "Details", line: "line",
    empty_check: "Nothing here yet. Paste a page, or take the example.",
    paste_here: "# Lecture notes\n\nPaste a page here: formulas stand between $ … $ or $$ … $$.",
    no_formula: "No formula was found. Formulas stand between $ … $ or \\( … \\).",
    summary: (report) => `${report.words}.`,
    bezier: "Bézier", bspline: "B-spline", curve_kind: "Kind of curve", grid: "Grid", parameter: "Parameter t",
    more: "Add a point", less: "Remove a point", degree: "Degree", knots: "Knots", reset: "Start again",
    picture: "Curve with its control points", pyramid: "Every level", values: "Value and derivative",
    point_name: (label, x, y) => `Control point ${label} at (${x}, ${y}). Arrow keys move it.`,
    knot_name: (i, value) => `Knot ${i}: ${value}. Arrow keys move it.`,
    stopped: "Stopped. The session is as it was before.",
    trapped: (why) => `The computation broke down (${why}) and was started anew; the session is as it was before.`,
    too_long: (kb, most) => `This has ${kb} kB; more than ${most} kB are not read.`,
    link_broken: "This link is damaged, and nothing of it was run:",
    link_long: "The page of notes is too long for a link and was left out of it.",
    link_short: "it ends too early or was changed on the way", link_foreign: "it was not made by this page",
    link_field: (name) => `what it says of "${name}" has no meaning here`,
    no_start: "This browser cannot run polarform: ", copy_by_hand: "Copy this:", close: "Close",
    long_formula: "too long to be set; as text:",
  },
  zh: {
    other: "English",
    ask: "提问", check: "检查", play: "试验",
    tagline: "精确的多项式及其极形式",
    ask_lead: "多项式、极形式、取值、论断、图形。所有的数都是精确的。",
    check_lead: "粘贴讲义。每个公式都会得到结论;错误的公式会给出反例与可能的改正。",
    play_lead: "拖动控制点。算法中的每一个点都是极形式的一个值。",
    prompt: "查询", run: "运行", stop: "停止", clear: "清空", computing: "正在计算……",
    hint_keys: "Enter 运行,Shift-Enter 换行,↑ ↓ 浏览历史,Tab 补全",
    examples: "试一试", copy_latex: "LaTeX", copy_text: "文本", copy_svg: "SVG", copy_tikz: "TikZ", copied: "已复制",
    to_ask: "在“提问”中打开", copy_link: "复制链接",
    notes: "讲义", markdown: "Markdown", latex: "LaTeX", rst: "reStructuredText", format: "格式",
    example: "示例", apply: "采用", apply_all: "采用全部建议", all: "全部", only_wrong: "仅错误",
    proved: "已证明", sampled: "所试各例均成立", refuted: "不成立", undecided: "未定",
    unread: "未能读懂", definition: "定义", none: "非论断",
    counterexample: "反例", suggestion: "建议", tried: "试过", assumed: "假定", read_as: "读作",
    suspicious: "可疑", details: "细节", line: "行",
    empty_check: "这里还是空的。请粘贴一页讲义,或打开示例。",
    paste_here: "# 讲义\n\n把一页讲义粘贴到这里:公式写在 $ … $ 或 $$ … $$ 之间。",
    no_formula: "没有找到公式。公式写在 $ … $ 或 \\( … \\) 之间。",
    summary: ({ counts: { definition, silent, ...claims } }) => {
      const count = Object.values(claims).reduce((sum, one) => sum + one, 0);
      const parts = Object.entries(claims).filter(([, one]) => one > 0).map(([verdict, one]) => `${one} 个${WORDS.zh[verdict]}`);
      const rest = [[definition, "个定义或条件"], [silent, "个未作论断的公式"]].filter(([one]) => one > 0).map(([one, words]) => `${one} ${words}`);
      return `${count} 个论断${parts.length ? `:${parts.join(",")}` : ""}${rest.map((one) => `;${one}`).join("")}。`;
    },
    bezier: "Bézier", bspline: "B 样条", curve_kind: "曲线类型", grid: "网格", parameter: "参数 t",
    more: "增加一点", less: "减少一点", degree: "次数", knots: "节点", reset: "重新开始",
    picture: "曲线及其控制点", pyramid: "各层的点", values: "取值与导数",
    point_name: (label, x, y) => `控制点 ${label},位于 (${x}, ${y})。方向键移动。`,
    knot_name: (i, value) => `节点 ${i}:${value}。方向键移动。`,
    stopped: "已停止。会话保持原样。",
    trapped: (why) => `计算中断(${why}),已重新启动;会话保持原样。`,
    too_long: (kb, most) => `这里有 ${kb} kB;超过 ${most} kB 不予读取。`,
    link_broken: "链接已损坏,其中的内容没有运行:",
    link_long: "讲义太长,没有放进链接。",
    link_short: "链接不完整,或中途被改动", link_foreign: "链接不是由本页生成的",
    link_field: (name) => `其中的“${name}”在这里没有意义`,
    no_start: "此浏览器无法运行 polarform:", copy_by_hand: "请复制:", close: "关闭",
    long_formula: "公式太长,以文本显示:",
  },
};

let lang = (navigator.language || "en").toLowerCase().startsWith("zh") ? "zh" : "en";

/** A word or sentence in the language of the page. */
function say(name, ...values) {
  const words = WORDS[lang][name];
  return typeof words === "function" ? words(...values) : words;
}

/** Puts the language into all that stands in the page; `[data-say]` is text, `[data-name]` a name for screen readers. */
function translate() {
  document.documentElement.lang = lang === "zh" ? "zh-Hans" : "en";
  for (const node of document.querySelectorAll("[data-say]")) node.textContent = say(node.dataset.say);
  for (const node of document.querySelectorAll("[data-name]")) node.setAttribute("aria-label", say(node.dataset.name));
  for (const node of document.querySelectorAll("[data-hint]")) node.placeholder = say(node.dataset.hint);
}

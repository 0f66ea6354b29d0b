const buttons = [...document.querySelectorAll("[data-show]")];
document.querySelectorAll(".filters, .copy").forEach(element => { element.hidden = false; });
for (const button of buttons) {
  button.addEventListener("click", () => {
    const show = button.dataset.show;
    buttons.forEach(other => other.setAttribute("aria-pressed", other === button));
    document.querySelectorAll(".finding").forEach(finding => {
      finding.hidden = show !== "all" && !finding.dataset.kinds.split(" ").includes(show);
    });
    document.querySelectorAll("section").forEach(section => {
      section.hidden = show !== "all" && !section.querySelector(".finding:not([hidden])");
    });
  });
}
document.querySelector('[data-show][aria-pressed="true"]')?.click();
document.querySelectorAll(".copy").forEach(button => {
  const code = button.parentElement.querySelector("code");
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(code.textContent);
      button.textContent = "copied";
    } catch {
      getSelection().selectAllChildren(code);
    }
  });
});

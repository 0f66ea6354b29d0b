// Puts the parts together.

async function main() {
  translate();
  Ask.begin();
  Check.begin();
  Play.begin();
  byId("language").addEventListener("click", () => {
    lang = lang === "en" ? "zh" : "en";
    translate();
    Check.list();
    if (Play.answer) Play.show();
    Link.changed();
  });
  // The fragment of the address holds the state, so these are no ordinary links.
  for (const link of document.querySelectorAll("[data-to]")) {
    link.addEventListener("click", (event) => {
      event.preventDefault();
      byId(link.dataset.to).scrollIntoView();
    });
  }
  byId("copy-link").addEventListener("click", (event) => Link.copy(event.currentTarget));
  // A link that is pasted into the address of an open page.
  addEventListener("hashchange", () => location.hash !== Link.own && location.reload());
  try {
    await unpacked();
  } catch (error) {
    notice(say("no_start"), String(error.message));
    return;
  }
  document.documentElement.dataset.ready = "yes";
  await Link.read();
  warm();
}

main();

// Search as one types: sections of the book, ranked by BM25, with what stands around the words. Without a network and without a server.
(() => {
  const MOST = 12;
  /** Characters that are shown, and of them before the first word. */
  const EXCERPT = 150;
  const BEFORE = 50;
  /** A word of a heading, and of a page's title, is worth so many of the text. */
  const HEADING = 8;
  const TITLE = 4;
  /** Factor for the words of the search next to each other. */
  const PHRASE = 4;
  const [K, B] = [1.2, 0.6];
  /** Pages that repeat what others say. */
  const LESS = /^(CHANGELOG|ARCHITECTURE|CONTRIBUTING)\.html/;

  const root = document.documentElement.dataset.content_root ?? "./";
  /** Words; an option of a command, such as `--density`, is one with its dashes. */
  const wordsOf = (text) => text.toLowerCase().match(/--[a-z][a-z-]*|[\p{L}\p{N}_]+/gu) ?? [];
  /** Words as which a text is found: an option also without its dashes. */
  const foundAs = (text) => wordsOf(text).flatMap((word) => (word.startsWith("--") ? [word, ...word.match(/[a-z]+/g)] : [word]));

  let index = null;
  function load() {
    index ??= new Promise((done, failed) => {
      const script = document.createElement("script");
      script.src = `${root}_static/sections.js`;
      script.onload = () => done(build(window.polhodeSections));
      script.onerror = failed;
      document.head.append(script);
    });
    return index;
  }

  /** For each word the sections that have it, and how often. */
  function build(sections) {
    const words = new Map();
    const lengths = sections.map(([, page, heading, text], k) => {
      const counts = new Map();
      const add = (word, weight) => counts.set(word, (counts.get(word) ?? 0) + weight);
      const body = foundAs(text);
      for (const word of body) add(word, 1);
      for (const word of foundAs(heading)) add(word, HEADING);
      for (const word of foundAs(page)) add(word, heading ? 1 : HEADING + TITLE);
      for (const [word, count] of counts) {
        if (!words.has(word)) words.set(word, []);
        words.get(word).push([k, count]);
      }
      return body.length;
    });
    const mean = lengths.reduce((a, b) => a + b, 0) / Math.max(1, lengths.length);
    return { sections, words, lengths, mean };
  }

  /** The places of the best sections that have every word, or the beginning of a longer one. */
  function find({ sections, words, lengths, mean }, query) {
    const wanted = wordsOf(query);
    let scores = null;
    for (const word of wanted) {
      const found = new Map();
      for (const [known, postings] of words) {
        if (!known.startsWith(word)) continue;
        const rarity = Math.log(1 + (sections.length - postings.length + 0.5) / (postings.length + 0.5));
        const likeness = word.length / known.length;
        for (const [k, count] of postings) {
          const share = (count * (K + 1)) / (count + K * (1 - B + (B * lengths[k]) / mean));
          found.set(k, Math.max(found.get(k) ?? 0, rarity * share * likeness));
        }
      }
      const before = scores;
      scores = new Map([...found].filter(([k]) => before === null || before.has(k)).map(([k, s]) => [k, s + (before?.get(k) ?? 0)]));
    }
    const less = (k) => (LESS.test(sections[k][0]) ? 0.5 : 1);
    const phrase = wanted.join(" ");
    const more = (k) => (wanted.length > 1 && sections[k].slice(1).some((part) => wordsOf(part).join(" ").includes(phrase)) ? PHRASE : 1);
    const ranked = [...(scores ?? [])].map(([k, score]) => [k, score * less(k) * more(k)]);
    return ranked.sort((a, b) => b[1] - a[1] || a[0] - b[0]).map(([k]) => k);
  }

  /** The text around the first of the words, with all of them marked. */
  function excerpt(text, wanted) {
    const lower = text.toLowerCase();
    const places = wanted.map((word) => lower.indexOf(word)).filter((at) => at >= 0);
    const first = Math.min(...places, text.length);
    const begin = first <= BEFORE || first === text.length ? 0 : text.indexOf(" ", first - BEFORE) + 1;
    const end = begin + EXCERPT < text.length ? text.lastIndexOf(" ", begin + EXCERPT) : text.length;
    const part = document.createElement("span");
    const shown = (begin > 0 ? "… " : "") + text.slice(begin, end) + (end < text.length ? " …" : "");
    const pattern = new RegExp(`(${wanted.join("|")})`, "giu");
    for (const piece of shown.split(pattern)) {
      if (wanted.includes(piece.toLowerCase())) {
        const mark = document.createElement("mark");
        mark.textContent = piece;
        part.append(mark);
      } else part.append(piece);
    }
    return part;
  }

  function attach(box) {
    const list = document.createElement("ul");
    list.id = "found";
    list.setAttribute("role", "listbox");
    list.setAttribute("aria-label", "Found");
    list.hidden = true;
    document.body.append(list);
    for (const [name, value] of Object.entries({ role: "combobox", "aria-controls": "found", "aria-expanded": "false", autocomplete: "off" })) {
      box.setAttribute(name, value);
    }
    let chosen = -1;
    const links = () => [...list.querySelectorAll("a")];
    const close = () => {
      list.hidden = true;
      box.setAttribute("aria-expanded", "false");
      box.removeAttribute("aria-activedescendant");
    };
    const choose = (k) => {
      const all = links();
      if (all.length === 0) return;
      all[chosen]?.removeAttribute("aria-selected");
      chosen = (k + all.length) % all.length;
      all[chosen].setAttribute("aria-selected", "true");
      all[chosen].scrollIntoView({ block: "nearest" });
      box.setAttribute("aria-activedescendant", all[chosen].id);
    };
    const show = async () => {
      const query = box.value;
      const wanted = wordsOf(query);
      if (wanted.length === 0) return close();
      const built = await load();
      if (query !== box.value) return;
      const found = find(built, query);
      list.replaceChildren();
      chosen = -1;
      for (const [n, k] of found.slice(0, MOST).entries()) {
        const [place, page, heading, text] = built.sections[k];
        const link = document.createElement("a");
        link.href = root + place;
        link.id = `found-${n}`;
        link.setAttribute("role", "option");
        const name = document.createElement("strong");
        name.textContent = heading ? `${page} › ${heading}` : page;
        link.append(name, excerpt(text, wanted));
        const item = document.createElement("li");
        item.setAttribute("role", "presentation");
        item.append(link);
        list.append(item);
      }
      const total = document.createElement("li");
      total.className = "total";
      total.textContent = found.length === 0 ? "nothing found" : found.length > MOST ? `the best ${MOST} of ${found.length} sections` : `${found.length} sections`;
      list.append(total);
      // On a narrow page the box is above the list, else beside it.
      list.style.top = matchMedia("(max-width: 63em)").matches ? `${box.getBoundingClientRect().bottom + 4}px` : "";
      list.hidden = false;
      box.setAttribute("aria-expanded", "true");
      if (found.length > 0) choose(0);
    };
    box.addEventListener("focus", load);
    box.addEventListener("input", show);
    box.addEventListener("keydown", (event) => {
      if (event.key === "Escape") close();
      if (list.hidden) return;
      if (event.key === "ArrowDown") choose(chosen + 1);
      else if (event.key === "ArrowUp") choose(chosen - 1);
      else if (event.key === "Enter" && chosen >= 0) links()[chosen].click();
      else return;
      event.preventDefault();
    });
    list.addEventListener("click", close);
    // A pointer in a frame is not heard here, but it takes the focus.
    addEventListener("blur", close);
    document.addEventListener("pointerdown", (event) => {
      if (event.target !== box && !list.contains(event.target)) close();
    });
  }

  // For its tests.
  globalThis.polhodeSearch = { build, find };
  document.addEventListener("DOMContentLoaded", () => {
    const box = document.querySelector("input.sidebar-search");
    if (box) attach(box);
  });
})();

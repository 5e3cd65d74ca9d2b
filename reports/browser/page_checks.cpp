// SPDX-License-Identifier: MIT
#include "reports/browser/page_checks.hpp"

namespace phytobench {

namespace {

namespace fs = std::filesystem;

/// Colours as the browser computes them, and the luminance and contrast of [WCAG] 2.2.
constexpr const char* colour_functions = R"js(
  const colour = text => {
    const numbers = text.match(/[\d.]+/g).map(Number);
    const scale = text.startsWith('color(srgb') ? 255 : 1;
    if (!/^(rgba?|color\(srgb)/.test(text)) throw new Error('a colour of another kind: ' + text);
    return [...numbers.slice(0, 3).map(n => n * scale), numbers.length > 3 ? numbers[3] : 1];
  };
  const over = (top, ground, share) => [0, 1, 2].map(i => top[i] * share + ground[i] * (1 - share));
  const luminance = rgb => {
    const [r, g, b] = rgb.map(n => n / 255).map(n =>
      n <= 0.04045 ? n / 12.92 : ((n + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const looks = new Map();
  const look = e => {  // of an element: its style, the colour behind its text, its opacity
    if (!e) return { ground: [255, 255, 255], opacity: 1 };
    if (!looks.has(e)) {
      const style = getComputedStyle(e), behind = look(e.parentElement);
      const own = colour(style.backgroundColor);
      const scheme = e === document.documentElement && style.colorScheme.startsWith('dark')
        ? [18, 18, 18] : behind.ground;
      looks.set(e, { style, ground: over(own, scheme, own[3] * behind.opacity),
                     opacity: behind.opacity * Number(style.opacity) });
    }
    return looks.get(e);
  };
)js";

std::string script(const char* body) {
  return std::string("(() => {") + colour_functions + body + "})()";
}

Problems ids_that_are_wrong(Page& page) {
  return page.texts(R"js((() => {
    const ids = new Set(), problems = [];
    for (const { id } of document.querySelectorAll('[id]')) {
      if (ids.has(id)) problems.push('two elements have the id ' + id);
      ids.add(id);
    }
    const need = (e, id) => {
      if (!ids.has(id)) problems.push('no element has the id that is named in ' +
                                      e.cloneNode().outerHTML.slice(0, 120));
    };
    for (const e of document.querySelectorAll('[href^="#"]'))
      need(e, decodeURIComponent(e.getAttribute('href').slice(1)));
    for (const name of ['for', 'aria-labelledby', 'aria-describedby', 'aria-controls'])
      for (const e of document.querySelectorAll('[' + name + ']'))
        e.getAttribute(name).split(/\s+/).forEach(id => need(e, id));
    return problems;
  })())js");
}

std::vector<std::string> linked_files(Page& page) {
  return page.texts(R"js(
    [...new Set([...document.querySelectorAll('[href], [src]')]
      .map(e => e.getAttribute('href') || e.getAttribute('src'))
      .filter(link => link && !/^(#|[a-z]+:)/.test(link))
      .map(link => decodeURIComponent(link.split('#')[0])))])js");
}

}  // namespace

Problems loading_problems(Page& page) {
  Problems problems = page.complaints();
  const std::vector<std::string> requests = page.requests();
  for (std::size_t i = 1; i < requests.size(); ++i) problems.push_back("asks for " + requests[i]);
  return problems;
}

Problems link_problems(Page& page, const fs::path& folder) {
  Problems problems = ids_that_are_wrong(page);
  for (const std::string& file : linked_files(page))
    if (!fs::is_regular_file(folder / file)) problems.push_back("no file " + file);
  return problems;
}

Problems width_problems(Page& page) {
  return page.texts(R"js((() => {
    const page = document.scrollingElement, width = document.documentElement.clientWidth;
    if (page.scrollWidth <= width) return [];
    const clips = e => e && (getComputedStyle(e).overflowX !== 'visible' || clips(e.parentElement));
    const wide = [...document.body.querySelectorAll('*')].filter(e =>
      e.getBoundingClientRect().right > width + 1 && !clips(e.parentElement));
    return ['the page is ' + page.scrollWidth + ' pixels wide, its window ' + width,
            ...wide.slice(-5).map(e => 'too wide: ' + e.outerHTML.slice(0, 120))];
  })())js");
}

Problems target_problems(Page& page, const std::string& container) {
  return page.texts("(selector => " + std::string(R"js(
    [...document.querySelectorAll(selector)].filter(e => e.checkVisibility()).flatMap(e => {
      const { width, height } = e.getBoundingClientRect();
      return width >= 24 && height >= 24 ? []
        : [width + ' x ' + height + ' pixels: ' + e.outerHTML.slice(0, 120)];
    }))js") + ")('" +
                    container + " :is(input, select, button, summary)')");
}

Problems contrast_problems(Page& page) {
  return page.texts(script(R"js(
    const found = new Map();
    const compare = (e, style) => {
      const { ground, opacity } = look(e), own = colour(style.color);
      const lights = [over(own, ground, own[3] * opacity), ground].map(luminance);
      const contrast = (Math.max(...lights) + 0.05) / (Math.min(...lights) + 0.05);
      const size = parseFloat(style.fontSize), bold = Number(style.fontWeight) >= 700;
      if (contrast >= (size >= 24 || bold && size >= 18.66 ? 3 : 4.5)) return;
      const key = [style.color, ground, e.tagName].join();
      if (!found.has(key)) found.set(key, contrast.toFixed(2) + ': ' + e.outerHTML.slice(0, 120));
    };
    for (const e of document.querySelectorAll('[placeholder]'))
      compare(e, getComputedStyle(e, '::placeholder'));
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) {
      const e = texts.currentNode.parentElement;
      if (!texts.currentNode.data.trim() || e.closest('script, style, svg, option, [hidden]'))
        continue;
      compare(e, look(e).style);
    }
    return [...found.values()];
  )js"));
}

double ground_luminance(Page& page) {
  return page.evaluate(script("return luminance(look(document.body).ground);")).get<double>();
}

}  // namespace phytobench

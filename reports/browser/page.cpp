// SPDX-License-Identifier: MIT
#include "reports/browser/page.hpp"

#include <unistd.h>

#include <algorithm>
#include <string_view>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

using nlohmann::json;

std::string from_base64(std::string_view text) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

bool is_complaint(const std::string& kind) {
  return kind == "error" || kind == "warning" || kind == "assert";
}

std::string printed(const json& arguments) {
  std::string text;
  for (const json& argument : arguments)
    text += " " + argument.value("description", argument.value("value", json()).dump());
  return text;
}

/// Where the middle of an element is, after scrolling to it; the text says why it cannot be hit.
std::string middle_of(const std::string& element) {
  return "(() => { const e = " + element +
         "; if (!e) return 'not there';"
         "e.scrollIntoView({ block: 'center', behavior: 'instant' });"
         "const box = e.getClientRects()[0]; if (!box) return 'not shown';"
         "const x = box.x + box.width / 2, y = box.y + box.height / 2;"
         "const hit = document.elementFromPoint(x, y);"
         "return e.contains(hit) || (hit && hit.contains(e)) && !hit.closest('.bar') ? { x, y }"
         "  : 'covered by ' + (hit ? hit.outerHTML.slice(0, 80) : 'nothing'); })()";
}

}  // namespace

Page::Page(Browser& browser) : browser_(browser) {
  target_ = browser_.call("Target.createTarget", {{"url", "about:blank"}})["targetId"];
  session_ = browser_.call("Target.attachToTarget",
                           {{"targetId", target_}, {"flatten", true}})["sessionId"];
  for (const char* domain : {"Page", "Runtime", "Log", "Network"})
    call(std::string(domain) + ".enable");
  call("Network.emulateNetworkConditions",
       {{"offline", true}, {"latency", 0}, {"downloadThroughput", -1}, {"uploadThroughput", -1}});
  reset();
}

Page::~Page() {
  try {
    browser_.call("Target.closeTarget", {{"targetId", target_}});
  } catch (const EnvironmentError&) {  // a browser that has ended shows no page any more
  }
}

void Page::open(const std::filesystem::path& file, const std::string& fragment) {
  // From one fragment of a page to another a browser loads nothing.
  go_to("about:blank");
  go_to("file://" + std::filesystem::absolute(file).string() + fragment);
}

void Page::go_to(const std::string& address) {
  std::vector<json>& events = browser_.events(session_);
  events.clear();
  const json answer = call("Page.navigate", {{"url", address}});
  if (answer.contains("errorText"))
    throw EnvironmentError("browser: " + address + ": " + answer["errorText"].dump());
  browser_.wait_until(
      [&] {
        return std::any_of(events.begin(), events.end(), [](const json& event) {
          return event["method"] == "Page.loadEventFired";
        });
      },
      "loading " + address);
}

json Page::evaluate(const std::string& expression) {
  const json answer =
      call("Runtime.evaluate",
           {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  if (answer.contains("exceptionDetails"))
    throw EnvironmentError("browser: " + expression.substr(0, 200) + ": " +
                           answer["exceptionDetails"].dump().substr(0, 500));
  return answer["result"].value("value", json());
}

void Page::wait_until(const std::string& expression) {
  for (const Deadline deadline = deadline_in(10.0); !holds(expression); ::usleep(10'000))
    if (std::chrono::steady_clock::now() > deadline)
      throw EnvironmentError("browser: never true: " + expression);
}

void Page::click(const std::string& element) {
  const json place = evaluate(middle_of(element));
  if (!place.is_object())
    throw EnvironmentError("browser: cannot click " + element + ": " + place.dump());
  json event{{"type", "mousePressed"},
             {"x", place["x"]},
             {"y", place["y"]},
             {"button", "left"},
             {"clickCount", 1}};
  call("Input.dispatchMouseEvent", event);
  event["type"] = "mouseReleased";
  call("Input.dispatchMouseEvent", event);
}

void Page::press(const std::string& key) {
  const int code = key == "Tab" ? 9 : key == "Enter" ? 13 : key == "Escape" ? 27 : 0;
  json event{{"type", "keyDown"}, {"key", key}, {"code", key}, {"windowsVirtualKeyCode", code}};
  if (key == "Enter") event["text"] = "\r";
  call("Input.dispatchKeyEvent", event);
  event["type"] = "keyUp";
  event.erase("text");
  call("Input.dispatchKeyEvent", event);
}

void Page::type(const std::string& text) {
  for (std::size_t start = 0, end = 0; start < text.size(); start = end) {
    const auto continues = [&] { return (text[end] & '\xc0') == '\x80'; };
    for (++end; end < text.size() && continues(); ++end) continue;
    const std::string letter = text.substr(start, end - start);
    call("Input.dispatchKeyEvent", {{"type", "keyDown"}, {"key", letter}, {"text", letter}});
    call("Input.dispatchKeyEvent", {{"type", "keyUp"}, {"key", letter}});
  }
}

void Page::reset() {
  set_size(1280, 900);
  medium_ = "screen";
  set_color_scheme("light");
  set_scripts(true);
}

void Page::set_size(int width, int height) {
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", width < 500}});
}

void Page::set_color_scheme(const std::string& scheme) {
  scheme_ = scheme;
  set_media();
}

void Page::set_medium(const std::string& medium) {
  medium_ = medium;
  set_media();
}

void Page::set_media() {
  const json feature{{"name", "prefers-color-scheme"}, {"value", scheme_}};
  call("Emulation.setEmulatedMedia", {{"media", medium_}, {"features", json::array({feature})}});
}

void Page::set_scripts(bool enabled) {
  call("Emulation.setScriptExecutionDisabled", {{"value", !enabled}});
}

std::string Page::screenshot() {
  return from_base64(
      call("Page.captureScreenshot", {{"format", "png"}})["data"].get<std::string>());
}

std::string Page::print_to_pdf(const std::string& pages) {
  return from_base64(
      call("Page.printToPDF", {{"printBackground", true}, {"pageRanges", pages}})["data"]
          .get<std::string>());
}

std::vector<std::string> Page::complaints() {
  std::vector<std::string> texts;
  for (const json& event : browser_.events(session_)) {
    const std::string method = event["method"];
    const json& what = event["params"];
    if (method == "Runtime.exceptionThrown")
      texts.push_back("uncaught: " + what["exceptionDetails"].dump());
    if (method == "Runtime.consoleAPICalled" && is_complaint(what["type"]))
      texts.push_back("console:" + printed(what["args"]));
    if (method == "Log.entryAdded" && is_complaint(what["entry"]["level"]))
      texts.push_back("browser: " + what["entry"]["text"].get<std::string>());
  }
  return texts;
}

std::vector<std::string> Page::requests() {
  std::vector<std::string> addresses;
  for (const json& event : browser_.events(session_))
    if (event["method"] == "Network.requestWillBeSent")
      if (const std::string address = event["params"]["request"]["url"];
          !address.starts_with("data:"))
        addresses.push_back(address);
  return addresses;
}

}  // namespace phytobench

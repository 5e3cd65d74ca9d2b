// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "reports/browser/browser.hpp"

namespace phytobench {

/// One tab, without a network. JavaScript that is handed over runs even where scripts are disabled.
class Page {
 public:
  explicit Page(Browser& browser);
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// Loads a file anew and waits for it; `fragment` is what follows its name: "#counts".
  void open(const std::filesystem::path& file, const std::string& fragment = "");

  /// The value of an expression. Throws EnvironmentError with the text of what it throws.
  nlohmann::json evaluate(const std::string& expression);
  bool holds(const std::string& expression) { return evaluate("!!(" + expression + ")"); }
  std::vector<std::string> texts(const std::string& expression) {
    return evaluate(expression).get<std::vector<std::string>>();
  }

  /// Waits until an expression is true. Throws EnvironmentError if it is not in time.
  void wait_until(const std::string& expression);

  /// What a hand does: one click in the middle of an element, after scrolling to it; one key
  /// ("Tab", "Enter"); letters in UTF-8. Throws EnvironmentError where something else lies on the
  /// element.
  void click(const std::string& element);
  void press(const std::string& key);
  void type(const std::string& text);

  /// Back to 1280 x 900 pixels, light, a screen, with scripts: what it is at first.
  void reset();
  void set_size(int width, int height);              ///< narrow ones are those of a phone
  void set_color_scheme(const std::string& scheme);  ///< "light" or "dark"
  void set_medium(const std::string& medium);        ///< "screen" or "print"
  void set_scripts(bool enabled);

  std::string screenshot();                            ///< bytes of a PNG file
  std::string print_to_pdf(const std::string& pages);  ///< "1-3" -> bytes of a PDF file

  /// Since the page was opened: errors and warnings of the console, uncaught exceptions.
  std::vector<std::string> complaints();
  /// Since the page was opened: addresses of what was asked for. Not the data that a page holds.
  std::vector<std::string> requests();

  nlohmann::json call(const std::string& method,
                      const nlohmann::json& parameters = nlohmann::json::object()) {
    return browser_.call(method, parameters, session_);
  }

 private:
  void go_to(const std::string& address);
  void set_media();

  Browser& browser_;
  std::string target_, session_;
  std::string medium_ = "screen", scheme_ = "light";
};

}  // namespace phytobench

// SPDX-License-Identifier: MIT
#include "reports/plot/line_plot.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

constexpr int width = 960, height = 540;

// The colours' contrast is at least 4:1 to both pages, #fdfdfb and #141814; dashes start over.
constexpr std::array colours{"#247be0", "#ca5b0b", "#238e50", "#9e60ca", "#d84a46", "#168797",
                             "#d04596", "#8c7c14", "#6f6fe0", "#9d7254", "#56891d", "#6e7d8d"};
constexpr std::array marks{7, 5, 9, 13, 6, 4, 8, 12, 11, 15, 2, 10};
constexpr std::array dashes{"solid", "(10,4)", "(3,3)", "(12,3,3,3)"};

constexpr char head[] =
    "set terminal svg size {},{} noenhanced font 'sans-serif,14'\nset encoding utf8\n"
    "set key outside right top Left reverse samplen 4 spacing 1.2\nset border 3 lw 0.75\n"
    "set tics nomirror scale 0.7\nset grid lt 1 lw 0.75 lc rgb '#b0808080'\nset format '%g'\n"
    "set pointsize 0.8\nset xlabel {}\nset ylabel {}\n";

void expect_drawable(const LinePlot& plot) {
  PHYTOBENCH_EXPECT(!plot.id.empty() && std::all_of(plot.id.begin(), plot.id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  }));
  PHYTOBENCH_EXPECT(!plot.series.empty() && plot.series.size() <= colours.size());
  for (const auto& [name, x, y, low, high] : plot.series) {
    PHYTOBENCH_EXPECT(!x.empty() && y.size() == x.size() && low.size() == high.size());
    PHYTOBENCH_EXPECT(low.empty() || low.size() == x.size());
    for (const auto* values : {&x, &y, &low, &high})
      for (const double value : *values)
        PHYTOBENCH_EXPECT(std::isfinite(value) &&
                          (value > 0.0 || !(values == &x ? plot.log_x : plot.log_y)));
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// With spaces for control characters, which neither gnuplot's strings nor XML can hold.
std::string printable(std::string text) {
  for (char& c : text) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return text;
}

/// Octal escapes only, for gnuplot ends or expands quoted text in more ways than its manual says.
std::string quoted(const std::string& text) {
  std::string codes;
  for (const char c : printable(text)) codes += fmt::format("\\{:03o}", c & 0xff);
  return "\"" + codes + "\"";
}

std::string escaped_for_xml(const std::string& text) {
  const std::string inside = replaced(replaced(printable(text), "&", "&amp;"), "\"", "&quot;");
  return replaced(replaced(inside, "<", "&lt;"), ">", "&gt;");
}

/// digit * 10^power: 0.01, 50, 1,000, but 1e-6.
std::string tick_label(int digit, int power) {
  if (power < -3 || power > 7) return fmt::format("{}e{}", digit, power);
  std::string label = fmt::format("{:.{}f}", digit * std::pow(10, power), std::max(0, -power));
  for (int place = power - 2; place > 0; place -= 3)
    label.insert(static_cast<std::size_t>(place), ",");
  return label;
}

/// Ticks at every digit, named at decades; at 2 and 5 as well where there are few decades.
std::string logarithmic_axis(char axis, const std::vector<double>& values) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  // At least a factor of 6.25 from end to end, so that two named ticks lie between.
  const double pad = std::max(1.4, 2.5 / std::sqrt(*highest / *lowest));
  const double low = *lowest / pad, high = *highest * pad;
  std::string script =
      fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\nset {0}tics ()\n", axis, low, high);
  for (int power = static_cast<int>(std::floor(std::log10(low))); power <= std::log10(high);
       ++power)
    for (int digit = 1; digit <= 9; ++digit) {
      const bool named = digit == 1 || (high < 100.0 * low && (digit == 2 || digit == 5));
      script += fmt::format("set {}tics add ('{}' {}e{} {})\n", axis,
                            named ? tick_label(digit, power) : "", digit, power, named ? 0 : 1);
    }
  return script;
}

std::string script_of(const LinePlot& plot) {
  std::string script = fmt::format(head, width, height, quoted(plot.x_label), quoted(plot.y_label));
  std::vector<double> all_x, all_y;
  std::string curves = "plot", bars;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const auto& [name, x, y, low, high] = plot.series[i];
    script += fmt::format("$data{} << end\n", i);
    for (std::size_t j = 0; j < x.size(); ++j)
      script += low.empty() ? fmt::format("{0} {1} {1} {1}\n", x[j], y[j])
                            : fmt::format("{} {} {} {}\n", x[j], y[j], low[j], high[j]);
    script += "end\n";
    all_x.insert(all_x.end(), x.begin(), x.end());
    for (const auto* values : {&y, &low, &high})
      all_y.insert(all_y.end(), values->begin(), values->end());
    curves += fmt::format(" $data{} using 1:2 with lp lw 2 lc rgb '{}' dt {} pt {} title {},", i,
                          colours[i], dashes[i % dashes.size()], marks[i], quoted(name));
    bars += fmt::format(
        " $data{} u 1:3:(0):($4-$3) with vectors heads size screen 0.004,90 lc rgb '{}' notitle,",
        i, colours[i]);
  }
  bars.back() = '\n';
  if (plot.log_x) script += logarithmic_axis('x', all_x);
  if (plot.log_y) script += logarithmic_axis('y', all_y);
  return script + curves + bars;
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// With the content to read. Files instead of pipes: nobody waits for a reader.
File temporary_file(const std::string& content = "") {
  File file(std::tmpfile(), std::fclose);
  if (!file || std::fputs(content.c_str(), file.get()) < 0 || std::fflush(file.get()) != 0)
    throw EnvironmentError(std::string("no file for gnuplot's script: ") + std::strerror(errno));
  std::rewind(file.get());
  return file;
}

std::string content_of(const File& file) {
  std::string content;
  std::rewind(file.get());
  for (int c; (c = std::fgetc(file.get())) != EOF;) content += static_cast<char>(c);
  return content;
}

/// The SVG file that gnuplot makes of a script; nothing if there is no such program.
std::optional<std::string> output_of(std::string program, const std::string& script) {
  const File in = temporary_file(script), out = temporary_file(), err = temporary_file();
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  int target = 0, status = -1;
  for (const File* file : {&in, &out, &err})
    ::posix_spawn_file_actions_adddup2(&actions, ::fileno(file->get()), target++);
  std::string no_user_settings = "-d", locale = "LC_ALL=C";
  char* const argv[] = {program.data(), no_user_settings.data(), nullptr};
  char* const envp[] = {locale.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, argv, envp);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT || error == ENOTDIR || error == EACCES) return std::nullopt;
  while (error == 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  std::string svg = content_of(out);
  if (status == 0 && svg.find("</svg>") != std::string::npos) return svg;
  throw EnvironmentError(program + " drew nothing: " +
                         (error == 0 ? printable(content_of(err)) : std::strerror(error)));
}

/// The picture under our title. Only tags change: what stands between may be a text of the user.
std::string inlined(const LinePlot& plot, const std::string& svg) {
  std::string result = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\" aria-labelledby=\"{2}-title {2}-description\">\n"
      "<title id=\"{2}-title\">{3}</title>\n<desc id=\"{2}-description\">{4}</desc>\n",
      width, height, plot.id, escaped_for_xml(plot.title), escaped_for_xml(plot.description));
  std::size_t titles = 0;  // of curves, then of their error bars
  for (std::size_t tag = svg.find("<g id="), text = 0, next = 0; tag < svg.size(); tag = next) {
    text = svg.find('>', tag) + 1;
    next = std::min(svg.find('<', text), svg.size());
    std::string markup = replaced(svg.substr(tag, text - tag), "black", "currentColor");
    for (const char* reference : {" id='", " id=\"", "href='#", "url(#"})
      markup = replaced(markup, reference, fmt::format("{}{}-", reference, plot.id));
    result += markup;
    result += markup == "<title>" ? escaped_for_xml(plot.series[titles++ % plot.series.size()].name)
                                  : svg.substr(text, next - text);
  }
  return result;
}

}  // namespace

std::optional<std::string> draw(const LinePlot& plot, const std::string& gnuplot) {
  expect_drawable(plot);
  const std::optional<std::string> svg = output_of(gnuplot, script_of(plot));
  return svg ? std::optional(inlined(plot, *svg)) : std::nullopt;
}

}  // namespace phytobench

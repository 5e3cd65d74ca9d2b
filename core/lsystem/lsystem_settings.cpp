// SPDX-License-Identifier: MIT
#include "core/lsystem/lsystem_settings.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"

namespace phytobench {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_steps = 1'000'000;
constexpr double most_seed = 9'007'199'254'740'992;  // 2^53: a double holds no more

struct ValueReader {
  LSystem& system;
  LineScanner scanner;
  const LineSetting& setting;
  const Alphabet& alphabet;
  const Constants& constants;

  double number(const NumberRange& range) {
    const std::size_t place = scanner.offset();
    const double value = parse_constant(scanner, constants);
    if (!is_allowed(value, range))
      setting.line->fail(place, out_of_range(setting.key, value, range));
    return value;
  }

  std::string letters() {
    std::string all;
    for (const ListedLetter& listed : parse_letters(scanner, alphabet)) {
      const char letter = listed.letter[0];
      if (listed.letter.size() > 1)
        setting.line->fail(listed.place,
                           fmt::format("'{}' has more than one character; only letters of one "
                                       "character can {}",
                                       listed.letter, setting.key));
      if (std::string_view("+-&^\\/|$[]{}.!'%").find(letter) != std::string_view::npos)
        setting.line->fail(listed.place, fmt::format("'{}' already means something to the turtle; "
                                                     "{} with another letter",
                                                     letter, setting.key));
      if (all.find(letter) == std::string::npos) all += letter;
    }
    return all;
  }

  void colours() {
    while (!scanner.at_end()) {
      const std::size_t place = scanner.offset();
      const std::string_view word = scanner.take_word();
      if (!is_colour(word))
        setting.line->fail(place, fmt::format("'{}' is no colour; write '#' and six hexadecimal "
                                              "digits, as in '#6b4a2b'",
                                              in_one_line(word, 40)));
      system.turtle.colours.emplace_back(word);
    }
  }

  void convention() {
    const std::size_t place = scanner.offset();
    try {
      system.turtle.convention = turtle_convention_named(scanner.take_word());
    } catch (const InputError& error) {
      setting.line->fail(place, error.what());
    }
  }

  void start() {
    const std::size_t place = scanner.offset();
    const std::string_view word = scanner.take_word();
    if (word == "upwards") {
      system.turtle.start = TurtleStart::upwards;
    } else if (word == "local") {
      system.turtle.start = TurtleStart::local;
    } else {
      setting.line->fail(
          place, fmt::format("no start '{}'{}; give upwards or local", in_one_line(word, 40),
                             near_name(word, {"upwards", "local"})));
    }
  }
};

struct Key {
  std::string_view name;
  SettingKind kind;
  void (*assign)(ValueReader& reader) = nullptr;
};

constexpr NumberRange above_zero{.low = 0.0, .low_is_allowed = false};

constexpr std::array keys{
    Key{"axiom", SettingKind::axiom},
    Key{"omega", SettingKind::axiom},
    Key{"ω", SettingKind::axiom},
    Key{"w", SettingKind::axiom},
    Key{"alphabet", SettingKind::alphabet},
    Key{"V", SettingKind::alphabet},
    Key{"ignore", SettingKind::ignore},
    Key{"steps", SettingKind::value,
        [](ValueReader& r) {
          r.system.steps = static_cast<int>(r.number({.high = most_steps, .whole = true}));
        }},
    Key{"seed", SettingKind::value,
        [](ValueReader& r) {
          r.system.seed = static_cast<std::uint64_t>(r.number({.high = most_seed, .whole = true}));
        }},
    Key{"angle", SettingKind::value,
        [](ValueReader& r) { r.system.turtle.angle_deg = r.number({.low = -infinity}); }},
    Key{"step", SettingKind::value,
        [](ValueReader& r) { r.system.turtle.step = r.number(above_zero); }},
    Key{"width", SettingKind::value,
        [](ValueReader& r) {
          r.system.turtle.width = r.number(above_zero);
          r.system.turtle.width_is_given = true;
        }},
    Key{"width_factor", SettingKind::value,
        [](ValueReader& r) { r.system.turtle.width_factor = r.number(above_zero); }},
    Key{"draw", SettingKind::value, [](ValueReader& r) { r.system.turtle.draws = r.letters(); }},
    Key{"move", SettingKind::value, [](ValueReader& r) { r.system.turtle.moves = r.letters(); }},
    Key{"turtle", SettingKind::value, [](ValueReader& r) { r.convention(); }},
    Key{"start", SettingKind::value, [](ValueReader& r) { r.start(); }},
    Key{"colours", SettingKind::value, [](ValueReader& r) { r.colours(); }},
};

const Key* key_named(std::string_view name) {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

/// One letter or omega: what a constant or label may well be called.
bool is_alias(const Key& key) {
  return key.name.size() <= 2 || key.name == "omega";
}

/// The key at the scanner, with its ':'; empty if there is none.
std::string_view take_key(LineScanner& scanner) {
  LineScanner ahead = scanner;
  std::string_view name = ahead.take_name();
  if (name.empty() && ahead.next_is("ω")) name = ahead.take_character();
  if (name.empty() || !ahead.take(":")) return {};
  scanner = ahead;
  return name;
}

[[noreturn]] void refuse_line(const LineScanner& scanner) {
  scanner.fail(
      "neither a production with an arrow, as 'F -> F[+F]', nor 'key: value' or 'name = number'; "
      "complete the line (it goes on with the one before if it begins with a blank)");
}

[[noreturn]] void refuse_key(const SourceLine& line, std::size_t place, std::string_view name) {
  std::vector<std::string> known;
  for (const Key& key : keys)
    if (!is_alias(key)) known.emplace_back(key.name);
  line.fail(place,
            fmt::format("unknown key '{}'{} (and there is no arrow, as in 'F -> F[+F]', that "
                        "would make the line a production)",
                        in_one_line(name, 40), near_name(name, known)));
}

bool is_given(const std::vector<LineSetting>& settings, std::string_view key) {
  return std::any_of(settings.begin(), settings.end(),
                     [&](const LineSetting& setting) { return setting.key == key; });
}

}  // namespace

bool is_setting(std::string_view name) {
  const Key* key = key_named(name);
  return key != nullptr && !is_alias(*key);
}

std::vector<LineSetting> line_settings(const SourceLine& line) {
  std::vector<LineSetting> settings;
  LineScanner scanner(line);
  while (!scanner.at_end()) {
    const std::size_t place = scanner.offset();
    const std::string_view name = take_key(scanner);
    if (name.empty()) {
      if (settings.empty()) refuse_line(scanner);
      scanner.take_word();
    } else {
      const Key* key = key_named(name);
      if (key == nullptr) refuse_key(line, place, name);
      if (!settings.empty()) settings.back().end = place;
      settings.push_back({key->name, key->kind, &line, place, scanner.offset(), line.text.size()});
    }
  }
  for (const LineSetting& setting : settings)
    if (setting.value().at_end())
      line.fail(setting.key_offset,
                fmt::format("'{}:' without a value; give one, or remove it", setting.key));
  return settings;
}

std::vector<ListedLetter> parse_letters(LineScanner& scanner, const Alphabet& alphabet) {
  std::vector<ListedLetter> letters;
  while (!scanner.at_end()) {
    if (scanner.take(",")) continue;
    const std::size_t place = scanner.offset();
    letters.push_back({alphabet.take_letter(scanner), place});
  }
  return letters;
}

void assign_value(LSystem& system, const LineSetting& setting, const Alphabet& alphabet,
                  const Constants& constants) {
  ValueReader reader{system, setting.value(), setting, alphabet, constants};
  key_named(setting.key)->assign(reader);
  if (!reader.scanner.at_end())
    reader.scanner.fail(fmt::format("{} behind the value of '{}'; remove it",
                                    reader.scanner.next_shown(), setting.key));
}

void settle_draw_and_move(LSystem& system, const std::vector<LineSetting>& settings) {
  std::string& draws = system.turtle.draws;
  std::string& moves = system.turtle.moves;
  const bool draw_is_given = is_given(settings, "draw");
  const bool move_is_given = is_given(settings, "move");
  if (draw_is_given && move_is_given)
    for (const LineSetting& setting : settings) {
      const std::size_t both = draws.find_first_of(moves);
      if (setting.key == "move" && both != std::string::npos)
        setting.line->fail(setting.begin,
                           fmt::format("'{}' is also named by 'draw:'; keep one", draws[both]));
    }
  if (draw_is_given && !move_is_given)
    std::erase_if(moves, [&](char c) { return draws.find(c) != std::string::npos; });
  if (move_is_given && !draw_is_given)
    std::erase_if(draws, [&](char c) { return moves.find(c) != std::string::npos; });
}

}  // namespace phytobench

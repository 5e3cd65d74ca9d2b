// SPDX-License-Identifier: MIT
// The values of reference/certified/growth.toml derived again, and the library held to them.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/population/coupled_growth.hpp"
#include "core/population/growth_integrators.hpp"
#include "core/population/richards_growth.hpp"
#include "core/statistics/log_relative_error.hpp"
#include "reference/certified_values.hpp"

namespace phytobench::certified {
namespace {

/// As the literature writes it: w (1 + ((w / v_0)^(delta - 1) - 1) e^(-k t))^(-1 / (delta - 1)).
Exact size_law(const Exact& k, const Exact& w, const Exact& delta, const Exact& start,
               const Exact& time) {
  const Exact left = exp(Exact(-k * time)), bend = delta - 1;
  if (bend == 0) return w * exp(Exact(log(Exact(start / w)) * left));
  return w * pow(Exact(1 + (pow(Exact(w / start), bend) - 1) * left), Exact(-1 / bend));
}

Exact richards(const Value& v) {
  return size_law(v.exact("rate"), v.exact("final_size"), v.exact("shape"), v.exact("initial"),
                  v.exact("time"));
}

/// (5.8) in separated variables: R / (R_max - R) grows as e^(MGR t / R_max).
Exact radius(const Value& v) {
  const Exact largest = v.exact("largest_radius"), start = v.exact("initial");
  const Exact odds =
      start / (largest - start) * exp(Exact(v.exact("highest_rate") * v.exact("time") / largest));
  return largest * odds / (1 + odds);
}

Exact inflection(const Value& v) {
  const Exact delta = v.exact("shape");
  return delta == 1 ? Exact(v.exact("final_size") / exp(Exact(1)))
                    : Exact(v.exact("final_size") * pow(delta, Exact(1 / (1 - delta))));
}

/// The rate at the inflection as (2.1) has it, k v log(w / v) for delta = 1.
Exact largest_rate(const Value& v) {
  const Exact k = v.exact("rate"), w = v.exact("final_size"), bend = v.exact("shape") - 1;
  const Exact size = inflection(v);
  if (bend == 0) return k * size * log(Exact(w / size));
  return k / bend * size * (1 - pow(Exact(size / w), bend));
}

Exact conserved(const Exact& size, const Exact& asymmetry) {
  if (asymmetry == 1) return log(size);
  return (pow(size, Exact(1 - asymmetry)) - 1) / (1 - asymmetry);
}

/// By halving the interval in which the difference of what is conserved is that of the start.
Exact end_of_smaller(const Value& v) {
  const Exact a = v.exact("asymmetry"), w = v.exact("final_size");
  const Exact kept = conserved(v.exact("second"), a) - conserved(v.exact("first"), a);
  Exact low = v.exact("first"), high = w / 2;
  while (high - low > Exact("1e-40")) {
    const Exact middle = (low + high) / 2;
    const bool too_far_apart = conserved(w - middle, a) - conserved(middle, a) >= kept;
    (too_far_apart ? low : high) = middle;
  }
  return low;
}

template <class Method>
Exact stepped(const Value& v, const Method& method) {
  const Exact step = v.exact("time") / v.exact("steps");
  const auto rate = [&](const Exact& size) -> Exact {
    return v.exact("rate") * size * (1 - size / v.exact("final_size"));
  };
  Exact size = v.exact("initial");
  for (std::size_t i = 0; i < v.count("steps"); ++i) size = method(size, step, rate);
  return size;
}

Exact euler(const Value& v) {
  return stepped(v, [](const Exact& size, const Exact& step, const auto& rate) -> Exact {
    return size + step * rate(size);
  });
}

Exact runge_kutta(const Value& v) {
  return stepped(v, [](const Exact& size, const Exact& step, const auto& rate) -> Exact {
    const Exact first = rate(size), second = rate(Exact(size + step * first / 2));
    const Exact third = rate(Exact(size + step * second / 2));
    const Exact fourth = rate(Exact(size + step * third));
    return size + step * (first + 2 * second + 2 * third + fourth) / 6;
  });
}

RichardsGrowth growth_of(const Value& v) {
  return {v.number("rate"), v.number("final_size"), v.number("shape")};
}

template <class Method>
double stepped_by_library(const Value& v) {
  const RichardsGrowth logistic{v.number("rate"), v.number("final_size"), 2.0};
  return integrated(Method{}, v.number("initial"), v.number("time"), v.count("steps"),
                    [&](double size) { return richards_rate(logistic, size); });
}

struct Quantity {
  std::function<Exact(const Value&)> derived;
  std::function<double(const Value&)> computed;
};

const std::map<std::string, Quantity>& quantities() {
  static const std::map<std::string, Quantity> all = {
      {"richards_size",
       {richards,
        [](const Value& v) {
          return richards_size(growth_of(v), v.number("initial"), v.number("time"));
        }}},
      {"radius_size",
       {radius,
        [](const Value& v) {
          return richards_size(radius_growth(v.number("highest_rate"), v.number("largest_radius")),
                               v.number("initial"), v.number("time"));
        }}},
      {"inflection_size",
       {inflection, [](const Value& v) { return richards_inflection_size(growth_of(v)).value(); }}},
      {"largest_rate",
       {largest_rate, [](const Value& v) { return richards_largest_rate(growth_of(v)).value(); }}},
      {"end_size_of_smaller",
       {end_of_smaller,
        [](const Value& v) {
          return end_sizes_of_two(v.number("final_size"), v.number("asymmetry"),
                                  {v.number("first"), v.number("second")})
              .first;
        }}},
      {"euler", {euler, stepped_by_library<ExplicitEuler>}},
      {"runge_kutta", {runge_kutta, stepped_by_library<RungeKutta4>}}};
  return all;
}

TEST(CertifiedGrowthOracle, HasTheDigitsOfAnotherDerivation) {
  const std::vector<Value> values = values_of("growth");
  ASSERT_GE(values.size(), 34u);
  for (const Value& value : values) {
    const Exact exact = quantities().at(value.quantity()).derived(value);
    EXPECT_TRUE(is_rounded_to(value.digits(), exact)) << value.name() << ": " << exact.str(35);
  }
}

TEST(CertifiedGrowthOracle, IsKeptByTheLibrary) {
  for (const Value& value : values_of("growth")) {
    const double computed = quantities().at(value.quantity()).computed(value);
    EXPECT_GE(log_relative_error(computed, value.certified()), value.promised_digits())
        << value.name();
  }
}

}  // namespace
}  // namespace phytobench::certified

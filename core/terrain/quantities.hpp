// SPDX-License-Identifier: MIT
// Numbers with units that the compiler checks: a product where a quotient is meant does not fit
// what it is assigned to.
#pragma once

#include <compare>

namespace phytobench {

/// kcal^energy m^length l^volume d^time.
template <int energy, int length, int volume, int time>
class Quantity {
 public:
  constexpr Quantity() = default;
  constexpr explicit Quantity(double value) : value_(value) {}
  constexpr double value() const { return value_; }

  friend constexpr auto operator<=>(const Quantity&, const Quantity&) = default;
  friend constexpr Quantity operator+(Quantity a, Quantity b) {
    return Quantity(a.value_ + b.value_);
  }
  friend constexpr Quantity operator-(Quantity a, Quantity b) {
    return Quantity(a.value_ - b.value_);
  }
  friend constexpr Quantity operator*(Quantity a, double factor) {
    return Quantity(a.value_ * factor);
  }
  friend constexpr Quantity operator*(double factor, Quantity a) { return a * factor; }
  friend constexpr Quantity operator/(Quantity a, double divisor) {
    return Quantity(a.value_ / divisor);
  }

 private:
  double value_ = 0.0;
};

template <int e, int l, int v, int t, int f, int m, int w, int u>
constexpr auto operator*(Quantity<e, l, v, t> a, Quantity<f, m, w, u> b) {
  return Quantity<e + f, l + m, v + w, t + u>(a.value() * b.value());
}
template <int e, int l, int v, int t, int f, int m, int w, int u>
constexpr auto operator/(Quantity<e, l, v, t> a, Quantity<f, m, w, u> b) {
  return Quantity<e - f, l - m, v - w, t - u>(a.value() / b.value());
}
/// How many times the one is contained in the other.
template <int e, int l, int v, int t>
constexpr double operator/(Quantity<e, l, v, t> a, Quantity<e, l, v, t> b) {
  return a.value() / b.value();
}

using EnergyPerArea = Quantity<1, -2, 0, 0>;      ///< kcal/m2
using DailyEnergy = Quantity<1, -2, 0, -1>;       ///< kcal/m2 a day
using DailyWater = Quantity<0, -2, 1, -1>;        ///< l/m2 a day, which is mm a day
using HeatOfEvaporation = Quantity<1, 0, -1, 0>;  ///< kcal/l
using Length = Quantity<0, 1, 0, 0>;              ///< m
using Time = Quantity<0, 0, 0, 1>;                ///< d
inline constexpr Time one_day{1.0};

constexpr Length centimetres(double number) {
  return Length(number / 100.0);
}
constexpr double in_centimetres(Length length) {
  return length.value() * 100.0;
}

}  // namespace phytobench

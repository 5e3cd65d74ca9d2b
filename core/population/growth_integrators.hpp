// SPDX-License-Identifier: MIT
// Steps of a growth law v' = rate(v) that does not depend on the time itself. A state is a number,
// or a vector of them with one entry per plant.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/contract/check.hpp"

namespace phytobench {

/// state + step * slope.
inline double moved(double state, double step, double slope) {
  return state + step * slope;
}

inline std::vector<double> moved(std::vector<double> state, double step,
                                 const std::vector<double>& slope) {
  PHYTOBENCH_EXPECT(state.size() == slope.size());
  for (std::size_t i = 0; i < state.size(); ++i) state[i] += step * slope[i];
  return state;
}

/// Explicit Euler, of order 1: what (4.7) of [Alsweis] is taken to mean.
struct ExplicitEuler {
  template <class State, class Rate>
  State operator()(const State& state, double step, const Rate& rate) const {
    return moved(state, step, rate(state));
  }
};

/// The classical method of Runge and Kutta, of order 4.
struct RungeKutta4 {
  template <class State, class Rate>
  State operator()(const State& state, double step, const Rate& rate) const {
    const State k1 = rate(state);
    const State k2 = rate(moved(state, 0.5 * step, k1));
    const State k3 = rate(moved(state, 0.5 * step, k2));
    const State k4 = rate(moved(state, step, k3));
    return moved(moved(moved(moved(state, step / 6.0, k1), step / 3.0, k2), step / 3.0, k3),
                 step / 6.0, k4);
  }
};

/// The state after `steps` equal steps that fill a time.
template <class Method, class State, class Rate>
State integrated(const Method& method, State state, double time, std::size_t steps,
                 const Rate& rate) {
  PHYTOBENCH_EXPECT(std::isfinite(time) && steps > 0);
  const double step = time / static_cast<double>(steps);
  for (std::size_t i = 0; i < steps; ++i) state = method(state, step, rate);
  return state;
}

/// Implicit Euler, of order 1: the size v > 0 with v = size + step * rate(v), which is what (4.7)
/// of [Alsweis] says. Of several the nearest in the direction of growth that a search in doubling
/// strides does not overlook; nothing if there is none. For size > 0 and a rate of all sizes > 0.
template <class Rate>
std::optional<double> implicit_euler_step(double size, double step, const Rate& rate) {
  PHYTOBENCH_EXPECT(size > 0.0 && std::isfinite(step));
  const auto excess = [&](double v) { return v - moved(size, step, rate(v)); };
  const double growth = step * rate(size);
  if (growth == 0.0) return size;
  // Find a size on the other side of the solution.
  double near = size, far = size, stride = growth;
  do {
    near = far;
    far = growth > 0.0 ? size + stride : 0.5 * far;
    stride *= 2.0;
    if (!(far > 0.0 && std::isfinite(far))) return std::nullopt;
  } while (!(growth > 0.0 ? excess(far) > 0.0 : excess(far) < 0.0));
  // Halve until no number lies between.
  for (;;) {
    const double middle = 0.5 * (near + far);
    if (middle == near || middle == far) return far;
    ((growth > 0.0 ? excess(middle) > 0.0 : excess(middle) < 0.0) ? far : near) = middle;
  }
}

}  // namespace phytobench

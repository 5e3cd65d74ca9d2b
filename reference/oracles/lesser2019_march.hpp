// SPDX-License-Identifier: MIT
// The march along a ray of sunlight of [Lesser2019] listing 9.12, line by line, with each of its
// faults as a switch. Shares no code with core/.
#pragma once

#include <vector>

#include "reference/oracles/lesser2019_terrain.hpp"

namespace phytobench::oracles::lesser2019 {

// The thesis does not print where a ray starts. From the corner (x ps, y ps) hours 1 and 13 work.
enum class Start { corner, centre };

struct MarchForm {
  // E08: the axis with the larger remainder, and the way to its next line in positive direction.
  // Otherwise the line that is met first.
  bool larger_remainder = true;
  // E10: int() cuts off, so that less than a pixel outside is inside. Otherwise floor().
  bool truncates = true;
  // E09: may divide by zero, or add steps of nothing for ever. Otherwise the other axis is taken,
  // and a step of nothing goes on by a pixel.
  bool unguarded = true;
  Start start = Start::corner;
};

enum class Outcome {
  lit,
  dark,
  stuck,    // t + t_step = t: the loop does not end
  crashed,  // division by zero
};

struct Visited {
  int i = 0, j = 0;     // the pixel that was compared
  double X = 0, Y = 0;  // m, where the ray was then
};

struct MarchResult {
  Outcome outcome = Outcome::lit;
  int iterations = 0;  // of the loop that were begun
  std::vector<Visited> visited;
};

class PrintedMarch {
 public:
  // The heights must outlive the march.
  explicit PrintedMarch(const Heights& heights, MarchForm form = {});

  MarchResult from(int x, int y, const Direction& sun) const;
  // A height to start at that is not the pixel's own, and a map that is higher than it is: for
  // following rays that nothing stops.
  MarchResult over(int x, int y, double z, const Direction& sun, double heightmap_max) const;

 private:
  struct Step {
    double t = 0;
    bool divides_by_zero = false;
  };
  Step step(double X, double Y, const Direction& sun) const;
  Step printed_step(double X, double Y, const Direction& sun) const;
  double true_step(double X, double Y, const Direction& sun) const;
  int pixel(double real, double ps) const;

  const Heights& map_;
  MarchForm form_;
  double heightmap_max_height_;
};

// Cells whose inside a ray from the corner of (x, y) passes through, in order, its own left out.
std::vector<Visited> crossed_from_corner(const Heights& map, int x, int y, const Direction& sun);

// How many of them the march never compares, over all crossed ones.
struct Untested {
  int crossed = 0, untested = 0;
};
Untested untested_cells(const Heights& map, int x, int y, const Direction& sun,
                        const MarchForm& form = {});

}  // namespace phytobench::oracles::lesser2019

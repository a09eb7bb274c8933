// SPDX-License-Identifier: LGPL-2.1-or-later
// The search for the largest distance that can be proved to be regular.
//
// A limit is sampled to find its least value, which is an estimate; then a distance below that by a
// margin is put to the proof. What is returned is proved, whatever the samples were.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"

namespace pn {

/// What a limit says to a distance.
struct Verdict {
  bool proved;
  double least_sample;  ///< met on the way to the proof
};

/// Distances that are tried, in tolerances.
struct Margins {
  double factor;    ///< by which the margin grows while a distance cannot be proved
  double most;      ///< the largest margin
  double farthest;  ///< the distance for which a proof is tried where no sample is smaller
};

/// So many distances are tried.
inline constexpr int kMostTries = 100;

/// The largest distance within all limits that is proved, below their least sample by the
/// tolerance. Throws Undecided when the margins are used up. A limit has the functions
/// least_sample(limit) and verdict(limit, distance).
template <class SomeLimit>
double proved_limit(const std::vector<SomeLimit>& limits, double tolerance, double least_useful,
                    const Margins& margins) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<double> samples(limits.size());
  for_each_index(limits.size(), [&](std::size_t i) { samples[i] = least_sample(limits[i]); });
  double least = *std::min_element(samples.begin(), samples.end());
  least = std::min(least, margins.farthest * tolerance);
  double margin = tolerance;
  for (int tries = 0; tries < kMostTries && margin <= margins.most * tolerance; ++tries) {
    const double distance = least - margin;
    if (distance <= least_useful) return least_useful;
    std::vector<Verdict> verdicts(limits.size());
    for_each_index(limits.size(),
                   [&](std::size_t i) { verdicts[i] = verdict(limits[i], distance); });
    double smaller = kInfinity;
    bool proved = true;
    for (const Verdict& v : verdicts) {
      smaller = std::min(smaller, v.least_sample);
      proved = proved && v.proved;
    }
    if (proved) return distance;
    // A smaller sample is a new place to start from; without one the proof lacks room.
    margin = smaller < least ? tolerance : margins.factor * margin;
    least = std::min(least, smaller);
  }
  throw Undecided("the limit of the offsets");
}

}  // namespace pn

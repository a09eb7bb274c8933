// SPDX-License-Identifier: LGPL-2.1-or-later
// The search for the largest distance that can be proved to be regular.
//
// A limit is sampled to find its least value, which is an estimate; then a distance below that by a
// margin is put to the proof. The distance is proved, whatever the samples were; the place of the
// least one comes with it as an estimate.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "pn/algebra/parallel.hpp"
#include "pn/algebra/roots.hpp"

namespace pn {

/// A value of a limit, and where it was taken.
template <class Place>
struct LimitSample {
  double value = std::numeric_limits<double>::infinity();
  Place at = {};
};

/// What a limit says to a distance.
template <class Place>
struct Verdict {
  bool proved;
  LimitSample<Place> least_sample;  ///< met on the way to the proof
};

/// Where limits are least: nearly, since only distances are proved.
template <class Place>
struct CriticalPlace {
  std::size_t limit;  ///< which of them
  LimitSample<Place> sample;
};

template <class Place>
struct ProvedLimit {
  double distance;
  std::optional<CriticalPlace<Place>> critical;  ///< none where no sample was near the distance
};

/// Distances that are tried, in tolerances.
struct Margins {
  double factor;    ///< by which the margin grows while a distance cannot be proved
  double most;      ///< the largest margin
  double farthest;  ///< the distance for which a proof is tried where no sample is smaller
};

/// So many distances are tried.
inline constexpr int kMostTries = 100;

/// The least of some samples, one for each limit.
template <class Place>
CriticalPlace<Place> least_of(const std::vector<LimitSample<Place>>& samples) {
  const auto less = [](const auto& a, const auto& b) { return a.value < b.value; };
  const auto least = std::min_element(samples.begin(), samples.end(), less);
  return {static_cast<std::size_t>(least - samples.begin()), *least};
}

/// The largest distance within all limits that is proved, below their least sample by the
/// tolerance. Throws Undecided when the margins are used up. A limit has a type Place and the
/// functions least_sample(limit) and verdict(limit, distance).
template <class SomeLimit>
ProvedLimit<typename SomeLimit::Place> proved_limit(const std::vector<SomeLimit>& limits,
                                                    double tolerance, double least_useful,
                                                    const Margins& margins) {
  using Place = typename SomeLimit::Place;
  std::vector<LimitSample<Place>> samples(limits.size());
  for_each_index(limits.size(), [&](std::size_t i) { samples[i] = least_sample(limits[i]); });
  CriticalPlace<Place> least = least_of(samples);
  const double farthest = margins.farthest * tolerance;
  double margin = tolerance;
  for (int tries = 0; tries < kMostTries && margin <= margins.most * tolerance; ++tries) {
    const bool is_near = least.sample.value < farthest;
    const auto critical = is_near ? std::optional(least) : std::nullopt;
    const double distance = std::min(least.sample.value, farthest) - margin;
    if (distance <= least_useful) return {least_useful, critical};
    std::vector<std::optional<Verdict<Place>>> verdicts(limits.size());
    for_each_index(limits.size(),
                   [&](std::size_t i) { verdicts[i] = verdict(limits[i], distance); });
    bool proved = true;
    for (std::size_t i = 0; i < limits.size(); ++i) {
      samples[i] = verdicts[i]->least_sample;
      proved = proved && verdicts[i]->proved;
    }
    if (proved) return {distance, critical};
    // A smaller sample is a new place to start from; without one the proof lacks room.
    const CriticalPlace<Place> met = least_of(samples);
    const bool is_smaller = met.sample.value < std::min(least.sample.value, farthest);
    margin = is_smaller ? tolerance : margins.factor * margin;
    if (is_smaller) least = met;
  }
  throw Undecided("the limit of the offsets");
}

}  // namespace pn

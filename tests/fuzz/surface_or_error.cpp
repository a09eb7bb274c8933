// SPDX-License-Identifier: LGPL-2.1-or-later
#include "surface_or_error.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <future>

#include "pn/algebra/cancellation.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/geometry_error.hpp"

namespace pn::fuzz {
namespace {

// Many times what a surface of these sizes takes without sanitizers. High precision may take longer
// and is no finding: the work is asked to stop then. It is one when that does not help, see
// scripts/fuzz.
constexpr std::chrono::seconds kPatience(5);

bool is_finite(double x) { return std::isfinite(x); }

template <std::size_t Dimension>
bool is_finite(const std::array<double, Dimension>& point) {
  return std::all_of(point.begin(), point.end(), [](double x) { return is_finite(x); });
}

void check_knots(int degree, const std::vector<double>& knots,
                 const std::vector<int>& multiplicities) {
  require(degree >= 1 && degree <= kLargestDegree, "The degree lies between 1 and 25.");
  require(knots.size() >= 2 && knots.size() == multiplicities.size(),
          "Every knot has its multiplicity.");
  require(std::all_of(knots.begin(), knots.end(), [](double t) { return is_finite(t); }),
          "Knots are finite.");
  require(std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<>()) == knots.end(),
          "Knots increase strictly.");
  require(multiplicities.front() == degree + 1 && multiplicities.back() == degree + 1,
          "The spline is clamped.");
}

void check_face(const BSplineSurface& face) {
  check_knots(face.u_degree, face.u_knots, face.u_multiplicities);
  check_knots(face.v_degree, face.v_knots, face.v_multiplicities);
  require(face.poles.size() == face.u_count() * face.v_count(), "There is a pole for each place.");
  require(face.weights.size() == face.poles.size(), "There is a weight for each pole.");
  for (const auto& pole : face.poles) require(is_finite(pole), "Poles are finite.");
  for (const double weight : face.weights) {
    require(is_finite(weight) && weight > 0, "Weights are positive.");
  }
  for (const TrimLoop& loop : face.trims) {
    for (const ParameterCurve& curve : loop) {
      check_knots(curve.degree, curve.knots, curve.multiplicities);
      for (const auto& pole : curve.poles) require(is_finite(pole), "Trims are finite.");
    }
  }
  const SurfaceEvaluation point(face);
  for (const double part : {0.0, 0.375, 1.0}) {
    const double u = face.u_knots.front() + part * (face.u_knots.back() - face.u_knots.front());
    for (const double v : {face.v_knots.front(), face.v_knots[face.v_knots.size() / 2]}) {
      require(is_finite(point(u, v)), "Points are finite.");
    }
  }
}

void check_section(const PNSurface& surface, Lines lines) {
  for (const BSplineSurface& face : surface.faces(lines)) check_face(face);
  const Certificate certificate = surface.certificate(lines);
  require(is_finite(certificate.deviation) && certificate.deviation >= 0,
          "The bound on the deviation is finite.");
  require(is_finite(certificate.trim_deviation) && certificate.trim_deviation >= 0,
          "The measured deviation of the trims is finite.");
  require(certificate.poles > 0, "There are faces.");
}

}  // namespace

void require(bool promise, const char* sentence) {
  if (promise) return;
  std::fprintf(stderr, "Not kept: %s\n", sentence);
  std::abort();
}

int expect_result_or_error(const std::function<void()>& work) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  Cancellation cancellation;
  std::promise<void> end;
  const auto watch = std::async(std::launch::async, [&, ended = end.get_future()] {
    if (ended.wait_for(kPatience) == std::future_status::timeout) cancellation.request();
  });
  try {
    cancellation.run(work);
  } catch (const GeometryError& error) {
    require(*error.what() != '\0', "An error has a sentence.");
  } catch (const Cancelled&) {
    std::fprintf(stderr, "Asked to stop.\n");
  }
  end.set_value();
  return 0;
}

void check_surface(const PNSurface& surface, FuzzInput& input) {
  const Lines lines = input.flag() ? Lines::kLowestDegree : Lines::kEven;
  check_section(surface, lines);
  if (surface.has_offsets()) {
    if (input.flag()) check_section(surface.offset(input.number()), lines);
    if (input.choice(4) == 3) {
      const OffsetRange range = surface.regular_range();
      require(!std::isnan(range.lower) && !std::isnan(range.upper), "Limits are numbers.");
    }
  }
  if (input.choice(8) == 7) {
    const auto crossing = surface.self_intersection();
    require(!crossing || is_finite(crossing->point), "A crossing is a point.");
  }
}

}  // namespace pn::fuzz

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/bezier/pn_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>

#include "pn/algebra/precision.hpp"
#include "pn/bezier/chain_source.hpp"
#include "pn/bezier/evaluation.hpp"
#include "pn/geometry_error.hpp"
#include "pn/input_numbers.hpp"

namespace pn {
namespace {

std::size_t index_of(Lines lines) { return lines == Lines::kEven ? 0 : 1; }

/// Normals are unit vectors but for rounding, except where offsets are not rational.
std::array<double, 3> unit(const std::array<double, 3>& normal) {
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  return {normal[0] / length, normal[1] / length, normal[2] / length};
}

/// A net and the edges of its faces, which hold for all its sections.
struct TrimmedNet {
  std::shared_ptr<const SectionNet> net;
  std::vector<TrimmedFace> faces;
};

}  // namespace

/// What all offsets have in common.
struct PNSurface::Shared {
  explicit Shared(std::shared_ptr<const SectionSource> section_source)
      : source(std::move(section_source)) {}

  const std::shared_ptr<const SectionSource> source;
  std::mutex mutex;
  std::array<std::map<long, TrimmedNet>, 2> nets;  ///< by their precision
  std::optional<OffsetRange> range;

  /// The net at this precision, or at the least that suffices to make one. A finer net that another
  /// distance needed is not taken: a section does not depend on what was asked for before.
  const TrimmedNet& net(Lines lines, long precision) {
    const std::lock_guard<std::mutex> lock(mutex);
    std::map<long, TrimmedNet>& known = nets[index_of(lines)];
    if (!known.empty()) precision = std::max(precision, known.begin()->first);
    const auto found = known.find(precision);
    if (found != known.end()) return found->second;
    const TrimmableNet made = source->net(lines, precision);
    return known.emplace(precision, TrimmedNet{made.net, made.trimmed_faces()}).first->second;
  }
};

struct PNSurface::Section {
  std::vector<RoundedFace> faces;        ///< of the net, whole
  std::vector<BSplineSurface> exported;  ///< trimmed
  std::vector<std::size_t> net_faces;    ///< of which these are parts
  double trim_deviation;
  std::shared_ptr<const SectionNet> net;

  /// The last face that begins at or before parameters t along and v around.
  std::size_t face_at(double t, double v) const {
    std::size_t found = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const BSplineSurface& surface = faces[i].surface;
      const bool begun = i == 0 || (surface.u_knots.front() <= t && surface.v_knots.front() <= v);
      if (begun && !net->faces()[i].stands_still) found = i;
    }
    return found;
  }
};

PNSurface::PNSurface(EnvelopeChain chain)
    : PNSurface(std::make_shared<const ChainSource>(std::move(chain))) {}

PNSurface::PNSurface(std::shared_ptr<const SectionSource> source)
    : shared_(std::make_shared<Shared>(std::move(source))),
      sections_(std::make_shared<std::array<std::shared_ptr<const Section>, 2>>()) {}

PNSurface PNSurface::offset(double d) const {
  require_input_number(distance_ + d, "The distance");
  if (distance_ + d != 0 && !has_offsets()) {
    throw GeometryError(ErrorCode::kNotRational,
                        "The offsets of this surface are not rational; only the surface at "
                        "distance zero is.");
  }
  PNSurface result = *this;
  result.sections_ = std::make_shared<std::array<std::shared_ptr<const Section>, 2>>();
  result.distance_ = distance_ + d;
  return result;
}

bool PNSurface::has_offsets() const { return shared_->source->has_offsets(); }

std::array<int, 2> PNSurface::degree() const { return shared_->source->degree(); }

OffsetRange PNSurface::regular_range() const {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  if (!shared_->range) shared_->range = shared_->source->regular_range();
  return *shared_->range;
}

std::shared_ptr<const PNSurface::Section> PNSurface::section(Lines lines) const {
  std::shared_ptr<const Section>& slot = (*sections_)[index_of(lines)];
  if (const auto known = std::atomic_load(&slot)) return known;
  const auto rounded = at_sufficient_precision([&](long precision) {
    const TrimmedNet& trimmed = shared_->net(lines, precision);
    Section section{trimmed.net->section(distance_), {}, {}, 0, trimmed.net};
    for (const TrimmedFace& face : trimmed.faces) {
      BSplineSurface surface = section.faces[face.net_face].surface;
      section.trim_deviation = std::max(section.trim_deviation, trim_deviation(surface, face));
      surface.trims = curves_of(face);
      section.exported.push_back(std::move(surface));
      section.net_faces.push_back(face.net_face);
    }
    return std::make_shared<const Section>(std::move(section));
  });
  std::atomic_store(&slot, rounded);
  return rounded;
}

std::vector<BSplineSurface> PNSurface::faces(Lines lines) const { return section(lines)->exported; }

Certificate PNSurface::certificate(Lines lines) const {
  const auto rounded = section(lines);
  const SectionSource& source = *shared_->source;
  Certificate certificate{0,
                          rounded->net->precision(),
                          source.is_exact(),
                          {0, 0},
                          0,
                          source.notes(),
                          rounded->trim_deviation};
  for (const RoundedFace& face : rounded->faces) {
    certificate.deviation = std::max(certificate.deviation, face.deviation);
  }
  for (const BSplineSurface& face : rounded->exported) {
    certificate.bidegree[0] = std::max(certificate.bidegree[0], face.u_degree);
    certificate.bidegree[1] = std::max(certificate.bidegree[1], face.v_degree);
    certificate.poles += face.poles.size();
  }
  return certificate;
}

std::optional<SelfIntersection> PNSurface::self_intersection() const {
  const auto rounded = section(Lines::kEven);
  const std::vector<BSplineSurface> normals = rounded->net->normals();
  std::vector<SectionFace> faces;
  for (std::size_t i = 0; i < rounded->exported.size(); ++i) {
    const std::size_t net_face = rounded->net_faces[i];
    faces.push_back({&rounded->exported[i], has_offsets() ? &normals[net_face] : nullptr,
                     rounded->net->faces()[net_face].stands_still});
  }
  return pn::self_intersection(faces);
}

std::vector<SurfacePoint> PNSurface::evaluate(const std::vector<double>& t,
                                              const std::vector<double>& v) const {
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(t.begin(), t.end(), is_finite) || !std::all_of(v.begin(), v.end(), is_finite)) {
    throw GeometryError(ErrorCode::kNotFinite, "A parameter is not a finite number.");
  }
  const auto rounded = section(Lines::kEven);
  const std::vector<BSplineSurface> normals = rounded->net->normals();
  const bool is_rational = rounded->net->has_normals();
  std::vector<SurfaceEvaluation> points_of, normals_of;
  for (const RoundedFace& face : rounded->faces) points_of.emplace_back(face.surface);
  for (const BSplineSurface& face : normals) normals_of.emplace_back(face);
  std::vector<SurfacePoint> result;
  result.reserve(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    const std::size_t face = rounded->face_at(t[i], v[i]);
    const auto normal =
        is_rational ? normals_of[face](t[i], v[i]) : points_of[face].normal(t[i], v[i]);
    result.push_back({points_of[face](t[i], v[i]), unit(normal)});
  }
  return result;
}

}  // namespace pn

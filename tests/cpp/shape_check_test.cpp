// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/occt/shape_check.hpp"

#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <catch2/catch.hpp>

#include "pn/occt/shell.hpp"
#include "surfaces_of_revolution.hpp"

using pn::boolean_faults;
using pn::faults;
using pn::make_shell;

namespace {

bool mention(const std::vector<std::string>& sentences, const std::string& word) {
  for (const std::string& sentence : sentences) {
    if (sentence.find(word) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("A valid shell has no fault") {
  const TopoDS_Shell shell = make_shell(pn::test::three_tubes());
  CHECK(faults(shell).empty());
  CHECK(boolean_faults(shell).empty());
}

TEST_CASE("A vertex away from its edges is named") {
  const TopoDS_Shell shell = make_shell({pn::test::tube(2, 0, 2, 5)});
  const TopExp_Explorer vertex(shell, TopAbs_VERTEX);
  BRep_Builder().UpdateVertex(TopoDS::Vertex(vertex.Current()), gp_Pnt(9, 9, 9), 1e-7);
  CHECK(mention(faults(shell), "Vertex1 in Edge"));
  CHECK(mention(faults(shell), "InvalidPointOnCurve."));
}

TEST_CASE("Knots of C0 multiplicity are a fault for Boolean operations only") {
  const auto circle = pn::test::quadratic_circle();
  const TopoDS_Shell shell =
      make_shell({pn::test::revolve(pn::test::scaled(circle, 2, 5), circle)});
  CHECK(faults(shell).empty());
  CHECK(mention(boolean_faults(shell), "Face1: the geometry is only C0."));
}

TEST_CASE("Two faces that cross intersect each other") {
  // The second tube turns back and dives through the first.
  const TopoDS_Shell shell = make_shell(
      {pn::test::tube(2, 0, 2, 5), pn::test::tube(2, 5, 1, 6), pn::test::tube(1, 6, 3, 2)});
  CHECK(faults(shell).empty());
  CHECK(mention(boolean_faults(shell), "intersects itself."));
}

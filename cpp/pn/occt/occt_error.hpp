// SPDX-License-Identifier: LGPL-2.1-or-later
// OpenCASCADE's failures as C++ exceptions: a Standard_Failure is not a std::exception.
#pragma once

#include <Standard_Failure.hxx>
#include <stdexcept>
#include <string>

namespace pn {

/// A failure inside OpenCASCADE, with the kind of failure and OpenCASCADE's own message.
class OcctError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The result of `work()`; a failure of OpenCASCADE leaves as an OcctError.
template <class Work>
auto with_occt_errors(const Work& work) {
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    throw OcctError(std::string(failure.DynamicType()->Name()) + ": " + failure.GetMessageString());
  }
}

}  // namespace pn

// SPDX-License-Identifier: LGPL-2.1-or-later
// The memory of this process, as Linux and glibc count it.
#pragma once

#include <cstddef>

namespace pn::bench {

/// Bytes that are allocated and not freed.
std::size_t allocated_bytes();

/// Bytes of resident memory above what was resident at the start, at the peak since then.
class PeakMemory {
 public:
  /// Starts. Throws std::runtime_error where the kernel does not let a process reset its peak.
  PeakMemory();
  std::size_t bytes() const;

 private:
  std::size_t at_start_;
};

}  // namespace pn::bench

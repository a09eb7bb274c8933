// SPDX-License-Identifier: LGPL-2.1-or-later
#include "memory.hpp"

#include <malloc.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace pn::bench {
namespace {

/// A line such as "VmHWM:   5120 kB" of the status of this process, in bytes.
std::size_t status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == name + ":" && status >> kilobytes) return kilobytes * 1024;
  }
  throw std::runtime_error("/proc/self/status has no " + name);
}

}  // namespace

std::size_t allocated_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

PeakMemory::PeakMemory() {
  malloc_trim(0);  // What earlier work left behind would hide what the next one needs.
  std::ofstream clear_refs("/proc/self/clear_refs");
  clear_refs << 5 << std::flush;  // 5 sets the peak back to what is resident now, proc(5).
  if (!clear_refs) throw std::runtime_error("The peak of resident memory cannot be reset.");
  at_start_ = status_bytes("VmRSS");
}

std::size_t PeakMemory::bytes() const {
  const std::size_t peak = status_bytes("VmHWM");
  return peak > at_start_ ? peak - at_start_ : 0;
}

}  // namespace pn::bench

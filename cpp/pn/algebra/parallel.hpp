// SPDX-License-Identifier: LGPL-2.1-or-later
// Independent work on several threads, with results and errors as if done in order.
#pragma once

#include <tbb/parallel_for.h>

#include <cstddef>
#include <exception>
#include <vector>

namespace pn {

/// work(i) for i = 0 .. count - 1, on as many threads as there are. When some of them throw, the
/// exception of the least i is thrown, whatever the threads did first.
template <class Work>
void for_each_index(std::size_t count, Work&& work) {
  if (count == 1) return work(std::size_t{0});
  std::vector<std::exception_ptr> errors(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    try {
      work(i);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  });
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace pn

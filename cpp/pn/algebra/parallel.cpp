// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pn/algebra/parallel.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <utility>

#include "pn/algebra/cancellation.hpp"

#if defined(PN_THREAD_SANITIZER)
#include <sanitizer/tsan_interface.h>
#endif

namespace pn {
namespace {

// The error of the least index. Only that one is kept: when memory runs out every piece of work
// throws, and the C++ runtime ends the process when more exceptions live than its reserve holds.
class LeastError {
 public:
  bool is_before(std::size_t i) const { return index_ < i; }

  void take(std::size_t i, std::exception_ptr error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (i >= index_) return;
    index_ = i;
    error_ = std::move(error);
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::atomic<std::size_t> index_{std::numeric_limits<std::size_t>::max()};
  std::exception_ptr error_;
};

// What happens before `reach` is seen by whoever has called `pass` after it. TBB keeps this
// promise at the beginning and at the end of a loop, but as Debian's library is not instrumented,
// the thread sanitizer has to be told.
class Moment {
 public:
#if defined(PN_THREAD_SANITIZER)
  void reach() { __tsan_release(this); }
  void pass() { __tsan_acquire(this); }
#else
  void reach() {}
  void pass() {}
#endif
};

}  // namespace

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work) {
  stop_if_cancelled();
  if (count == 1) return work(0);
  LeastError error;
  // Two moments: with one, the end of an index would come before the beginning of the next one, and
  // hide that both write to the same place.
  Moment beginning, end;
  const auto guarded = [&](std::size_t i) {
    beginning.pass();
    if (error.is_before(i)) return;
    try {
      work(i);
    } catch (...) {
      error.take(i, std::current_exception());
    }
    end.reach();
  };
  beginning.reach();
  // Isolated, so that a thread that waits here does not take up foreign work, perhaps under a lock.
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, count, guarded); });
  end.pass();
  stop_if_cancelled();
  error.rethrow();
}

void for_each_index_in_blocks(std::size_t count, std::size_t block,
                              const std::function<void(std::size_t)>& work) {
  for_each_index((count + block - 1) / block, [&](std::size_t b) {
    for (std::size_t i = b * block; i < std::min(count, (b + 1) * block); ++i) work(i);
  });
}

}  // namespace pn

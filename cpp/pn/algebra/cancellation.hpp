// SPDX-License-Identifier: LGPL-2.1-or-later
// Cancellation: work that another thread can ask to stop.
//
// TBB hands a request down to all parallel loops inside. Whatever runs in order asks between its
// steps with `stop_if_cancelled`; every for_each_index (parallel.hpp) does. Nothing is left half
// done: an exception leaves the work, and what it was making was never seen.
#pragma once

#include <tbb/task_group.h>

#include <exception>
#include <utility>

namespace pn {

/// Thrown out of work that was asked to stop.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "The computation was cancelled."; }
};

/// To be called between the steps of long work.
inline void stop_if_cancelled() {
  if (tbb::is_current_task_group_canceling()) throw Cancelled();
}

/// One request to stop; may be made from any thread, before the work or during it.
class Cancellation {
 public:
  void request() { context_.cancel_group_execution(); }
  bool is_requested() { return context_.is_group_execution_cancelled(); }

  /// Does the work in this thread. Throws Cancelled after a request, otherwise what it throws.
  template <class Work>
  void run(Work&& work) {
    std::exception_ptr error;
    tbb::task_group group(context_);
    // An exception that TBB sees would count as a request.
    const auto guarded = [&] {
      try {
        work();
      } catch (...) {
        error = std::current_exception();
      }
    };
    const bool is_complete = group.run_and_wait(guarded) == tbb::complete;
    if (!is_complete) throw Cancelled();
    if (error) std::rethrow_exception(error);
  }

 private:
  // A bound context would take over the state of the work around and forget an earlier request.
  tbb::task_group_context context_{tbb::task_group_context::isolated};
};

}  // namespace pn

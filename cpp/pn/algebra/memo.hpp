// SPDX-License-Identifier: LGPL-2.1-or-later
// Memos: the values of a function without side effects, each found once. For constants of the
// method of which few are ever asked for; they are kept as long as the memo.
#pragma once

#include <map>
#include <mutex>

namespace pn {

/// May be asked from several threads.
template <class Argument, class Value>
class Memo {
 public:
  /// The value for an argument, by compute() where it is not known yet.
  template <class Compute>
  const Value& operator()(const Argument& argument, Compute&& compute) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto known = values_.find(argument);
    return known != values_.end() ? known->second
                                  : values_.emplace(argument, compute()).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<Argument, Value> values_;
};

}  // namespace pn

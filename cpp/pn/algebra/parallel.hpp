// SPDX-License-Identifier: LGPL-2.1-or-later
// Independent work on several threads, with results and errors as if done in order.
#pragma once

#include <cstddef>
#include <functional>

namespace pn {

/// work(i) for i = 0 .. count - 1, on as many threads as there are. When some of them throw, the
/// exception of the least i is thrown, whatever the threads did first; work after it may be left
/// out. Throws Cancelled when the work around was asked to stop.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work);

/// The same for work so small that it takes `block` of it to be worth another thread.
void for_each_index_in_blocks(std::size_t count, std::size_t block,
                              const std::function<void(std::size_t)>& work);

}  // namespace pn

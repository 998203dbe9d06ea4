// Threads that the host lends: for programs that have a pool of their own and want no other.
#pragma once

#include <functional>

namespace glint {

/// Hands a task over to the host, which calls it once: on any thread, at once or later, also within this very call,
/// also after the work it was meant for is over, or never. Tasks block on nothing but the host's own scheduling, may
/// run at the same time, and throw nothing.
///
/// Whoever brings work (a render, a tree to be built) hands out one task for each further thread and then works
/// himself. At the end he waits only for tasks that have begun; one that begins later finds nothing to do, and touches
/// nothing of what it was meant for. So no order of running them can come to a deadlock, and a host that runs none gets
/// the same picture from the calling thread alone. With a hook set, the library starts no thread.
///
/// The hook is called from whichever thread brings work, from several at once where several do. What it throws counts
/// as a task that never begins. Copies of it live as long as what it was given to, and of a task until it has run.
///
///     options.submit = [&pool](std::function<void()> task) { pool.enqueue(std::move(task)); };
using SubmitTask = std::function<void(std::function<void()> task)>;

} // namespace glint

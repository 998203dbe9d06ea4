// Who works on a loop: threads of the library's own, or the host's.
#pragma once

#include <glint/host_threads.hpp>

namespace glint {

/// So many threads, the calling one included. Points to the host's hook, which must outlive it.
struct Crew {
    unsigned threads = 1;
    const SubmitTask *host = nullptr; ///< nullptr = threads of the library's own

    Crew(unsigned threads_) : threads(threads_) {}
    /// As options say it: 0 threads = one a processor, an empty hook = threads of the library's own.
    Crew(unsigned threads_, const SubmitTask &submit);
};

} // namespace glint

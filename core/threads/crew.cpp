// Who works on a loop: threads of the library's own, or the host's.
#include "threads/crew.hpp"

#include <algorithm>
#include <thread>

namespace glint {

Crew::Crew(unsigned threads_, const SubmitTask &submit)
    : threads(threads_ > 0 ? threads_ : std::max(1u, std::thread::hardware_concurrency())),
      host(submit ? &submit : nullptr) {}

} // namespace glint

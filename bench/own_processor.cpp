// Keeping threads apart by sched_setaffinity.
#include "bench/own_processor.hpp"

namespace glint::bench {

OwnProcessor::OwnProcessor() {
    CPU_ZERO(&all_);
    if (::sched_getaffinity(0, sizeof all_, &all_) != 0) CPU_ZERO(&all_);
    own_ = others_ = all_;
    if (CPU_COUNT(&all_) < 2) return;
    CPU_ZERO(&own_);
    int first = 0;
    while (!CPU_ISSET(first, &all_)) ++first;
    CPU_SET(first, &own_);
    CPU_CLR(first, &others_);
    move_to(own_);
}

OwnProcessor::~OwnProcessor() {
    move_to(all_);
}

void OwnProcessor::move_to(const cpu_set_t &set) {
    if (CPU_COUNT(&set) > 0) ::sched_setaffinity(0, sizeof set, &set);
}

} // namespace glint::bench

// The machine that a measurement was taken on.
#include "bench/machine.hpp"

#include <fstream>
#include <string_view>
#include <thread>

#include <sched.h>
#include <sys/utsname.h>

#include <glint/version.hpp>

namespace glint::bench {
namespace {

/// The value of the first line `key separator value` of a text file; empty when there is none.
std::string find_value(const char *file, std::string_view key, char separator) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with(key)) continue;
        const size_t split = line.find(separator);
        if (split == std::string::npos) continue;
        const size_t first = line.find_first_not_of(" \t\"", split + 1);
        const size_t last = line.find_last_not_of(" \t\"");
        if (first != std::string::npos && first <= last) return line.substr(first, last - first + 1);
    }
    return {};
}

unsigned usable_processors() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (::sched_getaffinity(0, sizeof set, &set) == 0) return static_cast<unsigned>(CPU_COUNT(&set));
    return std::thread::hardware_concurrency();
}

} // namespace

Machine describe_machine() {
    Machine machine;
    utsname system{};
    if (::uname(&system) == 0) {
        machine.kernel = std::string(system.sysname) + ' ' + system.release + ' ' + system.machine;
    }
    machine.cpu = find_value("/proc/cpuinfo", "model name", ':');
    if (machine.cpu.empty()) machine.cpu = find_value("/proc/cpuinfo", "Hardware", ':'); // ARM kernels
    if (machine.cpu.empty()) machine.cpu = system.machine;
    machine.processors = usable_processors();
    machine.os = find_value("/etc/os-release", "PRETTY_NAME", '=');
    const BuildInfo build = build_info();
    machine.compiler = build.compiler;
    machine.glint = build.version;
    return machine;
}

} // namespace glint::bench

// Pieces that several JSON reports share.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "bench/machine.hpp"
#include "bench/statistics.hpp"

namespace glint::bench {

using Json = nlohmann::ordered_json;

[[nodiscard]] inline Json to_json(const Summary &summary) {
    return {{"median", summary.median}, {"min", summary.min}, {"p95", summary.p95}};
}

[[nodiscard]] inline Json to_json(const Machine &machine) {
    return {{"cpu", machine.cpu},       {"processors", machine.processors}, {"os", machine.os},
            {"kernel", machine.kernel}, {"compiler", machine.compiler},     {"glint", machine.glint}};
}

/// The report's text. A file name need not be UTF-8; JSON text must be.
[[nodiscard]] inline std::string json_text(const Json &report) {
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace glint::bench

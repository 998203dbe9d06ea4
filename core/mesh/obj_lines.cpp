// An OBJ file's lines, joined where a backslash says that they go on.
#include "mesh/obj_lines.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace glint {

namespace {

char *find(char *begin, char *end, char wanted) {
    auto *found = static_cast<char *>(std::memchr(begin, wanted, static_cast<size_t>(end - begin)));
    return found ? found : end;
}

} // namespace

bool ObjLines::next() {
    if (next_ == text_end_) return false;
    line_ += static_cast<uint32_t>(physical_begins_.size());
    physical_begins_.clear();
    begin_ = next_;
    bool goes_on = true;
    while (goes_on) {
        char *const physical = next_;
        physical_begins_.push_back(physical);
        end_ = find(physical, find(physical, text_end_, '\n'), '\r');
        next_ = end_;
        if (next_ != text_end_ && *next_ == '\r') ++next_;
        if (next_ != text_end_ && *next_ == '\n') ++next_;
        goes_on = end_ != physical && end_[-1] == '\\' && next_ != text_end_ && find(physical, end_, '#') == end_;
    }
    return true;
}

void ObjLines::join() {
    if (end_ != begin_ && end_[-1] == '\\') end_[-1] = ' '; // a last line that promises another
    for (size_t i = 1; i < physical_begins_.size(); ++i) {
        char *at = physical_begins_[i] - 1;
        while (*at == '\n' || *at == '\r') *at-- = ' ';
        *at = ' '; // the backslash
    }
}

Place ObjLines::place(const char *at) const {
    const auto behind_at = std::upper_bound(physical_begins_.begin() + 1, physical_begins_.end(), at);
    const auto i = static_cast<size_t>(behind_at - physical_begins_.begin()) - 1;
    const char *const first = physical_begins_[i];
    const char *const behind = i + 1 < physical_begins_.size() ? physical_begins_[i + 1] : end_;
    std::string_view source(first, static_cast<size_t>(behind - first));
    while (!source.empty() && (source.back() == '\n' || source.back() == '\r')) source.remove_suffix(1);
    return {line_ + static_cast<uint32_t>(i), static_cast<uint32_t>(at - first) + 1, source};
}

} // namespace glint

// What Java holds instead of pointers: numbers that are never used twice, so that one that is closed says so.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include <jni.h>

namespace glint::android {

/// Java calls with a handle that was closed, or is none.
struct ClosedHandle {};

/// Objects of all kinds that are open. Theirs is the only state that this library has.
inline std::atomic<jint> &open_handles() {
    static std::atomic<jint> count{0};
    return count;
}

/// The objects of one kind that Java holds. A call that is under way keeps its object, whoever closes it meanwhile. Any
/// thread may call.
template <typename T> class Handles {
public:
    static Handles &all() {
        static Handles handles;
        return handles;
    }

    [[nodiscard]] jlong open(std::shared_ptr<T> object) {
        const std::lock_guard lock(mutex_);
        objects_.emplace(++last_, std::move(object));
        ++open_handles();
        return last_;
    }

    /// Throws ClosedHandle.
    [[nodiscard]] std::shared_ptr<T> at(jlong handle) {
        const std::lock_guard lock(mutex_);
        const auto found = objects_.find(handle);
        if (found == objects_.end()) throw ClosedHandle();
        return found->second;
    }

    /// What was open; nullptr where it is closed already. It goes when no call uses it any more.
    std::shared_ptr<T> close(jlong handle) {
        const std::lock_guard lock(mutex_);
        const auto found = objects_.find(handle);
        if (found == objects_.end()) return nullptr;
        std::shared_ptr<T> object = std::move(found->second);
        objects_.erase(found);
        --open_handles();
        return object;
    }

private:
    std::mutex mutex_;
    std::map<jlong, std::shared_ptr<T>> objects_;
    jlong last_ = 0;
};

} // namespace glint::android

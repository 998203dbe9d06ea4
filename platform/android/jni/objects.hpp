// The C++ objects behind the handles of the Java classes.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <glint/accel.hpp>
#include <glint/framebuffer.hpp>
#include <glint/render_job.hpp>
#include <glint/renderer.hpp>
#include <glint/scene.hpp>

#include "android/jni/java.hpp"

namespace glint::android {

/// GlintScene's.
struct SceneObject {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Accel> accel;
    std::vector<std::string> warnings;
};

/// GlintRenderer's.
struct RendererObject {
    explicit RendererObject(std::shared_ptr<const Accel> accel, const RendererOptions &options)
        : renderer(std::move(accel), options) {}
    Renderer renderer;
};

/// GlintJob's. Members go in reverse order: the job ends before what it uses.
struct JobObject {
    JobObject(std::shared_ptr<RendererObject> renderer_, JNIEnv *env, jobject memory_, Framebuffer target_)
        : renderer(std::move(renderer_)), memory(env, memory_), target(std::move(target_)) {}
    std::shared_ptr<RendererObject> renderer;
    GlobalRef memory; // that the target lies in
    Framebuffer target;
    std::mutex waiting; // one thread waits at a time
    std::optional<RenderJob> job;
};

} // namespace glint::android

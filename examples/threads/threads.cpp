// Renders on the program's own threads, so that Glint starts none: threads SCENE PICTURE
#include <condition_variable>
#include <cstdio>
#include <functional>
#include <mutex>
#include <queue>
#include <thread>
#include <vector>

#include <glint/glint.hpp>
#include <glint/imageio.hpp>

namespace {

/// Any pool will do: this one has a queue, and threads that take from it.
class Pool {
public:
    explicit Pool(unsigned threads) {
        for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    }
    ~Pool() {
        enqueue({}); // each thread hands the end on to the next
        for (std::thread &thread : threads_) thread.join();
    }
    Pool(const Pool &) = delete;
    Pool &operator=(const Pool &) = delete;

    void enqueue(std::function<void()> task) {
        const std::lock_guard lock(mutex_);
        tasks_.push(std::move(task));
        changed_.notify_one();
    }

private:
    void work() {
        while (const std::function<void()> task = next()) task();
        enqueue({});
    }
    std::function<void()> next() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !tasks_.empty(); });
        std::function<void()> task = std::move(tasks_.front());
        tasks_.pop();
        return task;
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::queue<std::function<void()>> tasks_;
    std::vector<std::thread> threads_;
};

int fail(const glint::Error &error) {
    std::puts(error.text().c_str());
    return 1;
}

} // namespace

int main(int, char **arguments) {
    Pool pool(3);
    const glint::SubmitTask submit = [&pool](std::function<void()> task) { pool.enqueue(std::move(task)); };

    const auto file = glint::read_scene(arguments[1]);
    if (!file) return fail(file.error());
    const auto accel = glint::Accel::build(file->scene, {.submit = submit});
    glint::Renderer renderer(accel, {.threads = 4, .submit = submit}); // this thread, too
    auto picture = glint::Framebuffer::create(512, 512);
    if (!picture) return fail(picture.error());
    if (const auto rendered = renderer.render(*picture); !rendered) return fail(rendered.error());
    if (const auto written = glint::write_image(arguments[2], *picture); !written) return fail(written.error());
}

// Presenters that are made anew when their context is.
#include <glint/gles/reliable_presenter.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "gles/gl.hpp"

namespace glint::gles {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

} // namespace

struct ReliablePresenter::Impl {
    explicit Impl(ContextSource context_) : context(std::move(context_)) {}

    Status make_current();
    Status prepare(size_t layer_count);
    Result<ShowTimes> show(std::span<const Layer> layers, const ShowOptions &options);
    Status upload(std::span<const Layer> layers);
    Status draw(std::span<const Layer> layers);
    [[nodiscard]] bool is_lost() const;
    void give_up();

    /// What shows one layer, and which of its versions.
    struct LayerPresenter {
        std::unique_ptr<Presenter> presenter;
        uint64_t version = 0;
    };

    ContextSource context;
    ProcLoader load;
    std::optional<Gl> gl; // of the context in use; nothing until there is one
    std::vector<LayerPresenter> presenters;
    bool unreachable = false; // could not be made current
    bool lost = false;        // the next context must be a new one
    uint64_t losses = 0;
};

/// The old names mean nothing any more, and to no new context.
void ReliablePresenter::Impl::give_up() {
    for (LayerPresenter &layer : presenters) layer.presenter->abandon();
    presenters.clear();
    gl.reset();
    load = nullptr;
    losses += lost ? 0 : 1;
    lost = true;
}

Status ReliablePresenter::Impl::make_current() {
    Result<ProcLoader> loader = context(lost);
    unreachable = !loader;
    if (!loader) return std::move(loader).error();
    lost = false;
    if (gl) return Done{};
    Result<Gl> loaded = Gl::load(*loader);
    lost = !loaded; // of no use: the next call shall not get the same again
    if (!loaded) return std::move(loaded).error();
    gl = std::move(loaded).value();
    load = std::move(loader).value();
    return Done{};
}

bool ReliablePresenter::Impl::is_lost() const {
    if (!gl) return false; // there was none to lose
    const auto says_so = [](const LayerPresenter &layer) { return layer.presenter->context_lost(); };
    return unreachable || gl->is_lost() || std::any_of(presenters.begin(), presenters.end(), says_so);
}

Status ReliablePresenter::Impl::prepare(size_t layer_count) {
    while (presenters.size() < layer_count) {
        Result<std::unique_ptr<Presenter>> presenter = Presenter::create(load);
        if (!presenter) return std::move(presenter).error();
        presenters.push_back({std::move(presenter).value(), 0});
    }
    return Done{};
}

Status ReliablePresenter::Impl::upload(std::span<const Layer> layers) {
    for (size_t i = 0; i < layers.size(); ++i) {
        LayerPresenter &shown = presenters[i];
        if (layers[i].version != 0 && layers[i].version == shown.version) continue;
        shown.version = 0;
        if (Status status = shown.presenter->upload(layers[i].picture); !status) return status;
        shown.version = layers[i].version;
    }
    return Done{};
}

Status ReliablePresenter::Impl::draw(std::span<const Layer> layers) {
    for (size_t i = 0; i < layers.size(); ++i) {
        const Layer &layer = layers[i];
        const Status status =
            presenters[i].presenter->draw(layer.x, layer.y, layer.width_px, layer.height_px, layer.how);
        if (!status) return status;
    }
    return Done{};
}

Result<ShowTimes> ReliablePresenter::Impl::show(std::span<const Layer> layers, const ShowOptions &options) {
    if (Status status = make_current(); !status) return std::move(status).error();
    if (Status status = prepare(layers.size()); !status) return std::move(status).error();
    const Clock::time_point start = Clock::now();
    if (Status status = upload(layers); !status) return std::move(status).error();
    if (options.finish) gl->finish();
    const Clock::time_point uploaded = Clock::now();
    if (Status status = draw(layers); !status) return std::move(status).error();
    if (options.finish) gl->finish();
    return ShowTimes{seconds_between(start, uploaded), seconds_between(uploaded, Clock::now())};
}

ReliablePresenter::ReliablePresenter(ContextSource context) : impl_(std::make_unique<Impl>(std::move(context))) {}

ReliablePresenter::~ReliablePresenter() {
    if (impl_->gl && !impl_->context(/*lost=*/false)) impl_->give_up();
}

Result<ShowTimes> ReliablePresenter::show(std::span<const Layer> layers, const ShowOptions &options) {
    for (const bool first : {true, false}) {
        Result<ShowTimes> times = impl_->show(layers, options);
        // Some drivers take every call of a lost context without an error and draw nothing.
        if (!impl_->is_lost()) return times;
        impl_->give_up();
        if (!first && !times) return times;
    }
    return Error(ErrorCode::unsupported, "the OpenGL context was lost twice while one frame was drawn");
}

void ReliablePresenter::context_was_lost() {
    impl_->give_up();
}

uint64_t ReliablePresenter::losses() const {
    return impl_->losses;
}

} // namespace glint::gles

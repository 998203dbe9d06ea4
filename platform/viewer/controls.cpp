// What input means: which events move the camera, and which change how the picture is made.
#include "viewer/controls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glint::viewer {

namespace {

/// A press that moves no further is a click.
constexpr double click_px = 3.0;
/// A notch of the wheel brings the place under the cursor so much nearer.
constexpr double factor_per_notch = 0.85;
/// Scene radii a second, and how much faster with Shift.
constexpr double flight_speed = 0.5, shift_factor = 4.0;
constexpr unsigned most_threads = 1024;

constexpr HudKey help[] = {
    {"left drag", "orbit"},
    {"right drag, two fingers", "pan"},
    {"wheel, pinch", "zoom to the cursor"},
    {"W A S D Q E", "fly; with Shift faster"},
    {"R", "back to the scene's camera"},
    {"F", "frame the scene"},
    {"0 - 9", "depth of recursion"},
    {"+ -", "threads"},
    {"Space", "pause"},
    {"P", "save a screenshot"},
    {"click", "a pixel's rays; up, down scroll"},
    {"Tab", "figures"},
    {"H", "this help"},
    {"Esc", "quit"},
};

uint64_t bit_of(Key key) {
    return uint64_t{1} << static_cast<unsigned>(key);
}

} // namespace

std::span<const HudKey> help_lines() {
    return help;
}

Controls::Controls(CameraControl &camera, ViewChoices choices, DistanceAt distance_at, uint32_t width_px,
                   uint32_t height_px)
    : camera_(camera),
      choices_(std::move(choices)),
      distance_at_(std::move(distance_at)),
      width_px_(width_px),
      height_px_(height_px),
      cursor_x_(0.5 * width_px),
      cursor_y_(0.5 * height_px) {}

void Controls::moved(bool by_hand) {
    ++moves_;
    has_moved_camera_ = by_hand;
    choices_.inspected.reset(); // it belonged to the picture before
}

void Controls::handle(const InputEvent &event) {
    using Kind = InputEvent::Kind;
    switch (event.kind) {
    case Kind::button_down:
        begin_drag(event);
        break;
    case Kind::button_up:
        if (drag_ && drag_->button == event.button) {
            drag_to(event.x, event.y);
            end_drag();
        }
        break;
    case Kind::move:
        drag_to(event.x, event.y);
        break;
    case Kind::wheel:
        zoom(event.x, event.y, event.amount);
        break;
    case Kind::finger_down:
    case Kind::finger_move:
    case Kind::finger_up:
        touch(touch_.handle(event));
        break;
    case Kind::key_down:
        held_ |= bit_of(event.key);
        press(event.key);
        break;
    case Kind::key_up:
        held_ &= ~bit_of(event.key);
        break;
    case Kind::resize:
        width_px_ = event.width_px;
        height_px_ = event.height_px;
        camera_.resize(event.width_px, event.height_px);
        moved(has_moved_camera_);
        break;
    case Kind::close:
        choices_.closes = true;
        break;
    case Kind::redraw:
    case Kind::context_lost:
        break;
    }
}

void Controls::begin_drag(const InputEvent &event) {
    if (drag_) return; // the first button counts
    drag_ = Drag{event.button, event.x, event.y, event.x, event.y, true, std::nullopt};
    if (event.button != Button::left) drag_->distance = distance_at_(event.x / width_px_, event.y / height_px_);
}

void Controls::drag_to(double x, double y) {
    cursor_x_ = x;
    cursor_y_ = y;
    if (!drag_) return;
    if (drag_->is_click) {
        if (std::hypot(x - drag_->start_x, y - drag_->start_y) <= click_px) return;
        drag_->is_click = false;
    }
    const double from_x = std::exchange(drag_->x, x), from_y = std::exchange(drag_->y, y);
    if (from_x == x && from_y == y) return;
    if (drag_->button == Button::left) {
        camera_.orbit({(x - from_x) / width_px_, (y - from_y) / height_px_});
    } else {
        camera_.pan({from_x / width_px_, from_y / height_px_}, {x / width_px_, y / height_px_}, drag_->distance);
    }
    moved();
}

void Controls::end_drag() {
    const Drag drag = *std::exchange(drag_, std::nullopt);
    if (!drag.is_click || drag.button != Button::left) return;
    const auto pixel = [](double at, double size) { return static_cast<uint32_t>(std::clamp(at, 0.0, size - 1.0)); };
    const PixelPlace clicked{pixel(drag.start_x, width_px_), pixel(drag.start_y, height_px_)};
    choices_.first_ray = 0;
    if (choices_.inspected == clicked) {
        choices_.inspected.reset();
    } else {
        choices_.inspected = clicked;
    }
}

void Controls::touch(const TouchMove &move) {
    if (move.kind == TouchMove::Kind::none) return;
    if (move.kind == TouchMove::Kind::one) {
        camera_.orbit({(move.to_x - move.from_x) / width_px_, (move.to_y - move.from_y) / height_px_});
    } else {
        const double x = move.to_x / width_px_, y = move.to_y / height_px_;
        camera_.pan({move.from_x / width_px_, move.from_y / height_px_}, {x, y});
        camera_.zoom({x, y}, 1.0 / move.spread);
    }
    moved();
}

void Controls::zoom(double x, double y, double notches) {
    if (notches == 0.0) return;
    const double place_x = x / width_px_, place_y = y / height_px_;
    camera_.zoom({place_x, place_y}, std::pow(factor_per_notch, notches), distance_at_(place_x, place_y));
    moved();
}

void Controls::press(Key key) {
    if (key >= Key::digit0 && key <= Key::digit9) {
        choices_.depth = static_cast<uint32_t>(key) - static_cast<uint32_t>(Key::digit0);
        return;
    }
    switch (key) {
    case Key::r:
        camera_.reset();
        moved(false);
        break;
    case Key::f:
        camera_.frame();
        moved();
        break;
    case Key::plus:
        choices_.threads = std::min(choices_.threads + 1, most_threads);
        break;
    case Key::minus:
        choices_.threads = std::max(choices_.threads - 1, 1u);
        break;
    case Key::space:
        choices_.is_paused = !choices_.is_paused;
        break;
    case Key::p:
        ++choices_.screenshots;
        break;
    case Key::h:
        choices_.shows_help = !choices_.shows_help;
        break;
    case Key::tab:
        choices_.shows_figures = !choices_.shows_figures;
        break;
    case Key::escape:
        choices_.closes = true;
        break;
    case Key::down:
        ++choices_.first_ray;
        break;
    case Key::up:
        choices_.first_ray -= choices_.first_ray > 0 ? 1 : 0;
        break;
    default:
        break; // flight keys count while they are held
    }
}

Controls::Flight Controls::flight() const {
    const auto held = [&](Key key) { return (held_ & bit_of(key)) != 0 ? 1.0 : 0.0; };
    return {held(Key::d) - held(Key::a), held(Key::e) - held(Key::q), held(Key::w) - held(Key::s)};
}

bool Controls::is_flying() const {
    const auto [right, up, ahead] = flight();
    return right != 0.0 || up != 0.0 || ahead != 0.0;
}

void Controls::advance(double seconds) {
    if (!is_flying()) return;
    const auto [right, up, ahead] = flight();
    const double speed = flight_speed * ((held_ & bit_of(Key::shift)) != 0 ? shift_factor : 1.0);
    camera_.fly({right * speed, up * speed, ahead * speed}, seconds);
    moved();
}

bool Controls::is_moving() const {
    return is_flying() || (drag_ && !drag_->is_click) || touch_.touched();
}

} // namespace glint::viewer

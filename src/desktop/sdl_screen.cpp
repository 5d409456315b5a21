#include "desktop/sdl_screen.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#define SDL_MAIN_HANDLED
#include <SDL.h>
#include <SDL_ttf.h>
#include <fmt/format.h>

#include "core/error.h"
#include "haptics/driver_library.h"

namespace bodkin::desktop {

namespace {

constexpr const char* font_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr std::array<int, 4> font_pixels = {13, 16, 26, 48};  // in the order of SdlScreen::Size
constexpr float half_width = 0.7F;                            // of a line's solid core, pixels
constexpr float soft_edge = 1.0F;                             // over which it fades

// What we use of SDL, by its own declarations.
struct Sdl {
  haptics::DriverLibrary sdl{
      {.product = "SDL", .chosen = "", .places = {"libSDL2-2.0.so.0"}, .advice = "install libsdl2-2.0-0"}};
  haptics::DriverLibrary ttf{{.product = "SDL_ttf",
                              .chosen = "",
                              .places = {"libSDL2_ttf-2.0.so.0"},
                              .advice = "install libsdl2-ttf-2.0-0"}};
  decltype(&SDL_SetHint) set_hint{};
  decltype(&SDL_SetMainReady) set_main_ready{};
  decltype(&SDL_InitSubSystem) init{};
  decltype(&SDL_QuitSubSystem) quit{};
  decltype(&SDL_GetError) error{};
  decltype(&SDL_CreateWindow) create_window{};
  decltype(&SDL_DestroyWindow) destroy_window{};
  decltype(&SDL_CreateRenderer) create_renderer{};
  decltype(&SDL_DestroyRenderer) destroy_renderer{};
  decltype(&SDL_RenderSetLogicalSize) set_logical_size{};
  decltype(&SDL_SetRenderDrawBlendMode) set_blend{};
  decltype(&SDL_SetRenderDrawColor) set_colour{};
  decltype(&SDL_RenderClear) clear{};
  decltype(&SDL_RenderFillRectF) fill{};
  decltype(&SDL_RenderGeometry) geometry{};
  decltype(&SDL_RenderCopyF) copy{};
  decltype(&SDL_RenderPresent) present{};
  decltype(&SDL_CreateTextureFromSurface) texture{};
  decltype(&SDL_DestroyTexture) destroy_texture{};
  decltype(&SDL_FreeSurface) free_surface{};
  decltype(&SDL_CreateRGBSurfaceWithFormatFrom) surface_from{};
  decltype(&SDL_PollEvent) poll{};
  decltype(&SDL_GetModState) modifiers{};
  decltype(&TTF_Init) ttf_init{};
  decltype(&TTF_Quit) ttf_quit{};
  decltype(&TTF_OpenFont) open_font{};
  decltype(&TTF_CloseFont) close_font{};
  decltype(&TTF_RenderUTF8_Blended) render{};

  Sdl() {
    sdl.need(set_hint, "SDL_SetHint");
    sdl.need(set_main_ready, "SDL_SetMainReady");
    sdl.need(init, "SDL_InitSubSystem");
    sdl.need(quit, "SDL_QuitSubSystem");
    sdl.need(error, "SDL_GetError");
    sdl.need(create_window, "SDL_CreateWindow");
    sdl.need(destroy_window, "SDL_DestroyWindow");
    sdl.need(create_renderer, "SDL_CreateRenderer");
    sdl.need(destroy_renderer, "SDL_DestroyRenderer");
    sdl.need(set_logical_size, "SDL_RenderSetLogicalSize");
    sdl.need(set_blend, "SDL_SetRenderDrawBlendMode");
    sdl.need(set_colour, "SDL_SetRenderDrawColor");
    sdl.need(clear, "SDL_RenderClear");
    sdl.need(fill, "SDL_RenderFillRectF");
    sdl.need(geometry, "SDL_RenderGeometry");
    sdl.need(copy, "SDL_RenderCopyF");
    sdl.need(present, "SDL_RenderPresent");
    sdl.need(texture, "SDL_CreateTextureFromSurface");
    sdl.need(destroy_texture, "SDL_DestroyTexture");
    sdl.need(free_surface, "SDL_FreeSurface");
    sdl.need(surface_from, "SDL_CreateRGBSurfaceWithFormatFrom");
    sdl.need(poll, "SDL_PollEvent");
    sdl.need(modifiers, "SDL_GetModState");
    ttf.need(ttf_init, "TTF_Init");
    ttf.need(ttf_quit, "TTF_Quit");
    ttf.need(open_font, "TTF_OpenFont");
    ttf.need(close_font, "TTF_CloseFont");
    ttf.need(render, "TTF_RenderUTF8_Blended");
  }
};

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

// The kinds of display to try; left alone, SDL takes one that nobody sees. Throws InputError where there is none.
const char* displays() {
  const bool x11 = is_set("DISPLAY"), wayland = is_set("WAYLAND_DISPLAY");
  if (!x11 && !wayland) {
    throw InputError(
        "there is no display to open a window on, expected DISPLAY or WAYLAND_DISPLAY to name one; start Bodkin in a "
        "desktop session");
  }
  return x11 && wayland ? "x11,wayland" : x11 ? "x11" : "wayland";
}

// The video of SDL, for as long as this lives.
class Video {
 public:
  Video() : displays_(displays()) {
    sdl_.set_main_ready();
    sdl_.set_hint(SDL_HINT_VIDEODRIVER, displays_);
    sdl_.set_hint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Ctrl-C is the command's
    sdl_.set_hint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");
    if (sdl_.init(SDL_INIT_VIDEO) == 0) return;
    throw InputError(fmt::format(
        "the display does not answer ({}), expected one that DISPLAY or WAYLAND_DISPLAY names; start Bodkin in a "
        "desktop session",
        sdl_.error()));
  }
  ~Video() { sdl_.quit(SDL_INIT_VIDEO); }
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;
  const Sdl* operator->() const noexcept { return &sdl_; }

 private:
  const char* displays_;  // asked for before SDL is loaded
  Sdl sdl_;
};

ScreenKey key_of(SDL_Keycode code) {
  switch (code) {
    case SDLK_SPACE:
      return ScreenKey::space;
    case SDLK_ESCAPE:
      return ScreenKey::escape;
    case SDLK_QUESTION:
    case SDLK_SLASH:  // the same key without shift
      return ScreenKey::question;
    case SDLK_UP:
      return ScreenKey::up;
    case SDLK_DOWN:
      return ScreenKey::down;
    case SDLK_LEFT:
      return ScreenKey::left;
    case SDLK_RIGHT:
      return ScreenKey::right;
    case SDLK_PAGEUP:
      return ScreenKey::page_up;
    case SDLK_PAGEDOWN:
      return ScreenKey::page_down;
    case SDLK_a:
      return ScreenKey::a;
    case SDLK_c:
      return ScreenKey::c;
    case SDLK_d:
      return ScreenKey::d;
    case SDLK_e:
      return ScreenKey::e;
    case SDLK_f:
      return ScreenKey::f;
    case SDLK_g:
      return ScreenKey::g;
    case SDLK_h:
      return ScreenKey::h;
    case SDLK_i:
      return ScreenKey::i;
    case SDLK_j:
      return ScreenKey::j;
    case SDLK_k:
      return ScreenKey::k;
    case SDLK_l:
      return ScreenKey::l;
    case SDLK_m:
      return ScreenKey::m;
    case SDLK_n:
      return ScreenKey::n;
    case SDLK_o:
      return ScreenKey::o;
    case SDLK_q:
      return ScreenKey::q;
    case SDLK_r:
      return ScreenKey::r;
    case SDLK_s:
      return ScreenKey::s;
    case SDLK_t:
      return ScreenKey::t;
    case SDLK_u:
      return ScreenKey::u;
    case SDLK_w:
      return ScreenKey::w;
    case SDLK_x:
      return ScreenKey::x;
    case SDLK_0:
      return ScreenKey::zero;
    case SDLK_1:
      return ScreenKey::one;
    case SDLK_2:
      return ScreenKey::two;
    case SDLK_3:
      return ScreenKey::three;
    case SDLK_4:
      return ScreenKey::four;
    case SDLK_5:
      return ScreenKey::five;
    case SDLK_6:
      return ScreenKey::six;
    case SDLK_7:
      return ScreenKey::seven;
    case SDLK_8:
      return ScreenKey::eight;
    default:
      return ScreenKey::other;
  }
}

// What we make of an event of SDL; nothing of one that is of no interest.
std::optional<ScreenEvent> translated(const SDL_Event& from) {
  using Kind = ScreenEvent::Kind;
  ScreenEvent event;
  if (from.type == SDL_QUIT) return event;
  if (from.type == SDL_MOUSEMOTION) {
    event.kind = Kind::motion;
    event.x = from.motion.x;
    event.y = from.motion.y;
    event.button = from.motion.state != 0;
    return event;
  }
  if (from.type == SDL_MOUSEBUTTONDOWN || from.type == SDL_MOUSEBUTTONUP) {
    if (from.button.button != SDL_BUTTON_LEFT) return std::nullopt;
    event.kind = Kind::button;
    event.x = from.button.x;
    event.y = from.button.y;
    event.down = from.type == SDL_MOUSEBUTTONDOWN;
    return event;
  }
  if (from.type == SDL_MOUSEWHEEL) {
    event.kind = Kind::wheel;
    event.steps = static_cast<double>(from.wheel.preciseY);
    return event;
  }
  if (from.type == SDL_KEYDOWN || from.type == SDL_KEYUP) {
    if (from.key.repeat != 0) return std::nullopt;
    event.kind = Kind::key;
    event.key = key_of(from.key.keysym.sym);
    event.down = from.type == SDL_KEYDOWN;
    return event;
  }
  if (from.type != SDL_WINDOWEVENT) return std::nullopt;
  if (from.window.event == SDL_WINDOWEVENT_LEAVE) {
    event.kind = Kind::leave;
  } else if (from.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
    event.kind = Kind::focus_lost;
  } else if (from.window.event != SDL_WINDOWEVENT_CLOSE) {
    return std::nullopt;
  }
  return event;
}

}  // namespace

struct SdlScreen::Impl {
  Impl(const std::string& title, int width, int height) {
    if (video->ttf_init() != 0) fail("text cannot be drawn");
    for (std::size_t i = 0; i < fonts.size(); ++i) {
      fonts[i] = video->open_font(font_file, font_pixels[i]);
      if (fonts[i] == nullptr) fail("the font is missing, install fonts-dejavu-core");
    }
    window = video->create_window(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                                  SDL_WINDOW_RESIZABLE);
    if (window == nullptr) fail("no window can be opened");
    // The processor draws: no graphics driver takes time from the loop of the force.
    renderer = video->create_renderer(window, -1, SDL_RENDERER_SOFTWARE);
    if (renderer == nullptr) fail("the window cannot be drawn into");
    video->set_logical_size(renderer, width, height);
    video->set_blend(renderer, SDL_BLENDMODE_BLEND);
  }
  ~Impl() { close(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[noreturn]] void fail(const char* what) {
    const std::string sentence = fmt::format("{} ({})", what, video->error());
    close();
    throw SystemError(sentence);
  }

  void close() noexcept {
    if (renderer != nullptr) video->destroy_renderer(renderer);
    if (window != nullptr) video->destroy_window(window);
    for (TTF_Font* font : fonts) {
      if (font != nullptr) video->close_font(font);
    }
    video->ttf_quit();
  }

  void add_line(const Eigen::Vector2f& from, const Eigen::Vector2f& to, Colour colour) {
    const Eigen::Vector2f way = to - from;
    if (!(way.norm() > 0.0F)) return;
    const Eigen::Vector2f across = Eigen::Vector2f(-way.y(), way.x()).normalized();
    const auto corner = [&](const Eigen::Vector2f& at, float aside, Uint8 alpha) {
      const Eigen::Vector2f place = at + aside * across;
      return SDL_Vertex{{place.x(), place.y()}, {colour.red, colour.green, colour.blue, alpha}, {0.0F, 0.0F}};
    };
    const auto strip = [&](float near, Uint8 near_alpha, float far, Uint8 far_alpha) {
      const SDL_Vertex a = corner(from, near, near_alpha), b = corner(to, near, near_alpha);
      const SDL_Vertex c = corner(from, far, far_alpha), d = corner(to, far, far_alpha);
      corners.insert(corners.end(), {a, b, c, b, d, c});
    };
    constexpr float edge = half_width + soft_edge;
    strip(-edge, 0, -half_width, 255);
    strip(-half_width, 255, half_width, 255);
    strip(half_width, 255, edge, 0);
  }

  void draw_lines() {
    if (corners.empty()) return;
    video->geometry(renderer, nullptr, corners.data(), static_cast<int>(corners.size()), nullptr, 0);
  }

  Video video;
  std::array<TTF_Font*, font_pixels.size()> fonts{};
  SDL_Window* window = nullptr;
  SDL_Renderer* renderer = nullptr;
  std::vector<SDL_Vertex> corners;  // of the pieces of lines
};

SdlScreen::SdlScreen(const std::string& title, int width, int height)
    : impl_(std::make_unique<Impl>(title, width, height)) {}

SdlScreen::~SdlScreen() = default;

std::string SdlScreen::obstacle() {
  try {
    const Video video;
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

bool SdlScreen::next(ScreenEvent& event) {
  SDL_Event from;
  while (impl_->video->poll(&from) != 0) {
    const std::optional<ScreenEvent> found = translated(from);
    if (!found) continue;
    event = *found;
    // With a key comes what was held when it was pressed, which may be let go by now.
    const bool is_key = from.type == SDL_KEYDOWN || from.type == SDL_KEYUP;
    const int held = is_key ? int{from.key.keysym.mod} : static_cast<int>(impl_->video->modifiers());
    event.shift = (held & KMOD_SHIFT) != 0;
    return true;
  }
  return false;
}

void SdlScreen::clear(Colour colour) {
  impl_->video->set_colour(impl_->renderer, colour.red, colour.green, colour.blue, SDL_ALPHA_OPAQUE);
  impl_->video->clear(impl_->renderer);
}

void SdlScreen::fill(double x, double y, double width, double height, Colour colour) {
  const SDL_FRect place{static_cast<float>(x), static_cast<float>(y), static_cast<float>(width),
                        static_cast<float>(height)};
  impl_->video->set_colour(impl_->renderer, colour.red, colour.green, colour.blue, SDL_ALPHA_OPAQUE);
  impl_->video->fill(impl_->renderer, &place);
}

// Each piece is three strips side by side: a soft edge, the core, the other soft edge.
void SdlScreen::line(std::span<const Eigen::Vector2f> points, Colour colour) {
  impl_->corners.clear();
  for (std::size_t i = 1; i < points.size(); ++i) impl_->add_line(points[i - 1], points[i], colour);
  impl_->draw_lines();
}

void SdlScreen::segments(std::span<const Eigen::Vector2f> ends, Colour colour) {
  impl_->corners.clear();
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) impl_->add_line(ends[i], ends[i + 1], colour);
  impl_->draw_lines();
}

void SdlScreen::text(double x, double y, const std::string& words, Size size, Colour colour, Align align) {
  const SDL_Color ink{colour.red, colour.green, colour.blue, SDL_ALPHA_OPAQUE};
  TTF_Font* const font = impl_->fonts[static_cast<std::size_t>(size)];
  SDL_Surface* const surface = impl_->video->render(font, words.c_str(), ink);
  if (surface == nullptr) return;  // nothing to draw: an empty text
  const double begin = align == Align::left ? x : align == Align::right ? x - surface->w : x - 0.5 * surface->w;
  const SDL_FRect place{static_cast<float>(std::round(begin)), static_cast<float>(std::round(y)),
                        static_cast<float>(surface->w), static_cast<float>(surface->h)};
  SDL_Texture* const texture = impl_->video->texture(impl_->renderer, surface);
  impl_->video->free_surface(surface);
  if (texture == nullptr) return;
  impl_->video->copy(impl_->renderer, texture, nullptr, &place);
  impl_->video->destroy_texture(texture);
}

void SdlScreen::picture(double x, double y, double width, double height, const imaging::ImageRgb& image) {
  if (image.pixels.empty()) return;
  imaging::ImageRgb& pixels = const_cast<imaging::ImageRgb&>(image);  // NOLINT: SDL only reads them
  SDL_Surface* const surface = impl_->video->surface_from(pixels.pixels.data(), image.width, image.height, 24,
                                                          3 * image.width, SDL_PIXELFORMAT_RGB24);
  if (surface == nullptr) return;
  SDL_Texture* const texture = impl_->video->texture(impl_->renderer, surface);
  impl_->video->free_surface(surface);
  if (texture == nullptr) return;
  const SDL_FRect place{static_cast<float>(x), static_cast<float>(y), static_cast<float>(width),
                        static_cast<float>(height)};
  impl_->video->copy(impl_->renderer, texture, nullptr, &place);
  impl_->video->destroy_texture(texture);
}

void SdlScreen::present() {
  impl_->video->present(impl_->renderer);
}

}  // namespace bodkin::desktop

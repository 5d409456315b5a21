#include "scene/graphics_card/opengl_context.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <mutex>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/glx.h>
#include <GL/glxext.h>
#include <X11/Xlib.h>

#include "core/error.h"

namespace bodkin::scene {

namespace {

constexpr std::array<std::string_view, 9> computed_by_the_processor = {
    "llvmpipe", "softpipe", "swrast",      "swiftshader", "software rasterizer",
    "openswr",  "mesa x11", "gdi generic", "basic render"};

// Xlib ends the program at a server's error by default; the handler is common to all displays.
class ErrorsNoted {
 public:
  explicit ErrorsNoted(Display* display) : alone_(mutex_), display_(display) {
    noted_ = false;
    before_ = XSetErrorHandler(&ErrorsNoted::note);
  }
  ~ErrorsNoted() {
    XSync(display_, False);
    XSetErrorHandler(before_);
  }
  ErrorsNoted(const ErrorsNoted&) = delete;
  ErrorsNoted& operator=(const ErrorsNoted&) = delete;

  bool any() const {
    XSync(display_, False);
    return noted_;
  }

 private:
  static int note(Display*, XErrorEvent*) {
    noted_ = true;
    return 0;
  }

  static inline std::mutex mutex_;
  static inline std::atomic<bool> noted_;
  std::scoped_lock<std::mutex> alone_;
  Display* display_;
  XErrorHandler before_;
};

// Xlib ends the program when a server goes away. A window on Wayland can continue without OpenGL's server, so
// connections opened here are distinguished from others.
class OwnServers {
 public:
  static void add(Display* server) {
    static std::once_flag once;
    std::call_once(once, [] { others_ = XSetIOErrorHandler(&OwnServers::is_gone); });
    const std::scoped_lock lock(mutex_);
    servers_.push_back(server);
  }
  static void forget(Display* server) {
    const std::scoped_lock lock(mutex_);
    std::erase(servers_, server);
  }

 private:
  static int is_gone(Display* server) {
    {
      const std::scoped_lock lock(mutex_);
      if (std::find(servers_.begin(), servers_.end(), server) != servers_.end()) return 0;
    }
    return others_ == nullptr ? 0 : others_(server);
  }

  static inline std::mutex mutex_;
  static inline std::vector<Display*> servers_;
  static inline XIOErrorHandler others_ = nullptr;
};

void live_without(Display* server) {
  OwnServers::add(server);
  XSetIOErrorExitHandler(
      server, [](Display*, void*) {}, nullptr);
}

}  // namespace

bool is_graphics_card(std::string_view renderer) {
  std::string name(renderer);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return !name.empty() && std::none_of(computed_by_the_processor.begin(), computed_by_the_processor.end(),
                                       [&](std::string_view part) { return name.find(part) != std::string::npos; });
}

struct OpenGlContext::Display {
  ::Display* server = nullptr;
  GLXContext context = nullptr;
  GLXPbuffer buffer = 0;

  ~Display() {
    if (server == nullptr) return;
    if (context != nullptr) {
      glXMakeContextCurrent(server, 0, 0, nullptr);
      glXDestroyContext(server, context);
    }
    if (buffer != 0) glXDestroyPbuffer(server, buffer);
    XCloseDisplay(server);
    OwnServers::forget(server);
  }
};

OpenGlContext::OpenGlContext() : display_(std::make_unique<Display>()) {
  display_->server = XOpenDisplay(nullptr);
  if (display_->server == nullptr) {
    throw SystemError("no graphics card can be reached, because there is no X11 display");
  }
  ::Display* const server = display_->server;
  live_without(server);
  const SystemError too_old("no graphics card can be reached, because the display has no OpenGL 3.2");
  if (glXQueryExtension(server, nullptr, nullptr) == False) throw too_old;
  const ErrorsNoted errors(server);
  const int wanted[] = {GLX_DRAWABLE_TYPE,
                        GLX_PBUFFER_BIT,
                        GLX_RENDER_TYPE,
                        GLX_RGBA_BIT,
                        GLX_RED_SIZE,
                        8,
                        GLX_GREEN_SIZE,
                        8,
                        GLX_BLUE_SIZE,
                        8,
                        None};
  int count = 0;
  GLXFBConfig* const found = glXChooseFBConfig(server, DefaultScreen(server), wanted, &count);
  if (found == nullptr || count == 0) throw too_old;
  const GLXFBConfig config = found[0];
  XFree(found);
  const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
      glXGetProcAddressARB(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
  if (create == nullptr) throw too_old;
  const int version[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 2, None};
  display_->context = create(server, config, nullptr, True, version);
  if (display_->context == nullptr || errors.any()) throw too_old;
  const int size[] = {GLX_PBUFFER_WIDTH, 16, GLX_PBUFFER_HEIGHT, 16, None};
  display_->buffer = glXCreatePbuffer(server, config, size);
  if (display_->buffer == 0 || errors.any()) throw too_old;
  if (glXMakeContextCurrent(server, display_->buffer, display_->buffer, display_->context) == False || errors.any()) {
    throw too_old;
  }
  if (const GLubyte* const name = glGetString(GL_RENDERER)) renderer_ = reinterpret_cast<const char*>(name);
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most_);
}

OpenGlContext::~OpenGlContext() = default;

}  // namespace bodkin::scene

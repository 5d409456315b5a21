#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace bodkin::scene {

// Whether an OpenGL renderer of this name (GL_RENDERER) is a graphics card: false for renderers that use the
// processor, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
bool is_graphics_card(std::string_view renderer);

// OpenGL without a window, on the X11 display of this process; current in the thread that made it, which also
// destroys it.
class OpenGlContext {
 public:
  // Throws SystemError if there is no display or no OpenGL 3.2.
  OpenGlContext();
  ~OpenGlContext();
  OpenGlContext(const OpenGlContext&) = delete;
  OpenGlContext& operator=(const OpenGlContext&) = delete;

  const std::string& renderer() const { return renderer_; }  // GL_RENDERER
  int most_along_a_side() const { return most_; }            // largest number of voxels of a volume along each side

 private:
  struct Display;

  std::unique_ptr<Display> display_;
  std::string renderer_;
  int most_ = 0;
};

}  // namespace bodkin::scene

#include "scene/graphics_card/card_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "scene/graphics_card/opengl_context.h"
#include <GL/gl.h>
#include <GL/glext.h>
#include <fmt/format.h>
#include <vtkAutoInit.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkShortArray.h>
#include <vtkUniforms.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include "core/error.h"
#include "core/thread_pool.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2)

namespace bodkin::scene {

namespace {

constexpr double scale_from = imaging::least_shown_hounsfield, scale_to = imaging::most_shown_hounsfield;
constexpr int scale_rows = 4096;  // one for each HU
constexpr double nearest = 0.1;   // mm before the eye
constexpr int check_size = 48;    // pixels along each side of the picture that is compared

// The light of imaging::RayCaster (find_brightness(), light_towards_viewer()): brightness by how far an edge of HU
// faces a light beside the viewer, of samples that take more than 1.5 % of the ray's light. The gradient along each
// axis is a difference over 8/3 voxels of means over four places: what smoothing by (1 2 1) / 4 along every axis and
// central differences reach. All directions are along i, j, k in mm.
constexpr const char* lighting = R"(
vec4 computeLighting(vec4 color, int component, float label)
{
  if (in_bodkinShaded < 0.5) return color;
  if (color.a * (1.0 - g_fragColor.a) < 0.015) return vec4(0.85 * color.rgb, color.a);
  const float along = 4.0 / 3.0, across = 0.707;
  vec3 gradient = vec3(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    vec3 side = vec3((corner & 1) == 0 ? -1.0 : 1.0, (corner & 2) == 0 ? -1.0 : 1.0, (corner & 4) == 0 ? -1.0 : 1.0);
    vec3 x = vec3(along, across, across) * side * in_cellStep[0], y = vec3(across, along, across) * side * in_cellStep[0],
         z = vec3(across, across, along) * side * in_cellStep[0];
    gradient += side * vec3(texture3D(in_volume[0], g_dataPos + x).r, texture3D(in_volume[0], g_dataPos + y).r,
                            texture3D(in_volume[0], g_dataPos + z).r);
  }
  gradient *= 4095.0 * in_volume_scale[0].r / (8.0 * along) / in_bodkinSpacing;
  float size = length(gradient);
  float edge = min(1.0, 127.0 * size / (size + 60.0) / 24.0);
  vec3 ahead = normalize(g_dirStep / in_cellStep[0] * in_bodkinSpacing);
  vec3 right = cross(ahead, in_bodkinUp);
  if (dot(right, right) < 1e-6) right = in_bodkinLeft;
  right = normalize(right);
  vec3 light = normalize(-ahead + 0.45 * cross(right, ahead) - 0.35 * right);
  float facing = abs(dot(gradient, light)) / (size + 1e-3);
  float lit = 0.22 + 0.74 * facing + 0.22 * pow(facing, 16.0);
  return vec4((0.85 + edge * (lit - 0.85)) * color.rgb, color.a);
}
)";

void note_error(vtkObject*, unsigned long, void* client, void* data) {
  auto& noted = *static_cast<std::string*>(client);
  if (!noted.empty() || data == nullptr) return;
  noted = static_cast<const char*>(data);
  // "ERROR: In file, line n\nClass (address): what\n\n": what is of use is the last part.
  const std::size_t begin = noted.find("): ");
  if (begin != std::string::npos) noted.erase(0, begin + 3);
  const std::size_t end = noted.find('\n');
  if (end != std::string::npos) noted.resize(end);
}

// Two additional voxels on every side: one that repeats the outermost ones, as in PreparedVolume, and one that no ray
// meets, whose corners have the ends of the scale. So VTK's tables have a row for each HU.
void fill_image(const imaging::PreparedVolume& volume, vtkImageData& image) {
  const std::array<int, 3> from = volume.size;
  const int nx = from[0] + 2, ny = from[1] + 2, nz = from[2] + 2;
  image.SetDimensions(nx, ny, nz);
  image.SetSpacing(volume.grid.spacing.data());
  const Vec3 origin = -2.0 * volume.grid.spacing;
  image.SetOrigin(origin.data());
  vtkNew<vtkShortArray> values;
  values->SetNumberOfTuples(static_cast<vtkIdType>(nx) * ny * nz);
  short* out = values->GetPointer(0);
  for (int k = 0; k < nz; ++k) {
    const int from_k = std::clamp(k - 1, 0, from[2] - 1);
    for (int j = 0; j < ny; ++j, out += nx) {
      const int from_j = std::clamp(j - 1, 0, from[1] - 1);
      for (int i = 0; i < nx; ++i) {
        out[i] = volume.hounsfield[volume.offset(std::clamp(i - 1, 0, from[0] - 1), from_j, from_k)];
      }
    }
  }
  values->SetValue(0, static_cast<short>(scale_from));
  values->SetValue(values->GetNumberOfValues() - 1, static_cast<short>(scale_to));
  image.GetPointData()->SetScalars(values);
}

double difference(std::uint32_t a, std::uint32_t b) {
  double sum = 0.0;
  for (unsigned shift = 0; shift < 24U; shift += 8U) {
    sum += std::abs(static_cast<double>(a >> shift & 0xFFU) - static_cast<double>(b >> shift & 0xFFU));
  }
  return sum / 3.0;
}

}  // namespace

struct CardVolume::Scene {
  std::string error;      // the first error from VTK; declared before its reporter, destroyed first
  OpenGlContext context;  // before all that lives in it
  std::shared_ptr<const imaging::PreparedVolume> patient;
  std::optional<imaging::VolumeLook> look;
  vtkNew<vtkCallbackCommand> errors, made_current, is_current, supports;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkImageData> image;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> colours;

  Scene(std::shared_ptr<const imaging::PreparedVolume> of, bool software_too) : patient(std::move(of)) {
    check_limits(software_too);
    listen();
    fill_image(*patient, *image);
    place();
    window->SetMultiSamples(0);
    window->SetOffScreenRendering(1);
    window->SetReadyForRendering(true);
    window->AddRenderer(renderer);
    window->OpenGLInit();
    mapper->SetInputData(image);
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetUseJittering(0);
    vtkVolumeProperty* const property = volume->GetProperty();
    property->SetInterpolationTypeToLinear();
    property->SetScalarOpacityUnitDistance(1.0);
    property->SetScalarOpacity(opacity);
    property->SetColor(colours);
    volume->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::ComputeLighting::Dec", true, lighting, false);
    vtkUniforms* const uniforms = volume->GetShaderProperty()->GetFragmentCustomUniforms();
    const Eigen::Vector3f spacing = patient->grid.spacing.cast<float>();
    uniforms->SetUniform3f("in_bodkinSpacing", spacing.data());
    const Eigen::Matrix3f axes = patient->grid.direction.transpose().cast<float>();
    const Eigen::Vector3f up = axes.col(2), left = axes.col(0);
    uniforms->SetUniform3f("in_bodkinUp", up.data());
    uniforms->SetUniform3f("in_bodkinLeft", left.data());
    volume->SetMapper(mapper);
    renderer->AddVolume(volume);
  }

  void check_limits(bool software_too) const {
    if (!software_too && !is_graphics_card(context.renderer())) {
      throw SystemError(fmt::format("OpenGL is computed by the processor here ({})", context.renderer()));
    }
    const int longest = *std::max_element(patient->size.begin(), patient->size.end()) + 2;
    if (longest > context.most_along_a_side()) {
      throw SystemError(fmt::format("the volume is {} voxels long, and the graphics card takes {}", longest,
                                    context.most_along_a_side()));
    }
  }

  void listen() {
    errors->SetCallback(&note_error);
    errors->SetClientData(&error);
    for (vtkObject* const part : {static_cast<vtkObject*>(window), static_cast<vtkObject*>(renderer),
                                  static_cast<vtkObject*>(mapper), static_cast<vtkObject*>(volume)}) {
      part->AddObserver(vtkCommand::ErrorEvent, errors);
    }
    // The context is current in this thread as long as it lives.
    is_current->SetCallback(
        [](vtkObject*, unsigned long, void*, void* answer) { *static_cast<bool*>(answer) = true; });
    window->AddObserver(vtkCommand::WindowIsCurrentEvent, is_current);
    supports->SetCallback([](vtkObject*, unsigned long, void*, void* answer) { *static_cast<int*>(answer) = 1; });
    window->AddObserver(vtkCommand::WindowSupportsOpenGLEvent, supports);
  }

  // Places the volume and clips it to its outermost voxels.
  void place() {
    const anatomy::Grid& grid = patient->grid;
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, grid.direction(row, column));
      matrix->SetElement(row, 3, grid.origin[row]);
    }
    volume->SetUserMatrix(matrix);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        Vec3 border = Vec3::Zero();
        border[axis] = sign < 0.0 ? -0.5 : grid.size[static_cast<std::size_t>(axis)] - 0.5;
        const Vec3 at = grid.to_patient(border), inwards = -sign * grid.direction.col(axis);
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(at.data());
        plane->SetNormal(inwards.data());
        mapper->AddClippingPlane(plane);
      }
    }
  }

  void show(const imaging::VolumeLook& wanted) {
    if (look && *look == wanted) return;
    look = wanted;
    std::vector<double> opacities(scale_rows), rgb(std::size_t{3} * scale_rows);
    for (std::size_t row = 0; row < scale_rows; ++row) {
      const double hounsfield = scale_from + static_cast<double>(row);
      std::array<double, 3> colour = {1.0, 1.0, 1.0};
      double& opaque = opacities[row];
      const double window_share = (hounsfield - wanted.level) / wanted.window + 0.5;
      switch (wanted.mode) {
        case imaging::VolumeMode::colour:
        case imaging::VolumeMode::grey:
          opaque = std::clamp(wanted.transfer.opacity_at(hounsfield), 0.0, 0.999);
          colour = wanted.transfer.colour_at(hounsfield);
          if (wanted.mode == imaging::VolumeMode::grey) colour.fill(std::clamp(window_share, 0.06, 1.0));
          break;
        case imaging::VolumeMode::maximum:
          opaque = 1.0;
          colour.fill(std::clamp(window_share, 0.0, 1.0));
          break;
        case imaging::VolumeMode::sum:
          // VTK sums opacity times value, the value being 0 to 1 from one end of the scale to the other.
          if (hounsfield >= -900.0) {
            const double value = static_cast<double>(row) / (scale_rows - 1);
            opaque = wanted.brightness * 0.001 * (hounsfield + 1000.0) / (value * patient->thickest);
          }
          break;
      }
      for (std::size_t c = 0; c < 3; ++c) rgb[3 * row + c] = colour[c];
    }
    opacity->BuildFunctionFromTable(scale_from, scale_to, scale_rows, opacities.data());
    colours->BuildFunctionFromTable(scale_from, scale_to, scale_rows, rgb.data());
    const bool lit = wanted.mode == imaging::VolumeMode::colour || wanted.mode == imaging::VolumeMode::grey;
    switch (wanted.mode) {
      case imaging::VolumeMode::maximum:
        mapper->SetBlendModeToMaximumIntensity();
        break;
      case imaging::VolumeMode::sum:
        mapper->SetBlendModeToAdditive();
        break;
      default:
        mapper->SetBlendModeToComposite();
    }
    volume->GetProperty()->SetShade(lit ? 1 : 0);
    volume->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("in_bodkinShaded",
                                                                          lit && wanted.shaded ? 1.0F : 0.0F);
    const auto part = [&](unsigned shift) { return lit ? (wanted.background >> shift & 0xFFU) / 255.0 : 0.0; };
    renderer->SetBackground(part(16U), part(8U), part(0U));
  }

  void see_from(const imaging::VolumeCamera& camera) {
    const Vec3 right = camera.right.normalized(), down = camera.down.normalized(), ahead = right.cross(down);
    const Vec3 focus = camera.eye + 100.0 * ahead, up = -down;
    vtkCamera* const to = renderer->GetActiveCamera();
    to->SetPosition(camera.eye.data());
    to->SetFocalPoint(focus.data());
    to->SetViewUp(up.data());
    to->SetViewAngle(2.0 * std::atan(0.5 * camera.height * camera.down.norm()) / degree);
    // Nothing else is drawn that needs depth precision: everything before the eye is visible.
    const double across =
        patient->grid.spacing
            .cwiseProduct(Vec3(image->GetDimensions()[0], image->GetDimensions()[1], image->GetDimensions()[2]))
            .norm();
    const Vec3 middle(volume->GetCenter());
    to->SetClippingRange(nearest, std::max((middle - camera.eye).norm() + across, 2.0 * nearest));
  }

  void read(std::vector<std::uint32_t>& pixels, int width, int height) {
    std::vector<std::uint32_t> rows(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    vtkOpenGLFramebufferObject* const drawn = window->GetRenderFramebuffer();
    drawn->Bind(GL_READ_FRAMEBUFFER);
    drawn->ActivateReadBuffer(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_BYTE, rows.data());
    drawn->UnBind(GL_READ_FRAMEBUFFER);
    pixels.resize(rows.size());
    for (int y = 0; y < height; ++y) {  // OpenGL begins below
      const auto from = rows.begin() + static_cast<std::ptrdiff_t>(height - 1 - y) * width;
      std::transform(from, from + width, pixels.begin() + static_cast<std::ptrdiff_t>(y) * width,
                     [](std::uint32_t pixel) { return pixel | 0xFF000000U; });
    }
  }
};

CardVolume::CardVolume(std::shared_ptr<const imaging::PreparedVolume> volume, bool software_too) {
  scene_ = std::make_unique<Scene>(std::move(volume), software_too);
  if (static_cast<vtkGPUVolumeRayCastMapper&>(*scene_->mapper)
          .IsRenderSupported(scene_->window, scene_->volume->GetProperty()) == 0) {
    throw SystemError("VTK's volume mapper does not support this graphics card");
  }
  check_picture();
}

CardVolume::~CardVolume() = default;

const std::string& CardVolume::renderer() const {
  return scene_->context.renderer();
}

void CardVolume::draw(const imaging::VolumeCamera& camera, const imaging::VolumeLook& look, double step,
                      std::vector<std::uint32_t>& pixels) {
  Scene& scene = *scene_;
  scene.error.clear();
  scene.show(look);
  scene.mapper->SetSampleDistance(static_cast<float>(step));
  if (scene.window->GetSize()[0] != camera.width || scene.window->GetSize()[1] != camera.height) {
    scene.window->SetSize(camera.width, camera.height);
  }
  scene.see_from(camera);
  scene.window->Render();
  if (scene.error.empty()) scene.read(pixels, camera.width, camera.height);
  if (!scene.error.empty())
    throw SystemError(fmt::format("the graphics card did not draw the volume: {}", scene.error));
}

// Some drivers draw nothing and report no error.
void CardVolume::check_picture() {
  const imaging::PreparedVolume& patient = *scene_->patient;
  const anatomy::Grid& grid = patient.grid;
  const Vec3 last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const double across = grid.spacing.cwiseProduct(last + Vec3::Ones()).norm();
  const Vec3 middle = grid.to_patient(0.5 * last), ahead = Vec3(0.3, -1.0, -0.2).normalized();
  imaging::VolumeCamera camera;
  camera.eye = middle - 2.0 * across * ahead;
  camera.width = camera.height = check_size;
  const double pixel = 0.5 / check_size;
  camera.right = pixel * ahead.cross(Vec3::UnitZ()).normalized();
  camera.down = ahead.cross(camera.right);
  camera.first = ahead + (0.5 - 0.5 * check_size) * (camera.right + camera.down);
  ThreadPool pool(1);
  for (const imaging::VolumeMode mode : {imaging::VolumeMode::maximum, imaging::VolumeMode::colour}) {
    imaging::VolumeLook look;
    look.mode = mode;
    look.transfer = imaging::preset_function(imaging::TransferPreset::skin);
    std::vector<std::uint32_t> expected, drawn;
    const double step = imaging::step_of(patient, 2.0);
    imaging::RayCaster(scene_->patient, look, step).draw(camera, pool, expected);
    draw(camera, look, step, drawn);
    double sum = 0.0;
    for (std::size_t i = 0; i < drawn.size(); ++i) sum += difference(drawn[i], expected[i]);
    constexpr double most = 12.0;  // of 255, in the mean
    if (sum > most * static_cast<double>(drawn.size())) {
      throw SystemError("the graphics card draws a different image than the processor");
    }
  }
}

}  // namespace bodkin::scene

#include "tracking/footage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "tracking/jpeg_file.h"
#include "tracking/pose_step.h"

#include "core/parallel_for.h"
#include "core/random.h"

namespace bodkin::tracking {

namespace {

constexpr float white = 0.82F, black = 0.035F, skin = 0.3F;  // reflectance

// A sheet as the camera sees it at one instant of the exposure.
struct SeenSheet {
  Mat3 to_face = Mat3::Identity();  // camera axes to face axes
  Vec3 eye = Vec3::Zero();          // the camera in the face's frame
  double sheet = 0.0, cell = 0.0;   // mm: half an edge, a cell
  bool marked = false;
  float plain = 0.0F;  // reflectance of a sheet without a marker
  std::array<std::array<bool, marker_cells>, marker_cells> pattern{};
  float shade = 1.0F;
  int left = 0, top = 0, right = -1, bottom = -1;  // pixels that it may cover
};

struct Finger {
  Eigen::Vector2d from, to;  // pixels
  double radius = 0.0;
};

bool front(SeenSheet& seen, const MarkerFace& face, const Pose& camera_from_body, const CameraModel& camera) {
  const Pose place = camera_from_body * face.place;
  const Vec3 inward = place.linear().col(2);
  if (inward.dot(place.translation()) <= 0.0) return false;
  seen.to_face = place.linear().transpose();
  seen.eye = -(seen.to_face * place.translation());
  seen.sheet = 0.5 * face.sheet;
  seen.marked = face.id >= 0;
  seen.plain = static_cast<float>(face.reflectance);
  seen.cell = face.side / marker_cells;
  if (seen.marked) seen.pattern = marker_pattern(face.id);
  // Light from above the camera's left shoulder.
  const Vec3 light = Vec3(0.35, 0.6, 1.0).normalized();
  seen.shade = static_cast<float>(0.35 + 0.65 * std::max(0.0, inward.dot(light)));
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int corner = 0; corner < 4; ++corner) {
    const Vec3 at =
        place * Vec3((corner & 1) != 0 ? seen.sheet : -seen.sheet, (corner & 2) != 0 ? seen.sheet : -seen.sheet, 0.0);
    if (at.z() < 10.0) return false;
    const Eigen::Vector2d pixel = camera.project(at);
    low = low.cwiseMin(pixel);
    high = high.cwiseMax(pixel);
  }
  seen.left = std::max(0, static_cast<int>(std::floor(low.x())) - 2);
  seen.top = std::max(0, static_cast<int>(std::floor(low.y())) - 2);
  seen.right = std::min(camera.width - 1, static_cast<int>(std::ceil(high.x())) + 2);
  seen.bottom = std::min(camera.height - 1, static_cast<int>(std::ceil(high.y())) + 2);
  return seen.left <= seen.right && seen.top <= seen.bottom;
}

// Light from the sheet where a ray meets it, negative if it does not; `depth` becomes the depth of the hit.
float light_from(const SeenSheet& seen, const Vec3& ray, double& depth) {
  const Vec3 along = seen.to_face * ray;
  if (along.z() <= 1e-9) return -1.0F;
  const double far = -seen.eye.z() / along.z();
  if (far >= depth) return -1.0F;
  const double u = seen.eye.x() + far * along.x(), v = seen.eye.y() + far * along.y();
  if (std::abs(u) > seen.sheet || std::abs(v) > seen.sheet) return -1.0F;
  depth = far;
  if (!seen.marked) return seen.plain * seen.shade;
  const int column = static_cast<int>(std::floor(u / seen.cell + 0.5 * marker_cells));
  const int row = static_cast<int>(std::floor(v / seen.cell + 0.5 * marker_cells));
  const bool on_marker = column >= 0 && row >= 0 && column < marker_cells && row < marker_cells;
  const bool bright = !on_marker || seen.pattern[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  return (bright ? white : black) * seen.shade;
}

// A cluttered table: soft blobs and streaks.
float background(int x, int y, int width, std::uint64_t seed) {
  const double scale = 1280.0 / width;
  const double u = x * scale, v = y * scale, phase = 6.28 * static_cast<double>(seed % 97) / 97.0;
  const double waves = std::sin(0.013 * u + phase) * std::cos(0.017 * v - phase) +
                       0.6 * std::sin(0.041 * u - 0.029 * v + 2.0 * phase) + 0.3 * std::sin(0.11 * v + 0.07 * u);
  return static_cast<float>(0.22 + 0.07 * waves);
}

std::vector<Finger> fingers_over(const std::vector<PlacedBody>& bodies, const CameraModel& camera, double share,
                                 std::uint64_t seed) {
  std::vector<Finger> fingers;
  Random random(mix64(seed) + 17U);
  for (const PlacedBody& placed : bodies) {
    const double present = random.uniform(), across = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, 6.28);
    if (share <= 0.0 || present > 0.8) continue;
    double reach = 0.0;
    for (const MarkerFace& face : placed.body->faces)
      reach = std::max(reach, face.place.translation().norm() + 0.5 * face.sheet);
    const Vec3 centre = placed.camera_from_body.translation();
    if (centre.z() < 10.0) continue;
    const double pixels = camera.fx * reach / centre.z();
    const Eigen::Vector2d middle = camera.project(centre), along(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d side(-along.y(), along.x());
    const Eigen::Vector2d inner = middle + across * 0.8 * pixels * side;
    fingers.push_back({inner, inner + 3.0 * pixels * along, share * pixels});
  }
  return fingers;
}

bool hidden(const std::vector<Finger>& fingers, double x, double y) {
  const Eigen::Vector2d at(x, y);
  return std::any_of(fingers.begin(), fingers.end(), [&](const Finger& finger) {
    const Eigen::Vector2d along = finger.to - finger.from;
    const double share = std::clamp((at - finger.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (at - finger.from - share * along).norm() < finger.radius;
  });
}

// Gaussian blur of both axes; the border repeats.
void blur(std::vector<float>& light, int width, int height, double sigma) {
  if (sigma < 0.05) return;
  const int reach = static_cast<int>(std::ceil(4.0 * sigma));
  std::vector<float> weights(static_cast<std::size_t>(reach) + 1);
  float sum = 0.0F;
  for (int i = 0; i <= reach; ++i) {
    weights[static_cast<std::size_t>(i)] = static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += (i == 0 ? 1.0F : 2.0F) * weights[static_cast<std::size_t>(i)];
  }
  for (float& weight : weights) weight /= sum;
  std::vector<float> across(light.size());
  const auto w = static_cast<std::size_t>(width);
  parallel_for(height, [&](int y) {
    const float* const row = light.data() + static_cast<std::size_t>(y) * w;
    for (int x = 0; x < width; ++x) {
      float value = weights[0] * row[x];
      for (int i = 1; i <= reach; ++i)
        value += weights[static_cast<std::size_t>(i)] * (row[std::max(x - i, 0)] + row[std::min(x + i, width - 1)]);
      across[static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x)] = value;
    }
  });
  parallel_for(height, [&](int y) {
    float* const out = light.data() + static_cast<std::size_t>(y) * w;
    const auto row = [&](int at) {
      return across.data() + static_cast<std::size_t>(std::clamp(at, 0, height - 1)) * w;
    };
    const float* const middle = row(y);
    for (int x = 0; x < width; ++x) out[x] = weights[0] * middle[x];
    for (int i = 1; i <= reach; ++i) {
      const float *const above = row(y - i), *const below = row(y + i);
      const float weight = weights[static_cast<std::size_t>(i)];
      for (int x = 0; x < width; ++x) out[x] += weight * (above[x] + below[x]);
    }
  });
}

void sharpen(GreyImage& picture, double share) {
  std::vector<float> soft(picture.pixels.begin(), picture.pixels.end());
  blur(soft, picture.width, picture.height, 1.0);
  for (std::size_t i = 0; i < soft.size(); ++i) {
    const double level = picture.pixels[i];
    const double sharp = level + share * (level - static_cast<double>(soft[i]));
    picture.pixels[i] = static_cast<std::uint8_t>(std::clamp(std::lround(sharp), 0L, 255L));
  }
}

}  // namespace

GreyImage render_picture(const CameraModel& camera, const FootageLook& look, const std::vector<PlacedBody>& bodies,
                         std::uint64_t seed) {
  const int width = camera.width, height = camera.height, samples = look.samples;
  const bool moves = std::any_of(bodies.begin(), bodies.end(), [](const PlacedBody& placed) {
    return placed.shift.norm() + placed.turn.norm() > 0.0;
  });
  const int instants = moves ? look.instants : 1;
  std::vector<std::vector<SeenSheet>> seen(static_cast<std::size_t>(instants));
  for (int n = 0; n < instants; ++n) {
    const double when = instants == 1 ? 0.0 : (n + 0.5) / instants - 0.5;
    for (const PlacedBody& placed : bodies) {
      Pose place = placed.camera_from_body;
      Vector6 step;
      step << when * placed.shift, when * placed.turn;
      take_step(place, step);
      for (const MarkerFace& face : placed.body->faces) {
        SeenSheet sheet;
        if (front(sheet, face, place, camera)) seen[static_cast<std::size_t>(n)].push_back(sheet);
      }
    }
  }
  const std::vector<Finger> fingers = fingers_over(bodies, camera, look.occlusion, seed);
  std::vector<float> light(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  parallel_for(height, [&](int y) {
    std::vector<const SeenSheet*> here;
    std::vector<Vec3> rays(static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples));
    for (int x = 0; x < width; ++x) {
      const float table = background(x, y, width, seed);
      float sum = 0.0F;
      bool have_rays = false;
      for (const std::vector<SeenSheet>& sheets : seen) {
        here.clear();
        for (const SeenSheet& sheet : sheets) {
          if (x >= sheet.left && x <= sheet.right && y >= sheet.top && y <= sheet.bottom) here.push_back(&sheet);
        }
        if (here.empty()) {
          sum += hidden(fingers, x, y) ? skin : table;
          continue;
        }
        if (!have_rays) {
          // Within a pixel the lens is practically linear.
          const Vec3 middle = camera.ray({x, y});
          const Vec3 by_x = camera.ray({x + 0.5, y}) - camera.ray({x - 0.5, y});
          const Vec3 by_y = camera.ray({x, y + 0.5}) - camera.ray({x, y - 0.5});
          for (int s = 0; s < samples * samples; ++s) {
            const double dx = (s % samples + 0.5) / samples - 0.5;
            const int line = s / samples;
            const double dy = static_cast<double>(line) / samples + 0.5 / samples - 0.5;
            rays[static_cast<std::size_t>(s)] = middle + dx * by_x + dy * by_y;
          }
          have_rays = true;
        }
        float within = 0.0F;
        for (const Vec3& ray : rays) {
          double depth = 1e9;
          float value = table;
          for (const SeenSheet* sheet : here) {
            const float met = light_from(*sheet, ray, depth);
            if (met >= 0.0F) value = met;
          }
          within += value;
        }
        within /= static_cast<float>(rays.size());
        sum += hidden(fingers, x, y) ? skin : within;
      }
      const double fx = 2.0 * (x - camera.cx) / width, fy = 2.0 * (y - camera.cy) / width;
      const double fall = 1.0 - look.unevenness * (fx * fx + fy * fy + 0.3 * fx) / 1.6;
      light[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
          sum / static_cast<float>(instants) * static_cast<float>(look.exposure * fall);
    }
  });
  blur(light, width, height, camera.blur);
  std::array<std::uint8_t, 4096> levels{};
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i] = static_cast<std::uint8_t>(std::lround(255.0 * camera.tone.level(static_cast<double>(i) / 4095.0)));
  GreyImage picture(width, height);
  parallel_for(height, [&](int y) {
    Random random(mix64(seed) ^ mix64(static_cast<std::uint64_t>(y) + 1U));
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (std::size_t i = row; i < row + static_cast<std::size_t>(width); ++i) {
      const double value = light[i];
      const double noise =
          std::sqrt(look.read_noise * look.read_noise + look.shot_noise * look.shot_noise * std::max(value, 0.0));
      const double noisy = value + noise * random.normal();
      picture.pixels[i] = levels[static_cast<std::size_t>(std::lround(4095.0 * std::clamp(noisy, 0.0, 1.0)))];
    }
  });
  if (look.sharpening > 0.0) sharpen(picture, look.sharpening);
  if (look.jpeg_quality > 0) picture = decode_jpeg_grey(encode_jpeg(picture, look.jpeg_quality), "footage");
  return picture;
}

}  // namespace bodkin::tracking

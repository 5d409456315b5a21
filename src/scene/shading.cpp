#include "scene/shading.h"

#include <algorithm>
#include <cmath>

namespace bodkin::scene {

namespace {

using Eigen::Vector3f;

Vector3f components(std::uint32_t colour) {
  const auto part = [colour](unsigned shift) { return static_cast<float>((colour >> shift) & 0xFFU); };
  return {part(16), part(8), part(0)};
}

// Strengths of the lights, chosen by eye. [D]
constexpr float sky_strength = 0.34F, lamp_strength = 0.72F, fill_strength = 0.16F;
constexpr float key_in_corners = 0.45F;  // of the first lamp that still reaches a corner with no sky

float power16(float x) {
  for (int i = 0; i < 4; ++i) x *= x;
  return x;
}

}  // namespace

void shade(const SceneMesh& mesh, const Material& material, const Projection& projection,
           std::vector<ScreenPoint>& points, std::span<const std::uint32_t> tint) {
  const Eigen::Matrix3f axes = projection.axes().cast<float>();  // right, down, away
  const Vector3f eye = projection.camera().eye.cast<float>();
  const Vector3f to_key = axes * Vector3f(-0.45F, -0.62F, -0.64F).normalized();
  const Vector3f to_fill = axes * Vector3f(0.85F, 0.10F, -0.52F).normalized();
  const Vector3f down = axes.col(1);
  const Vector3f between = (to_key - axes.col(2)).normalized();
  const Vector3f base = components(material.colour), rim_colour = components(material.rim_colour);
  const auto focal = static_cast<float>(projection.focal_length());
  const float middle_x = 0.5F * static_cast<float>(projection.width());
  const float middle_y = 0.5F * static_cast<float>(projection.height());
  points.resize(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vector3f seen = axes.transpose() * (mesh.points[i] - eye);
    ScreenPoint& point = points[i];
    point.nearness = seen.z() >= static_cast<float>(Projection::nearest) ? 1.0F / seen.z() : 0.0F;
    point.x = middle_x + focal * seen.x() * point.nearness;
    point.y = middle_y + focal * seen.y() * point.nearness;
    const Vector3f& normal = mesh.normals[i];
    const float open = mesh.openness[i];
    const float above = 0.5F - 0.25F * normal.dot(down);  // more light from above than from below
    const float lamp = std::max(0.0F, 0.15F + 0.85F * normal.dot(to_key));
    const float light = sky_strength * open * (above + 0.5F) +
                        lamp_strength * lamp * (key_in_corners + (1.0F - key_in_corners) * open) +
                        fill_strength * open * std::max(0.0F, normal.dot(to_fill));
    const float highlight = 255.0F * material.gloss * open * power16(std::max(0.0F, normal.dot(between)));
    Vector3f own = base;
    if (!tint.empty()) own += (components(tint[i]) - base) * (static_cast<float>(tint[i] >> 24U) / 255.0F);
    Vector3f colour = own * light + Vector3f::Constant(highlight);
    if (material.rim > 0.0F) {
      const Vector3f towards = (eye - mesh.points[i]) * point.nearness;
      const float away = 1.0F - std::min(1.0F, std::abs(normal.dot(towards)));
      colour += (rim_colour - colour) * (material.rim * away * away);
    }
    point.red = std::clamp(colour.x(), 0.0F, 255.0F);
    point.green = std::clamp(colour.y(), 0.0F, 255.0F);
    point.blue = std::clamp(colour.z(), 0.0F, 255.0F);
  }
}

}  // namespace bodkin::scene

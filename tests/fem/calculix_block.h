#pragma once

// The quarter of a layered block by CalculiX, in hexahedra of second order (C3D20) that become smaller towards a disk
// in the middle of its top: a mesh independent of ours.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/fem/calculix.h"
#include "tests/fem/layered_block.h"

namespace bodkin::checks {

class CalculixBlock {
 public:
  // A disk of this radius (mm) on a block of these layers, 60 x 60 x 40 mm.
  CalculixBlock(const std::vector<BlockLayer>& layers, double radius) : layers_(layers), radius_(radius) {
    fill_planes();
    fill_elements();
    fill_load();
  }

  // mm/N: mean indentation of the disk by a force of 1 N spread evenly over it. NaN if not computed.
  double compliance() const {
    const ScratchFolder folder;
    if (!calculix_ran(folder, input())) return std::nan("");
    const Eigen::VectorXd moved = calculix_table(folder.path() / "body.dat", "displacements", nodes_.size());
    double mean = 0.0;
    for (const auto& [node, share] : load_) mean -= share * moved(3 * static_cast<Eigen::Index>(node) + 2);
    return mean;
  }
  std::size_t nodes() const noexcept { return nodes_.size(); }

 private:
  using Place = std::array<int, 3>;  // in halves of an element, from the middle of the top outwards and down

  // Steps of half a radius within the disk, then each 1.6 times as long as the one before.
  void fill_planes() {
    double step = 0.5 * radius_;
    while (across_.back() < 30.0) {
      if (across_.back() > 1.2 * radius_) step *= 1.6;
      across_.push_back(across_.back() + step);
    }
    const double too_far = across_.back() / 30.0;
    for (double& plane : across_) plane /= too_far;
    step = 0.5 * radius_;
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
      const double end = down_.back() + layers_[layer].thickness;
      while (down_.back() < end - 1e-9) {
        const double left = end - down_.back();
        const double thick = left / std::max(1.0, std::round(left / std::min(step, layers_[layer].thickness / 3.0)));
        down_.push_back(down_.back() + thick);
        layer_of_.push_back(layer);
        step = std::min(4.0, 1.4 * step);
      }
    }
  }

  static double between(const std::vector<double>& planes, int halves) {
    const auto i = static_cast<std::size_t>(halves / 2);
    return halves % 2 == 0 ? planes[i] : 0.5 * (planes[i] + planes[i + 1]);
  }

  std::size_t node_at(const Place& at) {
    const auto [found, is_new] = names_.try_emplace(at, nodes_.size());
    if (is_new) nodes_.emplace_back(between(across_, at[0]), between(across_, at[1]), -between(down_, at[2]));
    return found->second;
  }

  // CalculiX's order: the corners below and above, the middles of the edges below, above and between.
  static constexpr std::array<Place, 20> corners = {
      {{0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 2}, {2, 1, 2},
       {1, 2, 2}, {0, 1, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};

  void fill_elements() {
    const auto n = static_cast<int>(across_.size()) - 1;
    elements_.resize(layers_.size());
    for (int k = 0; k + 1 < static_cast<int>(down_.size()); ++k) {
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          std::array<std::size_t, 20> element{};
          for (std::size_t corner = 0; corner < 20; ++corner) {
            const auto& at = corners[corner];
            element[corner] = node_at({2 * i + at[0], 2 * j + at[1], 2 * k + at[2]});
          }
          elements_[layer_of_[static_cast<std::size_t>(k)]].push_back(element);
        }
      }
    }
  }

  // The shares of the nodes of the faces on top, by the shape functions of their eight nodes at 60 x 60 places.
  void fill_load() {
    constexpr int places = 60;
    const auto n = static_cast<int>(across_.size()) - 1;
    double area = 0.0;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const double left = across_[static_cast<std::size_t>(i)], near = across_[static_cast<std::size_t>(j)];
        if (std::hypot(left, near) > radius_) continue;
        const double wide = across_[static_cast<std::size_t>(i + 1)] - left,
                     deep = across_[static_cast<std::size_t>(j + 1)] - near;
        for (int a = 0; a < places; ++a) {
          for (int b = 0; b < places; ++b) {
            const double p = (2.0 * a + 1.0) / places - 1.0, q = (2.0 * b + 1.0) / places - 1.0;
            if (std::hypot(left + 0.5 * (p + 1.0) * wide, near + 0.5 * (q + 1.0) * deep) > radius_) continue;
            const double here = wide * deep / (places * places);
            area += here;
            for (const int s : {-1, 1}) {
              for (const int t : {-1, 1})
                load_[node_at({2 * i + 1 + s, 2 * j + 1 + t, 0})] +=
                    here * 0.25 * (1.0 + s * p) * (1.0 + t * q) * (s * p + t * q - 1.0);
              load_[node_at({2 * i + 1 + s, 2 * j + 1, 0})] += here * 0.5 * (1.0 + s * p) * (1.0 - q * q);
              load_[node_at({2 * i + 1, 2 * j + 1 + s, 0})] += here * 0.5 * (1.0 - p * p) * (1.0 + s * q);
            }
          }
        }
      }
    }
    for (auto& [node, share] : load_) share /= area;
  }

  std::string input() const {
    std::string text = "*NODE, NSET=ALL\n";
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const Vec3& x = nodes_[node];
      text += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", node + 1, x.x(), x.y(), x.z());
    }
    std::size_t number = 0;
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
      text += fmt::format("*ELEMENT, TYPE=C3D20, ELSET=LAYER{}\n", layer);
      for (const auto& element : elements_[layer]) {
        text += fmt::format("{}", ++number);
        for (std::size_t i = 0; i < 20; ++i) text += fmt::format(",{}{}", i == 10 ? "\n" : " ", element[i] + 1);
        text += "\n";
      }
      text += fmt::format("*MATERIAL, NAME=M{0}\n{1}*SOLID SECTION, ELSET=LAYER{0}, MATERIAL=M{0}\n", layer,
                          calculix_material({layers_[layer].young, 0.3}));
    }
    text += "*BOUNDARY\n";
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      const Vec3& x = nodes_[node];
      if (x.z() < 1e-9 - 40.0) text += fmt::format("{}, 1, 3\n", node + 1);
      if (x.z() < 1e-9 - 40.0) continue;
      if (x.x() == 0.0) text += fmt::format("{}, 1, 1\n", node + 1);
      if (x.y() == 0.0) text += fmt::format("{}, 2, 2\n", node + 1);
    }
    text += "*STEP\n*STATIC\n*CLOAD\n";
    for (const auto& [node, share] : load_) text += fmt::format("{}, 3, {:.12g}\n", node + 1, -0.25 * share);
    return text + "*NODE PRINT, NSET=ALL\nU\n*END STEP\n";
  }

  std::vector<BlockLayer> layers_;
  double radius_;
  std::vector<double> across_{0.0}, down_{0.0};  // mm from the middle, from the top
  std::vector<std::size_t> layer_of_;            // between two planes
  std::map<Place, std::size_t> names_;
  std::vector<Vec3> nodes_;
  std::vector<std::vector<std::array<std::size_t, 20>>> elements_;  // by layer
  std::map<std::size_t, double> load_;                              // share of the whole force
};

}  // namespace bodkin::checks

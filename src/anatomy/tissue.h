#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/acoustic_tissue.h"
#include "anatomy/physical_tissue.h"
#include "anatomy/tissue_forces.h"

namespace bodkin::anatomy {

// The tissue of a voxel, as far as a needle can feel it. Values 0 to 31 are Bodkin's own and fixed; a tissue library
// may define more, 32 to 254. 255 is never a tissue.
using TissueId = std::uint8_t;

namespace tissue {
inline constexpr TissueId air = 0;
inline constexpr TissueId skin = 1;
inline constexpr TissueId fat = 2;
inline constexpr TissueId muscle = 3;
inline constexpr TissueId soft = 4;  // soft tissue that is not classified further
inline constexpr TissueId cortical_bone = 5;
inline constexpr TissueId cancellous_bone = 6;
inline constexpr TissueId disc = 7;
inline constexpr TissueId supraspinous_ligament = 8;
inline constexpr TissueId interspinous_ligament = 9;
inline constexpr TissueId ligamentum_flavum = 10;
inline constexpr TissueId epidural_fat = 11;  // the epidural space
inline constexpr TissueId dura = 12;          // dura with arachnoid
inline constexpr TissueId cerebrospinal_fluid = 13;
inline constexpr TissueId nerve = 14;  // nerve roots, including the cauda equina
inline constexpr TissueId vessel = 15;
inline constexpr TissueId organ = 16;
inline constexpr TissueId lung = 17;
inline constexpr TissueId gas = 18;  // inside the body: bowel gas
inline constexpr TissueId metal = 19;
inline constexpr TissueId mass = 20;  // a lesion, the target of a biopsy
inline constexpr TissueId cartilage = 21;
inline constexpr TissueId spinal_cord = 22;  // with its lower end, the conus medullaris
inline constexpr int count = 23;
}  // namespace tissue

// One tissue of the library.
struct TissueProperties {
  TissueId id = tissue::air;
  std::string name;                 // as case files write it: "ligamentum_flavum"
  std::string title;                // as people read it: "ligamentum flavum"
  std::uint32_t colour = 0x000000;  // 0xRRGGBB, of overlays and bands
  double hounsfield = 0.0;
  double hounsfield_noise = 0.0;
  LayeredTissue layered;
  TrackingWallTissue tracking_wall;
  DepthProfileTissue depth_profile;
  VolumeProxyTissue volume_proxy;
  ShaftFrictionTissue shaft_friction;
  SyringeTissue syringe;
  DeformableTissue deformable;
  AcousticTissue acoustic;
  PhysicalTissue physical;
  std::string source;  // where the numbers come from, one line for people

  template <typename S = TissueProperties>
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"id", &S::id, Range{0.0, 254.0}, "", "of the voxels that are made of it", Origin::choice},
        Parameter{"name", &S::name, "as case files write it", Origin::choice},
        Parameter{"title", &S::title, "as people read it", Origin::choice},
        Parameter{"colour", &S::colour, "of overlays and bands", Origin::choice},
        Parameter{"hounsfield_HU", &S::hounsfield, Range{-1024.0, 30000.0}, "HU",
                  "typical of the tissue; the synthetic patient is painted with it", Origin::choice},
        Parameter{"hounsfield_noise_HU", &S::hounsfield_noise, Range{0.0, 1000.0}, "HU",
                  "standard deviation inside one tissue", Origin::choice},
        Parameter{"source", &S::source, "where the numbers come from", Origin::choice},
        ChildElement{"layered", &S::layered, "of the resistance `layered`"},
        ChildElement{"tracking_wall", &S::tracking_wall, "of the resistance `tracking_wall`"},
        ChildElement{"depth_profile", &S::depth_profile, "of the resistance `depth_profile`"},
        ChildElement{"volume_proxy", &S::volume_proxy, "of the resistance `volume_proxy`"},
        ChildElement{"shaft_friction", &S::shaft_friction, "of the resistance and part `shaft_friction`"},
        ChildElement{"syringe", &S::syringe, "against a fluid pushed out of the tip"},
        ChildElement{"deformable", &S::deformable, "of the deformable body"},
        ChildElement{"acoustic", &S::acoustic, "of ultrasound"},
        ChildElement{"physical", &S::physical, "to a needle, whatever the model"}};
  }
};

// The tissues that a case knows, by id and by name.
class TissueLibrary {
 public:
  TissueLibrary() = default;
  // Throws InputError when two tissues share an id or a name, or when id 255 is used.
  explicit TissueLibrary(std::vector<TissueProperties> tissues);

  const std::vector<TissueProperties>& tissues() const { return tissues_; }
  // nullptr for an unknown id or name.
  const TissueProperties* find(TissueId id) const noexcept {
    return by_id_[id] < 0 ? nullptr : &tissues_[static_cast<std::size_t>(by_id_[id])];
  }
  const TissueProperties* find(std::string_view name) const noexcept;
  // One property of every tissue by id; `absent` for ids without an entry. For models that read it each tick.
  template <typename Property>
  std::array<Property, 256> by_id(Property TissueProperties::*property, const Property& absent = {}) const {
    std::array<Property, 256> table;  // 256, by TissueId
    table.fill(absent);
    for (const TissueProperties& tissue : tissues_) table[tissue.id] = tissue.*property;
    return table;
  }
  // Title of a tissue, or "tissue N" for an id without an entry.
  std::string title(TissueId id) const;

 private:
  std::vector<TissueProperties> tissues_;
  std::vector<int> by_id_ = std::vector<int>(256, -1);  // 256: position in tissues_, or -1
};

}  // namespace bodkin::anatomy

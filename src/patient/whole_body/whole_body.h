#pragma once

#include <optional>

#include "patient/whole_body/body_shape.h"
#include "patient/whole_body/body_tissues.h"

#include "anatomy/tissue.h"
#include "anatomy/volume.h"
#include "core/progress.h"

namespace bodkin::patient {

// The part of a body to generate, and its resolution.
struct BodyBlock {
  std::optional<Vec3> middle;  // LPS mm; empty: the whole body
  double width = 200.0;        // mm, of the cube about `middle`, 40 to 400
  double spacing = 4.0;        // mm, isotropic voxels; 3 to 8 for the whole body, 0.8 to 3 for a block
};

// The tissues of a body or of a part. The same parameters give the same voxels on every machine. Throws InputError
// for a size or spacing out of range.
anatomy::TissueVolume body_volume(const BodyShape& shape, const BodyTissues& tissues, const BodyBlock& block,
                                  const Progress& progress = {});

}  // namespace bodkin::patient

#include "patient/from_ct/morphology.h"

#include <algorithm>

#include <itkConnectedComponentImageFilter.h>
#include <itkImage.h>
#include <itkRelabelComponentImageFilter.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

namespace bodkin::patient {
namespace {

using MaskImage = itk::Image<std::uint8_t, 3>;
using PieceImage = itk::Image<std::uint32_t, 3>;
using DistanceImage = itk::Image<float, 3>;

MaskImage::Pointer to_itk(const MaskVolume& mask) {
  auto image = MaskImage::New();
  MaskImage::SizeType size;
  MaskImage::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<itk::SizeValueType>(mask.grid.size[axis]);
    spacing[axis] = mask.grid.spacing[static_cast<int>(axis)];
  }
  image->SetRegions(MaskImage::RegionType(size));
  image->SetSpacing(spacing);
  image->Allocate();
  std::copy(mask.voxels.begin(), mask.voxels.end(), image->GetBufferPointer());
  return image;
}

template <typename Image>
anatomy::Volume<typename Image::PixelType> from_itk(const Image& image, const anatomy::Grid& grid) {
  anatomy::Volume<typename Image::PixelType> volume;
  volume.grid = grid;
  volume.voxels.assign(image.GetBufferPointer(), image.GetBufferPointer() + grid.voxel_count());
  return volume;
}

}  // namespace

anatomy::Volume<float> signed_distance(const MaskVolume& mask) {
  auto filter = itk::SignedMaurerDistanceMapImageFilter<MaskImage, DistanceImage>::New();
  filter->SetInput(to_itk(mask));
  filter->SetUseImageSpacing(true);
  filter->SetSquaredDistance(false);
  filter->SetInsideIsPositive(false);
  filter->Update();
  return from_itk(*filter->GetOutput(), mask.grid);
}

anatomy::Volume<std::uint32_t> number_pieces(const MaskVolume& mask) {
  auto pieces = itk::ConnectedComponentImageFilter<MaskImage, PieceImage>::New();
  pieces->SetInput(to_itk(mask));
  auto ordered = itk::RelabelComponentImageFilter<PieceImage, PieceImage>::New();
  ordered->SetInput(pieces->GetOutput());
  ordered->Update();
  return from_itk(*ordered->GetOutput(), mask.grid);
}

MaskVolume largest_piece(const MaskVolume& mask) {
  const auto pieces = number_pieces(mask);
  MaskVolume largest(mask.grid);
  std::transform(pieces.voxels.begin(), pieces.voxels.end(), largest.voxels.begin(),
                 [](std::uint32_t piece) { return static_cast<std::uint8_t>(piece == 1 ? 1 : 0); });
  return largest;
}

}  // namespace bodkin::patient

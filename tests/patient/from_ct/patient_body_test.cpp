#include "patient/from_ct/tissue_lattice.h"
#include "tests/patient/from_ct/patient_crossing.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

// The lattice of tissues, the surface of the body and the classes of HU: on phantoms with a known answer, and on real
// CT with its pitfalls.

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::io;
using namespace bodkin::patient;
namespace {

using test::crossings;
using testing::Contains;
using testing::HasSubstr;

Grid lattice(std::array<int, 3> size, Vec3 spacing) {
  Grid grid;
  grid.size = size;
  grid.spacing = spacing;
  grid.direction = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  grid.origin = Vec3(10, -20, 30);
  return grid;
}

TEST(PatientLattice, voxels_are_cut_into_whole_parts_no_longer_than_wished) {
  const TissueLattice fine = divide_lattice(lattice({100, 90, 50}, Vec3(0.976562, 1.5, 3.27)), 1.0);
  EXPECT_EQ(fine.parts, (std::array<int, 3>{1, 2, 4}));
  EXPECT_EQ(fine.grid.size, (std::array<int, 3>{100, 180, 200}));
  EXPECT_EQ(divide_lattice(lattice({9, 9, 9}, Vec3(3, 1.04, 1.06)), 1.0).parts, (std::array<int, 3>{3, 1, 2}));
}

TEST(PatientLattice, faces_of_ct_voxels_stay_faces_of_tissue_voxels) {
  const Grid ct = lattice({10, 11, 12}, Vec3(3.0, 1.5, 0.7));
  const TissueLattice fine = divide_lattice(ct, 1.0);
  const Vec3 low = ct.to_patient(Vec3::Constant(-0.5));
  EXPECT_LT((fine.grid.to_patient(Vec3::Constant(-0.5)) - low).norm(), 1e-9);
  const Vec3 high = ct.to_patient(Vec3(9.5, 10.5, 11.5));
  EXPECT_LT((fine.grid.to_patient(Vec3(29.5, 21.5, 11.5)) - high).norm(), 1e-9);
}

TEST(PatientLattice, a_large_image_is_divided_less) {
  const TissueLattice fine = divide_lattice(lattice({512, 512, 400}, Vec3(1.2, 1.2, 3.0)), 1.0);
  EXPECT_LE(fine.grid.voxel_count(), 200'000'000U);
  EXPECT_GE(fine.grid.voxel_count(), lattice({512, 512, 400}, Vec3::Ones()).voxel_count());
}

// A body of fat, 140 by 90 mm, with a muscle core, on a couch, beside an arm; a bubble of gas inside.
CtVolume phantom(bool couch_touches) {
  Grid grid;
  grid.size = {120, 90, 30};
  grid.spacing = Vec3(2, 2, 2);
  CtVolume ct(grid, -1000);
  for (int k = 0; k < 30; ++k) {
    for (int j = 0; j < 90; ++j) {
      for (int i = 0; i < 120; ++i) {
        const Vec3 p = grid.to_patient(Vec3(i, j, k));
        const double body = std::pow((p.x() - 110) / 70, 2) + std::pow((p.y() - 70) / 45, 2);
        std::int16_t& voxel = ct.at(i, j, k);
        if (body < 1.0) voxel = body < 0.5 ? 40 : -100;
        if ((p - Vec3(110, 60, 30)).norm() < 12) voxel = -1000;
        if (std::hypot(p.x() - 215, p.y() - 70) < 18) voxel = 40;
        const double couch = couch_touches ? 116 : 130;
        if (p.y() >= couch && p.y() < couch + 4) voxel = 100;
      }
    }
  }
  return ct;
}

TEST(PatientBody, skin_covers_the_body_and_nothing_else) {
  for (const bool touches : {false, true}) {
    const BuiltPatient patient = build_patient(phantom(touches), {}, {}, {}, {});
    const Grid& grid = patient.tissues.grid;
    int skin = 0;
    for (int k = 0; k < grid.size[2]; ++k) {
      for (int j = 0; j < grid.size[1]; ++j) {
        for (int i = 0; i < grid.size[0]; ++i) {
          const TissueId id = patient.tissues.at(i, j, k);
          const Vec3 p = grid.to_patient(Vec3(i, j, k));
          const double body = std::pow((p.x() - 110) / 70, 2) + std::pow((p.y() - 70) / 45, 2);
          if (std::hypot(p.x() - 215, p.y() - 70) < 20) {
            EXPECT_EQ(id, tissue::air) << "arm at " << p.transpose();
          }
          if (p.y() > 126) {
            EXPECT_EQ(id, tissue::air) << "couch at " << p.transpose();
          }
          if (body < 0.85) {
            EXPECT_NE(id, tissue::skin) << "deep at " << p.transpose();
          }
          if (body < 0.85) {
            EXPECT_NE(id, tissue::air) << "gas is inside at " << p.transpose();
          }
          if (id == tissue::skin) ++skin;
        }
      }
    }
    // Circumference of the ellipse 365 mm, height 60 mm, 2 mm thick.
    EXPECT_NEAR(skin * grid.spacing.prod() / (365.0 * 60.0), 2.0, 0.6) << "couch touches: " << touches;
    EXPECT_THAT(patient.notes, Contains(HasSubstr("were left out")));
    EXPECT_THAT(patient.notes, Contains(HasSubstr("(foot, head)")));
    EXPECT_FALSE(patient.path.has_value());
    EXPECT_THAT(patient.notes, Contains(HasSubstr("No path was planned")));
  }
}

TEST(PatientBody, classes_follow_hounsfield) {
  const BuiltPatient patient = build_patient(phantom(false), {}, {}, {}, {});
  const auto way = crossings(patient.tissues, {Vec3(110, 113.9, 20), Vec3(110, 70, 20)});
  ASSERT_GE(way.size(), 3U);
  EXPECT_EQ(way[0].tissue, tissue::skin);
  EXPECT_NEAR(way[0].to, 2.0, 1.0);
  EXPECT_EQ(way[1].tissue, tissue::fat);
  EXPECT_NEAR(way[1].to, 45.0 * (1.0 - std::sqrt(0.5)), 1.5);
  EXPECT_EQ(way[2].tissue, tissue::muscle);
  EXPECT_EQ(nearest(patient.tissues, Vec3(110, 60, 30), tissue::air), tissue::gas);
}

TEST(PatientBody, noise_does_not_make_tissues_flicker) {
  CtVolume ct = phantom(false);
  std::uint64_t state = 7;
  for (std::int16_t& voxel : ct.voxels) {
    int sum = 0;  // near normal, standard deviation 15 HU
    for (int n = 0; n < 12; ++n)
      state = state * 6364136223846793005ULL + 1442695040888963407ULL, sum += static_cast<int>(state >> 58);
    voxel = static_cast<std::int16_t>(voxel + (sum - 378) * 15 / 64);
  }
  const BuiltPatient patient = build_patient(ct, {}, {}, {}, {});
  int wrong = 0, count = 0;
  for (double x = 80; x < 140; x += 0.7) {
    for (double z = 4; z < 50; z += 0.9, ++count) {
      wrong += nearest(patient.tissues, Vec3(x, 84, z), tissue::air) != tissue::muscle ? 1 : 0;
    }
  }
  EXPECT_LT(wrong, count / 500);
}

TEST(PatientBody, labels_say_what_hounsfield_cannot_and_not_what_it_forbids) {
  const CtVolume ct = phantom(false);
  LabelVolume labels(ct.grid);
  const auto fill = [&](Vec3 centre, double radius, std::uint16_t label) {
    for (int k = 0; k < ct.grid.size[2]; ++k) {
      for (int j = 0; j < ct.grid.size[1]; ++j) {
        for (int i = 0; i < ct.grid.size[0]; ++i) {
          if ((ct.grid.to_patient(Vec3(i, j, k)) - centre).norm() < radius) labels.at(i, j, k) = label;
        }
      }
    }
  };
  fill(Vec3(140, 70, 30), 10, 1);
  fill(Vec3(110, 60, 30), 15, 2);  // an organ with gas in it
  fill(Vec3(90, 70, 30), 9, 3);
  const BuiltPatient patient = build_patient(
      ct, labels, {{1, "kidney", "organ", true}, {2, "bowel", "organ", true}, {3, "rib", "bone", false}}, {}, {});
  EXPECT_EQ(nearest(patient.tissues, Vec3(140, 70, 30), tissue::air), tissue::organ);
  EXPECT_EQ(nearest(patient.tissues, Vec3(110, 60, 30), tissue::air), tissue::gas);
  EXPECT_EQ(nearest(patient.tissues, Vec3(90, 70, 30), tissue::air), tissue::cancellous_bone);
  const auto way = crossings(patient.tissues, {Vec3(90, 90, 30), Vec3(90, 70, 30)});
  EXPECT_EQ(way[1].tissue, tissue::cortical_bone) << "the shell of a labelled bone is cortical";
  EXPECT_THROW(build_patient(ct, labels, {{1, "kidney", "cheese", true}}, {}, {}), InputError);
}

TEST(PatientBody, an_image_without_a_body_is_refused) {
  Grid grid;
  grid.size = {40, 40, 20};
  EXPECT_THROW(build_patient(CtVolume(grid, -1000), {}, {}, {}, {}), InputError);
}

TEST(PatientBody, an_image_inside_the_body_has_no_skin) {
  Grid grid;
  grid.size = {50, 50, 30};
  grid.spacing = Vec3(2, 2, 2);
  const BuiltPatient patient = build_patient(CtVolume(grid, 40), {}, {}, {}, {});
  EXPECT_THAT(patient.tissues.voxels, testing::Each(tissue::muscle));
  EXPECT_THAT(patient.notes, Contains(HasSubstr("no skin")));
}

TEST(PatientBody, the_arms_and_the_couch_of_the_thorax_have_no_skin) {
  BODKIN_REQUIRE_DATA(data);
  const auto patient =
      test::build_real(data, "dicom_ct_thoracolumbar_j2k/series", "dicom_ct_thoracolumbar_j2k/labels.nii.gz",
                       read_label_scheme("totalsegmentator"));
  const Grid& grid = patient.ct.grid;
  int humerus = 0, skin = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const TissueId id = nearest(patient.built.tissues, grid.to_patient(Vec3(i, j, k)), tissue::air);
        skin += id == tissue::skin ? 1 : 0;
        const std::uint16_t label = patient.labels.at(i, j, k);
        if (label != 69 && label != 70) continue;
        ++humerus;
        // Not skin, and no skin within 40 mm of the bone: the arm is not body at all.
        ASSERT_EQ(id, tissue::air);
        for (int step = -40; step <= 40; step += 2) {
          ASSERT_NE(
              nearest(patient.built.tissues, Vec3(grid.to_patient(Vec3(i, j, k)) + Vec3(0, step, 0)), tissue::air),
              tissue::skin);
        }
      }
    }
  }
  EXPECT_GT(humerus, 1000);
  // The trunk's circumference is about 1.1 m, 40 mm high. Its skin is 2 mm thick at least, and as thick as the dermis
  // that the CT shows over subcutaneous fat: 2 to 3 mm on the back.
  const double thickness = skin * grid.spacing.prod() / (1100.0 * 40.0);
  EXPECT_GT(thickness, 1.8);
  EXPECT_LT(thickness, 3.2);
  // The couch lies more than 20 mm behind the skin of the back.
  const Vec3 back = patient.built.tissues.grid.to_patient(Vec3(256, 405, 20));
  EXPECT_EQ(nearest(patient.built.tissues, Vec3(back + Vec3(0, 25, 0)), tissue::skin), tissue::air);
}

TEST(PatientBody, the_couch_behind_the_lumbosacral_spine_is_no_body) {
  BODKIN_REQUIRE_DATA(data);
  const auto patient = test::build_real(data, "dicom_ct_lumbosacral/series", "", {});
  const Grid& grid = patient.built.tissues.grid;
  int couch = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 p = grid.to_patient(Vec3(i, j, k));
        // The two lines of the couch: the air between them and the back is about y = 148 at the midline.
        if (p.y() < 150.0 || p.x() > 60.0) continue;
        ASSERT_EQ(patient.built.tissues.at(i, j, k), tissue::air) << p.transpose();
        couch += linear(patient.ct, p, -1000.0) > -300.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(couch, 1000) << "the couch is in the image";
  EXPECT_THAT(patient.built.notes, Contains(HasSubstr("were left out")));
}

TEST(PatientBody, labelled_lung_is_inside_though_the_image_cuts_it_open) {
  BODKIN_REQUIRE_DATA(data);
  const auto whole =
      test::build_real(data, "lung_mha/lung_ct.mha", "lung_mha/lung_mask.mha", {{1, "lung", "lung", true}});
  int lung = 0, right = 0;
  for (int k = 0; k < whole.ct.grid.size[2]; k += 2) {
    for (int j = 0; j < whole.ct.grid.size[1]; j += 2) {
      for (int i = 0; i < whole.ct.grid.size[0]; i += 2) {
        if (whole.labels.at(i, j, k) == 0) continue;
        ++lung;
        right += nearest(whole.built.tissues, whole.ct.grid.to_patient(Vec3(i, j, k)), tissue::air) == tissue::lung
                     ? 1
                     : 0;
      }
    }
  }
  EXPECT_GT(right, 0.9 * lung);
  EXPECT_FALSE(whole.built.path.has_value()) << "no lumbar spine here";
}

// Two legs and the gap between them, which reaches the front and back faces but no corner of the image.
CtVolume gap_phantom(double emptiest, double fullest) {
  Grid grid;
  grid.size = {60, 40, 20};
  grid.spacing = Vec3(2.5, 2.5, 2.5);
  CtVolume ct(grid, 40);
  Random random(4);
  for (int k = 0; k < 15; ++k) {
    for (int j = 0; j < 40; ++j) {
      for (int i = 22; i < 38; ++i) ct.at(i, j, k) = static_cast<std::int16_t>(random.uniform(emptiest, fullest));
    }
  }
  return ct;
}

TEST(PatientBody, air_between_two_legs_is_the_room_and_cut_lung_in_its_place_is_not) {
  const Vec3 middle(75, 50, 15);
  const BuiltPatient legs = build_patient(gap_phantom(-1015, -985), {}, {}, {}, {});
  EXPECT_EQ(nearest(legs.tissues, middle, tissue::gas), tissue::air);
  EXPECT_EQ(nearest(legs.tissues, Vec3(52, 50, 15), tissue::gas), tissue::skin);
  const BuiltPatient chest = build_patient(gap_phantom(-1010, -800), {}, {}, {}, {});
  EXPECT_EQ(nearest(chest.tissues, middle, tissue::air), tissue::lung);
  EXPECT_EQ(std::count(chest.tissues.voxels.begin(), chest.tissues.voxels.end(), tissue::skin), 0);
  EXPECT_THAT(chest.notes, Contains(HasSubstr("no skin")));
}

template <typename Voxel>
Volume<Voxel> crop(const Volume<Voxel>& whole, std::array<int, 3> low, std::array<int, 3> high) {
  Grid grid = whole.grid;
  for (std::size_t axis = 0; axis < 3; ++axis) grid.size[axis] = high[axis] - low[axis];
  grid.origin = whole.grid.to_patient(Vec3(low[0], low[1], low[2]));
  Volume<Voxel> part(grid);
  for (int k = 0; k < grid.size[2]; ++k) {
    for (int j = 0; j < grid.size[1]; ++j) {
      for (int i = 0; i < grid.size[0]; ++i) part.at(i, j, k) = whole.at(i + low[0], j + low[1], k + low[2]);
    }
  }
  return part;
}

TEST(PatientBody, unlabelled_lung_that_the_image_cuts_open_is_lung_and_has_no_skin) {
  BODKIN_REQUIRE_DATA(data);
  const CtVolume ct = read_ct(data / "lung_mha/lung_ct.mha").ct;
  const LabelVolume mask =
      place_labels(read_labels(data / "lung_mha/lung_mask.mha"), ct.grid, false, "lung_mask.mha").labels;
  const std::array<std::pair<std::array<int, 3>, std::array<int, 3>>, 3> boxes = {{
      {{0, 0, 0}, {115, 157, 129}},   // whole: cut on the left, at its root
      {{0, 0, 20}, {70, 157, 60}},    // through the middle of the lung, sagittally
      {{0, 40, 20}, {115, 157, 60}},  // coronally
  }};
  for (const auto& [low, high] : boxes) {
    SCOPED_TRACE(testing::PrintToString(low) + " to " + testing::PrintToString(high));
    const CtVolume part = crop(ct, low, high);
    const LabelVolume labels = crop(mask, low, high);
    PatientOptions options;
    options.tissue_spacing = 2.5;
    const BuiltPatient built = build_patient(part, {}, {}, options, {});
    int count = 0, lung = 0, air = 0, skin = 0;
    for (int k = 0; k < part.grid.size[2]; k += 2) {
      for (int j = 0; j < part.grid.size[1]; j += 2) {
        for (int i = 0; i < part.grid.size[0]; i += 2) {
          if (labels.at(i, j, k) == 0) continue;
          const TissueId id = nearest(built.tissues, part.grid.to_patient(Vec3(i, j, k)), tissue::air);
          ++count;
          lung += id == tissue::lung ? 1 : 0;
          air += id == tissue::air ? 1 : 0;
          skin += id == tissue::skin ? 1 : 0;
        }
      }
    }
    EXPECT_GT(count, 10000);
    EXPECT_GT(lung, 0.85 * count);
    EXPECT_EQ(air, 0);
    EXPECT_EQ(skin, 0);
    EXPECT_THAT(built.tissues.voxels, Contains(tissue::skin)) << "the breast still has it";
  }
}

TEST(PatientBody, gas_in_the_bowel_behind_a_thin_wall_is_gas_and_neither_air_nor_lung) {
  BODKIN_REQUIRE_DATA(data);
  const auto patient = test::build_real(data, "abdomen/abdomen_ct.nii.gz", "", {});
  const LabelVolume labels =
      place_labels(read_labels(data / "abdomen/abdomen_labels.nii.gz"), patient.ct.grid, false, "labels").labels;
  constexpr std::uint16_t colon = 20;
  int count = 0, gas = 0;
  for (int k = 0; k < patient.ct.grid.size[2]; ++k) {
    for (int j = 0; j < patient.ct.grid.size[1]; ++j) {
      for (int i = 0; i < patient.ct.grid.size[0]; ++i) {
        if (labels.at(i, j, k) != colon || patient.ct.at(i, j, k) > -700) continue;
        ++count;
        gas += nearest(patient.built.tissues, patient.ct.grid.to_patient(Vec3(i, j, k)), tissue::air) == tissue::gas;
      }
    }
  }
  EXPECT_GT(count, 1000);
  EXPECT_GT(gas, 0.99 * count);
}

// A block of a body: 30 mm of air behind it (high y), then `dermis` mm as dense as muscle, fat, muscle.
CtVolume layered_back(double dermis, double fat) {
  Grid grid;
  grid.size = {80, 100, 60};
  grid.spacing = Vec3::Ones();
  CtVolume ct(grid, -1000);
  for (int k = 0; k < 60; ++k) {
    for (int j = 5; j < 70; ++j) {
      const double depth = 70.0 - j;
      const std::int16_t value = depth <= dermis ? 40 : depth <= dermis + fat ? -100 : 50;
      for (int i = 0; i < 80; ++i) ct.at(i, j, k) = value;
    }
  }
  return ct;
}

TEST(PatientBody, dermis_over_fat_is_skin_and_muscle_without_fat_is_not) {
  const auto tissue_at_depth = [](const CtVolume& ct, double depth) {
    const BuiltPatient built = build_patient(ct, {}, {}, {}, {});
    return nearest(built.tissues, Vec3(40.0, 69.5 - depth, 30.0), tissue::air);
  };
  const CtVolume thick = layered_back(5.0, 15.0);
  EXPECT_EQ(tissue_at_depth(thick, 1.0), tissue::skin);
  EXPECT_EQ(tissue_at_depth(thick, 4.0), tissue::skin) << "dermis, not muscle";
  EXPECT_EQ(tissue_at_depth(thick, 10.0), tissue::fat);
  EXPECT_EQ(tissue_at_depth(layered_back(30.0, 10.0), 4.0), tissue::muscle) << "nothing but muscle under thin skin";
}

}  // namespace
}  // namespace bodkin

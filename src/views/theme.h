#pragma once

#include <QColor>
#include <QFont>
#include <QString>

#include "anatomy/tissue.h"

namespace bodkin::views {

// Colours and sizes of everything that the window draws. Images of the patient stay dark in the light theme, because
// grey levels are judged against black: they use Theme::dark().
struct Theme {
  QColor ground, panel, raised, line;
  QColor text, second;
  QColor accent;  // call to action
  QColor plan;    // planned path and target
  QColor caution, danger, good;
  bool is_dark = true;

  static const Theme& dark();
  static const Theme& light();
  // The one in use.
  static const Theme& now();
  static void use(bool dark);

  // Of the whole application.
  QString style_sheet() const;
};

// Planes of the slices.
inline const QColor axial_colour{0xFF, 0x5A, 0x52}, sagittal_colour{0xF2, 0xC8, 0x2E},
    coronal_colour{0x4F, 0xC1, 0x5A}, along_colour{0x4D, 0xA3, 0xFF};
// The needle.
inline const QColor steel{0xE9, 0xED, 0xF2}, hub_colour{0x2A, 0x2F, 0x36}, fiftieth_mark{0xFF, 0x95, 0x1E};
// Path and curve of a second session.
inline const QColor second_session_colour{0xFF, 0x95, 0xD5};
// Skin in 3-D keeps a natural tone.
inline const QColor natural_skin{0xE0, 0xB5, 0x96};

inline constexpr int corner = 6, grid = 4;                                                  // pixels
inline constexpr int label_size = 11, text_size = 13, heading_size = 15, number_size = 22;  // pixels

// Digits of one width. `pixels`: label_size and so on; never below 11.
QFont font(int pixels, bool strong = false);

// Colours in which neighbours can be distinguished with any colour vision (least CIEDE2000 of tissues that touch:
// 15.6 over normal, protan, deutan and tritan vision); a tissue that is not Bodkin's own has the colour of its
// library.
QColor tissue_colour(anatomy::TissueId id, const anatomy::TissueLibrary& library);

}  // namespace bodkin::views

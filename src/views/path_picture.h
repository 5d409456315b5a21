#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "scene/marks.h"
#include "views/frame.h"

namespace bodkin::views {

// The path of the tip without anatomy, for a session whose patient is not available: from the patient's left and from
// behind, to one scale, with the plan and the needle at the selected time.
class PathPicture : public QWidget {
 public:
  explicit PathPicture(QWidget* parent = nullptr);

  void set_trails(std::shared_ptr<const std::vector<scene::Trail>> trails);
  void show_frame(const Frame& frame);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const std::vector<scene::Trail>> trails_;
  std::optional<anatomy::NeedlePath> plan_;
  std::optional<Pose> needle_;
};

}  // namespace bodkin::views

// Layout and connections of the widgets of the page for augmented reality.
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/pages/camera.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr int camera_gap = 6, camera_margin = 12, camera_side = 400, camera_panel = 214;  // pixels
constexpr int camera_row = 22, body_columns = 6, table_width = 330;
constexpr int least_oval = 40, most_oval = 200, usual_oval = 100;              // percent of the usual one
constexpr int least_threshold = 0, most_threshold = 99, usual_threshold = 70;  // percent of its radius

template <typename Widget>
Widget* named(Widget* widget, const char* name, const QString& text, const QString& tip) {
  widget->setObjectName(QLatin1String(name));
  widget->setAccessibleName(text);
  widget->setToolTip(tip);
  return widget;
}

}  // namespace

CameraPage::CameraPage(const std::filesystem::path& folder, QWidget* parent)
    : Page(PageId::camera, KeyScope::camera, true, parent),
      folder_(folder),
      picture_(named(new CameraPicture, "camera.picture", tr("The camera's picture"),
                     tr("The patient drawn into the mannequin, the needle, the planned path"))),
      ultrasound_(named(new UltrasoundView, "camera.ultrasound", tr("Ultrasound"),
                        tr("The ultrasound of where the tracked probe points"))) {
  connect(picture_, &CameraPicture::painted, this, &CameraPage::note_latency);
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4);
  auto* left = new QVBoxLayout;
  left->setSpacing(0);
  left->addWidget(picture_, 1);
  left->addWidget(make_panel());
  columns->addLayout(left, 1);
  columns->addWidget(make_side());
}

QWidget* CameraPage::make_side() {
  auto* side = new QWidget;
  side->setFixedWidth(camera_side);
  auto* rows = new QVBoxLayout(side);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  rows->addWidget(ultrasound_, 4);
  ct_ = named(new CameraPicture, "camera.ct", tr("CT where the probe points"),
              tr("The patient's CT in the plane of the tracked probe, as the probe presses it"));
  ct_->show_words(ct_->accessibleName());
  rows->addWidget(ct_, 3);
  auto* small = new QHBoxLayout;
  small->setSpacing(4);
  auto measures = std::make_shared<Measures>();
  const std::array kinds = {std::pair{SliceKind::coronal, "camera.slice.coronal"},
                            std::pair{SliceKind::sagittal, "camera.slice.sagittal"}};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    slices_[i] = named(new SliceView(kinds[i].first), kinds[i].second, tr("CT at the tip"),
                       tr("The patient's CT with a crosshair at the tip of the tracked needle"));
    slices_[i]->set_measures(measures);
    small->addWidget(slices_[i], 1);
  }
  rows->addLayout(small, 3);
  return side;
}

QLineEdit* CameraPage::make_file(const char* name, const QString& text, const QString& tip) {
  auto* made = named(new QLineEdit, name, text, tip);
  made->setPlaceholderText(tr("as in the folder"));
  return made;
}

QWidget* CameraPage::make_panel() {
  auto* panel = new QWidget;
  panel->setObjectName(QStringLiteral("panel"));
  panel->setAttribute(Qt::WA_StyledBackground);
  panel->setFixedHeight(camera_panel);
  auto* columns = new QHBoxLayout(panel);
  columns->setContentsMargins(camera_margin, camera_gap, camera_margin, camera_gap);
  columns->setSpacing(camera_margin);

  auto* form = new QGridLayout;
  form->setSpacing(camera_gap);
  const auto button = [](const char* name, const QString& text, const QString& tip) {
    auto* made = named(new QPushButton(text), name, text, tip);
    made->setFocusPolicy(Qt::NoFocus);
    return made;
  };
  source_ = named(new QComboBox, "camera.source", tr("Pictures"), tr("A camera (/dev/video0), a video, or a folder"));
  source_->setEditable(true);
  source_->setInsertPolicy(QComboBox::NoInsert);
  source_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (const QString& each : QDir(QStringLiteral("/dev")).entryList({QStringLiteral("video*")}, QDir::System))
    source_->addItem(QStringLiteral("/dev/") + each);
  paths_[camera] = make_file("camera.calibration", tr("Calibration"), tr("camera.json of 'bodkin camera calibrate'"));
  paths_[bodies] = make_file("camera.bodies", tr("Bodies"), tr("bodies.json of 'bodkin markers'"));
  paths_[registration] =
      make_file("camera.registration", tr("Registration"),
                tr("registration.json of 'bodkin register'; empty: the entry of the path lies on the back"));
  paths_[registration]->setPlaceholderText(tr("as in rendered footage"));
  form->addWidget(new QLabel(source_->accessibleName()), 0, 0);
  form->addWidget(source_, 0, 1);
  auto* browse = button("camera.browse", tr("..."), tr("A folder of pictures, or a video"));
  connect(browse, &QPushButton::clicked, this, &CameraPage::choose_source);
  form->addWidget(browse, 0, 2);
  for (int i = 0; i < files; ++i) {
    form->addWidget(new QLabel(paths_[i]->accessibleName()), i + 1, 0);
    form->addWidget(paths_[i], i + 1, 1);
    const QByteArray name = paths_[i]->objectName().toLatin1() + ".browse";
    auto* find = button(name.constData(), tr("..."), paths_[i]->toolTip());
    connect(find, &QPushButton::clicked, this, [this, i] { choose_file(static_cast<File>(i)); });
    form->addWidget(find, i + 1, 2);
  }
  form->setColumnStretch(1, 1);
  auto* buttons = new QHBoxLayout;
  start_ = button("camera.start", tr("Start"), tr("Show the pictures (Space)"));
  pause_ = button("camera.pause", tr("Pause"), tr("Hold this picture, or continue (Space)"));
  pause_->setCheckable(true);
  render_ = button("camera.demo", tr("Demonstration"), tr("Needs no camera: its pictures are rendered once"));
  record_ =
      button("camera.record", tr("Record"),
             tr("Record a session with the tracked needle, which is judged and kept; press again to end it (R)"));
  review_ = button("camera.review", tr("Review"), tr("See the session again, moment by moment"));
  connect(record_, &QPushButton::clicked, this, &CameraPage::record);
  connect(review_, &QPushButton::clicked, this, [this] {
    if (result_) emit patient_requested(QString::fromStdString(result_->session.string()));
  });
  connect(start_, &QPushButton::clicked, this, [this] { watch_ == nullptr ? start() : stop(); });
  connect(pause_, &QPushButton::clicked, this, [this] { press(QKeySequence(Qt::Key_Space)); });
  connect(render_, &QPushButton::clicked, this, &CameraPage::start_demo);
  for (QPushButton* each : {start_, pause_, render_, record_, review_}) buttons->addWidget(each);
  form->addLayout(buttons, files + 1, 0, 1, 3);
  columns->addLayout(form, 3);

  auto* side = new QVBoxLayout;
  side->setSpacing(camera_gap);
  table_ = named(new QTableWidget(0, body_columns), "camera.bodies.table", tr("How well each body is seen"),
                 tr("mm: standard deviation of its tip. Misfit: the part of the markers' contrast that is left over. "
                    "Edges: misfit at the markers' edges divided by that on flat parts, large when motion, lens or "
                    "folding do not fit"));
  table_->setHorizontalHeaderLabels({tr("Body"), tr("Seen"), tr("mm"), tr("Misfit"), tr("Edges"), tr("Markers")});
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(camera_row);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(body_columns - 1, QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setMinimumSectionSize(1);  // no column is kept wider than its share
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->setMinimumWidth(table_width);
  side->addWidget(table_, 1);
  auto* looks = new QGridLayout;
  looks->setSpacing(camera_gap);
  preset_ =
      named(new QComboBox, "camera.preset", tr("What is seen"), tr("What is seen within the mannequin (P: next)"));
  preset_->addItems({tr("Bone"), tr("Soft tissue"), tr("Skin"), tr("Vessels")});
  preset_->setCurrentIndex(1);
  const auto slider = [&](const char* name, const QString& text, const QString& tip, int low, int high, int value) {
    auto* made = named(new QSlider(Qt::Horizontal), name, text, tip);
    made->setRange(low, high);
    made->setValue(value);
    connect(made, &QSlider::valueChanged, this, &CameraPage::send_look);
    return made;
  };
  oval_ = slider("camera.oval", tr("Oval"), tr("Size of the view into the mannequin (+, -)"), least_oval, most_oval,
                 usual_oval);
  threshold_ = slider("camera.threshold", tr("Rim"), tr("How much of the oval is opaque, up to its soft rim"),
                      least_threshold, most_threshold, usual_threshold);
  plan_ = named(new QCheckBox(tr("Path")), "camera.plan", tr("Path"), tr("Draw the planned path and its target"));
  needle_ = named(new QCheckBox(tr("Needle")), "camera.needle", tr("Needle"),
                  tr("Draw the needle in the patient, in the colours of the tissues that it lies in"));
  for (QCheckBox* box : {plan_, needle_}) {
    box->setChecked(true);
    box->setFocusPolicy(Qt::NoFocus);
    connect(box, &QCheckBox::toggled, this, &CameraPage::send_look);
  }
  connect(preset_, qOverload<int>(&QComboBox::currentIndexChanged), this, &CameraPage::send_look);
  looks->addWidget(preset_, 0, 0);
  looks->addWidget(plan_, 0, 1);
  looks->addWidget(needle_, 0, 2);
  looks->addWidget(new QLabel(oval_->accessibleName()), 1, 0);
  looks->addWidget(oval_, 1, 1, 1, 2);
  looks->addWidget(new QLabel(threshold_->accessibleName()), 2, 0);
  looks->addWidget(threshold_, 2, 1, 1, 2);
  side->addLayout(looks);
  line_ = new QLabel;
  line_->setObjectName(QStringLiteral("camera.line"));
  line_->setWordWrap(true);
  line_->setProperty("role", QStringLiteral("second"));
  form->addWidget(line_, files + 2, 0, 1, 3);
  columns->addLayout(side, 2);
  return panel;
}

}  // namespace bodkin::app

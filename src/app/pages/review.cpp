#include "app/pages/review.h"

#include <QDesktopServices>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QStackedWidget>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/models/probe_outline.h"
#include "app/pages/session_list.h"
#include "app/pages/verdict_panel.h"
#include "report/report.h"
#include "views/language.h"
#include "views/theme.h"

#include "core/error.h"
#include "core/files.h"
#include "io/tissue_library_file.h"

namespace bodkin::app {

using namespace views;

namespace {

constexpr double picture_time = 0.04;                 // s that a step moves by
constexpr double other_width = 2.0, own_width = 3.0;  // pixels of the paths

std::uint32_t rgb_of(const QColor& colour) {
  return colour.rgb() & 0xFFFFFFU;
}

const anatomy::TissueLibrary& library_of(const Recording& recording) {
  static const anatomy::TissueLibrary usual = io::default_tissue_library();
  return recording.patient() != nullptr ? recording.patient()->patient.library : usual;
}

}  // namespace

ReviewPage::ReviewPage(std::filesystem::path sessions, QWidget* parent)
    : Page(PageId::review, KeyScope::review, false, parent), folder_(std::move(sessions)) {
  setAcceptDrops(true);
  setFocusPolicy(Qt::StrongFocus);
  build();
  connect(list_, &SessionList::chosen, this, [this](const QString& file) { open(file.toStdString()); });
  connect(list_, &SessionList::file_dialog_requested, this, [this] { choose_file(false); });
  show_list();
}

ReviewPage::~ReviewPage() {
  if (series_ != nullptr) series_->disconnect(this);
}

void ReviewPage::set_case(std::shared_ptr<const OpenCase> patient) {
  at_hand_ = std::move(patient);
}

void ReviewPage::enter() {
  if (recording_ == nullptr && job_ == nullptr) show_list();
}

void ReviewPage::leave() {
  play(false);
  if (series_ != nullptr) series_->cancel();
}

void ReviewPage::show_list() {
  play(false);
  list_->show_sessions(kept_sessions(folder_), folder_);
  stack_->setCurrentWidget(list_);
}

void ReviewPage::open(const std::filesystem::path& file) {
  play(false);
  if (series_ != nullptr) series_->cancel();
  list_->show_message({}, false);
  // An open patient need not be read again.
  const bool has_own = recording_ != nullptr && recording_->patient() != nullptr && at_hand_ == nullptr;
  job_ = std::make_unique<RecordingJob>(file, has_own ? recording_->patient() : at_hand_);
  show_busy();
}

void ReviewPage::compare_with(const std::filesystem::path& file) {
  if (recording_ == nullptr) return open(file);
  other_job_ = std::make_unique<RecordingJob>(file, recording_->patient());
  show_busy();
}

void ReviewPage::stop_comparing() {
  other_.reset();
  chart_->compare_with({});
  compare_->setText(tr("Compare..."));
  show_trails();
  show_lanes();
}

void ReviewPage::take_jobs() {
  if (job_ != nullptr) {
    const RecordingJob::Status status = job_->status();
    if (!status.is_done) return show_busy();
    std::shared_ptr<const Recording> made = job_->recording();
    const QString error = in_words(status.error);
    job_.reset();
    if (made == nullptr) {
      // The previous session remains visible; without one the list shows the reason.
      if (recording_ != nullptr) verdict_->show_message(error, true);
      if (recording_ == nullptr) list_->show_message(error, true);
    } else {
      recording_ = std::move(made);
      show_recording();
    }
    show_busy();
  }
  if (other_job_ == nullptr) return;
  const RecordingJob::Status status = other_job_->status();
  if (!status.is_done) return show_busy();
  std::shared_ptr<const Recording> made = other_job_->recording();
  const QString error = in_words(status.error);
  other_job_.reset();
  show_busy();
  if (made == nullptr) return verdict_->show_message(error, true);
  other_ = std::move(made);
  compare_->setText(tr("Stop comparing"));
  std::vector<station::HandSample> moved(other_->samples().begin(), other_->samples().end());
  for (station::HandSample& sample : moved) sample.time += shift();
  chart_->compare_with(moved);
  show_trails();
  show_lanes();
}

double ReviewPage::shift() const {
  return other_ == nullptr ? 0.0 : recording_->first_contact() - other_->first_contact();
}

void ReviewPage::show_recording() {
  other_.reset();
  compare_->setText(tr("Compare..."));
  const std::shared_ptr<const OpenCase>& patient = recording_->patient();
  view3d_->set_case(patient);
  for (SliceView* slice : slices_) slice->set_case(patient);
  slice_column_->setVisible(patient != nullptr);
  ScanReplay* const scan = recording_->scan();
  scan_.reset();
  arrange_slices(scan != nullptr);
  ultrasound_->set_case(patient);
  if (scan != nullptr) ultrasound_->set_scan(scan->choice(0));
  body_->setCurrentWidget(patient != nullptr ? static_cast<QWidget*>(view3d_) : path_);
  chart_->set_case(patient);
  chart_->compare_with({});
  const session::SessionHeader& header = recording_->session().header;
  title_->setText(
      tr("%1, by %2")
          .arg(QString::fromStdString(recording_->file().stem().string()), in_words(header.operator_name)));
  title_->setToolTip(QString::fromStdString(recording_->file().string()));
  verdict_->show_recording(*recording_);
  differences_.begin(patient, recording_->plan());
  crosshair_.reset();
  curves_stale_ = true;
  show_trails();
  show_lanes();
  stack_->setCurrentIndex(1);
  if (isVisible()) setFocus(Qt::OtherFocusReason);  // what had it is gone with the list
  time_ = recording_->begin();
  frame_ = recording_->frame(0);
  set_speed(1.0);
}

void ReviewPage::show_trails() {
  auto trails = std::make_shared<std::vector<scene::Trail>>();
  if (other_ != nullptr) {
    for (const Recording::PathPiece& piece : other_->path())
      trails->push_back({piece.points, rgb_of(second_session_colour), other_width});
  }
  const anatomy::TissueLibrary& library = library_of(*recording_);
  for (const Recording::PathPiece& piece : recording_->path())
    trails->push_back({piece.points, rgb_of(tissue_colour(piece.tissue, library)), own_width});
  if (scan_) trails->push_back({scan_border(recording_->session(), *scan_), rgb_of(along_colour), other_width});
  path_->set_trails(trails);
  for (SliceView* slice : slices_) slice->set_trails(trails);
  if (!scan_) return view3d_->set_trails(trails);
  auto with_probe = std::make_shared<std::vector<scene::Trail>>(*trails);
  const session::ScanSample& now = recording_->session().scans[*scan_];
  const std::vector<scene::Trail> probe =
      probe_outline(*recording_->session().header.ultrasound, now.settings.depth, now.probe);
  with_probe->insert(with_probe->end(), probe.begin() + 1, probe.end());
  view3d_->set_trails(std::move(with_probe));
}

// The probe at the moment: the border of its image among the paths, and the image.
void ReviewPage::show_scan(Frame& frame) {
  const std::optional<std::size_t> now = scan_at(recording_->session(), time_);
  if (now != scan_) {
    scan_ = now;
    show_trails();
  }
  if (now && recording_->scan() != nullptr) frame.ultrasound = &recording_->scan()->picture(*now, frame.needle);
}

void ReviewPage::show_lanes() {
  const auto lane_of = [](const Recording& recording, const QColor& colour, double moved) {
    Timeline::Lane lane;
    lane.colour = colour;
    const anatomy::TissueLibrary& library = library_of(recording);
    for (const Recording::TissueInterval& interval : recording.tissue_intervals()) {
      const double dt = recording.session().header.dt;
      lane.bands.push_back({recording.time(interval.first) + moved, recording.time(interval.last) + dt + moved,
                            tissue_colour(interval.tissue, library),
                            in_words(recording.tissue_title(interval.tissue))});
    }
    for (const Recording::ShownEvent& each : recording.shown_events())
      lane.events.push_back({each.time + moved, in_words(each.words), each.is_bad});
    return lane;
  };
  std::vector<Timeline::Lane> lanes = {lane_of(*recording_, Theme::now().accent, 0.0)};
  double begin = recording_->begin(), end = recording_->end();
  if (other_ != nullptr) {
    lanes.push_back(lane_of(*other_, second_session_colour, shift()));
    begin = std::min(begin, other_->begin() + shift());
    end = std::max(end, other_->end() + shift());
  }
  timeline_->set_lanes(std::move(lanes), begin, end);
  chart_->set_end_of_time(end);
}

void ReviewPage::play(bool on) {
  if (on && recording_ == nullptr) return;
  if (on && time_ >= recording_->end()) time_ = recording_->begin();
  playing_ = on;
  play_->setText(on ? tr("Pause") : tr("Play"));
}

void ReviewPage::set_speed(double times) {
  speed_ = times;
  for (QPushButton* each : speeds_) each->setChecked(each->property("speed").toDouble() == times);
}

void ReviewPage::seek(double time) {
  if (recording_ == nullptr) return;
  time_ = std::clamp(time, recording_->begin(), recording_->end());
}

void ReviewPage::step(int pictures) {
  play(false);
  seek(time_ + picture_time * pictures);
}

void ReviewPage::step_event(int direction) {
  if (recording_ == nullptr) return;
  play(false);
  const double near = 0.5 * recording_->session().header.dt;
  const std::vector<Recording::ShownEvent>& all = recording_->shown_events();
  if (direction > 0) {
    const auto next =
        std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.time > time_ + near; });
    return seek(next == all.end() ? recording_->end() : next->time);
  }
  const auto last =
      std::find_if(all.rbegin(), all.rend(), [&](const auto& each) { return each.time < time_ - near; });
  seek(last == all.rend() ? recording_->begin() : last->time);
}

void ReviewPage::advance(double clock) {
  const double passed = std::clamp(clock - clock_, 0.0, 0.25);
  clock_ = clock;
  take_jobs();
  if (recording_ == nullptr) return;
  if (series_ != nullptr) {
    series_->advance();
    show_busy();
    return;
  }
  if (playing_) {
    time_ += speed_ * passed;
    if (time_ >= recording_->end()) {
      time_ = recording_->end();
      play(false);
    }
  }
  show_moment(clock);
}

void ReviewPage::show_moment(double clock) {
  const std::size_t index = recording_->index_at(time_);
  frame_ = recording_->frame(index);
  left_needles_ = recording_->left_needles(index);
  frame_.left_needles = left_needles_;
  frame_.clock = clock;
  frame_.follows_tip = !crosshair_;
  if (crosshair_) frame_.crosshair = *crosshair_;
  show_scan(frame_);
  Changes changes = differences_.changes(frame_);
  changes.force = false;
  if (std::exchange(curves_stale_, false)) {
    Frame whole = frame_;
    whole.samples = recording_->samples();
    whole.events = recording_->session().events;
    Changes all = Changes::all();
    chart_->show_frame(whole, all);
    changes = all;
  }
  view3d_->setVisible(recording_->patient() != nullptr);
  if (recording_->patient() != nullptr) {
    view3d_->show_frame(frame_, changes);
    for (SliceView* slice : slices_) slice->show_frame(frame_, changes);
    if (frame_.ultrasound != nullptr) ultrasound_->show_frame(frame_, changes);
  } else if (changes.needle || changes.attempt) {
    path_->show_frame(frame_);
  }
  const double total = frame_.depth > 0.0 || index > 0 ? recording_->samples()[index].force : 0.0;
  const ForceChart::Cursor cursor{time_, frame_.depth, total};
  if (!(shown_cursor_ == cursor)) chart_->set_cursor(cursor);
  shown_cursor_ = cursor;
  timeline_->set_time(time_);
  clock_label_->setText(tr("%1 of %2 s").arg(time_, 0, 'f', 2).arg(recording_->end(), 0, 'f', 1));
  place_->setText(status_words());
}

QString ReviewPage::status_words() const {
  if (frame_.depth <= 0.0) return tr("outside the body");
  return tr("%1, %2 mm")
      .arg(in_words(frame_.warning ? frame_.warning->title : frame_.place))
      .arg(frame_.depth, 0, 'f', 1);
}

void ReviewPage::show_busy() {
  QString words;
  if (job_ != nullptr || other_job_ != nullptr) {
    const RecordingJob::Status status = (job_ != nullptr ? job_ : other_job_)->status();
    words = in_words(status.stage);
  } else if (series_ != nullptr) {
    words = tr("writing, %1 %").arg(static_cast<int>(100.0 * series_->fraction()));
  }
  if (stack_->currentWidget() == list_ && !words.isEmpty()) list_->show_message(words, false);
  busy_->setText(words);
  cancel_->setVisible(!words.isEmpty());
}

bool ReviewPage::press(const QKeySequence& keys) {
  if (recording_ == nullptr || stack_->currentWidget() == list_) return false;
  const QString key = keys.toString(QKeySequence::PortableText);
  if (key == QLatin1String("Space")) return play(!playing_), true;
  if (key == QLatin1String("Left")) return step(-1), true;
  if (key == QLatin1String("Right")) return step(1), true;
  if (key == QLatin1String("Shift+Left")) return step_event(-1), true;
  if (key == QLatin1String("Shift+Right")) return step_event(1), true;
  if (key == QLatin1String("G")) return write_report(), true;
  if (key != QLatin1String(",") && key != QLatin1String(".")) return false;
  auto now = std::find_if(speeds_.begin(), speeds_.end(), [](QPushButton* each) { return each->isChecked(); });
  if (key == QLatin1String(",") && now != speeds_.begin()) set_speed((*--now)->property("speed").toDouble());
  if (key == QLatin1String(".") && now + 1 < speeds_.end()) set_speed((*++now)->property("speed").toDouble());
  return true;
}

void ReviewPage::write_report(bool shown) {
  if (recording_ == nullptr) return;
  try {
    if (recording_->patient() == nullptr || !recording_->score()) {
      throw InputError("The report needs the patient of the session and a planned path; " +
                       (recording_->note().empty() ? recording_->not_judged() : recording_->note()));
    }
    const bool changed = !recording_->note().empty();
    const std::string html =
        report::report_html(recording_->session(), recording_->patient()->patient, *recording_->score(), changed);
    std::filesystem::path file = recording_->file();
    file.replace_extension(".html");
    write_file(file, html);
    const QString name = QString::fromStdString(file.string());
    const bool opened = shown && QDesktopServices::openUrl(QUrl::fromLocalFile(name));
    verdict_->show_message(shown && !opened
                               ? tr("The report is written to %1; no program here opens HTML pages.").arg(name)
                               : tr("The report is written to %1.").arg(name),
                           false);
  } catch (const std::exception& error) {
    verdict_->show_message(in_words(error.what()), true);
  }
}

void ReviewPage::save_series(const QString& target, bool is_video, double rate) {
  if (recording_ == nullptr || series_ != nullptr) return;
  play(false);
  const double begin = recording_->begin(), before = time_;
  const int count = 1 + static_cast<int>((recording_->end() - begin) * rate);
  const auto look = [this, begin, rate](int index) {
    seek(begin + index / rate);
    show_moment(clock_ + index / rate);
    return pictures_->grab();
  };
  series_ = std::make_unique<PictureSeries>(PictureSeries::Output{target, is_video, count, rate}, look, this);
  connect(series_.get(), &PictureSeries::finished, this, [this, target, before](const QString& trouble) {
    verdict_->show_message(trouble.isEmpty() ? tr("Written to %1.").arg(target) : trouble, !trouble.isEmpty());
    seek(before);
    series_.release()->deleteLater();
    show_busy();
  });
  series_->start();
  show_busy();
}

void ReviewPage::choose_target(bool is_video) {
  const QString beside = QString::fromStdString(recording_->file().parent_path().string());
  if (is_video && PictureSeries::encoder().isEmpty()) return save_series({}, true);  // which says what is missing
  const QString stem = QString::fromStdString(recording_->file().stem().string());
  const QString target = is_video
                             ? QFileDialog::getSaveFileName(this, tr("Video of the session"),
                                                            beside + QLatin1Char('/') + stem + QStringLiteral(".mp4"),
                                                            tr("Video (*.mp4 *.mkv *.webm)"))
                             : QFileDialog::getExistingDirectory(this, tr("Folder for the pictures"), beside);
  if (!target.isEmpty()) save_series(target, is_video);
}

void ReviewPage::choose_file(bool second) {
  const QString file = QFileDialog::getOpenFileName(this, second ? tr("Session to compare with") : tr("Session"),
                                                    QString::fromStdString(folder_.string()),
                                                    tr("Sessions (*.bodkin);;All files (*)"));
  if (file.isEmpty()) return;
  second ? compare_with(file.toStdString()) : open(file.toStdString());
}

void ReviewPage::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void ReviewPage::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.front().isLocalFile()) open(urls.front().toLocalFile().toStdString());
}

}  // namespace bodkin::app

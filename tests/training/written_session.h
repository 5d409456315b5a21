#pragma once

#include <string>

#include "session/session_file.h"
#include "tests/session/slab_case.h"

#include "core/geometry.h"

namespace bodkin {

// A session written by hand: tip, tissues and forces as given. The planned path runs from the origin 50 mm along -y;
// depth is measured along it.
class WrittenSession {
 public:
  struct Touch {
    bool in_contact = true;
    TissueId tissue = tissue::fat;
    double resistance = 0.0;  // N
  };
  static constexpr Touch air{false, tissue::air, 0.0};

  WrittenSession() {
    session_.header.path = {Vec3::Zero(), Vec3(0, -50, 0)};
    session_.header.dt = 0.001;
    session_.header.operator_name = "by hand";
    session_.header.started_at = "2026-11-21T02:00:00Z";
    const TissueLibrary library = default_tissue_library();
    for (const TissueProperties& each : library.tissues())
      session_.header.tissues.push_back({each.id, each.name, each.title});
    session_.finished = true;
    go(Vec3(0, 10, 0), 1, air);
  }

  // Moves straight to `tip` in `ticks` ticks.
  WrittenSession& go(const Vec3& tip, int ticks, const Touch& touch, const Vec3& axis = -Vec3::UnitY()) {
    const Vec3 from = session_.ticks.empty() ? tip : session_.ticks.back().input.needle.translation().eval();
    for (int i = 1; i <= ticks; ++i) add(from + (tip - from) * i / ticks, touch, axis);
    return *this;
  }
  // Moves along the planned path to a depth.
  WrittenSession& to(double depth, int ticks, const Touch& touch) { return go(Vec3(0, -depth, 0), ticks, touch); }
  WrittenSession& rest(int ticks, const Touch& touch) {
    return go(session_.ticks.back().input.needle.translation().eval(), ticks, touch);
  }
  WrittenSession& add(const Vec3& tip, const Touch& touch, const Vec3& axis = -Vec3::UnitY()) {
    simulation::TickRecord record;
    record.tick = session_.ticks.size();
    record.input.needle = needle_pose(tip, axis);
    record.output.depth = -tip.y();
    record.output.in_contact = touch.in_contact;
    record.output.tissue = touch.in_contact ? touch.tissue : tissue::air;
    record.output.resistance = touch.in_contact ? touch.resistance : 0.0;
    record.output.applied.force = -record.output.resistance * needle_axis(record.input.needle);
    session_.ticks.push_back(record);
    return *this;
  }
  WrittenSession& event(forces::EventKind kind, TissueId id = tissue::air, double value = 0.0) {
    session_.events.push_back({session_.ticks.back().tick, {kind, id, session_.ticks.back().output.depth, value}});
    return *this;
  }

  session::Session& session() { return session_; }

 private:
  session::Session session_;
};

// A faultless lumbar puncture: the ligamentum flavum is punctured at 40 mm, the tip rests in the fluid at 50 mm.
inline WrittenSession good_puncture() {
  using forces::EventKind;
  WrittenSession written;
  written.to(0, 500, WrittenSession::air).event(EventKind::contact, tissue::skin);
  written.to(5, 1000, {true, tissue::skin, 1.0}).event(EventKind::puncture, tissue::skin, 1.3);
  written.to(36, 6000, {true, tissue::interspinous_ligament, 1.5});
  written.to(40, 800, {true, tissue::ligamentum_flavum, 3.0});
  written.event(EventKind::loss_of_resistance, tissue::epidural_fat, 2.5);
  written.to(41, 200, {true, tissue::epidural_fat, 0.5}).rest(700, {true, tissue::epidural_fat, 0.2});
  written.to(46, 2500, {true, tissue::epidural_fat, 0.4}).to(47, 400, {true, tissue::dura, 0.7});
  written.to(50, 1500, {true, tissue::cerebrospinal_fluid, 0.1});
  written.rest(1000, {true, tissue::cerebrospinal_fluid, 0.1});
  return written;
}

// Appends the withdrawal of the needle.
inline WrittenSession withdrawn(WrittenSession written) {
  written.to(0, 2000, {true, tissue::fat, -0.5}).event(forces::EventKind::withdrawn);
  written.to(-8, 300, WrittenSession::air);
  return written;
}

inline CaseDescription written_description() {
  CaseDescription description;
  description.name = "written by hand";
  description.procedure.path = NeedlePath{Vec3::Zero(), Vec3(0, -50, 0)};
  return description;
}

}  // namespace bodkin

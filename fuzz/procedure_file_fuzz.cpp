// Untrusted procedure files: any bytes are either refused with a sentence, or give a procedure that can score a
// session.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "training/procedure_file.h"
#include "training/score.h"

namespace {

bodkin::session::Session short_session() {
  bodkin::session::Session session;
  session.header.path = {bodkin::Vec3::Zero(), bodkin::Vec3(0, 0, 10)};
  session.header.tissues = {{bodkin::anatomy::tissue::fat, "fat", "fat"}};
  for (int i = 0; i < 50; ++i) {
    bodkin::simulation::TickRecord& record = session.ticks.emplace_back();
    record.tick = static_cast<std::uint64_t>(i);
    record.input.needle.translation() = bodkin::Vec3(0, 0, 0.2 * i);
    record.output.in_contact = i > 5;
    record.output.depth = 0.2 * i;
    record.output.tissue = bodkin::anatomy::tissue::fat;
  }
  return session;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view document(reinterpret_cast<const char*>(data), size);
  static const bodkin::session::Session session = short_session();
  try {
    const bodkin::training::Procedure procedure = bodkin::training::parse_procedure(document, "procedure.xml");
    const bodkin::training::Score score = bodkin::training::score(session, {}, procedure);
    for (const bodkin::training::Finding& each : score.findings)
      if (each.grade > score.verdict || each.sentence.empty()) std::abort();
  } catch (const bodkin::InputError&) {
    return 0;
  }
  return 0;
}

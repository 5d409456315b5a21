// The page of a model lists its published numbers.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "simulation/resistance_models.h"

namespace bodkin {

using namespace bodkin::forces;
using namespace bodkin::simulation;
namespace {

TEST(ModelPages, list_the_diagnostics_of_their_model) {
  for (const ResistanceEntry& model : resistance_models()) {
    const std::string name(model.traits.name);
    std::ifstream page(std::filesystem::path(BODKIN_REPOSITORY) / "docs/models" / (name + ".md"));
    std::stringstream text;
    text << page.rdbuf();
    ASSERT_FALSE(text.str().empty()) << name << " has no page in docs/models";
    for (const DiagnosticName& diagnostic : model.traits.diagnostics) {
      if (diagnostic.name.empty()) continue;
      EXPECT_NE(text.str().find('`' + std::string(diagnostic.name) + '`'), std::string::npos)
          << "docs/models/" << name << ".md does not name " << diagnostic.name;
    }
  }
}

}  // namespace
}  // namespace bodkin

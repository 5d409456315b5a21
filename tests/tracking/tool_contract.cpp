// A tool in front of a camera, tested by driver_contract.cpp.
#include <filesystem>

#include "tests/haptics/driver_contract.h"
#include "tracking/footage_scene.h"
#include "tracking/tool_driver.h"
#include <unistd.h>

namespace bodkin {

using namespace bodkin::haptics;

std::vector<ContractSubject> contract_subjects() {
  const auto arrange = [] {
    static const std::filesystem::path folder = [] {
      std::filesystem::path made =
          std::filesystem::temp_directory_path() / ("bodkin-tool-" + std::to_string(getpid()));
      tracking::SceneOptions options;
      options.frames = 6;
      options.rate = 15.0;
      options.width = 640;
      options.height = 360;
      options.look.samples = 3;
      tracking::render_scene(made, options);
      return made;
    }();
    return ContractScene{.identity = folder.string(), .fault_at_end = DeviceFault::none};
  };
  return {{.name = "tracked",
           .driver = &tracking::tool_driver(),
           .arrange = arrange,
           .absent_identity = "/no/such/footage",
           .absent_message = {"/no/such/footage"}}};
}

}  // namespace bodkin

// Haply's Inverse service as a stand-in, for any program: prints its port and serves until its standard input ends.
// Its trouble comes from the environment (BODKIN_STAND_IN).
#include <cstdio>

#include "tests/haptics/stand_ins/haply.h"

int main() {
  const stand_in::HaplyService service(stand_in::board());
  std::printf("%d\n", service.port());
  std::fflush(stdout);
  while (std::getchar() != EOF) {
  }
}

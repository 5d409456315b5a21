// Haply's Inverse service as a mock, for any program: prints its port and serves until its standard input ends.
// Its trouble comes from the environment (BODKIN_MOCK).
#include <cstdio>

#include "tests/haptics/mocks/haply.h"

int main() {
  const mock::HaplyService service(mock::board());
  std::printf("%d\n", service.port());
  std::fflush(stdout);
  while (std::getchar() != EOF) {
  }
}

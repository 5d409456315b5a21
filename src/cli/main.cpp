#include "cli/program.h"

int main(int argc, char** argv) {
  return bodkin::cli::run_program(argc, argv);
}

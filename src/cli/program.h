#pragma once

namespace bodkin::cli {

// The program `bodkin`, from its arguments as main() gets them to its exit code: finds the command that they name and
// carries it out. Throws nothing; an error is one sentence on standard error. To be called once in a process.
int run_program(int argc, char** argv);

}  // namespace bodkin::cli

#pragma once

namespace bodkin::cli {

// The program `bodkin`, from the arguments of main() to its exit code: finds the command and executes it. Throws
// nothing; an error is one sentence on standard error. To be called once in a process.
int run_program(int argc, char** argv);

}  // namespace bodkin::cli

/* Libraries that misbehave as soon as they are loaded: one crashes, one never comes back, one ends the program. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

__attribute__((constructor)) static void at_load(void) {
  puts("{\"name\":\"a vendor's chatter\"}");
  fflush(stdout);
#if defined(CRASHES)
  signal(SIGSEGV, SIG_DFL);
  raise(SIGSEGV);
#elif defined(HANGS)
  for (;;) pause();
#else
  exit(7);
#endif
}

// Ctrl-C and a request to end: long work stops after the piece at hand, and what was written is whole.
#pragma once

namespace nuno {

// From now on SIGINT and SIGTERM set a flag; a second one ends the program at once.
void watch_interrupts();
bool interrupted();

}  // namespace nuno

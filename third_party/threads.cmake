# POSIX threads
# Version: the platform's
# Licence: the platform's
# Why: std::thread needs it at link time on some systems.
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads QUIET)
if(Threads_FOUND)
    add_library(third_party::threads ALIAS Threads::Threads)
else()
    nuno_missing("threads" libc6-dev)
endif()

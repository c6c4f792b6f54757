// One kernel for each width of vectors that machines have.
#pragma once

#include "model/wide.h"

// NUNO_BY_LANES(name, declaration, call): functions name_16, name_8 and name_4 of `declaration`, for the instruction
// sets that have such vectors, whose body is `call` with kLaneCount lanes. Sanitizers and clang get the last alone.
#if defined(NUNO_SANITIZED) || defined(__clang__)
#define NUNO_BY_LANES(name, declaration, call) \
    void name##_4 declaration                  \
    {                                          \
        constexpr int kLaneCount = 4;          \
        call;                                  \
    }                                          \
    constexpr auto *name##_16 = name##_4, *name##_8 = name##_4;
#else
#define NUNO_BY_LANES(name, declaration, call)                           \
    __attribute__((target("arch=x86-64-v4"))) void name##_16 declaration \
    {                                                                    \
        constexpr int kLaneCount = 16;                                   \
        call;                                                            \
    }                                                                    \
    __attribute__((target("arch=x86-64-v3"))) void name##_8 declaration  \
    {                                                                    \
        constexpr int kLaneCount = 8;                                    \
        call;                                                            \
    }                                                                    \
    void name##_4 declaration                                            \
    {                                                                    \
        constexpr int kLaneCount = 4;                                    \
        call;                                                            \
    }
#endif
#define NUNO_PICK_LANES(name, lanes) ((lanes) == 16 ? name##_16 : (lanes) == 8 ? name##_8 : name##_4)

namespace nuno {

// Lanes of the machine's vectors: 16 with AVX-512, 8 with AVX2, else 4.
inline int machine_lanes()
{
#if defined(NUNO_SANITIZED) || defined(__clang__)
    return 4;
#else
    return __builtin_cpu_supports("x86-64-v4") ? 16 : __builtin_cpu_supports("x86-64-v3") ? 8 : 4;
#endif
}

}  // namespace nuno

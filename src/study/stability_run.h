// One shaken cloth: whether its motion grows, stays right, or stays finite and is wrong.
#pragma once

#include <cstdint>
#include <string_view>

#include "study/stability_cloth.h"

namespace nuno {

enum class Verdict : std::int32_t
{
    stable,   // finite, does not grow, and within kRightError of a fine run
    wrong,    // finite and does not grow, but is not
    blown_up  // grows, or is lost
};
std::string_view name_of(Verdict verdict);

// Largest error, as a share of the motion at the start, of a run that is right: half of it.
inline constexpr double kRightError = 0.5;

// What a run is judged by.
struct ShakeRun
{
    Verdict verdict = Verdict::stable;
    double growth = 0;  // of the motion in a substep: its logarithm, where it has settled to one; below 0 it dies down
    double error = 0;   // largest difference from a fine run over a period of the slow motion, in shares of the start
    int substeps = 0;   // that were run
    int lost_after = -1;  // substeps until a number was lost (is_lost); -1: none was
};

// Largest difference from a fine run over a period of the slow motion, in shares of the motion at the start. Not finite
// where a number was lost.
double error_of(const RestCloth& cloth, Method method, double substep_s, int seed);

// `substeps` of a method from the shaken cloth, or fewer once motion has grown.
ShakeRun shake(const RestCloth& cloth, Method method, double substep_s, int substeps, int seed);

// Whether it grows, and nothing else.
bool grows(const RestCloth& cloth, Method method, double substep_s, int substeps, int seed);

// Substeps after which growth of a few parts in a thousand beyond the limit is seen: most with explicit Euler, which is
// slow to go bad; few with methods that are stable with any.
int substeps_to_judge(Method method);

}  // namespace nuno

// Runs of a shaken cloth.
#include "study/stability_run.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/oscillator.h"

namespace nuno {
namespace {

// Growth is told in small motion, since folds that open and close take energy out of larger motion and hold what grows
// slowly: at a few hundred times this size. The highest mode is given more than its share of the noise, for a damper
// would take that below the rounding of positions before it grows. Explicit Euler, which grows slowest, needs more
// motion, or its steps are lost in that rounding.
constexpr double kSmall = 5e-5, kSmallOfEuler = 1e-3, kMuchNoise = 0.3, kFast = 2;
// Errors show in slow motion that single precision can follow in short substeps.
constexpr double kLarge = 1e-2, kLittleNoise = 0.01;

// Times the motion at the start: more than a stable method makes of a mode just below its limit, and for methods without
// one more than other rests that they find.
constexpr double kGrown = 10, kGrownWithoutLimit = 30;
constexpr double kWellGrown = 1e3;  // until where its growth is measured
constexpr double kGoesOn = 4;       // times what it was after half of the substeps
constexpr int kCheckpoints = 4;     // in a period of the slow motion
constexpr int kMostToCompare = 4000;
constexpr double kFineOmegaH = 0.15;  // of the fine run, rk4

struct GrowthRun
{
    int substeps, seed;
    bool only_whether;  // it grows
};

struct Sample
{
    int substep;
    double speed;
};

// Growth, from samples that are close together at first.
class GrowthWatch
{
  public:
    GrowthWatch(const RestCloth& cloth, const ClothState& start, Method method)
        : cloth_(cloth), has_limit_(is_explicit(method)), samples_{{0, mean_speed(cloth, start)}}
    {
    }

    // False where nothing more can be learnt.
    bool look(int substep, const ClothState& state)
    {
        const double now = mean_speed(cloth_, state);
        if (first_lost(state.positions) || first_lost(state.velocities) || !std::isfinite(now)) lost_after_ = substep;
        if (std::isfinite(now)) samples_.push_back({substep, now});
        return lost_after_ < 0 && !(has_limit_ && now > kWellGrown * first());
    }

    // A method without a limit may be soft, and go to another rest from there; what grows goes on.
    bool has_grown() const
    {
        const double last = samples_.back().speed;
        if (lost_after_ >= 0) return true;
        if (has_limit_) return last > kGrown * first();
        return last > kGrownWithoutLimit * first() && last > kGoesOn * half().speed;
    }
    int lost_after() const { return lost_after_; }
    int substeps() const { return lost_after_ >= 0 ? lost_after_ : samples_.back().substep; }
    double first() const { return samples_.front().speed; }

    // Where motion grew, since it was a few times the start; else over the second half.
    double growth() const
    {
        const Sample& last = samples_.back();
        if (last.substep == 0) return kLostAtOnce;
        const auto rising = std::find_if(samples_.rbegin() + 1, samples_.rend(),
                                         [&](const Sample& s) { return s.speed <= kRising * first(); });
        const Sample& since = !has_grown() && half().substep < last.substep ? half()
                              : rising == samples_.rend()                   ? samples_.front()
                                                                            : *rising;
        return std::log(std::max(last.speed, kLeast) / std::max(since.speed, kLeast)) / (last.substep - since.substep);
    }

  private:
    static constexpr double kLeast = 1e-300, kLostAtOnce = 50, kRising = 5;

    const Sample& half() const
    {
        return *std::find_if(samples_.begin(), samples_.end(),
                             [&](const Sample& s) { return 2 * s.substep >= samples_.back().substep; });
    }

    const RestCloth& cloth_;
    const bool has_limit_;
    std::vector<Sample> samples_;
    int lost_after_ = -1;
};

int next_look(int substep) { return substep + std::clamp(substep / 3, 1, 64); }

// The same motion in substeps too short to matter, to the times at which a run is compared with it.
class FineRun
{
  public:
    FineRun(const RestCloth& cloth, const ClothState& start) : cloth_(cloth), now_(start)
    {
        const double rate = double(cloth.params.damping) / double(cloth.params.areal_density);
        substep_s_ = kFineOmegaH / std::max(cloth.omega, rate);
    }

    const ClothState& at(double time_s)
    {
        const double span = time_s - time_s_;
        const int count = std::max(1, static_cast<int>(std::ceil(span / substep_s_)));
        ExactSubsteps run(cloth_, Method::rk4, span / count);
        run.upload(now_);
        run.step(count);
        now_ = run.state();
        time_s_ = time_s;
        return now_;
    }

  private:
    const RestCloth& cloth_;
    ClothState now_;
    double substep_s_, time_s_ = 0;
};

}  // namespace

std::string_view name_of(Verdict verdict)
{
    return verdict == Verdict::stable ? "stable" : verdict == Verdict::wrong ? "wrong" : "blown_up";
}

int substeps_to_judge(Method method)
{
    if (method == Method::explicit_euler) return 20000;
    if (is_explicit(method)) return 4000;
    return method == Method::xpbd || method == Method::vbd ? 1000 : 200;
}

namespace {

// Methods with a limit are watched in small motion. The others would lose that in rounding where substeps are short.
Shake shake_to_grow(Method method, int seed)
{
    if (!is_explicit(method)) return {kLarge, kMuchNoise, 0, seed};
    return {method == Method::explicit_euler ? kSmallOfEuler : kSmall, kMuchNoise, kFast, seed};
}

GrowthWatch watched(const RestCloth& cloth, Method method, double substep_s, const GrowthRun& how)
{
    const ClothState start = shaken(cloth, shake_to_grow(method, how.seed));
    GrowthWatch watch(cloth, start, method);
    ExactSubsteps run(cloth, method, substep_s);
    run.upload(start);
    for (int done = 0; done < how.substeps && !(how.only_whether && watch.has_grown());) {
        const int next = std::min(next_look(done), how.substeps);
        run.step(next - done);
        if (!watch.look(done = next, run.state())) break;
    }
    return watch;
}

}  // namespace

// Over a period of the slow motion, and one substep at least.
double error_of(const RestCloth& cloth, Method method, double substep_s, int seed)
{
    const ClothState start = shaken(cloth, {kLarge, kLittleNoise, 0, seed});
    const double first = mean_speed(cloth, start), period_s = 2 * M_PI / cloth.slow_omega;
    const int apart = std::clamp(static_cast<int>(std::lround(period_s / kCheckpoints / substep_s)), 1,
                                 kMostToCompare / kCheckpoints);
    const int last = std::clamp(static_cast<int>(period_s / substep_s), apart, apart * kCheckpoints);
    ExactSubsteps run(cloth, method, substep_s);
    run.upload(start);
    FineRun fine(cloth, start);
    double largest = 0;
    for (int done = apart; done <= last; done += apart) {
        run.step(apart);
        const double error = difference(cloth, run.state(), fine.at(done * substep_s)) / first;
        if (!(error <= largest)) largest = error;
        if (!std::isfinite(error)) break;
    }
    return largest;
}

ShakeRun shake(const RestCloth& cloth, Method method, double substep_s, int substeps, int seed)
{
    const GrowthWatch watch = watched(cloth, method, substep_s, {substeps, seed, false});
    ShakeRun result;
    result.growth = watch.growth();
    result.substeps = watch.substeps();
    result.lost_after = watch.lost_after();
    if (watch.has_grown()) {
        result.verdict = Verdict::blown_up;
        return result;
    }
    result.error = error_of(cloth, method, substep_s, seed);
    result.verdict = result.error <= kRightError ? Verdict::stable : Verdict::wrong;
    return result;
}

bool grows(const RestCloth& cloth, Method method, double substep_s, int substeps, int seed)
{
    return watched(cloth, method, substep_s, {substeps, seed, true}).has_grown();
}

}  // namespace nuno

// Random pairs in motion: each family starts from plain numbers and spoils them.
#include "collision/ccd/random_query.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace nuno {
namespace {

using glm::dvec3;

// Its own uniform numbers, as those of the standard library differ between systems.
class Dice
{
  public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    int whole(int lo, int hi) { return lo + static_cast<int>(engine_() % static_cast<std::uint64_t>(hi - lo + 1)); }
    double real(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
    bool chance(double p) { return real(0, 1) < p; }
    dvec3 vector(double size)
    {
        const double x = real(-size, size), y = real(-size, size), z = real(-size, size);
        return {x, y, z};
    }
    dvec3 whole_vector(int size)
    {
        const int x = whole(-size, size), y = whole(-size, size), z = whole(-size, size);
        return {x, y, z};
    }

  private:
    std::mt19937_64 engine_;
};

template <class Change>
void for_each_point(Query& query, const Change& change)
{
    for (FourPoints* points : {&query.t0, &query.t1})
        for (dvec3& point : *points) change(point);
}

// Moves the first point (of an edge: both of its ends) so that the pair touches at a time, but for rounding.
void make_touch(Query& query, Dice& dice)
{
    const double time = dice.chance(0.2) ? dice.whole(0, 1) : dice.real(0, 1);
    double s = dice.real(0, 1), r = dice.real(0, 1);
    if (dice.chance(0.3)) s = dice.whole(0, 1);
    if (dice.chance(0.3)) r = dice.whole(0, 1);
    const auto at = [&](int i) { return (1 - time) * query.t0[i] + time * query.t1[i]; };
    dvec3 gap;
    if (query.kind == PairKind::vertex_face)
        gap = (1 - s) * at(1) + s * ((1 - r) * at(2) + r * at(3)) - at(0);
    else
        gap = (1 - r) * at(2) + r * at(3) - ((1 - s) * at(0) + s * at(1));
    for (int i = 0; i < (query.kind == PairKind::vertex_face ? 1 : 2); ++i) {
        query.t0[i] += gap;
        query.t1[i] += gap;
    }
}

void make_planar(Query& query, Dice& dice)
{
    const dvec3 origin = dice.whole_vector(3), u = dice.whole_vector(3), v = dice.whole_vector(3);
    const bool is_whole = dice.chance(0.7);
    for_each_point(query, [&](dvec3& point) {
        const double a = is_whole ? dice.whole(-4, 4) : std::floor(point.x * 1024);
        const double b = is_whole ? dice.whole(-4, 4) : std::floor(point.y * 1024);
        point = origin + a * u + b * v;
    });
}

void make_rigid(Query& query, Dice& dice)
{
    if (dice.chance(0.5))
        for_each_point(query, [&](dvec3& point) { point = dice.whole_vector(2); });
    else if (dice.chance(0.7))
        make_touch(query, dice);
    const dvec3 motion = dice.chance(0.5) ? dvec3(0) : dice.whole_vector(3);
    for (int i = 0; i < 4; ++i) query.t1[i] = query.t0[i] + motion;
}

void make_sliver(Query& query, Dice& dice)
{
    const int kept = dice.whole(0, 3), moved = dice.whole(0, 3);
    for (FourPoints* points : {&query.t0, &query.t1}) {
        if (dice.chance(0.2)) continue;
        if (dice.chance(0.5))
            (*points)[moved] = (*points)[kept];
        else
            (*points)[3] = 0.5 * ((*points)[1] + (*points)[2]);
    }
    if (dice.chance(0.5)) make_touch(query, dice);
}

void make_extreme(Query& query, Dice& dice)
{
    const double all = std::ldexp(1.0, dice.whole(-1000, 1000));
    const bool each = dice.chance(0.3);
    if (dice.chance(0.5)) make_touch(query, dice);
    for_each_point(query, [&](dvec3& point) {
        point *= all;
        if (each) point[dice.whole(0, 2)] = std::ldexp(dice.real(-1, 1), dice.whole(-1060, 1000));
    });
}

void make_cloth_in_floats(Query& query, Dice& dice)
{
    const dvec3 place = dice.vector(dice.chance(0.2) ? 1e4 : 1), motion = dice.vector(0.05);
    for (int i = 0; i < 4; ++i) {
        query.t0[i] = place + 0.01 * query.t0[i];
        query.t1[i] = query.t0[i] + motion + dice.vector(0.01);
    }
    if (dice.chance(0.5)) make_touch(query, dice);
    for_each_point(query, [](dvec3& point) { point = dvec3(glm::vec3(point)); });
}

// Along z, the vertex onto a side of the face, or an end of one edge onto the other, but for rounding.
void make_plumb(Query& query, Dice& dice)
{
    const double s = dice.real(0, 1);
    const dvec3 &a = query.t0[dice.whole(1, 2)], &b = query.t0[3];
    const bool face = query.kind == PairKind::vertex_face;
    const dvec3 onto = face ? (1 - s) * a + s * b : (1 - s) * query.t0[2] + s * b;
    query.t0[0] = dvec3(onto.x, onto.y, query.t0[0].z);
    for (int i = 0; i < 4; ++i) query.t1[i] = dvec3(query.t0[i].x, query.t0[i].y, 2 * query.t1[i].z);
}

bool have_swept_boxes_that_meet(const Query& query)
{
    const int first_count = query.kind == PairKind::vertex_face ? 1 : 2;
    for (int k = 0; k < 3; ++k) {
        double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
        for (int i = 0; i < 4; ++i) {
            const int which = i < first_count ? 0 : 1;
            lo[which] = std::min({lo[which], query.t0[i][k], query.t1[i][k]});
            hi[which] = std::max({hi[which], query.t0[i][k], query.t1[i][k]});
        }
        if (lo[0] > hi[1] || lo[1] > hi[0]) return false;
    }
    return true;
}

// Two layers, sides along a grid turned by some angle, up to 5 mm apart, that move by up to 8 mm.
void make_broad_phase(Query& query, Dice& dice)
{
    const double angle = dice.real(0, 6.3), cell = 0.01;
    const dvec3 u = cell * dvec3(std::cos(angle), std::sin(angle), 0.2), v = cell * dvec3(-u.y, u.x, 0) / cell;
    do {
        const dvec3 between = dice.vector(cell) * dvec3(1, 1, 0.5), motion = dice.vector(0.003);
        const dvec3 corners[4] = {between, u, v, dvec3(0)}, ends[4] = {between, between + u, v, dvec3(0)};
        for (int i = 0; i < 4; ++i) {
            const bool is_second = i >= (query.kind == PairKind::vertex_face ? 1 : 2);
            query.t0[i] = (query.kind == PairKind::vertex_face ? corners : ends)[i] + dice.vector(0.002);
            query.t1[i] = query.t0[i] + (is_second ? motion : -motion) + dice.vector(0.001);
        }
        for_each_point(query, [](dvec3& point) { point = dvec3(glm::vec3(point)); });
    } while (!have_swept_boxes_that_meet(query));
}

void make_turning(Query& query, Dice& dice)
{
    for (int i = 0; i < 4; ++i) query.t1[i] = -query.t0[i] + dice.vector(0.3);
    if (dice.chance(0.5)) make_touch(query, dice);
}

void spoil(Query& query, QueryFamily family, Dice& dice)
{
    switch (family) {
    case QueryFamily::any: break;
    case QueryFamily::grid: {
        const int size = dice.whole(1, 4);
        for_each_point(query, [&](dvec3& point) { point = dice.whole_vector(size); });
        break;
    }
    case QueryFamily::planar: make_planar(query, dice); break;
    case QueryFamily::rigid: make_rigid(query, dice); break;
    case QueryFamily::offset: {
        make_touch(query, dice);
        const dvec3 offset = dice.vector(1e8);
        for_each_point(query, [&](dvec3& point) { point += offset; });
        break;
    }
    case QueryFamily::built: make_touch(query, dice); break;
    case QueryFamily::nudged:
        make_touch(query, dice);
        for_each_point(query, [&](dvec3& point) { point += dice.vector(3e-16); });
        break;
    case QueryFamily::scaled: {
        if (dice.chance(0.6)) make_touch(query, dice);
        const int x = dice.whole(-40, 0), y = dice.whole(-40, 0), z = dice.whole(-40, 0);
        for_each_point(query, [&](dvec3& p) { p = {std::ldexp(p.x, x), std::ldexp(p.y, y), std::ldexp(p.z, z)}; });
        break;
    }
    case QueryFamily::sliver: make_sliver(query, dice); break;
    case QueryFamily::extreme: make_extreme(query, dice); break;
    case QueryFamily::in_floats: make_cloth_in_floats(query, dice); break;
    case QueryFamily::turning: make_turning(query, dice); break;
    case QueryFamily::plumb: make_plumb(query, dice); break;
    case QueryFamily::broad_phase: make_broad_phase(query, dice); break;
    case QueryFamily::count: break;
    }
}

}  // namespace

std::string name_of(QueryFamily family)
{
    constexpr const char* kNames[] = {"any",    "grid",   "planar",  "rigid",     "offset",  "built", "nudged",
                                      "scaled", "sliver", "extreme", "in_floats", "turning", "plumb", "broad_phase"};
    return kNames[static_cast<int>(family)];
}

Query random_query(QueryFamily family, std::uint64_t seed)
{
    Dice dice(seed * 64 + static_cast<std::uint64_t>(family));
    Query query;
    query.kind = dice.chance(0.5) ? PairKind::vertex_face : PairKind::edge_edge;
    for_each_point(query, [&](dvec3& point) { point = dice.vector(1); });
    spoil(query, family, dice);
    return query;
}

std::string text_of(const Query& query)
{
    std::string text = query.kind == PairKind::vertex_face ? "vf" : "ee";
    for (const FourPoints* points : {&query.t0, &query.t1})
        for (const dvec3& point : *points)
            for (int k = 0; k < 3; ++k) {
                char number[40];
                std::snprintf(number, sizeof number, " %a", point[k]);
                text += number;
            }
    return text;
}

}  // namespace nuno

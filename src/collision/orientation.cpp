// In double where that is certain, else in integers. Sums and products of floats neither overflow nor underflow there.
#include "collision/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "collision/ccd/binary_parts.h"
#include "collision/ccd/integer.h"

namespace nuno {
namespace {

constexpr double kUnit = 0x1p-53;  // of rounding to nearest

int sign_of(double a) { return (a > 0) - (a < 0); }

// The differences of the points to the first, along one axis, times a power of two that makes them integers.
template <std::size_t count>
std::array<Integer, count> whole_differences(const std::array<double, count + 1>& coordinates)
{
    std::array<BinaryParts, count + 1> parts;
    int least = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i <= count; ++i) {
        parts[i] = binary_parts(coordinates[i]);
        if (parts[i].bits != 0) least = std::min(least, parts[i].exponent);
    }
    const auto whole = [least](const BinaryParts& part) {
        return part.bits == 0 ? Integer() : Integer(part.bits) << static_cast<unsigned>(part.exponent - least);
    };
    std::array<Integer, count> differences;
    for (std::size_t i = 0; i < count; ++i) differences[i] = whole(parts[i + 1]) - whole(parts[0]);
    return differences;
}

int exact_volume_sign(const std::array<glm::dvec3, 4>& p)
{
    std::array<std::array<Integer, 3>, 3> w;  // by axis
    for (int k = 0; k < 3; ++k) w[std::size_t(k)] = whole_differences<3>({p[0][k], p[1][k], p[2][k], p[3][k]});
    Integer volume;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
        Integer area;
        area.add_product(w[x][0], w[y][1]).add_product(w[y][0], w[x][1], -1);
        volume.add_product(area, w[k][2]);
    }
    return volume.sign();
}

}  // namespace

// A difference of doubles is within kUnit of itself, so each of the six triple products is within 8 kUnit of itself in
// the sum that is computed (three differences, two products, three sums); 9 is for rounding the bound.
int volume_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d)
{
    const std::array<glm::dvec3, 4> p{glm::dvec3(a), glm::dvec3(b), glm::dvec3(c), glm::dvec3(d)};
    const glm::dvec3 u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
    double volume = 0, size = 0;
    for (int k = 0; k < 3; ++k) {
        const int x = k == 2 ? 0 : k + 1, y = k == 0 ? 2 : k - 1;
        const double left = u[x] * v[y], right = u[y] * v[x];
        volume += (left - right) * w[k];
        size += (std::abs(left) + std::abs(right)) * std::abs(w[k]);
    }
    if (std::abs(volume) > 9 * kUnit * size) return sign_of(volume);
    const bool has_doubles = p[1] == p[2] || p[1] == p[3] || p[2] == p[3];  // the first one has a size of 0
    return size == 0 || has_doubles ? 0 : exact_volume_sign(p);
}

// As above: two differences, a product and a sum.
int area_sign(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int axis)
{
    const int x = axis == 2 ? 0 : axis + 1, y = axis == 0 ? 2 : axis - 1;
    const double ax = a[x], ay = a[y], bx = b[x], by = b[y], cx = c[x], cy = c[y];
    const double left = (bx - ax) * (cy - ay), right = (by - ay) * (cx - ax);
    const double area = left - right, size = std::abs(left) + std::abs(right);
    if (std::abs(area) > 5 * kUnit * size) return sign_of(area);
    if (size == 0) return 0;
    const std::array<Integer, 2> u = whole_differences<2>({ax, bx, cx}), v = whole_differences<2>({ay, by, cy});
    Integer exact;
    exact.add_product(u[0], v[1]).add_product(v[0], u[1], -1);
    return exact.sign();
}

}  // namespace nuno

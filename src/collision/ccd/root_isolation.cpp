// Distinct roots: multiple ones are split off by the discriminant, the others told apart by Descartes' rule of signs on
// halves of halves.
#include <array>
#include <utility>

#include "collision/ccd/exact_root.h"

namespace nuno {
namespace {

using Coefficients = std::array<Integer, 4>;

// Over [lo, lo + 1] / 2^shift in the basis of Bernstein; times some positive integer.
struct Piece
{
    Coefficients b;
    Integer lo;
    unsigned shift;
};

struct Signs
{
    int variations = 0;
    int first = 0;  // that is not 0
};

Signs signs_of(const Coefficients& b, int count)
{
    Signs signs;
    int last = 0;
    for (int i = 0; i < count; ++i) {
        const int sign = b[i].sign();
        if (sign == 0) continue;
        if (last == 0)
            signs.first = sign;
        else if (sign != last)
            ++signs.variations;
        last = sign;
    }
    return signs;
}

// b_i = sum over j <= i of c_j (i over j) / (d over j), times d for the degrees 1, 2, 3.
Coefficients bernstein_of(const Polynomial& p)
{
    const auto& c = p.c;
    Coefficients b;
    if (p.count == 2) {
        b[0] = c[0];
        b[1] = c[0] + c[1];
    } else if (p.count == 3) {
        b[0] = c[0] << 1;
        b[1] = b[0] + c[1];
        b[2] = (c[0] + c[1] + c[2]) << 1;
    } else {
        const Integer three(3);
        b[0] = c[0] * three;
        b[1] = b[0] + c[1];
        b[2] = b[1] + c[1] + c[2];
        b[3] = (c[0] + c[1] + c[2] + c[3]) * three;
    }
    return b;
}

// De Casteljau: both halves, times 2^(count - 1).
std::pair<Coefficients, Coefficients> halves_of(const Coefficients& b, int count)
{
    Coefficients left, right, row = b;
    for (int k = 0; k < count; ++k) {
        const auto missing = static_cast<unsigned>(count - 1 - k);
        left[k] = row[0] << missing;
        right[count - 1 - k] = row[count - 1 - k] << missing;
        for (int i = 0; i + 1 < count - k; ++i) row[i] += row[i + 1];
    }
    return {std::move(left), std::move(right)};
}

// The only root between lo and hi, which may be roots themselves: the bracket is narrowed until they are not.
ExactRoot root_inside(const Polynomial& p, Fraction lo, Fraction hi, int sign_after_lo)
{
    bool lo_is_root = sign_at(p, lo) == 0, hi_is_root = sign_at(p, hi) == 0;
    while (lo_is_root || hi_is_root) {
        Fraction middle = middle_of(lo, hi);
        const int sign = sign_at(p, middle);
        if (sign == 0) return ExactRoot(std::move(middle));
        if (sign == sign_after_lo) {
            lo = std::move(middle);
            lo_is_root = false;
        } else {
            hi = std::move(middle);
            hi_is_root = false;
        }
    }
    return {p, std::move(lo), std::move(hi), sign_after_lo};
}

// p has no multiple root in (0, 1).
void isolate(const Polynomial& p, Coefficients b, std::vector<ExactRoot>& roots)
{
    if (b[0].sign() == 0) roots.emplace_back(Fraction{});
    if (b[p.count - 1].sign() == 0) roots.emplace_back(Fraction{Integer(1), 0});
    std::vector<Piece> pieces;
    pieces.push_back({std::move(b), Integer(0), 0});
    while (!pieces.empty()) {
        const Piece piece = std::move(pieces.back());
        pieces.pop_back();
        const Signs signs = signs_of(piece.b, p.count);
        if (signs.variations == 0) continue;
        if (signs.variations == 1) {
            roots.push_back(root_inside(p, {piece.lo, piece.shift}, {piece.lo + Integer(1), piece.shift}, signs.first));
            continue;
        }
        auto [left, right] = halves_of(piece.b, p.count);
        const Integer left_lo = piece.lo << 1, right_lo = left_lo + Integer(1);
        if (right[0].sign() == 0) roots.emplace_back(Fraction{right_lo, piece.shift + 1});
        pieces.push_back({std::move(right), right_lo, piece.shift + 1});
        pieces.push_back({std::move(left), left_lo, piece.shift + 1});
    }
}

void append_roots(const Polynomial& p, std::vector<ExactRoot>& roots);

// a t + b.
void append_root_of_line(Integer a, Integer b, std::vector<ExactRoot>& roots)
{
    Polynomial line;
    line.count = 2;
    line.c[0] = std::move(b);
    line.c[1] = std::move(a);
    append_roots(line, roots);
}

// Whether a t^2 + b t + c has no two different real roots; the double one is appended.
bool is_settled_quadratic(const Polynomial& p, std::vector<ExactRoot>& roots)
{
    const auto& [c, b, a, unused] = p.c;
    Integer discriminant = b * b;
    discriminant -= (a * c) << 2;
    if (discriminant.sign() == 0) append_root_of_line(a << 1, b, roots);
    return discriminant.sign() <= 0;
}

// Whether a t^3 + b t^2 + c t + d has a multiple root; its roots are then appended. With h = b^2 - 3ac, k = bc - 9ad
// and g = c^2 - 3bd, k^2 - 4hg is -3 times the discriminant. Where that is 0 the double root is -k / 2h and the other
// one (ak - bh) / ah, or with h = 0 a triple one -b / 3a.
bool is_settled_cubic(const Polynomial& p, std::vector<ExactRoot>& roots)
{
    const auto& [d, c, b, a] = p.c;
    const Integer three(3);
    const Integer h = b * b - three * (a * c), k = b * c - Integer(9) * (a * d), g = c * c - three * (b * d);
    if ((k * k - ((h * g) << 2)).sign() != 0) return false;
    if (h.sign() == 0) {
        append_root_of_line(three * a, b, roots);
        return true;
    }
    append_root_of_line(h << 1, k, roots);
    append_root_of_line(a * h, b * h - a * k, roots);
    return true;
}

void append_roots(const Polynomial& p, std::vector<ExactRoot>& roots)
{
    if (p.count < 2) return;
    Coefficients b = bernstein_of(p);
    const Signs signs = signs_of(b, p.count);
    const bool ends_in_root = b[0].sign() == 0 || b[p.count - 1].sign() == 0;
    if (signs.variations == 0 && !ends_in_root) return;
    if (signs.variations > 1 || ends_in_root) {
        if (p.count == 3 && is_settled_quadratic(p, roots)) return;
        if (p.count == 4 && is_settled_cubic(p, roots)) return;
    }
    isolate(p, std::move(b), roots);
}

}  // namespace

std::vector<ExactRoot> roots_of(const Polynomial& p)
{
    std::vector<ExactRoot> roots;
    append_roots(p, roots);
    return roots;
}

}  // namespace nuno

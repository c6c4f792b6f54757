// Sturm's theorem, as textbooks have it.
#include "collision/ccd/rational_polynomial.h"

#include <algorithm>
#include <cassert>

namespace nuno {
namespace {

void trim(RationalPolynomial& p)
{
    while (!p.empty() && p.back() == 0) p.pop_back();
}

RationalPolynomial combined(const RationalPolynomial& a, const RationalPolynomial& b, int sign_of_b)
{
    RationalPolynomial sum(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < a.size(); ++i) sum[i] += a[i];
    for (std::size_t i = 0; i < b.size(); ++i) sum[i] += sign_of_b * b[i];
    trim(sum);
    return sum;
}

struct Division
{
    RationalPolynomial quotient, remainder;
};

Division divided(RationalPolynomial a, const RationalPolynomial& b)
{
    Division result;
    if (a.size() >= b.size()) result.quotient.resize(a.size() - b.size() + 1);
    while (a.size() >= b.size()) {
        const Rational factor = a.back() / b.back();
        const std::size_t offset = a.size() - b.size();
        result.quotient[offset] = factor;
        for (std::size_t i = 0; i < b.size(); ++i) a[i + offset] -= factor * b[i];
        trim(a);
    }
    result.remainder = std::move(a);
    return result;
}

RationalPolynomial derivative(const RationalPolynomial& p)
{
    RationalPolynomial slope;
    for (std::size_t i = 1; i < p.size(); ++i) slope.push_back(p[i] * static_cast<unsigned long>(i));
    return slope;
}

// Times a positive number that leaves whole numbers without a common divisor.
void make_primitive(RationalPolynomial& p)
{
    mpz_class denominator = 1, numerator = 0;
    for (const Rational& c : p) denominator = lcm(denominator, c.get_den());
    for (Rational& c : p) {
        c *= denominator;
        numerator = gcd(numerator, c.get_num());
    }
    for (Rational& c : p) c /= numerator;
}

RationalPolynomial without_multiple_roots(const RationalPolynomial& p)
{
    RationalPolynomial simple = divided(p, greatest_common_divisor(p, derivative(p))).quotient;
    make_primitive(simple);
    return simple;
}

using SturmChain = std::vector<RationalPolynomial>;

// p must have no multiple root.
SturmChain sturm_chain(const RationalPolynomial& p)
{
    SturmChain chain{p, derivative(p)};
    while (!chain.back().empty()) {
        RationalPolynomial next = divided(chain[chain.size() - 2], chain.back()).remainder;
        for (Rational& c : next) c = -c;
        make_primitive(next);
        chain.push_back(std::move(next));
    }
    chain.pop_back();
    return chain;
}

int sign_changes(const SturmChain& chain, const Rational& t)
{
    int changes = 0, last = 0;
    for (const RationalPolynomial& p : chain) {
        const int sign = sgn(value_at(p, t));
        if (sign != 0 && last != 0 && sign != last) ++changes;
        if (sign != 0) last = sign;
    }
    return changes;
}

// The root is simple: at the middle, or where the sign changes.
void halve(RealRoot& root)
{
    const Rational middle = (root.lo + root.hi) / 2;
    const int at_middle = sgn(value_at(root.p, middle)), at_hi = sgn(value_at(root.p, root.hi));
    const bool is_in_first_half = at_hi != 0 && at_middle != -at_hi;
    (is_in_first_half ? root.hi : root.lo) = middle;
}

}  // namespace

RationalPolynomial operator+(const RationalPolynomial& a, const RationalPolynomial& b) { return combined(a, b, 1); }
RationalPolynomial operator-(const RationalPolynomial& a, const RationalPolynomial& b) { return combined(a, b, -1); }

RationalPolynomial operator*(const RationalPolynomial& a, const RationalPolynomial& b)
{
    if (a.empty() || b.empty()) return {};
    RationalPolynomial product(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
    return product;
}

Rational value_at(const RationalPolynomial& p, const Rational& t)
{
    Rational value = 0;
    for (std::size_t i = p.size(); i-- > 0;) value = value * t + p[i];
    return value;
}

RationalPolynomial greatest_common_divisor(RationalPolynomial a, RationalPolynomial b)
{
    while (!b.empty()) {
        RationalPolynomial remainder = divided(a, b).remainder;
        make_primitive(remainder);
        a = std::move(b);
        b = std::move(remainder);
    }
    return a;
}

int root_count(const RationalPolynomial& p, const Rational& lo, const Rational& hi)
{
    assert(!p.empty());
    if (p.size() == 1) return 0;
    const SturmChain chain = sturm_chain(without_multiple_roots(p));
    return sign_changes(chain, lo) - sign_changes(chain, hi);
}

std::vector<RealRoot> roots_between_0_and_1(const RationalPolynomial& p)
{
    std::vector<RealRoot> roots, pieces;
    if (p.size() < 2) return roots;
    const RationalPolynomial simple = without_multiple_roots(p);
    if (value_at(simple, 0) == 0) roots.push_back({{0, 1}, -1, 0});
    const SturmChain chain = sturm_chain(simple);
    pieces.push_back({simple, 0, 1});
    while (!pieces.empty()) {
        const RealRoot piece = pieces.back();
        pieces.pop_back();
        const int count = sign_changes(chain, piece.lo) - sign_changes(chain, piece.hi);
        if (count == 1) roots.push_back(piece);
        if (count <= 1) continue;
        const Rational middle = (piece.lo + piece.hi) / 2;
        pieces.push_back({simple, middle, piece.hi});
        pieces.push_back({simple, piece.lo, middle});
    }
    return roots;
}

int sign_at_root(const RationalPolynomial& h, RealRoot& root)
{
    if (h.empty()) return 0;
    const RationalPolynomial common = greatest_common_divisor(root.p, h);
    if (common.size() > 1 && root_count(common, root.lo, root.hi) == 1) return 0;
    const SturmChain chain = sturm_chain(without_multiple_roots(h));
    while (sign_changes(chain, root.lo) != sign_changes(chain, root.hi)) halve(root);
    return sgn(value_at(h, root.hi));
}

bool is_at_most(const Rational& time, const RealRoot& root)
{
    if (time <= root.lo) return true;
    if (time > root.hi) return false;
    return root_count(root.p, root.lo, time) == 0 || value_at(root.p, time) == 0;
}

}  // namespace nuno

// Sign and magnitude, schoolbook products.
#include "collision/ccd/integer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace nuno {
namespace {

__extension__ typedef unsigned __int128 Wide128;

// Most integers are this short; a copy of fixed length is no call. Every integer has room for so many limbs.
constexpr int kShort = 4;

void copy_limbs(const std::uint64_t* from, int count, std::uint64_t* to)
{
    if (count <= kShort)
        std::memcpy(to, from, kShort * sizeof *to);
    else
        std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof *to);
}

}  // namespace

Integer::Integer(std::int64_t value)
{
    if (value == 0) return;
    own_[0] = value < 0 ? -static_cast<Limb>(value) : static_cast<Limb>(value);
    count_ = value < 0 ? -1 : 1;
}

Integer& Integer::operator=(const Integer& other)
{
    if (this == &other) return *this;
    const int size = other.size();
    count_ = 0;
    reserve(size);
    copy_limbs(other.limbs(), size, limbs());
    count_ = other.count_;
    return *this;
}

Integer& Integer::operator=(Integer&& other) noexcept
{
    if (this == &other) return *this;
    if (!other.heap_) {
        copy_limbs(other.own_, other.size(), limbs());
    } else {
        heap_ = std::move(other.heap_);
        capacity_ = std::exchange(other.capacity_, kOwnLimbs);
    }
    count_ = std::exchange(other.count_, 0);
    return *this;
}

void Integer::grow(int limb_count)
{
    const int capacity = std::max(limb_count, 2 * capacity_);
    auto larger = std::make_unique_for_overwrite<Limb[]>(std::size_t(capacity));
    std::copy_n(limbs(), size(), larger.get());
    heap_ = std::move(larger);
    capacity_ = capacity;
}

void Integer::set_size(int limb_count, int sign)
{
    const Limb* const limb = limbs();
    while (limb_count > 0 && limb[limb_count - 1] == 0) --limb_count;
    count_ = sign < 0 ? -limb_count : limb_count;
}

int Integer::bit_count() const
{
    const int n = size();
    return n == 0 ? 0 : 64 * n - std::countl_zero(limbs()[n - 1]);
}

Integer::Rounded Integer::rounded() const
{
    const int n = size();
    if (n == 0) return {0, 0};
    const Limb* const limb = limbs();
    const int zeros = std::countl_zero(limb[n - 1]);
    Limb top = limb[n - 1] << zeros;
    if (zeros > 0 && n > 1) top |= limb[n - 2] >> (64 - zeros);
    const double mantissa = static_cast<double>(top >> 11) * 0x1p-53;
    return {count_ < 0 ? -mantissa : mantissa, 64 * n - zeros};
}

int Integer::compare_magnitudes(const Integer& a, const Integer& b)
{
    if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
    const Limb *const x = a.limbs(), *const y = b.limbs();
    for (int i = a.size() - 1; i >= 0; --i)
        if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
    return 0;
}

void Integer::set_sum_of_magnitudes(const Integer& a, const Integer& b, int sign)
{
    const bool a_is_longer = a.size() >= b.size();
    const Integer &longer = a_is_longer ? a : b, &shorter = a_is_longer ? b : a;
    const int n = longer.size(), m = shorter.size();
    reserve(n + 1);
    const Limb *const x = longer.limbs(), *const y = shorter.limbs();
    Limb* const sum = limbs();
    Limb carry = 0;
    for (int i = 0; i < m; ++i) {
        const Wide128 total = Wide128(x[i]) + y[i] + carry;
        sum[i] = static_cast<Limb>(total);
        carry = static_cast<Limb>(total >> 64);
    }
    for (int i = m; i < n; ++i) {
        const Limb limb = x[i] + carry;
        carry = limb < carry;
        sum[i] = limb;
    }
    sum[n] = carry;
    set_size(n + 1, sign);
}

void Integer::set_difference_of_magnitudes(const Integer& larger, const Integer& smaller, int sign)
{
    const int n = larger.size(), m = smaller.size();
    reserve(n);
    const Limb *const x = larger.limbs(), *const y = smaller.limbs();
    Limb* const difference = limbs();
    Limb borrow = 0;
    for (int i = 0; i < m; ++i) {
        const Wide128 total = Wide128(x[i]) - y[i] - borrow;
        difference[i] = static_cast<Limb>(total);
        borrow = static_cast<Limb>(total >> 64) & 1;
    }
    for (int i = m; i < n; ++i) {
        const Limb limb = x[i];
        difference[i] = limb - borrow;
        borrow = limb < borrow;
    }
    set_size(n, sign);
}

Integer& Integer::set_sum(const Integer& a, const Integer& b, int sign_of_b)
{
    const int sign_a = a.sign(), sign_b = b.sign() * sign_of_b;
    if (sign_b == 0) return *this = a;
    if (sign_a == 0) {
        *this = b;
        if (sign_of_b < 0) negate();
        return *this;
    }
    if (sign_a == sign_b) {
        set_sum_of_magnitudes(a, b, sign_a);
        return *this;
    }
    const int order = compare_magnitudes(a, b);
    if (order == 0)
        count_ = 0;
    else if (order > 0)
        set_difference_of_magnitudes(a, b, sign_a);
    else
        set_difference_of_magnitudes(b, a, sign_b);
    return *this;
}

void Integer::set_product(const Integer& a, const Integer& b)
{
    const int n = a.size(), m = b.size();
    count_ = 0;
    if (n == 0 || m == 0) return;
    reserve(n + m);
    const Limb *const x = a.limbs(), *const y = b.limbs();
    Limb* const product = limbs();
    Limb first_carry = 0;
    for (int i = 0; i < n; ++i) {
        const Wide128 total = Wide128(x[i]) * y[0] + first_carry;
        product[i] = static_cast<Limb>(total);
        first_carry = static_cast<Limb>(total >> 64);
    }
    product[n] = first_carry;
    for (int j = 1; j < m; ++j) {
        Limb carry = 0;
        for (int i = 0; i < n; ++i) {
            const Wide128 total = Wide128(x[i]) * y[j] + product[i + j] + carry;
            product[i + j] = static_cast<Limb>(total);
            carry = static_cast<Limb>(total >> 64);
        }
        product[n + j] = carry;
    }
    set_size(n + m, a.sign() * b.sign());
}

Integer& Integer::add_product(const Integer& a, const Integer& b, int sign)
{
    Integer product;
    product.set_product(a, b);
    return set_sum(*this, product, sign);
}

Integer& Integer::operator<<=(unsigned bits)
{
    const int n = size(), sign_before = sign();
    if (n == 0 || bits == 0) return *this;
    const int whole = static_cast<int>(bits / 64);
    const unsigned part = bits % 64;
    reserve(n + whole + 1);
    Limb* const limb = limbs();
    limb[n + whole] = part == 0 ? 0 : limb[n - 1] >> (64 - part);
    for (int i = n - 1; i >= 0; --i)
        limb[i + whole] = part == 0 ? limb[i] : limb[i] << part | (i > 0 ? limb[i - 1] >> (64 - part) : 0);
    std::fill_n(limb, whole, Limb(0));
    set_size(n + whole + 1, sign_before);
    return *this;
}

}  // namespace nuno

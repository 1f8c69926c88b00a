// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/plain_row.h"

#include "core/capture/formats/text/text_table.h"

#include <array>
#include <bit>
#include <cfloat>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace dyncal {
namespace {

static_assert(FLT_EVAL_METHOD == 0, "one rounding per operation is what makes digits exact here");

constexpr std::ptrdiff_t kDigits = 19; ///< that fit 64 bits
constexpr std::uint64_t kExactMantissa = std::uint64_t(1) << 53;
constexpr int kExactExponent = 22; ///< 10^22 is the last exact power of ten
constexpr std::array<double, kExactExponent + 1> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7,
    1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

__extension__ using Wide = unsigned __int128;

constexpr int kLastPowerOf5 = 27; ///< the last that fits 64 bits
constexpr std::array<std::uint64_t, kLastPowerOf5 + 1> kPowersOf5 = [] {
    std::array<std::uint64_t, kLastPowerOf5 + 1> powers{1};
    for (std::size_t k = 1; k < powers.size(); ++k)
        powers[k] = powers[k - 1] * 5;
    return powers;
}();

bool isDigit(char c)
{
    return static_cast<unsigned char>(c - '0') < 10;
}

/// The value of eight digits, if these are eight digits (all at once in one register, Lemire 2022).
bool eightDigits(const char *at, std::uint64_t &value)
{
    std::uint64_t word;
    std::memcpy(&word, at, sizeof word);
    const std::uint64_t high = word & 0xF0F0F0F0F0F0F0F0;
    const std::uint64_t above9 = (word + 0x0606060606060606) & 0xF0F0F0F0F0F0F0F0;
    if (high != 0x3030303030303030 || above9 != high)
        return false;
    word -= 0x3030303030303030;
    word = word * 10 + (word >> 8);
    const std::uint64_t mask = 0x000000FF000000FF;
    value = ((word & mask) * 0x000F424000000064 + ((word >> 16) & mask) * 0x0000271000000001) >> 32;
    return true;
}

/// Reads digits; too many overflow harmlessly, as their number is checked later.
const char *behindDigits(const char *at, const char *end, std::uint64_t &mantissa)
{
    for (; at != end && isDigit(*at); ++at)
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
    return at;
}

/// The same for the digits after the mark, eight at a time because there are more of them.
const char *behindFraction(const char *at, const char *end, std::uint64_t &mantissa)
{
    constexpr std::uint64_t kEightPlaces = 100000000;
    if constexpr (std::endian::native == std::endian::little) {
        std::uint64_t eight = 0;
        while (end - at >= 8 && eightDigits(at, eight)) {
            mantissa = mantissa * kEightPlaces + eight;
            at += 8;
        }
    }
    return behindDigits(at, end, mantissa);
}

/// "e-05" as -5; null if there are no or too many digits.
const char *behindExponent(const char *at, const char *end, int &exponent)
{
    constexpr std::ptrdiff_t kMostDigits = 4;
    const bool negative = at != end && *at == '-';
    if (at != end && (*at == '-' || *at == '+'))
        ++at;
    std::uint64_t value = 0;
    const char *const behind = behindDigits(at, end, value);
    if (behind == at || behind - at > kMostDigits)
        return nullptr;
    exponent = negative ? -static_cast<int>(value) : static_cast<int>(value);
    return behind;
}

/// What a number is made of.
struct Digits
{
    std::uint64_t mantissa = 0;
    std::ptrdiff_t count = 0;
    int exponent = 0;
    bool negative = false;
};

/// Takes a number apart; null if there is none.
const char *behindNumber(const char *at, const char *end, char decimal, Digits &number)
{
    number.negative = at != end && *at == '-';
    at += at != end && (*at == '-' || *at == '+') ? 1 : 0;
    const char *const integer = at;
    at = behindDigits(at, end, number.mantissa);
    number.count = at - integer;
    std::ptrdiff_t decimals = 0;
    if (at != end && *at == decimal) {
        const char *const fraction = at + 1;
        at = behindFraction(fraction, end, number.mantissa);
        decimals = at - fraction;
        if (decimals == 0 && decimal != '.')
            return nullptr; // "1," is a list of one
    }
    number.count += decimals;
    if (number.count == 0)
        return nullptr;
    if (at != end && (*at == 'e' || *at == 'E'))
        at = behindExponent(at + 1, end, number.exponent);
    number.exponent -= static_cast<int>(decimals);
    return at;
}

/// Without a branch, which the processor would mispredict every second time.
double signOf(const Digits &number)
{
    constexpr std::array<double, 2> kSign{1.0, -1.0};
    return kSign[number.negative ? 1 : 0];
}

/// Mantissa / 10^k for all 64 bits of it, correctly rounded: w / 5^k to at least 63 bits in 128-bit
/// integers, one more bit for a remainder (so that ties are recognised), and a power of two.
double longQuotient(std::uint64_t mantissa, std::size_t k)
{
    const std::uint64_t power = kPowersOf5[k];
    const int up = std::countl_zero(mantissa);
    const int powerUp = std::countl_zero(power);
    const Wide dividend = static_cast<Wide>(mantissa << up) << 63;
    const std::uint64_t divisor = power << powerUp;
    const auto quotient = static_cast<std::uint64_t>(dividend / divisor); // < 2^64: both >= 2^63
    const bool rest = static_cast<Wide>(quotient) * divisor != dividend;
    const int twos = powerUp - up - 63 - static_cast<int>(k);
    const auto scale = static_cast<std::uint64_t>(1023 + twos) << 52; // of a normal number
    return static_cast<double>(quotient | (rest ? 1 : 0)) * std::bit_cast<double>(scale);
}

/// Mantissa times power of ten with one rounding: in one operation where both are exact (Clinger
/// 1990), otherwise by integers.
bool compose(const Digits &number, double &value)
{
    if (number.count > kDigits)
        return false;
    const int exponent = std::abs(number.exponent);
    if (number.mantissa <= kExactMantissa && exponent <= kExactExponent) {
        const double power = kPowers[static_cast<std::size_t>(exponent)];
        const double digits
            = signOf(number) * static_cast<double>(static_cast<std::int64_t>(number.mantissa));
        value = number.exponent < 0 ? digits / power : digits * power;
        return true;
    }
    if (number.mantissa == 0 || number.exponent > 0 || exponent > kLastPowerOf5)
        return false;
    value = signOf(number) * longQuotient(number.mantissa, static_cast<std::size_t>(exponent));
    return true;
}

/// Reads one number; null if there is none.
const char *readNumber(const char *at, const char *end, char decimal, double &value)
{
    Digits number;
    const char *const behind = behindNumber(at, end, decimal, number);
    if (behind == nullptr || compose(number, value))
        return behind;
    const std::string_view cell(at, static_cast<std::size_t>(behind - at));
    return readCell(cell, decimal, value) == CellKind::Number ? behind : nullptr;
}

const char *behindBlanks(const char *at, const char *end, char separator)
{
    while (at != end && (*at == ' ' || (*at == '\t' && separator != '\t')))
        ++at;
    return at;
}

} // namespace

const char *PlainRowReader::behindRow(const char *at, const char *end, const Target &row) const
{
    const bool byBlanks = m_separator == kBlankSeparator;
    for (std::size_t i = 0; i < row.count; ++i) {
        const char *const number = behindBlanks(at, end, m_separator);
        if (i > 0 && byBlanks && number == at)
            return nullptr; // "1.5-2.5" is one cell
        at = readNumber(number, end, m_decimal, row.first[i * row.distance]);
        if (at == nullptr)
            return nullptr;
        if (byBlanks || i + 1 == row.count)
            continue;
        at = behindBlanks(at, end, m_separator);
        if (at == end || *at != m_separator)
            return nullptr;
        ++at;
    }
    at = behindBlanks(at, end, m_separator);
    while (at != end && *at == m_separator)
        at = behindBlanks(at + 1, end, m_separator);
    return at;
}

const char *PlainRowReader::behindLine(const char *at, const char *end, const Target &row) const
{
    at = behindRow(at, end, row);
    if (at == nullptr || at == end)
        return nullptr; // an unfinished line is left to the slow way
    if (*at == '\n')
        return at + 1;
    if (*at != '\r')
        return nullptr;
    return at + 1 != end && at[1] == '\n' ? at + 2 : at + 1;
}

const char *PlainRowReader::read(std::string_view text, std::span<double> row) const
{
    if (m_separator == m_decimal)
        return nullptr; // only quotes tell them apart
    return behindLine(text.data(), text.data() + text.size(), {row.data(), row.size(), 1});
}

std::size_t PlainRowReader::readRows(
    std::string_view &text, std::size_t numbers, double *columns, std::size_t most) const
{
    if (m_separator == m_decimal)
        return 0;
    const char *at = text.data();
    const char *const end = at + text.size();
    std::size_t rows = 0;
    for (; rows < most; ++rows) {
        const char *const behind = behindLine(at, end, {columns + rows, numbers, most});
        if (behind == nullptr)
            break;
        at = behind;
    }
    text.remove_prefix(static_cast<std::size_t>(at - text.data()));
    return rows;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace dyncal {
namespace {

using Node = TdmsScaleNode;
using Refusal = tl::unexpected<Message>;

constexpr std::uint64_t kRawInput = 0xFFFFFFFF;
constexpr std::uint64_t kMostScales = 256;

std::string prefixOf(std::uint64_t scale)
{
    return "NI_Scale[" + std::to_string(scale) + "]_";
}

/// Highest index in NI_Scale[k]_Scale_Type + 1; 0 if there is none.
std::uint64_t countedScales(const TdmsProperties &properties)
{
    constexpr std::string_view kPrefix = "NI_Scale[";
    std::uint64_t count = 0;
    for (auto it = properties.lower_bound(kPrefix);
         it != properties.end() && it->first.starts_with(kPrefix); ++it) {
        std::uint64_t index = 0;
        std::size_t i = kPrefix.size();
        for (; i < it->first.size() && it->first[i] >= '0' && it->first[i] <= '9'; ++i)
            index = std::min<std::uint64_t>(
                index * 10 + static_cast<std::uint64_t>(it->first[i] - '0'), kRawInput);
        if (it->first.substr(i) == "]_Scale_Type")
            count = std::max(count, index + 1);
    }
    return count;
}

std::uint64_t numberOfScales(const TdmsProperties &properties)
{
    const auto stated = countOf(properties, "NI_Number_Of_Scales");
    return stated ? *stated : countedScales(properties);
}

/// Value of a list as LabVIEW writes it: <name>[0], <name>[1], ...; its length in <name>_Size.
/// Empty if an element is missing or not finite.
std::vector<double> listOf(
    const TdmsProperties &properties, const std::string &name, std::uint64_t defaultSize)
{
    const std::uint64_t size = countOf(properties, name + "_Size").value_or(defaultSize);
    std::vector<double> values;
    if (size > properties.size())
        return values;
    for (std::uint64_t i = 0; i < size; ++i) {
        const auto value = numberOf(properties, name + "[" + std::to_string(i) + "]");
        if (!value || !std::isfinite(*value))
            return {};
        values.push_back(*value);
    }
    return values;
}

/// Builds the chain from the last scale down.
class ChainBuilder
{
public:
    ChainBuilder(
        const std::string &channel, const TdmsProperties &properties, const TdmsCounts &counts)
        : m_channel(channel)
        , m_properties(properties)
        , m_counts(counts)
    {
    }

    tl::expected<std::optional<TdmsScaleChain>, Message> build(std::uint64_t scales)
    {
        if (scales > kMostScales)
            return problem(
                DYNCAL_TEXT("core", "Channel %1 declares %2 scales, more than can be meant."),
                {std::to_string(scales)});
        m_scales = scales;
        if (const auto result = node(scales - 1); !result)
            return Refusal(result.error());
        return std::optional(std::move(m_chain));
    }

private:
    using Place = tl::expected<std::size_t, Message>;

    Refusal problem(const char *text, std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), m_channel);
        return Refusal(Message{text, std::move(arguments)});
    }

    Refusal incomplete(std::uint64_t scale, const std::string &type) const
    {
        return problem(
            DYNCAL_TEXT("core",
                "Channel %1: scale %2 (%3) lacks a number that it needs, or has one that makes no sense."),
            {std::to_string(scale), type});
    }

    std::size_t add(Node node)
    {
        m_chain.nodes.push_back(std::move(node));
        return m_chain.nodes.size() - 1;
    }

    /// The node of a scale; scales that several others use exist once.
    Place node(std::uint64_t scale)
    {
        if (const auto known = m_known.find(scale); known != m_known.end())
            return known->second;
        if (scale != kRawInput && (scale >= m_scales || !m_open.insert(scale).second))
            return problem(
                DYNCAL_TEXT("core",
                    "The scales of channel %1 refer to scale %2, which is not there or needs itself."),
                {std::to_string(scale)});
        const Place place = scale == kRawInput ? rawInput() : scaleNode(scale);
        if (place)
            m_known[scale] = *place;
        return place;
    }

    Place rawInput()
    {
        if (m_counts.daqmx && m_counts.scaleIds.size() != 1)
            return problem(
                DYNCAL_TEXT("core",
                    "The scales of channel %1 do not say which of its %2 kinds of counts they are for."),
                {std::to_string(m_counts.scaleIds.size())});
        return rawNode(0);
    }

    std::size_t rawNode(std::size_t stream)
    {
        Node raw;
        raw.stream = stream;
        return add(std::move(raw));
    }

    /// A scale without type stands for the counts of the DAQmx scaler with its number.
    Place scalerNode(std::uint64_t scale)
    {
        const auto &ids = m_counts.scaleIds;
        const auto found = std::find(ids.begin(), ids.end(), scale);
        if (found == ids.end() || std::count(ids.begin(), ids.end(), scale) > 1)
            return problem(
                DYNCAL_TEXT("core", "Channel %1: scale %2 has no type and no counts of its own."),
                {std::to_string(scale)});
        return rawNode(static_cast<std::size_t>(found - ids.begin()));
    }

    Place scaleNode(std::uint64_t scale)
    {
        const std::string typeName = prefixOf(scale) + "Scale_Type";
        if (!m_properties.contains(typeName))
            return scalerNode(scale);
        const std::string type = textOf(m_properties, typeName);
        if (type == "Linear")
            return linear(scale);
        if (type == "Polynomial")
            return polynomial(scale);
        if (type == "Table")
            return table(scale);
        if (type == "Add")
            return pair(scale, type, Node::Kind::Sum);
        if (type == "Subtract")
            return pair(scale, type, Node::Kind::Difference);
        if (type == "AdvancedAPI")
            return input(scale, "AdvancedAPI_Input_Source");
        return problem(
            DYNCAL_TEXT("core",
                "Channel %1: scale %2 is of the kind \"%3\", which this program does not apply; write the channel scaled."),
            {std::to_string(scale), type});
    }

    Place input(std::uint64_t scale, const char *name)
    {
        return node(countOf(m_properties, prefixOf(scale) + name).value_or(kRawInput));
    }

    Place addWithInput(Node made, std::uint64_t scale, const char *inputName)
    {
        const Place source = input(scale, inputName);
        if (!source)
            return source;
        made.left = *source;
        return add(std::move(made));
    }

    Place linear(std::uint64_t scale)
    {
        const auto slope = numberOf(m_properties, prefixOf(scale) + "Linear_Slope");
        const auto intercept = numberOf(m_properties, prefixOf(scale) + "Linear_Y_Intercept");
        if (!slope || !intercept || !std::isfinite(*slope) || !std::isfinite(*intercept))
            return incomplete(scale, "Linear");
        Node made;
        made.kind = Node::Kind::Polynomial;
        made.coefficients = {*intercept, *slope};
        return addWithInput(std::move(made), scale, "Linear_Input_Source");
    }

    Place polynomial(std::uint64_t scale)
    {
        constexpr std::uint64_t kDefaultCoefficients = 4;
        Node made;
        made.kind = Node::Kind::Polynomial;
        made.coefficients = listOf(
            m_properties, prefixOf(scale) + "Polynomial_Coefficients", kDefaultCoefficients);
        if (made.coefficients.empty())
            return incomplete(scale, "Polynomial");
        return addWithInput(std::move(made), scale, "Polynomial_Input_Source");
    }

    Place table(std::uint64_t scale)
    {
        Node made;
        made.kind = Node::Kind::Table;
        made.inputs = listOf(m_properties, prefixOf(scale) + "Table_Pre_Scaled_Values", 0);
        made.outputs = listOf(m_properties, prefixOf(scale) + "Table_Scaled_Values", 0);
        if (made.inputs.size() > 1 && made.inputs.front() > made.inputs.back()) {
            std::reverse(made.inputs.begin(), made.inputs.end());
            std::reverse(made.outputs.begin(), made.outputs.end());
        }
        const bool increasing
            = std::adjacent_find(made.inputs.begin(), made.inputs.end(), std::greater_equal<>())
            == made.inputs.end();
        if (made.inputs.empty() || made.inputs.size() != made.outputs.size() || !increasing)
            return incomplete(scale, "Table");
        return addWithInput(std::move(made), scale, "Table_Input_Source");
    }

    Place pair(std::uint64_t scale, const std::string &type, Node::Kind kind)
    {
        const std::string left = type + "_Left_Operand_Input_Source";
        const std::string right = type + "_Right_Operand_Input_Source";
        if (!m_properties.contains(prefixOf(scale) + left)
            || !m_properties.contains(prefixOf(scale) + right))
            return incomplete(scale, type);
        const Place first = input(scale, left.c_str());
        if (!first)
            return first;
        const Place second = input(scale, right.c_str());
        if (!second)
            return second;
        Node made;
        made.kind = kind;
        made.left = *first;
        made.right = *second;
        return add(std::move(made));
    }

    const std::string &m_channel;
    const TdmsProperties &m_properties;
    const TdmsCounts &m_counts;
    std::uint64_t m_scales = 0;
    TdmsScaleChain m_chain;
    std::map<std::uint64_t, std::size_t> m_known; ///< scale -> node
    std::set<std::uint64_t> m_open; ///< scales that have been begun
};

template <typename Number>
Number horner(std::span<const double> coefficients, Number x)
{
    Number sum = 0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
        sum = sum * x + static_cast<Number>(*c);
    return sum;
}

double interpolated(const Node &table, double x)
{
    if (std::isnan(x))
        return x;
    const auto above = std::upper_bound(table.inputs.begin(), table.inputs.end(), x);
    if (above == table.inputs.begin())
        return table.outputs.front();
    if (above == table.inputs.end())
        return table.outputs.back();
    const auto i = static_cast<std::size_t>(above - table.inputs.begin());
    const double fraction = (x - table.inputs[i - 1]) / (table.inputs[i] - table.inputs[i - 1]);
    return table.outputs[i - 1] + fraction * (table.outputs[i] - table.outputs[i - 1]);
}

double valueAt(const Node &node, double left, double right)
{
    switch (node.kind) {
    case Node::Kind::Raw:
        return left;
    case Node::Kind::Polynomial:
        return horner(std::span(node.coefficients), left);
    case Node::Kind::Table:
        return interpolated(node, left);
    case Node::Kind::Sum:
        return left + right;
    case Node::Kind::Difference:
        return right - left;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

using LongPolynomial = std::vector<long double>;

/// outer(inner(x)), with more digits than the result keeps.
LongPolynomial composed(const std::vector<double> &outer, const LongPolynomial &inner)
{
    LongPolynomial result{0.0L};
    for (auto c = outer.rbegin(); c != outer.rend(); ++c) {
        LongPolynomial product(result.size() + inner.size() - 1, 0.0L);
        for (std::size_t i = 0; i < result.size(); ++i) {
            for (std::size_t k = 0; k < inner.size(); ++k)
                product[i + k] += result[i] * inner[k];
        }
        product[0] += static_cast<long double>(*c);
        result = std::move(product);
        while (result.size() > 1 && result.back() == 0.0L)
            result.pop_back();
    }
    return result;
}

/// Whether the polynomial gives the chain's values to double precision.
bool agrees(
    const TdmsScaleChain &chain, const TdmsPolynomial &polynomial, double lowest, double highest)
{
    constexpr int kPoints = 33;
    constexpr double kTolerance = 8 * std::numeric_limits<double>::epsilon(); // roundings of both
    double largest = 0.0;
    double difference = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        const double x = lowest + (highest - lowest) * i / (kPoints - 1);
        double value = x;
        for (const Node &node : chain.nodes)
            value = valueAt(node, value, 0.0);
        const double here = std::abs(horner(std::span(polynomial.coefficients), x) - value);
        if (!std::isfinite(here)) // std::max passes over NaN
            return false;
        largest = std::max(largest, std::abs(value));
        difference = std::max(difference, here);
    }
    return difference <= kTolerance * largest;
}

} // namespace

tl::expected<std::optional<TdmsScaleChain>, Message> tdmsScaleChain(const std::string &channel,
    std::span<const TdmsProperties *const> holders, const TdmsCounts &counts)
{
    for (const TdmsProperties *holder : holders) {
        const std::uint64_t scales = holder != nullptr ? numberOfScales(*holder) : 0;
        if (scales == 0)
            continue;
        if (textOf(*holder, "NI_Scaling_Status") == "scaled" && !counts.daqmx)
            break;
        return ChainBuilder(channel, *holder, counts).build(scales);
    }
    if (counts.daqmx && counts.scaleIds.size() != 1)
        return std::nullopt;
    TdmsScaleChain raw;
    raw.nodes.emplace_back();
    return std::optional(std::move(raw));
}

void evaluate(
    const TdmsScaleChain &chain, std::span<const std::vector<double>> raw, std::span<double> values)
{
    std::vector<std::vector<double>> results(chain.nodes.size());
    for (std::size_t n = 0; n < chain.nodes.size(); ++n) {
        const Node &node = chain.nodes[n];
        const bool isRaw = node.kind == Node::Kind::Raw;
        const std::vector<double> &left = isRaw ? raw[node.stream] : results[node.left];
        const std::vector<double> &right = isRaw ? left : results[node.right];
        results[n].resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            results[n][i] = valueAt(node, left[i], right[i]);
    }
    std::copy(results.back().begin(), results.back().end(), values.begin());
}

std::optional<TdmsPolynomial> asPolynomial(
    const TdmsScaleChain &chain, double lowest, double highest)
{
    constexpr std::size_t kMostCoefficients = 13;
    TdmsPolynomial polynomial;
    LongPolynomial sum{0.0L, 1.0L};
    bool straight = true;
    for (std::size_t n = 0; n < chain.nodes.size(); ++n) {
        const Node &node = chain.nodes[n];
        if (n == 0) {
            polynomial.stream = node.stream;
            continue;
        }
        if (node.kind != Node::Kind::Polynomial || node.left != n - 1
            || node.coefficients.size() > kMostCoefficients)
            return {};
        straight = straight && node.coefficients.size() <= 2;
        sum = composed(node.coefficients, sum);
        if (sum.size() > kMostCoefficients)
            return {};
    }
    for (const long double coefficient : sum)
        polynomial.coefficients.push_back(static_cast<double>(coefficient));
    if (polynomial.coefficients.size() < 2)
        polynomial.coefficients.push_back(0.0);
    const bool single = chain.nodes.size() <= 2;
    const bool bounded = lowest < highest;
    const bool same = single || (bounded ? agrees(chain, polynomial, lowest, highest) : straight);
    return same ? std::optional(std::move(polynomial)) : std::nullopt;
}

} // namespace dyncal

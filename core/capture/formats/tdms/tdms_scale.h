// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/capture/formats/tdms/tdms_properties.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace dyncal {

/// One scale of a chain, or the counts themselves.
struct TdmsScaleNode
{
    enum class Kind { Raw, Polynomial, Table, Sum, Difference };

    Kind kind = Kind::Raw;
    std::size_t left = 0; ///< input: a node before this one
    std::size_t right = 0; ///< second input of Sum and Difference (right - left)
    std::size_t stream = 0; ///< Raw: which counts of the channel
    std::vector<double> coefficients; ///< Polynomial: ascending
    std::vector<double> inputs; ///< Table: increasing
    std::vector<double> outputs; ///< Table: linear in between, held at both ends
};

/// What turns the counts of a channel into its quantity (NI_Scale properties). A node comes after
/// its inputs; the last node is the result.
struct TdmsScaleChain
{
    std::vector<TdmsScaleNode> nodes;

    bool isRaw() const { return nodes.size() == 1; }
};

/// The kinds of counts of a channel: scaler ids of a DAQmx channel; empty for others, which have
/// one kind.
struct TdmsCounts
{
    bool daqmx = false;
    std::vector<std::uint32_t> scaleIds;
};

/// The scales of a channel: its own, else its group's, else the file's. A chain of the counts alone
/// if there are none, or if the samples are stored scaled. Fails with a sentence (%1 = channel) if
/// a scale is of a kind that is not read, incomplete or refers to what is not there: a channel is
/// never read with a scale left out. Empty: DAQmx counts of several kinds without any scale.
tl::expected<std::optional<TdmsScaleChain>, Message> tdmsScaleChain(const std::string &channel,
    std::span<const TdmsProperties *const> holders, const TdmsCounts &counts);

/// Values of the quantity: `raw` holds samples of every stream, all of the same length as `values`.
void evaluate(const TdmsScaleChain &chain, std::span<const std::vector<double>> raw,
    std::span<double> values);

/// A chain of polynomials as one polynomial of one kind of counts.
struct TdmsPolynomial
{
    std::size_t stream = 0;
    std::vector<double> coefficients; ///< ascending
};

/// Empty if the chain is not one of polynomials, or if one polynomial would be less exact for
/// counts between `lowest` and `highest` (equal: unbounded counts; then at most one polynomial,
/// with straight lines, is combined).
std::optional<TdmsPolynomial> asPolynomial(
    const TdmsScaleChain &chain, double lowest, double highest);

} // namespace dyncal

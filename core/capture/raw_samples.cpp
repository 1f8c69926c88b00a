// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/raw_samples.h"

namespace dyncal {

RawSamples::RawSamples()
    : RawSamples(Counts())
{
}

RawSamples::RawSamples(Counts counts)
    : m_counts(std::make_shared<const Counts>(std::move(counts)))
    , m_size(std::visit([](const auto &v) { return static_cast<Index>(v.size()); }, *m_counts))
{
}

double RawSamples::at(Index i) const
{
    return std::visit(
        [i](const auto &v) { return static_cast<double>(v[static_cast<std::size_t>(i)]); },
        *m_counts);
}

std::span<const std::byte> RawSamples::bytes() const
{
    return std::visit(
        [](const auto &v) { return std::as_bytes(std::span(v.data(), v.size())); }, *m_counts);
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/json_codec.h"

#include <utility>
#include <vector>

namespace dyncal {

/// Collects the keys that a struct of plain settings lists itself (`S::keys`), beside the defaults.
template <typename S>
class SectionKeys
{
public:
    void flag(const char *key, const char *label, bool S::*member)
    {
        m_fields.push_back(field(key, label, member, boolean()));
    }
    void whole(const char *key, const char *label, Index S::*member, Index least, Index most)
    {
        m_fields.push_back(field(key, label, member, dyncal::whole(least, most)));
    }
    void number(const char *key, const char *label, double S::*member, double least, double most)
    {
        m_fields.push_back(field(key, label, member, dyncal::number(least, most)));
    }
    /// Above `least` and below `most`.
    void inside(const char *key, const char *label, double S::*member, double least, double most)
    {
        m_fields.push_back(
            field(key, label, member, dyncal::number(least, most, Bound::Exclusive)));
    }
    void nonNegative(const char *key, const char *label, double S::*member)
    {
        m_fields.push_back(field(key, label, member, nonNegativeNumber()));
    }
    /// A section of such settings: an object with the keys that it lists.
    template <typename T>
    void section(const char *key, const char *label, T S::*member)
    {
        SectionKeys<T> below;
        T::keys(below);
        m_fields.push_back(field(key, label, member, object<T>(below.take())));
    }

    std::vector<Field<S>> take() { return std::move(m_fields); }

private:
    std::vector<Field<S>> m_fields;
};

} // namespace dyncal

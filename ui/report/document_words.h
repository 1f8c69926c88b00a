// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "ui/report/report_language.h"

#include <QString>

#include <memory>
#include <string>

namespace dyncal {

/// The words of a document, which shortens nothing and keeps the lines of what was typed: in the
/// language that is installed, and beside them in a second one, if it has any. Labels stand side by
/// side ("Place / Plats"), sentences and whatever is in a table below each other; what is the same
/// in both, as names are, stands once; so do numbers, with the decimal mark of the first.
class DocumentWords
{
public:
    explicit DocumentWords(const std::string &secondLanguage = {}); ///< "" = none

    QString operator()(const Message &message) const;
    QString inTable(const Message &message) const; ///< whose columns are narrow

private:
    QString second(const Message &message) const; ///< empty where there is no other one

    std::shared_ptr<const ReportLanguage> m_second;
};

} // namespace dyncal

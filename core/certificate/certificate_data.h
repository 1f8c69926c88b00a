// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// One line "label: value".
struct CertificateField
{
    std::string id; ///< stable: "laboratory", "natural_frequency"
    Message label;
    Message value;
    bool missing = false; ///< must be there before the certificate can be issued
    bool wrong = false; ///< missing, because what is typed is not what it must be
};

struct CertificateColumn
{
    Message heading;
    bool number = false; ///< right-aligned
};

struct CertificateTable
{
    std::string id;
    Message caption;
    std::vector<CertificateColumn> columns;
    std::vector<std::vector<Message>> rows; ///< as many cells as columns
};

struct CertificateFigure
{
    std::string id; ///< "singular-values", "model-data", "model-error", "magnitude", ...
    Message caption;
};

struct CertificateSection
{
    std::string id;
    Message title;
    std::vector<Message> paragraphs; ///< before the fields
    std::vector<CertificateField> fields;
    std::vector<CertificateTable> tables;
    std::vector<Message> notes; ///< after the tables
    std::vector<CertificateFigure> figures;
};

/// The picture of the laboratory beside the title (checkLogo()).
struct CertificateLogo
{
    std::string bytes; ///< of its file; "" = none
    bool isSvg = false; ///< else PNG
};

/// A file inside the PDF of an issued certificate (core/pdf/pdf_archive.h).
struct CertificateAttachment
{
    std::string name;
    std::string mime;
    std::string relationship; ///< to the pages, one of kPdfRelationships
    Message description;
    std::string bytes;
};

/// A certificate as words and rounded numbers, ready for typesetting: no layout, no floating point.
struct CertificateData
{
    std::string language;
    std::string secondLanguage = {}; ///< of labels beside those of the first; "" = none
    std::string createdUtc;
    std::string number; ///< empty = none yet
    Message title;
    bool draft = true; ///< until it is issued (certificate_issue.h)
    bool isCertificate = true; ///< else a report without a number
    std::vector<CertificateSection> sections;
    /// By which an issued one is held against its files: name and value, in the file's metadata.
    std::vector<std::pair<std::string, std::string>> marks = {};
    CertificateLogo logo = {};
    std::vector<CertificateAttachment> attachments = {}; ///< of an issued one

    /// Labels of all fields that are missing, in order.
    std::vector<Message> missingFields() const;
    const CertificateSection *section(const std::string &id) const;
};

} // namespace dyncal

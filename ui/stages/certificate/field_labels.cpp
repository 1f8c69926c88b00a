// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/field_labels.h"

#include "core/certificate/certificate.h"
#include "ui/text/core_text.h"

#include <QCoreApplication>

#include <array>

namespace dyncal {

namespace {

struct Label
{
    const char *key;
    const char *text;
};

/// Of the fields that are not printed as such.
constexpr std::array<Label, 3> kNotPrinted{{
    {"laboratory_country", QT_TRANSLATE_NOOP("dyncal::FieldLabels", "Country of the laboratory")},
    {"customer_country", QT_TRANSLATE_NOOP("dyncal::FieldLabels", "Country of the customer")},
    {"remarks", QT_TRANSLATE_NOOP("dyncal::FieldLabels", "Remarks")},
}};

} // namespace

const CertificateField *fieldOf(const CertificateData &data, std::string_view key)
{
    for (const CertificateSection &section : data.sections)
        for (const CertificateField &field : section.fields)
            if (field.id == key)
                return &field;
    return nullptr;
}

const CertificateField *printedField(const std::string &key)
{
    static const CertificateData kEmpty = makeCertificate({}, {}, {});
    return fieldOf(kEmpty, key);
}

QString fieldLabel(const std::string &key)
{
    if (const CertificateField *printed = printedField(key))
        return translated(printed->label);
    for (const Label &label : kNotPrinted)
        if (key == label.key)
            return QCoreApplication::translate("dyncal::FieldLabels", label.text);
    return {};
}

} // namespace dyncal

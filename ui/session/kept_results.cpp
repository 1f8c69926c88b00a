// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/kept_results.h"

#include "core/base/foreign_text.h"

#include <QJsonArray>

namespace dyncal {

namespace {

QJsonArray jsonOf(const std::vector<Message> &messages);

QJsonObject jsonOf(const Message &message)
{
    QJsonObject json{{"text", message.text}};
    QJsonArray arguments;
    for (const std::string &argument : message.arguments)
        arguments << QString::fromStdString(argument);
    if (!arguments.isEmpty())
        json["arguments"] = arguments;
    if (!message.below.empty())
        json["below"] = jsonOf(message.below);
    return json;
}

QJsonArray jsonOf(const std::vector<Message> &messages)
{
    QJsonArray json;
    for (const Message &message : messages)
        json << jsonOf(message);
    return json;
}

QJsonObject jsonOf(const CertificateTable &table)
{
    QJsonArray headings;
    for (const CertificateColumn &column : table.columns)
        headings << jsonOf(column.heading);
    QJsonArray rows;
    for (const auto &row : table.rows)
        rows << jsonOf(row);
    return {{"caption", jsonOf(table.caption)}, {"columns", headings}, {"rows", rows}};
}

QJsonObject jsonOf(const CertificateSection &section)
{
    QJsonArray fields;
    for (const CertificateField &field : section.fields)
        fields << QJsonObject{{"label", jsonOf(field.label)}, {"value", jsonOf(field.value)}};
    QJsonArray tables;
    for (const CertificateTable &table : section.tables)
        tables << jsonOf(table);
    return {{"title", jsonOf(section.title)}, {"paragraphs", jsonOf(section.paragraphs)},
        {"fields", fields}, {"tables", tables}, {"notes", jsonOf(section.notes)}};
}

/// Builds the certificate again. Messages point to their texts, which it keeps.
class Reader
{
public:
    Message message(const QJsonValue &json)
    {
        Message message;
        const std::string text = json["text"].toString().toStdString(); // foreign, in a file
        message.text = m_texts->insert(presentable(text, LineBreaks::Keep)).first->c_str();
        for (const auto &argument : json["arguments"].toArray())
            message.arguments.push_back(argument.toString().toStdString());
        message.below = messages(json["below"]);
        return message;
    }

    std::vector<Message> messages(const QJsonValue &json)
    {
        std::vector<Message> list;
        for (const auto &each : json.toArray())
            list.push_back(message(each));
        return list;
    }

    CertificateSection section(const QJsonValue &json)
    {
        CertificateSection section;
        section.title = message(json["title"]);
        section.paragraphs = messages(json["paragraphs"]);
        section.notes = messages(json["notes"]);
        for (const auto &field : json["fields"].toArray())
            section.fields.push_back({{}, message(field[QLatin1String("label")]),
                message(field[QLatin1String("value")])});
        for (const auto &each : json["tables"].toArray())
            section.tables.push_back(table(each));
        return section;
    }

    std::shared_ptr<const std::set<std::string>> texts() const { return m_texts; }

private:
    /// Rows are made as long as there are columns, whatever the file says.
    CertificateTable table(const QJsonValue &json)
    {
        CertificateTable table;
        table.caption = message(json["caption"]);
        for (const Message &heading : messages(json["columns"]))
            table.columns.push_back({heading});
        for (const auto &row : json["rows"].toArray()) {
            table.rows.push_back(messages(row));
            table.rows.back().resize(table.columns.size());
        }
        return table;
    }

    std::shared_ptr<std::set<std::string>> m_texts = std::make_shared<std::set<std::string>>();
};

} // namespace

QJsonObject keptResultsJson(const CertificateData &certificate, const std::string &savedUtc)
{
    QJsonArray sections;
    for (const CertificateSection &section : certificate.sections)
        sections << jsonOf(section);
    return {{"saved_utc", QString::fromStdString(savedUtc)}, {"title", jsonOf(certificate.title)},
        {"sections", sections}};
}

std::optional<KeptResults> keptResults(const QJsonObject &project)
{
    const QJsonValue json = project[kKeptResults];
    const QJsonArray sections = json["sections"].toArray();
    if (sections.isEmpty())
        return std::nullopt;
    Reader reader;
    KeptResults kept{json["saved_utc"].toString().toStdString(), {}};
    kept.certificate.title = reader.message(json["title"]);
    for (const auto &section : sections)
        kept.certificate.sections.push_back(reader.section(section));
    kept.texts = reader.texts();
    return kept;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_reading.h"

#include "core/base/constants.h"
#include "core/project/strict_json.h"

namespace dyncal {
namespace {

/// "dyncal-results/" of whatever version.
bool isOtherVersion(const std::string &schema)
{
    const std::string own = kResultsSchema;
    return schema.starts_with(own.substr(0, own.find('/') + 1));
}

Result<void> checkResultsSchema(const Json &root, const std::string &name)
{
    const std::string schema = textAt(root, "schema");
    if (schema == kResultsSchema)
        return {};
    return fail(ErrorKind::Usage,
        {isOtherVersion(schema)
                ? DYNCAL_TEXT("core",
                    "%1 was written by a later version: its schema is \"%2\", and this one reads \"%3\"; use that version of Dyncal.")
                : DYNCAL_TEXT("core",
                    "%1 is no results.json of a calibration: its schema is \"%2\" instead of \"%3\"; give the folder or the results.json that dyncal run wrote."),
            {name, schema, kResultsSchema}});
}

} // namespace

Result<Json> parseResults(const std::string &text, const std::string &name)
{
    Result<Json> root = parseStrictJson(text, name);
    if (!root)
        return root;
    if (const Result<void> checked = checkResultsSchema(*root, name); !checked)
        return tl::unexpected<Error>(checked.error());
    return root;
}

const Json &valueAt(const Json &object, const std::string &key)
{
    static const Json none;
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() ? *found : none;
}

double numberAt(const Json &object, const std::string &key)
{
    const Json &value = valueAt(object, key);
    return value.is_number() ? value.get<double>() : kUnknown;
}

std::string textAt(const Json &object, const std::string &key)
{
    const Json &value = valueAt(object, key);
    return value.is_string() ? value.get<std::string>() : std::string();
}

Eigen::VectorXd numbersAt(const Json &object, const std::string &key)
{
    const Json &list = valueAt(object, key);
    Eigen::VectorXd numbers(list.is_array() ? static_cast<Index>(list.size()) : 0);
    for (Index i = 0; i < numbers.size(); ++i) {
        const Json &value = list[static_cast<std::size_t>(i)];
        numbers[i] = value.is_number() ? value.get<double>() : kUnknown;
    }
    return numbers;
}

} // namespace dyncal

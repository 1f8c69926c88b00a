// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/checked_change.h"
#include "ui/stages/frame/entry_list.h"

#include <QPushButton>

#include <functional>
#include <vector>

namespace dyncal {

/// A list of the recipe as an EntryList edits it, and what its steps are called when undone.
template <typename Entry>
struct EntryEdits
{
    std::function<std::vector<Entry> &(Recipe &)> of;
    std::function<Entry()> typed; ///< as the fields have it
    QString adding;
    QString changing;
    QString removing;
};

/// The buttons of `list` add what is typed, put it in the place of the selected entry, or remove
/// that, each as changeIfAllowed() with the reason below the button. `session` outlives `list`.
template <typename Entry>
void connectEdits(Session &session, EntryList &list, const EntryEdits<Entry> &edits)
{
    const auto change = [&session, of = edits.of](QPushButton *button, const QString &label,
                            const std::function<void(std::vector<Entry> &)> &edit) {
        return changeIfAllowed(session, button, label, [&](Recipe &recipe) { edit(of(recipe)); });
    };
    QObject::connect(&list, &EntryList::addAsked, &list, [=, &list] {
        if (change(list.addingButton(), edits.adding,
                [&](auto &entries) { entries.push_back(edits.typed()); }))
            list.selectLast();
    });
    QObject::connect(&list, &EntryList::replaceAsked, &list, [=, &list] {
        change(list.replacingButton(), edits.changing, [&](auto &entries) {
            entries.at(static_cast<std::size_t>(list.row())) = edits.typed();
        });
    });
    QObject::connect(&list, &EntryList::removeAsked, &list, [=, &list] {
        change(list.removingButton(), edits.removing,
            [&](auto &entries) { entries.erase(entries.begin() + list.row()); });
    });
}

} // namespace dyncal

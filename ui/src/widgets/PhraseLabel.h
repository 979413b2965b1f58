#pragma once
#include <QString>

class QBoxLayout;
class QLabel;

namespace pellucida {

struct Phrase;

/// A label for a small text that changes, at the row's end. `widest`: the text it must have room for, UTF-8.
QLabel* add_phrase_label(QBoxLayout& row, const QString& widest = {});

/// Text and colour.
void show_phrase(QLabel& label, const Phrase& phrase);

}  // namespace pellucida

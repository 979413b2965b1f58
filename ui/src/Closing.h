#pragma once

class QWidget;

namespace pellucida {

/// Closes `window` without a question: a signal or a timer ends the program.
void close_now(QWidget& window);
/// True while `close_now` closes it.
bool closes_now(const QWidget& window);

/// Closes `window` as a person does who wants the start page next; it may ask first, or refuse.
void close_for_start_page(QWidget& window);
/// True once `close_for_start_page` was called; until then, or `forget_start_page`, the program ends with the window.
bool leads_to_start_page(const QWidget& window);
void forget_start_page(QWidget& window);

}  // namespace pellucida

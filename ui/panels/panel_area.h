#pragma once

class QScrollArea;
class QWidget;

namespace knead {

/// An area that scrolls a panel downwards only: it is at least as wide as the panel wants, in whatever language.
QScrollArea* scrolled(QWidget* panel);

} // namespace knead

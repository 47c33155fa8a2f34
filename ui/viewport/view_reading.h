#pragma once

namespace knead {

class Document;
class ViewportWidget;

/// For those who do not see the view: readers of screens hear what is selected, and a frame shows that Tab led to it.
void makeReadable(ViewportWidget& view, Document& document);

} // namespace knead

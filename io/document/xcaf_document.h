#pragma once

#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>

namespace knead {

/// A document that is closed in any case.
class ScopedDocument {
public:
    ScopedDocument() { XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", m_document); }
    ~ScopedDocument() { XCAFApp_Application::GetApplication()->Close(m_document); }
    ScopedDocument(const ScopedDocument&) = delete;
    ScopedDocument& operator=(const ScopedDocument&) = delete;

    Handle(TDocStd_Document) & operator*() { return m_document; }

private:
    Handle(TDocStd_Document) m_document;
};

} // namespace knead

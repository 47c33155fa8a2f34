#pragma once

#include <QWidget>

class QLineEdit;

namespace knead {

class ModelTree;

/// The model tree with a field to search it.
class ModelPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ModelPanel(ModelTree* tree, QWidget* parent = nullptr);

    void beginSearch();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLineEdit* m_search;
    ModelTree* m_tree;
};

} // namespace knead

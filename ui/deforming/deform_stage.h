#pragma once

#include "core/session/deformed_start.h"
#include "ui/deforming/deform_preview.h"
#include "ui/frame/workbench.h"
#include "ui/viewport/color_scale.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace knead {

/// Which parts are meant: per part of the model, and per body.
struct MeantParts {
    std::vector<bool> parts;
    std::vector<bool> bodies;

    bool isAny() const;
};

/// A deformation between being said and being done: shows in the view what it would make of the parts, and does it, as a new start of
/// the history. Window thread.
class DeformStage final : public QObject {
    Q_OBJECT
public:
    explicit DeformStage(const Workbench& bench);

    MeantParts allParts() const;
    MeantParts selectedParts() const;
    /// Of the surfaces that are meant, as they are now [m].
    Box boxOf(const MeantParts& meant) const;
    /// These surfaces together.
    TriangleMesh surfaceOf(const MeantParts& meant) const;

    struct Look {
        std::shared_ptr<const std::vector<Deformation>>
            deformations; ///< the same pointer as before: their map is still good
        MeantParts meant;
        double exaggeration = 1; ///< of all ways
        bool showsColors = false;
        QString caption;
        std::function<void(const SmoothMap& map, TaskControl&)> examine = {}; ///< see PreviewRequest
    };
    /// Shows what would come of it, as soon as that is known. Where all was seen before, all is then, unless a hand is dragging.
    void look(Look look, bool isDragged = false);
    /// The view shows the present again, and what is being applied is given up.
    void end();
    /// Meanwhile the view shows the present, in which something is selected.
    void setHidden(bool on);

    /// Deforms the parts that are looked at, in the background: they are written, read again and filled.
    /// @param said the same as a recipe says it; empty: it cannot @param title of what is done @param name of the entry
    void apply(std::shared_ptr<const std::vector<Deformation>> deformations, std::vector<RecipeDeformation> said,
               const QString& title, const Message& name);

    /// Lets grips do it to the bodies that are looked at, see Document::deformByPhysics(); what is looked at stays until then.
    void applyByPhysics(const PhysicalDeformation& deformation, const QString& title, const Message& name);

signals:
    void seen(const knead::DeformedFrame& frame); ///< the view shows it
    void failed(const QString& sentence);         ///< it is no deformation
    void applied(const knead::ExportReport& report);

private:
    void ask();
    void showFrame(const DeformedFrame& made);
    void showPresent();
    void setColored(bool on);
    void followColors();
    void startApplying(const DeformationRequest& request, const QString& title, const Message& name);
    void finish(PreparedDeformation done, const Message& name);

    Workbench m_bench;
    DeformPreview* m_preview;
    std::optional<Look> m_look;
    bool m_isHidden = false;
    std::optional<ColorOptions> m_colorsBefore; ///< while others are shown
    bool m_wasAllSeen = false;                  ///< before the newest look
    QString m_applying;                         ///< title of the task that does it; empty: none
};

} // namespace knead

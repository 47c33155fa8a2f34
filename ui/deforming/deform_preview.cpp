#include "ui/deforming/deform_preview.h"

#include "core/deformation/field_map.h"
#include "core/message/message.h"
#include "ui/language/said.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace knead {

namespace {

/// x(X) = X + s (m(X) - X)
class ScaledMap final : public SmoothMap {
public:
    ScaledMap(std::shared_ptr<const SmoothMap> map, double scale)
        : m_map(std::move(map))
        , m_scale(scale)
    {
    }

    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override
    {
        const std::vector<Vec3> before(points.begin(), points.end());
        m_map->evaluate(before, places);
        for (std::size_t i = 0; i < before.size(); ++i)
            places[i] = before[i] + m_scale * (places[i] - before[i]);
    }
    double featureSize() const override { return m_map->featureSize(); }

private:
    std::shared_ptr<const SmoothMap> m_map;
    double m_scale;
};

/// Null: it is not one by a field alone.
const FieldDeformation* fieldIn(const std::vector<Deformation>& deformations)
{
    return deformations.size() == 1 ? std::get_if<FieldDeformation>(&deformations.front()) : nullptr;
}

/// @param earlier the map before; null: none
std::shared_ptr<const SmoothMap> nextMap(const std::vector<Deformation>& deformations, const SmoothMap* earlier,
                                         TaskControl& control)
{
    const FieldDeformation* field = fieldIn(deformations);
    return field != nullptr ? fieldMap(*field, control, earlier) : mapOf(std::span(deformations), control);
}

} // namespace

/// Between the window and the worker.
struct DeformPreview::Shared {
    std::mutex mutex;
    std::optional<PreviewRequest> wanted;  ///< the newest that was not begun yet
    std::atomic<std::uint64_t> forgot = 0; ///< how often all was forgotten

    // Of the worker:
    std::shared_ptr<const std::vector<Deformation>> deformations; ///< whose map is kept
    std::shared_ptr<const SmoothMap> map;

    std::optional<PreviewRequest> taken()
    {
        const std::lock_guard lock(mutex);
        return std::exchange(wanted, {});
    }

    void replace(std::optional<PreviewRequest> request)
    {
        const std::lock_guard lock(mutex);
        wanted = std::move(request);
    }

    bool isOtherWanted(const PreviewRequest& than)
    {
        const std::lock_guard lock(mutex);
        return wanted && wanted->deformations != than.deformations;
    }

    /// With whose map that of the request would be of no use.
    bool isOtherFieldWanted(const PreviewRequest& than)
    {
        const std::lock_guard lock(mutex);
        const FieldDeformation* field = fieldIn(*than.deformations);
        const FieldDeformation* next = wanted ? fieldIn(*wanted->deformations) : field;
        return field != nullptr && (next == nullptr || next->field != field->field);
    }

    /// @param making of a map
    DeformedFrame make(const PreviewRequest& request, TaskControl& making, TaskControl& control)
    {
        if (deformations != request.deformations) {
            map = nextMap(*request.deformations, map.get(), making);
            deformations = request.deformations;
        }
        if (request.exaggeration == 1)
            return deformedFrame(request.from, *map, request.which, control);
        return deformedFrame(request.from, ScaledMap(map, request.exaggeration), request.which, control);
    }
};

namespace {

/// Until all is forgotten. A frame that was begun before another request is finished, so that something is seen during a long drag.
class UntilForgotten final : public TaskControl {
public:
    explicit UntilForgotten(const std::atomic<std::uint64_t>& forgot)
        : m_forgot(forgot)
        , m_begin(forgot)
    {
    }
    void report(double /*fraction*/, std::string_view /*stage*/) override {}
    bool isCancelled() const override { return m_forgot != m_begin; }
    std::uint64_t begin() const { return m_begin; }

private:
    const std::atomic<std::uint64_t>& m_forgot;
    const std::uint64_t m_begin;
};

/// Until something else holds.
class Until final : public TaskControl {
public:
    explicit Until(std::function<bool()> holds)
        : m_holds(std::move(holds))
    {
    }
    void report(double /*fraction*/, std::string_view /*stage*/) override {}
    bool isCancelled() const override { return m_holds(); }

private:
    std::function<bool()> m_holds;
};

} // namespace

DeformPreview::DeformPreview(QObject* parent)
    : QObject(parent)
    , m_shared(std::make_shared<Shared>())
{
}

DeformPreview::~DeformPreview()
{
    forget();
}

void DeformPreview::forget()
{
    m_shared->replace({});
    ++m_shared->forgot;
}

void DeformPreview::release()
{
    forget();
    m_worker.run([shared = m_shared] {
        shared->deformations.reset();
        shared->map.reset();
    });
}

void DeformPreview::ask(PreviewRequest request)
{
    m_shared->replace(std::move(request));
    m_worker.run([this, shared = m_shared] {
        UntilForgotten control(shared->forgot);
        const std::optional<PreviewRequest> wanted = shared->taken();
        if (!wanted)
            return;
        Until making([&] { return control.isCancelled() || shared->isOtherFieldWanted(*wanted); });
        std::optional<DeformedFrame> frame;
        QString failure;
        const bool isNew = shared->deformations != wanted->deformations;
        try {
            frame = shared->make(*wanted, making, control);
        } catch (const Cancelled&) {
            return;
        } catch (const std::exception& error) {
            failure = said(messageOf(error));
        }
        const auto tell = [this, begin = control.begin(), frame = std::move(frame), failure] {
            if (begin != m_shared->forgot)
                return;
            if (frame)
                emit made(*frame);
            else
                emit failed(failure);
        };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
        if (!isNew || !failure.isEmpty() || !wanted->examine)
            return;
        try {
            Until examining([&] { return control.isCancelled() || shared->isOtherWanted(*wanted); });
            wanted->examine(*shared->map, examining);
        } catch (const Cancelled&) {
        }
    });
}

} // namespace knead

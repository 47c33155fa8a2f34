#include "io/step_assembly_size.h"

#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace knead {

namespace {

class PartCounter {
public:
    PartCounter(const Interface_InterfaceModel& model, int enough)
        : m_enough(enough)
    {
        for (int i = 1; i <= model.NbEntities(); ++i) {
            const auto usage = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model.Value(i));
            if (usage.IsNull() || usage->RelatingProductDefinition().IsNull() ||
                usage->RelatedProductDefinition().IsNull())
                continue;
            m_parts[usage->RelatingProductDefinition().get()].push_back(usage->RelatedProductDefinition().get());
            m_used.insert(usage->RelatedProductDefinition().get());
        }
    }

    int count()
    {
        int total = 0;
        for (const auto& [product, parts] : m_parts)
            if (!m_used.contains(product))
                total = std::min(total + countIn(product), m_enough);
        return total;
    }

private:
    using Product = const void*;

    /// A product that holds itself is counted once; the reader refuses it later.
    int countIn(Product product)
    {
        const auto parts = m_parts.find(product);
        if (parts == m_parts.end())
            return 1;
        const auto [known, isNew] = m_counts.try_emplace(product, 1);
        if (!isNew)
            return known->second;
        int total = 0;
        for (const Product part : parts->second)
            total = std::min(total + countIn(part), m_enough);
        return m_counts[product] = total;
    }

    int m_enough;
    std::unordered_map<Product, std::vector<Product>> m_parts;
    std::unordered_set<Product> m_used;
    std::unordered_map<Product, int> m_counts;
};

} // namespace

int countUnfoldedParts(const STEPControl_Reader& reader, int enough)
{
    const Handle(Interface_InterfaceModel) model = reader.Model();
    return model.IsNull() ? 0 : PartCounter(*model, enough).count();
}

} // namespace knead

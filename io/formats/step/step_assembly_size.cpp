#include "io/formats/step/step_assembly_size.h"

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

using Product = const void*;
using PartsOfProduct = std::unordered_map<Product, std::vector<Product>>;

PartsOfProduct partsOfProducts(const Interface_InterfaceModel& model)
{
    PartsOfProduct parts;
    for (int i = 1; i <= model.NbEntities(); ++i) {
        const auto usage = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model.Value(i));
        if (usage.IsNull() || usage->RelatingProductDefinition().IsNull() || usage->RelatedProductDefinition().IsNull())
            continue;
        parts[usage->RelatingProductDefinition().get()].push_back(usage->RelatedProductDefinition().get());
    }
    return parts;
}

class PartCounter {
public:
    PartCounter(const Interface_InterfaceModel& model, int enough)
        : m_enough(enough)
        , m_parts(partsOfProducts(model))
    {
        for (const auto& [product, parts] : m_parts)
            m_used.insert(parts.begin(), parts.end());
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
    /// A product that holds itself is counted once; see isCyclic().
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
    PartsOfProduct m_parts;
    std::unordered_set<Product> m_used;
    std::unordered_map<Product, int> m_counts;
};

/// Walks down every assembly once; a product that is met again before it was left holds itself.
class CircularPartSearch {
public:
    explicit CircularPartSearch(const PartsOfProduct& parts)
        : m_parts(parts)
    {
    }

    bool run()
    {
        return std::any_of(m_parts.begin(), m_parts.end(), [&](const auto& entry) { return leadsBack(entry.first); });
    }

private:
    enum class State { Entered, Left };

    bool leadsBack(Product product)
    {
        const auto parts = m_parts.find(product);
        if (parts == m_parts.end())
            return false;
        const auto [known, isNew] = m_states.try_emplace(product, State::Entered);
        if (!isNew)
            return known->second == State::Entered;
        for (const Product part : parts->second)
            if (leadsBack(part))
                return true;
        m_states[product] = State::Left;
        return false;
    }

    const PartsOfProduct& m_parts;
    std::unordered_map<Product, State> m_states;
};

} // namespace

int countUnfoldedParts(const STEPControl_Reader& reader, int enough)
{
    const Handle(Interface_InterfaceModel) model = reader.Model();
    return model.IsNull() ? 0 : PartCounter(*model, enough).count();
}

bool isCyclic(const STEPControl_Reader& reader)
{
    const Handle(Interface_InterfaceModel) model = reader.Model();
    return !model.IsNull() && CircularPartSearch(partsOfProducts(*model)).run();
}

} // namespace knead

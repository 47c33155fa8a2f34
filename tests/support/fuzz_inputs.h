#pragma once

#include "core/model/import_options.h"
#include "support/iges_mutation.h"
#include "support/mesh_containers.h"
#include "support/step_mutation.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace knead::fuzz {

struct Input {
    std::string name; ///< "seed-1-number-42.step"
    std::string bytes;
    ImportOptions options;
};

/// Damaged files, made of sound ones: always the same for the same seed and number.
class Inputs {
public:
    /// @param folder of the sound files
    /// @throws std::runtime_error when one is missing
    explicit Inputs(const std::string& folder)
    {
        const auto add = [&](Format format, const std::string& name) {
            m_sound.push_back({format, name, contentOf(folder + "/" + name)});
        };
        for (const char* name : {"assembly.step", "hollow.step", "round.step", "splines.step", "surfaces.step"})
            add(Format::step, name);
        for (const char* name : {"assembly.igs", "faces.igs", "solid.igs"})
            add(Format::iges, name);
        for (const char* name : {"drilled.brep", "splines.brep"})
            add(Format::brep, name);
        for (const char* name : {"angle.stl", "angle.obj", "angle.ply"})
            add(Format::text, name);
        for (const char* name : {"angle_binary.stl", "angle_binary.ply"})
            add(Format::binary, name);
        add(Format::threeMf, "angle.model");
        add(Format::gltf, "angle.gltf");
        m_gltfNumbers = contentOf(folder + "/angle.bin");
    }

    /// Made of all CAD files of a folder, as people have them.
    static Inputs ofFolder(const std::string& folder)
    {
        Inputs inputs;
        std::vector<std::filesystem::path> paths;
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            paths.push_back(entry.path());
        std::sort(paths.begin(), paths.end());
        for (const std::filesystem::path& path : paths) {
            const std::string ending = path.extension().string();
            if (const auto format = formatOf(ending))
                inputs.m_sound.push_back({*format, path.stem().string() + ending, contentOf(path.string())});
        }
        inputs.m_takesAny = true;
        return inputs;
    }

    /// The sound files, as they are read.
    std::vector<Input> sound() const
    {
        std::vector<Input> result;
        for (const Sound& file : m_sound)
            result.push_back({packedName(file), packed(file.format, file.content, m_gltfNumbers), {}});
        return result;
    }

    Input input(std::uint64_t seed, std::uint64_t number) const
    {
        Random random(seed * 0x9E3779B97F4A7C15U ^ number);
        const Sound& file = someFile(random);
        std::string content = file.content;
        std::string numbers = m_gltfNumbers;
        for (std::size_t i = changeCount(random); i > 0; --i)
            mutate(file.format, content, numbers, random);
        std::string bytes = packed(file.format, content, numbers);
        if ((file.format == Format::threeMf || file.format == Format::gltf) && random.chance(25))
            mutateBytes(bytes, random);
        const bool isInMillimetres = file.format != Format::step || content.find("SI_UNIT(.MILLI.") != content.npos;
        return {"seed-" + std::to_string(seed) + "-number-" + std::to_string(number) + "-" + packedName(file), bytes,
                optionsFor(isInMillimetres, random)};
    }

private:
    Inputs() = default;

    enum class Format { step, iges, brep, text, binary, threeMf, gltf };

    struct Sound {
        Format format;
        std::string name;
        std::string content;
    };

    static std::optional<Format> formatOf(const std::string& ending)
    {
        if (ending == ".step" || ending == ".stp")
            return Format::step;
        if (ending == ".igs" || ending == ".iges")
            return Format::iges;
        return ending == ".brep" ? std::optional(Format::brep) : std::nullopt;
    }

    static std::string contentOf(const std::string& path)
    {
        std::ifstream file(path, std::ios::binary);
        if (!file)
            throw std::runtime_error(path + " is missing.");
        return {std::istreambuf_iterator<char>(file), {}};
    }

    /// Most mistakes are made where files are most complicated.
    const Sound& someFile(Random& random) const
    {
        if (m_takesAny)
            return m_sound[random.below(m_sound.size())];
        static constexpr std::array<Format, 20> formats{
            Format::step, Format::step, Format::step, Format::step, Format::step,   Format::step, Format::step,
            Format::step, Format::step, Format::iges, Format::iges, Format::iges,   Format::iges, Format::iges,
            Format::brep, Format::brep, Format::text, Format::text, Format::binary, Format::gltf,
        };
        const Format format = random.chance(4) ? Format::threeMf : random.oneOf(formats);
        return fileOf(format, random);
    }

    /// One change shows what it does; several get at what one cannot.
    static std::size_t changeCount(Random& random)
    {
        if (random.chance(60))
            return 1;
        return random.chance(75) ? 2 + random.below(2) : 4 + random.below(5);
    }

    void mutate(Format format, std::string& content, std::string& numbers, Random& random) const
    {
        switch (format) {
        case Format::step:
            return mutateStep(content, fileOf(format, random).content, random);
        case Format::iges:
            return mutateIges(content, fileOf(format, random).content, random);
        case Format::binary:
            return mutateBytes(content, random);
        case Format::gltf:
            return random.chance(30) ? mutateBytes(numbers, random) : mutateText(content, random);
        case Format::brep:
        case Format::text:
        case Format::threeMf:
            return mutateText(content, random);
        }
    }

    const Sound& fileOf(Format format, Random& random) const
    {
        std::vector<const Sound*> candidates;
        for (const Sound& file : m_sound)
            if (file.format == format)
                candidates.push_back(&file);
        return *random.oneOf(candidates);
    }

    static std::string packed(Format format, const std::string& content, const std::string& numbers)
    {
        return format == Format::threeMf ? threeMfOf(content)
               : format == Format::gltf  ? glbOf(content, numbers)
                                         : content;
    }

    static std::string packedName(const Sound& file)
    {
        return file.format == Format::threeMf ? "angle.3mf" : file.format == Format::gltf ? "angle.glb" : file.name;
    }

    /// Mostly coarse, which is much faster; now and then as people have them.
    /// But a millimetre of a part of kilometres is not coarse.
    static ImportOptions optionsFor(bool isInMillimetres, Random& random)
    {
        ImportOptions options;
        if (!random.chance(10) && isInMillimetres) {
            options.linearDeflection = 1e-3;
            options.angularDeflection = 0.5;
        }
        options.heal = !random.chance(10);
        if (random.chance(3))
            options.unit = random.chance(50) ? "m" : "inch";
        return options;
    }

    std::vector<Sound> m_sound;
    std::string m_gltfNumbers;
    bool m_takesAny = false; ///< each file as often as the others, instead of each format by its difficulty
};

} // namespace knead::fuzz

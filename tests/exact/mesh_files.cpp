// PLY and OBJ as far as the checks need them.
#include "exact/mesh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

namespace nuno {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what)
{
    throw std::runtime_error(fmt::format("{}: {}", path.string(), what));
}

double to_number(const std::filesystem::path& path, const std::string& word)
{
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || word.empty())
        refuse(path, fmt::format("\"{}\" is no number", word));
    return value;
}

// `value` as a whole number of 0 .. most.
std::uint32_t whole(const std::filesystem::path& path, const std::string& what, double value, double most)
{
    if (!(value >= 0 && value <= most) || value != std::floor(value))
        refuse(path, fmt::format("{}: {} is not a whole number of 0 to {}", what, value, most));
    return static_cast<std::uint32_t>(value);
}

constexpr double kMostVertices = 4e9;

enum class PlyForm
{
    ascii,
    little_endian,
    big_endian
};

struct PlyProperty
{
    std::string name, type, count_type;  // count_type: of a list's length; empty: no list
};

struct PlyElement
{
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader
{
    PlyForm form = PlyForm::ascii;
    std::vector<PlyElement> elements;
};

PlyHeader read_header(const std::filesystem::path& path, std::istream& in)
{
    PlyHeader header;
    std::string line, word;
    if (!std::getline(in, line) || line.substr(0, 3) != "ply")
        refuse(path, "no PLY file: the first line is not \"ply\"");
    while (std::getline(in, line)) {
        std::istringstream words(line);
        if (!(words >> word) || word == "comment" || word == "obj_info") continue;
        if (word == "end_header") return header;
        if (word == "format") {
            words >> word;
            header.form = word == "ascii"                  ? PlyForm::ascii
                          : word == "binary_little_endian" ? PlyForm::little_endian
                          : word == "binary_big_endian"    ? PlyForm::big_endian
                                                        : throw std::runtime_error(path.string() + ": format " + word);
        } else if (word == "element") {
            PlyElement element;
            std::string count;
            words >> element.name >> count;
            element.count = whole(path, "count of " + element.name, to_number(path, count), 4e9);
            header.elements.push_back(element);
        } else if (word == "property" && !header.elements.empty()) {
            PlyProperty property;
            words >> property.type;
            if (property.type == "list") words >> property.count_type >> property.type;
            words >> property.name;
            header.elements.back().properties.push_back(property);
        } else {
            refuse(path, fmt::format("cannot read the header's line \"{}\"", line));
        }
    }
    refuse(path, "the header has no end");
}

// Numbers of the body, one after another, whatever their form.
class PlyNumbers
{
  public:
    PlyNumbers(const std::filesystem::path& path, std::istream& in, PlyForm form) : path_(path), in_(in), form_(form) {}

    double next(const std::string& type)
    {
        if (form_ == PlyForm::ascii) {
            std::string word;
            if (!(in_ >> word)) refuse(path_, "ends too early");
            const double value = to_number(path_, word);
            return type == "float" || type == "float32" ? double(static_cast<float>(value)) : value;
        }
        if (type == "char" || type == "int8") return read<std::int8_t>();
        if (type == "uchar" || type == "uint8") return read<std::uint8_t>();
        if (type == "short" || type == "int16") return read<std::int16_t>();
        if (type == "ushort" || type == "uint16") return read<std::uint16_t>();
        if (type == "int" || type == "int32") return read<std::int32_t>();
        if (type == "uint" || type == "uint32") return read<std::uint32_t>();
        if (type == "float" || type == "float32") return double(read<float>());
        if (type == "double" || type == "float64") return read<double>();
        refuse(path_, fmt::format("unknown type {}", type));
    }

  private:
    template <class T>
    T read()
    {
        std::array<char, sizeof(T)> bytes;
        if (!in_.read(bytes.data(), sizeof(T))) refuse(path_, "ends too early");
        if (form_ == PlyForm::big_endian) std::reverse(bytes.begin(), bytes.end());
        return std::bit_cast<T>(bytes);
    }

    const std::filesystem::path& path_;
    std::istream& in_;
    PlyForm form_;
};

CheckedMesh read_ply(const std::filesystem::path& path, std::istream& in)
{
    const PlyHeader header = read_header(path, in);
    PlyNumbers numbers(path, in, header.form);
    CheckedMesh mesh;
    for (const PlyElement& element : header.elements)
        for (std::size_t i = 0; i < element.count; ++i) {
            std::array<double, 3> position{};
            for (const PlyProperty& property : element.properties) {
                if (property.count_type.empty()) {
                    const double value = numbers.next(property.type);
                    if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
                        position[std::size_t(property.name[0] - 'x')] = value;
                    continue;
                }
                const bool corners =
                    element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
                const std::uint32_t length =
                    whole(path, property.name, numbers.next(property.count_type), corners ? 1e3 : kMostVertices);
                if (corners && length != 3) refuse(path, fmt::format("face {} has {} corners, not 3", i, length));
                std::array<std::uint32_t, 3> face{};
                for (std::uint32_t n = 0; n < length; ++n) {
                    const double value = numbers.next(property.type);
                    if (corners) face[n] = whole(path, fmt::format("face {}", i), value, kMostVertices);
                }
                if (corners) mesh.faces.push_back(face);
            }
            if (element.name == "vertex") mesh.positions.push_back(position);
        }
    return mesh;
}

CheckedMesh read_obj(const std::filesystem::path& path, std::istream& in)
{
    CheckedMesh mesh;
    std::string line, word;
    for (int number = 1; std::getline(in, line); ++number) {
        std::istringstream words(line);
        if (!(words >> word)) continue;
        if (word == "v") {
            std::array<float, 3> x{};
            if (!(words >> x[0] >> x[1] >> x[2])) refuse(path, fmt::format("line {}: no position", number));
            mesh.positions.push_back({double(x[0]), double(x[1]), double(x[2])});
        } else if (word == "f") {
            std::vector<std::uint32_t> corners;
            while (words >> word) {
                const std::string index = word.substr(0, word.find('/'));
                const double value = to_number(path, index);
                const double from_first = value < 0 ? double(mesh.positions.size()) + value : value - 1;
                corners.push_back(whole(path, fmt::format("line {}", number), from_first, kMostVertices));
            }
            if (corners.size() != 3) refuse(path, fmt::format("line {}: {} corners, not 3", number, corners.size()));
            mesh.faces.push_back({corners[0], corners[1], corners[2]});
        }
    }
    return mesh;
}

}  // namespace

CheckedMesh read_mesh(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    if (!in) refuse(path, "cannot be read");
    const bool ply = path.extension() == ".ply";
    if (!ply && path.extension() != ".obj") refuse(path, "its name ends neither in .ply nor in .obj");
    CheckedMesh mesh = ply ? read_ply(path, in) : read_obj(path, in);
    if (mesh.faces.empty()) refuse(path, "has no face");
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        for (const std::uint32_t v : mesh.faces[f])
            if (v >= mesh.positions.size())
                refuse(path, fmt::format("face {} names vertex {}, of {}", f, v, mesh.positions.size()));
    return mesh;
}

}  // namespace nuno

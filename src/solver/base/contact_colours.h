// Contacts in colours: no two of one colour share a vertex, so that all of a colour may be answered at once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/layer_contact.h"

namespace nuno {

// How contacts choose their colours, and so in which order they are answered.
enum class ContactOrder
{
    first_free,  // as they come: along layers that lie upon each other, which carries pushes far
    steady       // each its own, as nearly as possible: the same order in every pass, which leaves layers at rest alone
};

struct ContactColours
{
    std::vector<LayerContact> contacts;  // colour by colour, within one as they came
    std::vector<std::uint32_t> starts;   // of every colour in `contacts`, and their end
};

// Vertices are below `vertex_count`.
ContactColours colour_contacts(std::span<const LayerContact> contacts, std::uint32_t vertex_count, ContactOrder order);

}  // namespace nuno

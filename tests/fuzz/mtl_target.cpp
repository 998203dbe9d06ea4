// Any text as an MTL file: valid materials, or reasons.
#include <cstdint>
#include <set>
#include <string>

#include "fuzz/budget.hpp"
#include "fuzz/verdict.hpp"
#include "mesh/read_mtl.hpp"
#include "support/text_in_memory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    using namespace glint;
    TextFile text = test::text_in_memory({reinterpret_cast<const char *>(data), size});

    const fuzz::Budget budget;
    const Result<MtlFile> file = read_mtl_text(std::move(text), "fuzz.mtl");
    budget.require_kept();
    if (!file.ok()) {
        fuzz::require_reasons(file.error());
        return 0;
    }
    std::set<std::string> names;
    for (const MtlMaterial &material : file->materials) {
        fuzz::require(!material.name.empty(), "a material has no name");
        fuzz::require(names.insert(material.name).second, "two materials have one name");
        fuzz::require_valid(material.material);
        fuzz::require(material.texture.empty() || material.texture_place.place().line > 0, "a texture has no place");
    }
    fuzz::require_words(file->warnings);
    return 0;
}

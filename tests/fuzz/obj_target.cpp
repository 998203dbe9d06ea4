// Any text as an OBJ file: a valid mesh, or reasons.
#include <cstdint>
#include <utility>

#include "fuzz/budget.hpp"
#include "fuzz/verdict.hpp"
#include "mesh/read_obj.hpp"
#include "support/text_in_memory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    using namespace glint;
    TextFile text = test::text_in_memory({reinterpret_cast<const char *>(data), size});

    const fuzz::Budget budget;
    const Result<MeshFile> mesh = read_obj_text(std::move(text), "fuzz.obj", {});
    budget.require_kept();
    if (mesh.ok()) {
        fuzz::require_valid(*mesh->mesh);
        fuzz::require_words(mesh->warnings);
    } else {
        fuzz::require_reasons(mesh.error());
    }
    return 0;
}

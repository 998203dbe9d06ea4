// Any text as an OBJ file with materials, beside the libraries of scene/: valid parts, or reasons.
#include <cstdint>

#include "fuzz/budget.hpp"
#include "fuzz/scene_place.hpp"
#include "fuzz/verdict.hpp"
#include "mesh/read_model.hpp"
#include "support/text_in_memory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    using namespace glint;
    TextFile text = test::text_in_memory({reinterpret_cast<const char *>(data), size});
    const std::filesystem::path path = fuzz::scene_folder() / "fuzz.obj";
    const ReadOptions options = fuzz::scene_options();
    const Result<AssetPaths> paths = AssetPaths::create(path, options);
    fuzz::require(paths.ok(), "the folder of meshes is not there");
    TextureLibrary textures(options);

    const fuzz::Budget budget;
    const Result<ModelFile> model =
        read_model_text(std::move(text), path, paths->beside(path, "OBJ file"), options, textures);
    budget.require_kept();
    if (!model.ok()) {
        fuzz::require_reasons(model.error());
        return 0;
    }
    fuzz::require(!model->parts.empty(), "a model has no part");
    for (const ModelPart &part : model->parts) {
        fuzz::require(part.mesh != nullptr, "a part has no mesh");
        fuzz::require_valid(*part.mesh);
        fuzz::require_valid(part.material);
    }
    fuzz::require_words(model->warnings);
    return 0;
}

#include <span>

#include "splitsum/atlas/entries.h"
#include "splitsum/atlas/file_cases.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/panorama/panorama.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

// The folder is the caller's; the page shall not depend on its name.
std::string without_folder(std::string text, const fs::path& folder) {
    const std::string prefix = folder.string() + "/";
    for (size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
        text.erase(at, prefix.size());
    return text;
}

AtlasCell cell_of_light(const Panorama& panorama, const FileCase& file, Reading expected) {
    AtlasCell cell{.verdict = expected == Reading::light ? Verdict::meets : Verdict::fails,
                   .text = panorama.repaired && !panorama.found.clean()
                               ? cat("repaired: ", describe(panorama.found))
                               : "read"};
    if (!panorama.notes.empty()) cell.text += cat("; ", join(panorama.notes, "; "));
    if (!all_are_radiance(panorama.pixels.rgb)) {
        cell.verdict = Verdict::fails;
        cell.text += "; what was read is no light";
    }
    if (!file.truth) return cell;
    if (panorama.pixels.rgb.size() != file.truth->rgb.size())
        return {.verdict = Verdict::fails, .text = cat(cell.text, "; of another size")};
    cell.figures = error_figures(panorama.pixels.rgb, file.truth->rgb, 3);
    if (!(cell.figures->rel_rms < 1e-6)) cell.verdict = Verdict::fails;
    return cell;
}

// A refusal names its reason; whether it was due is known.
AtlasCell cell_of(const FileCase& file, const fs::path& folder, bool repair, Progress& progress) {
    const Reading expected = repair ? file.repaired : file.as_it_is;
    PanoramaOptions options;
    options.repair = repair;
    const auto panorama = read_panorama(folder / file.name, options, progress);
    if (panorama) return cell_of_light(*panorama, file, expected);
    return {.verdict = expected == Reading::refusal ? Verdict::refuses : Verdict::fails,
            .text = without_folder(panorama.error().message, folder)};
}

}  // namespace

Result<AtlasEntry> files_entry(const AtlasPlan&, const fs::path& folder, Progress& progress) {
    AtlasEntry entry{.id = "files",
                     .title = "Files: NaN, other shapes, windows, channels, damage",
                     .problem =
                         "One NaN poisons every texel; a cropped file is read as a whole one; "
                         "a damaged one as black.",
                     .conduct =
                         "Read as it is meant, or refused with count and place, and repaired "
                         "only where --repair asks for it. Figures are those of the pixels."};
    entry.table = {"file", {"as it is", "--repair"}, {}};
    for (const FileCase& file : file_cases()) {
        if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
        const Status written =
            write_bytes_whole(folder / file.name, std::as_bytes(std::span(file.bytes)));
        if (!written) return written.error();
        entry.table.rows.push_back(
            {cat(file.name, ": ", file.about),
             {cell_of(file, folder, false, progress), cell_of(file, folder, true, progress)}});
    }
    return entry;
}

}  // namespace splitsum

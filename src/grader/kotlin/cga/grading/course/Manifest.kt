package cga.grading.course

import cga.framework.AtomicFile
import cga.framework.InputError
import cga.imaging.JsonNode
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.writeText

/** `course.json`: which submissions a result folder is about, written before the first is graded, so that none can be missed later. */
internal class Manifest(
    val shard: Shard,
    val entries: List<Entry>,
) {
    /** A submission by its name and the name of its folder. */
    class Entry(
        val name: String,
        val folder: String,
    )

    fun write(out: Path) {
        val json =
            buildJsonObject {
                put("shard", "$shard")
                val list = entries.map { entry ->
                    buildJsonObject {
                        put("name", entry.name)
                        put("folder", entry.folder)
                    }
                }
                if (list.isNotEmpty()) put("submissions", JsonArray(list))
            }
        AtomicFile.write(out.resolve(NAME)) { it.writeText(Json.encodeToString(JsonElement.serializer(), json) + "\n") }
    }

    companion object {
        const val NAME = "course.json"
        private val FOLDER = Regex("""[A-Za-z0-9][A-Za-z0-9._-]{0,99}""")

        /** The manifest in [out]. Throws [InputError] where there is none or it cannot be read. */
        fun read(out: Path): Manifest {
            val file = out.resolve(NAME)
            if (!Files.isRegularFile(file)) throw InputError("$out holds no results ($NAME is missing): name a folder that --out wrote.")
            val node = JsonNode.read(file, "course")
            val entries = node.find("submissions")?.list().orEmpty().map { entry ->
                val folder = entry.get("folder")
                if (!FOLDER.matches(folder.text())) folder.fail("must be a plain name.")
                Entry(entry.get("name").optionalText(), folder.text())
            }
            return Manifest(Shard.of(node.get("shard").text()), entries)
        }
    }
}

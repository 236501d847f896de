package cga.grading.submission

import cga.framework.Home
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes

/** Files of our own for models and textures that are not there, chosen by what their names say that they are for. */
internal object StandInAssets {
    private val GROUND = Regex("(?i)ground|floor|plane|boden")
    private val EMISSIVE = Regex("(?i)emi|glow|leucht")
    private val SPECULAR = Regex("(?i)spec|gloss|glanz")

    /** Whether the file [name] is about the ground. */
    fun isGround(name: String): Boolean = GROUND.containsMatchIn(name.substringAfterLast('/'))

    /**
     * What takes the place of the file [name], by path: the file itself, and beside a model its material and textures.
     *
     * @param materials the names of the materials that [name] has to have, where it holds some.
     */
    fun of(name: String, materials: List<String>): Map<String, ByteArray> {
        val folder = name.substringBeforeLast('/', "")
        return when (name.substringAfterLast('.').lowercase()) {
            "obj" -> model(name, folder)
            "mtl" -> mapOf(name to material(materials).toByteArray()) + beside(folder, textures("motorcycle").filter { it.name in PLAIN })
            else -> mapOf(name to texture(name).readBytes())
        }
    }

    private fun model(name: String, folder: String): Map<String, ByteArray> {
        val kind = if (isGround(name)) "ground" else "motorcycle"
        // A path is a list of its parts, too.
        val files = textures(kind) + listOf(home(kind).resolve("$kind.mtl"))
        return beside(folder, files) + (name to home(kind).resolve("$kind.obj").readBytes())
    }

    private fun texture(name: String): Path {
        val role = when {
            EMISSIVE.containsMatchIn(name.substringAfterLast('/')) -> "emissive"
            SPECULAR.containsMatchIn(name.substringAfterLast('/')) -> "specular"
            else -> "diffuse"
        }
        return if (isGround(name)) home("ground").resolve("ground_$role.png") else home("motorcycle").resolve("body_$role.png")
    }

    private fun material(names: List<String>): String =
        names.joinToString("\n") { "newmtl $it\nNs 60\nKd 1 1 1\nmap_Kd ${PLAIN[0]}\nmap_Ke ${PLAIN[1]}\nmap_Ks ${PLAIN[2]}\n" }

    private fun beside(folder: String, files: List<Path>) = files.associate { "$folder/${it.name}" to it.readBytes() }

    private fun textures(kind: String) = home(kind).listDirectoryEntries().filter { it.extension == "png" }.sorted()

    private fun home(kind: String) = Home.resolve("assets/$kind")

    private val PLAIN = listOf("body_diffuse.png", "body_emissive.png", "body_specular.png")
}

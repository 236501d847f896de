package cga.measure.mutation

import cga.framework.Home
import cga.framework.image.ImageData
import cga.framework.image.PngFile
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createParentDirectories
import kotlin.io.path.readText
import kotlin.io.path.relativeTo
import kotlin.io.path.writeText

/** A copy of the project's shaders and assets with a mutant's edits in it. */
internal object MutatedHome {
    private const val PROPERTY = "cga.home"
    private val READ_BY_PROGRAM = Regex(""".*\.(vert|frag|glsl|obj|mtl|png)""")

    /**
     * What [block] answers when every project file that it reads has [edits] in it; where those are in shaders alone it must read no
     * assets. Nothing else of the process may read project files meanwhile. An edit whose text is not in its file, or more than once, is
     * an [IllegalStateException]: the mutant would not be one.
     */
    fun <T> use(
        edits: List<Edit>,
        block: () -> T,
    ): T {
        if (edits.isEmpty()) return block()
        val folder = Files.createTempDirectory("cga-mutant")
        val before = System.getProperty(PROPERTY)
        try {
            copy(if (edits.all { it.file.startsWith("shaders/") }) listOf("shaders") else listOf("shaders", "assets"), folder)
            edits.forEach { apply(it, folder.resolve(it.file)) }
            System.setProperty(PROPERTY, "$folder")
            return block()
        } finally {
            if (before == null) System.clearProperty(PROPERTY) else System.setProperty(PROPERTY, before)
            folder.toFile().deleteRecursively()
        }
    }

    private fun copy(
        roots: List<String>,
        to: Path,
    ) {
        val home = Home.resolve("").toAbsolutePath()
        for (root in roots) {
            Files.walk(home.resolve(root)).use { files ->
                files.filter { READ_BY_PROGRAM.matches("$it") && Files.isRegularFile(it) }.forEach { file ->
                    file.copyTo(to.resolve("${file.relativeTo(home)}").createParentDirectories())
                }
            }
        }
    }

    private fun apply(
        edit: Edit,
        file: Path,
    ) {
        when (edit) {
            is TextEdit -> {
                val parts = file.readText().split(edit.old)
                check(parts.size == 2) { "${edit.file} holds ${parts.size - 1} times, not once: ${edit.old}" }
                file.writeText(parts.joinToString(edit.new))
            }
            is TextureEdit -> PngFile.write(edit.repaint(ImageData.read("$file")), file)
        }
    }
}

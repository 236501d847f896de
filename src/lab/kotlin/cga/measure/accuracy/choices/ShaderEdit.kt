package cga.measure.accuracy.choices

import cga.framework.Home
import cga.framework.InputError
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeText

/** Another way to write a part of `shaders/`[file]: [replacement] for every [text]. */
internal class ShaderEdit(
    private val file: String,
    private val text: String,
    private val replacement: String,
) {
    fun isOf(name: String): Boolean = file == name

    /** Throws [InputError] where [source] has no such text: an edit that does nothing would measure the wrong shader. */
    fun applyTo(source: String): String {
        if (text !in
            source
        ) {
            throw InputError("shaders/$file no longer has \"${text.trim()}\": bring the edits of the accuracy report up to date.")
        }
        return source.replace(text, replacement)
    }
}

/** Makes things with edited shaders: in a copy of the project's files, which lives as long as this does. */
internal class EditedHome : AutoCloseable {
    private val home = createTempDirectory("cga-accuracy")
    private val shaders = home.resolve("shaders").createDirectories()

    init {
        Home.resolve("assets").toFile().copyRecursively(home.resolve("assets").toFile())
    }

    /** What [make] makes while `shaders/` are as [edits], one after the other, leave them. */
    fun <T> with(
        edits: List<ShaderEdit>,
        make: () -> T,
    ): T {
        for (file in Home.resolve("shaders").listDirectoryEntries("*.{vert,frag,glsl}")) {
            val original = Home.read(file, "shader").decodeToString().replace("\r\n", "\n")
            shaders.resolve(file.name).writeText(edits.filter { it.isOf(file.name) }.fold(original) { text, edit -> edit.applyTo(text) })
        }
        val usual: String? = System.getProperty(PROPERTY)
        System.setProperty(PROPERTY, "$home")
        try {
            return make()
        } finally {
            if (usual == null) System.clearProperty(PROPERTY) else System.setProperty(PROPERTY, usual)
        }
    }

    override fun close() {
        home.toFile().deleteRecursively()
    }

    companion object {
        const val VERTEX = "scene.vert"
        const val FRAGMENT = "scene.frag"
        const val LIGHTING = "lighting.glsl"
        private const val PROPERTY = "cga.home"
    }
}

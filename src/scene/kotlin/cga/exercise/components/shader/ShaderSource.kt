package cga.exercise.components.shader

import cga.framework.Home

/** The text of a shader file, and where it came from. */
internal class ShaderSource(
    val path: String,
    val text: String,
) {
    companion object {
        /**
         * The file at [path], with the numbers of [constants] in the place of those in its `const int NAME = …;` lines. The lines stay
         * where they are, so that the compiler's messages point into the file. Throws [cga.framework.InputError] when it cannot be read.
         */
        fun read(
            path: String,
            constants: Map<String, Int>,
        ): ShaderSource =
            ShaderSource(
                path,
                constants.entries.fold(String(Home.read(path, "shader"))) { text, (name, value) ->
                    text.replace(Regex("""(?<=\bconst int $name = )\d+(?=;)"""), "$value")
                },
            )
    }
}

package cga.reader

import cga.reader.glsl.GlslCompiler
import cga.reader.lower.Lowering
import cga.reader.shader.Shader
import cga.reader.shader.Stage
import cga.reader.spirv.ModuleReader
import cga.reader.spirv.UnreadableException
import cga.reader.spirv.instructions
import cga.reader.spirv.naming

/** What is wrong with a shader; [line] is 0 where it is not known. */
public data class Problem(val file: String, val line: Int, val message: String) {
    override fun toString(): String = if (line > 0) "$file:$line: $message" else "$file: $message"
}

/** What came of reading a shader. */
public sealed interface Reading {
    /** It can be run. [repairs] tells what had to be written otherwise before, since the compiler takes less than some drivers. */
    public class Done(public val shader: Shader, public val repairs: List<String>) : Reading

    public class Failed(public val problems: List<Problem>) : Reading

    public companion object {
        /** Reads the shader [text], GLSL 1.10 to 4.60, as it is handed to OpenGL. [file] names it in problems. */
        public fun of(file: String, text: String, stage: Stage): Reading {
            val compiled = GlslCompiler.compile(file, text, stage)
            val binary = compiled.binary ?: return Failed(compiled.problems)
            return try {
                Done(ofSpirv(binary, stage), compiled.repairs)
            } catch (e: UnreadableException) {
                Failed(listOf(Problem(file, e.line, "cannot be read: ${e.message}")))
            }
        }

        /** Throws [UnreadableException]. */
        internal fun ofSpirv(
            binary: ByteArray,
            stage: Stage,
        ): Shader = naming(null) { Lowering(ModuleReader(instructions(binary)).read()).lower(stage) }
    }
}

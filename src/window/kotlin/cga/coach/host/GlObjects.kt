package cga.coach.host

import cga.coach.calls.Call
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil
import java.util.BitSet

/** The objects of OpenGL that a program has made and not deleted: all go with it, whether or not it cleans up. */
internal class GlObjects {
    private val names = Kind.entries.map { BitSet() }

    /** How many there are. */
    val count: Int get() = names.sumOf { it.cardinality() }

    /** Notes what [call] made or deleted, which has been answered. */
    fun note(call: Call) {
        val kind = KINDS[call.name] ?: return
        val isMade = call.name == kind.make
        if (kind.isSingle) return set(kind, if (isMade) call.answer else call.int(0), isMade)
        val array = call.long(1)
        for (i in 0 until call.int(0)) set(kind, MemoryUtil.memGetInt(array + i * Int.SIZE_BYTES.toLong()), isMade)
    }

    private fun set(
        kind: Kind,
        name: Int,
        isMade: Boolean,
    ) {
        if (name > 0) names[kind.ordinal].set(name, isMade)
    }

    /** Deletes them all. */
    fun delete() {
        for (kind in Kind.entries) {
            val set = names[kind.ordinal]
            set.stream().forEach { kind.delete(it) }
            set.clear()
        }
    }

    private enum class Kind(
        val make: String,
        val unmake: String,
        val isSingle: Boolean,
        val delete: (Int) -> Unit,
    ) {
        PROGRAM("glCreateProgram", "glDeleteProgram", true, { glDeleteProgram(it) }),
        SHADER("glCreateShader", "glDeleteShader", true, { glDeleteShader(it) }),
        VERTEX_ARRAY("glGenVertexArrays", "glDeleteVertexArrays", false, { glDeleteVertexArrays(it) }),
        BUFFER("glGenBuffers", "glDeleteBuffers", false, { glDeleteBuffers(it) }),
        TEXTURE("glGenTextures", "glDeleteTextures", false, { glDeleteTextures(it) }),
        SAMPLER("glGenSamplers", "glDeleteSamplers", false, { glDeleteSamplers(it) }),
        FRAMEBUFFER("glGenFramebuffers", "glDeleteFramebuffers", false, { glDeleteFramebuffers(it) }),
        RENDERBUFFER("glGenRenderbuffers", "glDeleteRenderbuffers", false, { glDeleteRenderbuffers(it) }),
        QUERY("glGenQueries", "glDeleteQueries", false, { glDeleteQueries(it) }),
    }

    companion object {
        private val KINDS = Kind.entries.flatMap { listOf(it.make to it, it.unmake to it) }.toMap()

        /** The functions that are to be looked at. */
        val FUNCTIONS: Set<String> = KINDS.keys
    }
}

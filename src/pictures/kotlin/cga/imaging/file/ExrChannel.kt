package cga.imaging.file

import cga.framework.InputError
import java.nio.BufferUnderflowException
import java.nio.ByteBuffer

/** A channel of an OpenEXR file, of 16-bit ([isHalf]) or 32-bit floats. */
internal class ExrChannel private constructor(
    val name: String,
    private val type: Int,
    private val xSampling: Int,
    private val ySampling: Int,
) {
    val isHalf: Boolean get() = type == HALF
    val bytes: Int get() = if (isHalf) 2 else 4

    /** Where the channel goes in RGBA; grey goes to all three colours. */
    val targets: List<Int> get() = if (name == "Y") listOf(0, 1, 2) else listOf("RGBA".indexOf(name))

    private fun check() {
        if (xSampling != 1 ||
            ySampling != 1
        ) {
            throw InputError("its channel $name has fewer pixels than others: save it with a value for each.")
        }
        if (type == UINT) throw InputError("its channel $name has whole numbers: save it as 16-bit or 32-bit floats.")
        if (type != HALF && type != FLOAT) throw InputError("its channel $name is of the unknown type $type: save it again.")
    }

    companion object {
        private const val UINT = 0
        private const val HALF = 1
        private const val FLOAT = 2

        // Alphabetical, as OpenEXR stores them.
        private val READ = setOf(listOf("B", "G", "R"), listOf("A", "B", "G", "R"), listOf("Y"), listOf("A", "Y"))

        /** The channels of an attribute `chlist`. Throws [InputError] unless they are a colour picture's. */
        fun list(content: ByteBuffer): List<ExrChannel> {
            val channels =
                try {
                    generateSequence { next(content) }.toList()
                } catch (e: BufferUnderflowException) {
                    throw InputError("its header has a broken list of channels: save it again.", e)
                }
            if (channels.map { it.name } !in READ) {
                throw InputError("its channels are ${shown(channels)}, not RGB, RGBA or Y with or without A: save those only.")
            }
            channels.forEach { it.check() }
            return channels
        }

        private fun next(content: ByteBuffer): ExrChannel? {
            val name = content.text()
            if (name.isEmpty()) return null
            val type = content.getInt()
            // How an 8-bit version should be made, and three bytes for later.
            content.getInt()
            return ExrChannel(name, type, content.getInt(), content.getInt())
        }

        private fun shown(channels: List<ExrChannel>): String {
            val names = channels.take(8).map { it.name.take(32).replace(Regex("[^ -~]"), "?") }
            return if (names.isEmpty()) "none" else names.joinToString() + if (channels.size > names.size) ", …" else ""
        }
    }
}

package cga.reader.spirv

import java.nio.ByteBuffer
import java.nio.ByteOrder

private const val MAGIC = 0x07230203
private const val HEADER_WORDS = 5
private const val MAX_WORDS = 1 shl 22

/** The instructions of a binary module, each with its line. Throws [UnreadableException]. */
internal fun instructions(binary: ByteArray): List<Instruction> {
    if (binary.size % 4 != 0 || binary.size < 4 * HEADER_WORDS) throw UnreadableException("${binary.size} bytes are no SPIR-V module")
    val words = IntArray(binary.size / 4).also { ByteBuffer.wrap(binary).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().get(it) }
    if (words[0] != MAGIC) throw UnreadableException("SPIR-V begins with %08x, not with %08x".format(MAGIC, words[0]))
    if (words.size > MAX_WORDS) throw UnreadableException("${words.size} words of SPIR-V; at most $MAX_WORDS can be read")
    return buildList {
        var at = HEADER_WORDS
        var line = 0
        while (at < words.size) {
            val length = words[at] ushr 16
            val code = words[at] and 0xffff
            val op = Op.of(code) ?: throw UnreadableException("SPIR-V's instruction $code is not known, at word $at", line)
            val first = at + 1 + (if (op.hasType) 1 else 0) + (if (op.hasId) 1 else 0)
            if (length == 0 || at + length > words.size || first > at + length) {
                throw UnreadableException("$op at word $at has $length words, which cannot be", line)
            }
            val type = if (op.hasType) words[at + 1] else 0
            val id = if (op.hasId) words[first - 1] else 0
            val instruction = Instruction(op, type, id, words.copyOfRange(first, at + length), line)
            line = when (op) {
                Op.LINE -> instruction.operands.getOrElse(1) { 0 }
                Op.NO_LINE, Op.FUNCTION_END -> 0
                else -> line
            }
            add(instruction)
            at += length
        }
    }
}

/** The text that begins at operand [start]: UTF-8, four bytes a word, ended by a zero. */
internal fun Instruction.text(start: Int): String {
    val bytes = from(start).flatMap { word -> List(4) { (word ushr (8 * it)).toByte() } }
    return String(bytes.takeWhile { it != 0.toByte() }.toByteArray())
}

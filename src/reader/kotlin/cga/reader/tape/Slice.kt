package cga.reader.tape

import cga.reader.shader.Slot
import cga.reader.shader.Source
import java.util.BitSet

/** Everything that some numbers of a tape were computed from. */
public class Slice internal constructor(
    private val tape: Tape,
    private val entries: BitSet,
    private val given: Set<Int>,
) {
    /** Uniforms, samplers among them, and inputs. */
    public val slots: Set<Slot>
        get() = given
            .mapNotNull {
                when (val source = tape.source(it)) {
                    is Source.Uniform -> source.slot
                    is Source.Input -> source.slot
                    else -> null
                }
            }.toSet()

    /** Everything that no operation made, component by component. */
    public val sources: Set<Source> get() = given.map(tape::source).toSet()

    /** The lines that had a part in it. */
    public val lines: Set<Int> get() = entries().map(tape::line).toSortedSet()

    /** The entries, in order. */
    public fun entries(): List<Int> = entries.stream().boxed().toList()

    public operator fun contains(entry: Int): Boolean = entries[entry]
}

/**
 * What the numbers of [references] come from, step by step; with [isGuarded] also what decided that those steps ran. That a branch was
 * not taken leaves no trace: what it would have assigned is not known.
 */
public fun Tape.slice(vararg references: Int, isGuarded: Boolean = false): Slice {
    val entries = BitSet(size)
    val given = HashSet<Int>()

    fun take(reference: Int) {
        if (reference >= 0) entries.set(reference) else given += reference
    }
    references.forEach(::take)
    // Operands and guards come before what uses them.
    var entry = entries.previousSetBit(size)
    while (entry >= 0) {
        repeat(operandCount(entry)) { take(operand(entry, it)) }
        if (isGuarded && guard(entry) >= 0) entries.set(guard(entry))
        entry = entries.previousSetBit(entry - 1)
    }
    return Slice(this, entries, given)
}

/** The entries that line [line] made. */
public fun Tape.entriesOfLine(line: Int): List<Int> = (0 until size).filter { line(it) == line }

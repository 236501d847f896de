package cga.coach.calls

import org.lwjgl.system.MemoryUtil
import org.lwjgl.system.libffi.LibFFI

/**
 * A call of an OpenGL function on its way to the driver.
 *
 * @property name of the function.
 */
public class Call(
    public val name: String,
    private val cif: Long,
    private val function: Long,
    private val result: Long,
    private val arguments: Long,
) {
    /** Argument number [index] as an integer, likewise the others; arguments are numbered from 0. */
    public fun int(index: Int): Int = MemoryUtil.memGetInt(at(index))

    public fun float(index: Int): Float = MemoryUtil.memGetFloat(at(index))

    public fun long(index: Int): Long = MemoryUtil.memGetLong(at(index))

    /** Puts [value] in the place of argument number [index]. */
    public fun setInt(
        index: Int,
        value: Int,
    ): Unit = MemoryUtil.memPutInt(at(index), value)

    /** Puts [value] in the place of argument number [index]. */
    public fun setFloat(
        index: Int,
        value: Float,
    ): Unit = MemoryUtil.memPutFloat(at(index), value)

    /** Puts [address] in the place of argument number [index]. */
    public fun setLong(
        index: Int,
        address: Long,
    ): Unit = MemoryUtil.memPutLong(at(index), address)

    /** What the caller is answered; libffi widens integers to a register. */
    public var answer: Int
        get() = MemoryUtil.memGetInt(result)
        set(value) = MemoryUtil.memPutLong(result, value.toLong())

    /** Lets the driver do it, with the arguments as they are now. */
    public fun proceed(): Unit = LibFFI.nffi_call(cif, function, result, arguments)

    private fun at(index: Int) = MemoryUtil.memGetAddress(arguments + index * Long.SIZE_BYTES)
}

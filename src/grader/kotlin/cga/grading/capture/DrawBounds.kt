package cga.grading.capture

/** Where in its buffers a draw reads. */
public object DrawBounds {
    /**
     * The largest of [count] indices of [bytes] bytes each that begin at byte [first] of [buffer]; −1 when there are none, null when they
     * do not all lie in the buffer.
     */
    public fun largestIndex(
        buffer: ByteArray,
        bytes: Int,
        first: Long,
        count: Int,
    ): Long? {
        if (first < 0 || count < 0 || first + count.toLong() * bytes > buffer.size) return null
        var largest = -1L
        var at = first.toInt()
        repeat(count) {
            var index = 0L
            for (byte in bytes - 1 downTo 0) index = index shl 8 or (buffer[at + byte].toLong() and 0xFF)
            if (index > largest) largest = index
            at += bytes
        }
        return largest
    }

    /** Whether vertex [last] of [attribute] lies in a buffer of [size] bytes. */
    public fun holds(
        attribute: CapturedAttribute,
        last: Long,
        size: Int,
    ): Boolean {
        val bytes = attribute.size * (GlNumbers.attributeBytes(attribute.type) ?: return false)
        val stride = if (attribute.stride == 0) bytes else attribute.stride
        if (last < 0) return true
        if (attribute.offset < 0 || attribute.offset > size || stride < 0) return false
        return last <= Int.MAX_VALUE && attribute.offset + last * stride + bytes <= size
    }
}

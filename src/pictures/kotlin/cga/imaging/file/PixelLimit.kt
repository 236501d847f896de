package cga.imaging.file

import cga.framework.InputError

/** Largest picture that is read: a little more than 8K (7680×4320). As floats it takes 512 MiB. */
internal const val MAX_PIXELS: Long = 1L shl 25

/** Longest side of one. */
private const val MAX_SIDE = 1L shl 15

/** A byte of deflated data grows to at most so many (zlib's technical details, "maximum compression factor"). */
private const val MAX_INFLATION = 1032L

/** Checks the size that a header tells, before any memory is taken for it. Throws [InputError] where it is empty or too large. */
internal fun checkSize(
    width: Long,
    height: Long,
) {
    if (width < 1 || height < 1) throw InputError("its size is ${width}x$height: save it again.")
    if (width > MAX_SIDE || height > MAX_SIDE || width * height > MAX_PIXELS) {
        throw InputError("its size is ${width}x$height; at most $MAX_PIXELS pixels are read, $MAX_SIDE a side: make it smaller.")
    }
}

/**
 * Throws [InputError] where [stored] bytes cannot grow to the [raw] ones that the header's size takes: so the memory taken is bounded by
 * the file, whatever its header says.
 */
internal fun checkStored(
    raw: Long,
    stored: Int,
) {
    if (raw > MAX_INFLATION * (stored + 1L)) throw InputError("its $stored bytes of data are too few for its size: save it again.")
}

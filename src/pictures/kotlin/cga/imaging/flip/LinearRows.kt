package cga.imaging.flip

/** A picture as LDR-ꟻLIP wants it: linear RGB in 0..1, row by row from top to bottom. */
internal interface LinearRows {
    val width: Int
    val height: Int

    fun read(
        y: Int,
        row: ColorRow,
    )
}

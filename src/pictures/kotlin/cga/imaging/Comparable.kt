package cga.imaging

import cga.framework.InputError

/** Throws [InputError] unless the two have the same size, kind and channels; the message says both of what differs. */
internal fun requireComparable(
    expected: Picture,
    actual: Picture,
) {
    fun check(
        what: String,
        cure: String,
        property: (Picture) -> String,
    ) {
        val (wanted, found) = property(expected) to property(actual)
        if (wanted != found) throw InputError("the pictures differ in $what: $wanted is expected, and $found was given. $cure")
    }
    check("size", "Render both in the same size.") { "${it.width}x${it.height}" }
    check("kind", "Save both as PNG, or both as OpenEXR.") { if (it is BytePicture) "8 bits a channel" else "float" }
    check("channels", "Save both with alpha, or both without.") { if (it.hasAlpha) "alpha" else "no alpha" }
}

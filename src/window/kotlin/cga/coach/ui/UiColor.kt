package cga.coach.ui

/** The colours of what is written and drawn on and over the panels, 0xRRGGBBAA. */
internal object UiColor {
    const val TEXT: Long = 0xE6E8ECFF
    const val FAINT: Long = 0x98A2B3FF
    const val WARNING: Long = 0xFFC857FF
    const val ERROR: Long = 0xFF6B6BFF
    const val GOOD: Long = 0x5BE495FF
    const val DARK: Long = 0x000000C0
    const val DIVIDER: Long = 0xFFFFFFD0

    /** Behind words that lie on the picture. */
    const val BACKDROP: Long = 0x10141CC0
}

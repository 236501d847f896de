package cga.imaging.file

/** What a file is that is neither PNG nor OpenEXR, by how it begins. */
internal object ForeignFormat {
    private class Sign(
        val name: String,
        val at: Int,
        val text: String,
    )

    private val SIGNS =
        listOf(
            Sign("a JPEG", 0, "\u00FF\u00D8\u00FF"),
            Sign("a GIF", 0, "GIF8"),
            Sign("a WebP", 8, "WEBP"),
            Sign("an AVIF", 4, "ftypavif"),
            Sign("a HEIC", 4, "ftypheic"),
            Sign("a JPEG XL", 0, "\u00FF\u000A"),
            Sign("a JPEG XL", 4, "JXL "),
            Sign("a TIFF", 0, "II*\u0000"),
            Sign("a TIFF", 0, "MM\u0000*"),
            Sign("a Radiance HDR", 0, "#?"),
            Sign("a Photoshop file", 0, "8BPS"),
            Sign("a DDS texture", 0, "DDS "),
            Sign("a QOI", 0, "qoif"),
            Sign("a PDF", 0, "%PDF"),
            Sign("a BMP", 0, "BM"),
            Sign("an MNG animation", 0, "\u008AMNG"),
            Sign("a PNG that was changed on its way, as by a transfer as text", 0, "\u0089PNG"),
        )

    /** Such as "a JPEG"; null for one that is not known. */
    fun of(file: ByteArray): String? {
        val start = String(file, 0, minOf(16, file.size), Charsets.ISO_8859_1)
        val isPnm = start.length > 2 && start[0] == 'P' && start[1] in '1'..'7' && start[2].isWhitespace()
        return if (isPnm) "a PNM" else SIGNS.find { start.startsWith(it.text, it.at) }?.name
    }
}

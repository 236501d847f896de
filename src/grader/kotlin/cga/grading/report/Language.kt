package cga.grading.report

/** The languages that reports are written in; [code] as in HTML. */
public enum class Language(
    public val code: String,
) {
    ENGLISH("en"),
    GERMAN("de"),
}

package cga.grading.report

import cga.imaging.report.pictureFigure
import cga.imaging.report.slider
import kotlinx.html.FlowContent
import kotlinx.html.div
import kotlinx.html.p

/** The picture against the expected one, with a slider; further whole pictures below. */
internal fun FlowContent.mainPicture(pictures: EvidencePictures, messages: Messages) {
    val first = pictures.main.firstOrNull() ?: return
    val expected = first.expected
    val title =
        when {
            pictures.areRepaired -> "page.picture-repaired"
            expected == null -> "page.picture-alone"
            else -> "page.picture"
        }
    part(messages.text(title)) {
        if (expected != null) {
            div("main-picture") { slider(first.measured, expected, first.own, messages.text("page.expected")) }
        }
        div("pairing") { pair(first, messages) }
        for (view in pictures.main.drop(1)) {
            p("caption") { +cleanLine(messages.say(view.evidence.title)) }
            div("pairing") { pair(view, messages) }
        }
    }
}

/** Every light alone, and whatever else was looked at apart. */
internal fun FlowContent.lights(pictures: EvidencePictures, messages: Messages) {
    if (pictures.others.isEmpty()) return
    part(messages.text("page.lights")) {
        p("note") { +messages.text("page.lights-about") }
        div("lights") {
            for (view in pictures.others) {
                div {
                    p("caption") { +cleanLine(messages.say(view.evidence.title)) }
                    div("pairing") { pair(view, messages) }
                }
            }
        }
    }
}

/** What was drawn, and what should have been, side by side; this is where the page carries them. */
internal fun FlowContent.pair(view: EvidenceView, messages: Messages) {
    pictureFigure(view.measured, view.own)
    view.expected?.let { pictureFigure(it, messages.text("page.expected")) }
}

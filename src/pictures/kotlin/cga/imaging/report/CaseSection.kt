package cga.imaging.report

import cga.imaging.BytePicture
import cga.imaging.Comparison
import cga.imaging.Severity
import cga.imaging.change
import cga.imaging.figures
import cga.imaging.flip.FlipMap
import cga.imaging.values
import cga.imaging.written
import kotlinx.html.FlowContent
import kotlinx.html.bdi
import kotlinx.html.dd
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.dl
import kotlinx.html.dt
import kotlinx.html.h2
import kotlinx.html.h3
import kotlinx.html.id
import kotlinx.html.img
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.summary
import kotlinx.html.ul

/** All that is known of one case. Those that passed are folded up. */
internal fun FlowContent.case(view: CaseView) {
    val case = view.case
    section("case ${case.severity.style}") {
        id = view.id
        attributes["data-severity"] = case.severity.style
        details {
            open = case.severity != Severity.PASS
            summary {
                badge(case.severity)
                h2 { bdi { +case.name } }
            }
            if (case.messages.isNotEmpty()) ul("messages") { case.messages.forEach { li { +it } } }
            view.pair?.let { pair(it) }
            notes(view).forEach { p("note") { +it } }
            val picture = view.picture
            if (picture == null) {
                div { facts(case) }
            } else {
                div("halves") {
                    pictureFigure(picture, if (case.comparison == null) ALONE else IDENTICAL)
                    div { facts(case) }
                }
            }
        }
    }
}

private const val ALONE = "Actual, with nothing to compare it to"
private const val IDENTICAL = "Expected and actual are identical"

private fun FlowContent.facts(case: ReportCase) {
    if (case.facts.isEmpty()) return
    h3 { +"How the picture was made" }
    pairs(case.facts)
}

private fun FlowContent.pair(pair: PairView) {
    div("pictures") {
        pictureFigure(pair.expected, "Expected")
        pictureFigure(pair.actual, "Actual")
        differenceFigure(pair.expected, pair.actual, pair.gain, pair.marks, choice = true)
        pictureFigure(pair.flip, "ꟻLIP", pair.marks) { colorBar() }
    }
    div("halves") {
        slider(pair.expected, pair.actual, "Expected", "Actual")
        div {
            h3 { +"Figures" }
            pairs(figures(pair.comparison))
        }
    }
    div("halves") {
        div { pair.zooms.forEach { zoom(it, pair) } }
        div("histograms") {
            histogram("Pixels by difference", axis(pair.comparison), differenceBars(pair.comparison))
            histogram("Pixels by ꟻLIP", "ꟻLIP error", flipBars(pair.comparison.flip))
        }
    }
}

private fun FlowContent.zoom(zoom: ZoomView, pair: PairView) {
    h3 { +zoom.title }
    div("zoom") {
        val (expected, actual) = pair.comparison.expected to pair.comparison.actual
        val (wanted, found) = (zoom.pixel?.let { values(expected, it) }) to (zoom.pixel?.let { values(actual, it) })
        pictureFigure(zoom.expected, "Expected", zoom.marks) { wanted?.let { p { +written(it) } } }
        pictureFigure(zoom.actual, "Actual", zoom.marks) { found?.let { p { +written(it) } } }
        differenceFigure(zoom.expected, zoom.actual, pair.gain, zoom.marks) {
            if (wanted != null && found != null) p { +change(wanted, found) }
        }
    }
}

/** From 0, as dark as ꟻLIP's maps begin, to 1. */
private fun FlowContent.colorBar() {
    div("colorbar") {
        span { +"0" }
        img(alt = "", src = COLOR_BAR)
        span { +"1" }
    }
}

private val COLOR_BAR = EmbeddedPicture("", "", FlipMap(64, 1, FloatArray(64) { it / 63f }).magma()).url

private fun FlowContent.pairs(pairs: List<Pair<String, String>>) {
    dl {
        for ((name, value) in pairs) {
            dt { +name }
            dd { +value }
        }
    }
}

private fun axis(comparison: Comparison) =
    "largest difference of a channel" + if (comparison.expected is BytePicture) ", in 1/255" else ""

private fun notes(view: CaseView): List<String> =
    buildList {
        view.exposure?.let {
            add(
                "The pictures hold floats, drawn at an exposure of ${exposure(it)} and clamped to 0…1. The figures are not.",
            )
        }
        if (view.pair?.isVisible ==
            false
        ) {
            add("They differ by too little, or in alpha only, for the drawn pictures to show it. The figures tell.")
        }
        if (view.reduction > 1) {
            add("The large pictures are drawn at 1/${view.reduction} of their size, to keep this page small.")
            add("Figures and enlarged parts are of the full ones.")
        }
    }

private fun exposure(stops: Int) =
    (if (stops > 0) "+" else "") + "$stops".replace('-', '−') + if (stops in setOf(-1, 1)) " stop" else " stops"

package cga.imaging.report

import kotlinx.html.FlowContent
import kotlinx.html.canvas
import kotlinx.html.div
import kotlinx.html.figcaption
import kotlinx.html.figure
import kotlinx.html.img
import kotlinx.html.label
import kotlinx.html.option
import kotlinx.html.select

/** Something to point at in a picture: the outline of [region], or a [ring] about it where that would be too small to see. */
public class Mark(
    public val region: Region,
    public val ring: Boolean,
)

/** [picture] under a caption, as wide as its place and at least as sharp as it is; this is where the page carries it. */
public fun FlowContent.pictureFigure(
    picture: EmbeddedPicture,
    caption: String,
    marks: List<Mark> = emptyList(),
    below: FlowContent.() -> Unit = {},
) {
    figure("picture") {
        figcaption { +caption }
        div("frame") {
            img(alt = picture.alt, src = picture.url) {
                attributes["id"] = picture.id
                width = "${picture.width}"
                height = "${picture.height}"
            }
            marks(picture.width, picture.height, marks)
        }
        below()
    }
}

/**
 * |[one] − [other]|, channel by channel, times [gain]; drawn by the page's script.
 *
 * @param choice whether there is a list to choose another gain from, for all differences of the same `<section>`.
 */
internal fun FlowContent.differenceFigure(
    one: EmbeddedPicture,
    other: EmbeddedPicture,
    gain: Int,
    marks: List<Mark> = emptyList(),
    choice: Boolean = false,
    below: FlowContent.() -> Unit = {},
) {
    figure("picture") {
        figcaption {
            +"Difference"
            if (choice) gainList(gain)
        }
        div("frame") {
            canvas("difference") {
                width = "${one.width}"
                height = "${one.height}"
                attributes["role"] = "img"
                attributes["aria-label"] = "Difference of: ${one.alt}; ${other.alt}"
                attributes["data-one"] = one.id
                attributes["data-other"] = other.id
                attributes["data-gain"] = "$gain"
            }
            marks(one.width, one.height, marks)
        }
        below()
    }
}

private fun FlowContent.gainList(gain: Int) {
    label("gain") {
        select {
            attributes["aria-label"] = "Amplification of the differences"
            for (choice in GAINS) {
                option {
                    value = "$choice"
                    selected = choice == gain
                    +(if (choice == GAINS.last()) "to white" else "×$choice")
                }
            }
        }
    }
}

private fun FlowContent.marks(width: Int, height: Int, marks: List<Mark>) {
    if (marks.isEmpty()) return
    drawing("marks", width, height, label = null) {
        for (mark in marks) {
            with(mark.region) {
                // Twice, dark below bright: seen on any picture.
                for (stroke in listOf("halo", "line")) {
                    if (mark.ring) {
                        element(
                            "circle",
                            "class" to stroke,
                            "cx" to x + this.width / 2.0,
                            "cy" to y + this.height / 2.0,
                            "r" to width / RING,
                        )
                    } else {
                        element("rect", "class" to stroke, "x" to x, "y" to y, "width" to this.width, "height" to this.height)
                    }
                }
            }
        }
    }
}

/** The choices of how much a difference is amplified; the last shows any difference of 1/255 in full brightness. */
internal val GAINS: List<Int> = listOf(1, 4, 16, 64, 255)

// A ring's radius as a share of the picture's width.
private const val RING = 40.0

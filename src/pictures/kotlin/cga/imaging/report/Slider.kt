package cga.imaging.report

import kotlinx.html.FlowContent
import kotlinx.html.div

/**
 * Two pictures of one size upon each other: [left] to the left of a divider that mouse, finger and arrow keys move, [right] to the
 * right of it; with buttons that flip between the two, once or again and again. The script of the page builds it, from the
 * pictures' places on the page; without script nothing is there.
 */
public fun FlowContent.slider(left: EmbeddedPicture, right: EmbeddedPicture, leftName: String, rightName: String) {
    div("slider") {
        attributes["data-left"] = left.id
        attributes["data-right"] = right.id
        attributes["data-left-name"] = leftName
        attributes["data-right-name"] = rightName
    }
}

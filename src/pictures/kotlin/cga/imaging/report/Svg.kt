package cga.imaging.report

import kotlinx.html.FlowContent
import kotlinx.html.HTMLTag
import kotlinx.html.HtmlTagMarker
import kotlinx.html.TagConsumer
import kotlinx.html.visit

/** An element of a drawing. kotlinx.html knows only `<svg>` itself, and writes a name space to it that HTML does not need. */
@HtmlTagMarker
public class SvgElement(
    name: String,
    attributes: Map<String, String>,
    consumer: TagConsumer<*>,
) : HTMLTag(name, consumer, attributes, inlineTag = false, emptyTag = false) {
    /** An element within this one; [attributes] and text are escaped. */
    public fun element(name: String, vararg attributes: Pair<String, Any>, content: SvgElement.() -> Unit = {}) {
        SvgElement(name, attributes.associate { (key, value) -> key to "$value" }, consumer).visit(content)
    }
}

/** A drawing in units of a [width]×[height] box. [label] is what a reader who does not see it is told; null for a mere ornament. */
public fun FlowContent.drawing(classes: String, width: Int, height: Int, label: String?, content: SvgElement.() -> Unit) {
    val words = if (label == null) mapOf("aria-hidden" to "true") else mapOf("role" to "img", "aria-label" to label)
    SvgElement("svg", mapOf("class" to classes, "viewBox" to "0 0 $width $height") + words, consumer).visit(content)
}

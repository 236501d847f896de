package cga.imaging.report

import cga.framework.AtomicFile
import kotlinx.html.MAIN
import kotlinx.html.body
import kotlinx.html.h1
import kotlinx.html.head
import kotlinx.html.html
import kotlinx.html.lang
import kotlinx.html.main
import kotlinx.html.meta
import kotlinx.html.noScript
import kotlinx.html.p
import kotlinx.html.script
import kotlinx.html.stream.appendHTML
import kotlinx.html.style
import kotlinx.html.title
import kotlinx.html.unsafe
import java.nio.file.Files
import java.nio.file.Path
import java.security.MessageDigest
import java.util.Base64

/** A page in one file: its style, its script and its pictures are in it, and it forbids the browser to load anything else. */
public object HtmlPage {
    private val css = resource("report.css")
    private val js = resource("report.js")

    // Style and script by their hash: nothing that comes in with a name or a message can run or restyle the page.
    private val policy =
        "default-src 'none'; img-src data:; style-src ${hash(css)}; script-src ${hash(js)}; base-uri 'none'; form-action 'none'"

    /** Writes the page to [file], whole or not at all. Throws [cga.framework.InputError] when that is not possible. */
    public fun write(title: String, file: Path, content: MAIN.() -> Unit): Unit =
        AtomicFile.write(file) { temporary ->
            Files.newBufferedWriter(temporary).use { writer ->
                writer.append("<!DOCTYPE html>\n")
                writer.appendHTML(prettyPrint = false).html {
                    lang = "en"
                    head {
                        meta(charset = "utf-8")
                        meta(content = policy) { attributes["http-equiv"] = "Content-Security-Policy" }
                        meta(name = "viewport", content = "width=device-width, initial-scale=1")
                        meta(name = "color-scheme", content = "light dark")
                        title(title)
                        style { unsafe { +css } }
                    }
                    body {
                        main {
                            h1 { +title }
                            noScript { p { +"Differences and sliders are drawn by a script, which this viewer does not run." } }
                            content()
                        }
                        script { unsafe { +js } }
                    }
                }
            }
        }

    private fun resource(name: String): String =
        checkNotNull(HtmlPage::class.java.getResource(name)) { "$name is missing from the program" }.readText()

    private fun hash(text: String): String =
        "'sha256-" + Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(text.toByteArray())) + "'"
}

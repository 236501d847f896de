package cga.grading.report

import cga.framework.AtomicFile
import cga.imaging.report.HtmlPage
import kotlinx.html.MAIN
import kotlinx.html.body
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

/**
 * A page in one file, in the manner of [HtmlPage], whose style and script it shares: pictures, style and scripts are in it, and it forbids
 * the browser to load or run anything else, whatever comes in with a name or a log.
 */
internal object ReportPage {
    private val styles = listOf(resource(HtmlPage::class.java, "report.css"), resource(ReportPage::class.java, "grade.css"))
    private val scripts = listOf(resource(HtmlPage::class.java, "report.js"), resource(ReportPage::class.java, "grade.js"))
    private val policy =
        "default-src 'none'; img-src data:; style-src ${hashes(styles)}; script-src ${hashes(scripts)}; base-uri 'none'; form-action 'none'"

    /** Writes the page to [file], whole or not at all. Throws [cga.framework.InputError] when that is not possible. */
    fun write(title: String, messages: Messages, file: Path, content: MAIN.() -> Unit): Unit =
        AtomicFile.write(file) { temporary ->
            Files.newBufferedWriter(temporary).use { writer ->
                writer.append("<!DOCTYPE html>\n")
                writer.appendHTML(prettyPrint = false).html {
                    lang = messages.language.code
                    head {
                        meta(charset = "utf-8")
                        meta(content = policy) { attributes["http-equiv"] = "Content-Security-Policy" }
                        meta(name = "viewport", content = "width=device-width, initial-scale=1")
                        meta(name = "color-scheme", content = "light dark")
                        title(title)
                        styles.forEach { style { unsafe { +it } } }
                    }
                    body {
                        main {
                            // The shared script speaks English; ours puts these words in.
                            for (word in listOf("flip", "blink", "divider")) {
                                attributes["data-$word"] =
                                    messages.text("page.$word", "{0}", "{1}")
                            }
                            noScript { p { +messages.text("page.no-script") } }
                            content()
                        }
                        scripts.forEach { script { unsafe { +it } } }
                    }
                }
            }
        }

    private fun resource(owner: Class<*>, name: String): String =
        checkNotNull(owner.getResource(name)) { "$name is missing from the program" }.readText()

    private fun hashes(texts: List<String>) =
        texts.joinToString(" ") { text ->
            "'sha256-" + Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(text.toByteArray())) + "'"
        }
}

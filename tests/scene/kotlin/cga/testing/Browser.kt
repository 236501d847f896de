package cga.testing

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.lang.ProcessBuilder.Redirect.DISCARD
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.net.http.WebSocket
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletionStage
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.deleteRecursively
import kotlin.io.path.isExecutable
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.writeBytes

/** A headless Chromium of its own, in which a page gets real mouse and key events; driven over the DevTools protocol. */
class Browser private constructor(program: Path) : AutoCloseable, WebSocket.Listener {
    private val profile = createTempDirectory("cga-browser")
    private val process =
        // Without its sandbox, which root cannot have: it opens our own pages only.
        ProcessBuilder(
            "$program --headless=new --no-sandbox --hide-scrollbars --remote-debugging-port=0 --user-data-dir=$profile about:blank".split(
                ' ',
            ),
        ).redirectOutput(DISCARD)
            .redirectError(DISCARD)
            .start()
    private val answers = ConcurrentHashMap<Int, CompletableFuture<JsonObject>>()
    private val received = CopyOnWriteArrayList<JsonObject>()
    private val message = StringBuilder()
    private val client = HttpClient.newHttpClient()
    private val socket: WebSocket
    private var calls = 0

    init {
        val list = HttpRequest.newBuilder(URI("http://127.0.0.1:${port()}/json/list")).build()
        val targets = Json.parseToJsonElement(client.send(list, HttpResponse.BodyHandlers.ofString()).body()).jsonArray
        val page = targets.map { it.jsonObject }.first { it.text("type") == "page" }
        socket = client.newWebSocketBuilder().buildAsync(URI(page.text("webSocketDebuggerUrl")), this).get(LIMIT_SECONDS, SECONDS)
        for (domain in listOf("Page", "Runtime", "Network", "Log")) call("$domain.enable")
    }

    /** What the page said that a sound page does not: errors and warnings of its script and of the browser. */
    val complaints: List<String>
        get() =
            events("Runtime.exceptionThrown").map { "$it" } + events("Log.entryAdded").map { "$it" } +
                events("Runtime.consoleAPICalled").filter { it.text("type") in setOf("error", "warning", "assert") }.map { "$it" }

    /** The addresses that were asked for, but for those that carry their content. */
    val requests: List<String>
        get() = events(
            "Network.requestWillBeSent",
        ).map { it.getValue("request").jsonObject.text("url") }.filterNot { it.startsWith("data:") }

    /** Opens [file] in a window of [width]×[height] and returns when everything in it has been loaded. */
    fun open(file: Path, width: Int, height: Int, isDark: Boolean = false) {
        received.clear()
        call("Emulation.setDeviceMetricsOverride", "width" to width, "height" to height, "deviceScaleFactor" to 1, "mobile" to false)
        val scheme = mapOf("name" to JsonPrimitive("prefers-color-scheme"), "value" to JsonPrimitive(if (isDark) "dark" else "light"))
        call("Emulation.setEmulatedMedia", "features" to JsonArray(listOf(JsonObject(scheme))))
        call("Page.navigate", "url" to "${file.toUri()}")
        awaitUntil("$file is loaded") { events("Page.loadEventFired").isNotEmpty() }
    }

    /** What the JavaScript [expression] amounts to; a promise's value once it is there. */
    fun evaluate(expression: String): JsonElement {
        val answer = call("Runtime.evaluate", "expression" to expression, "awaitPromise" to true, "returnByValue" to true)
        check("exceptionDetails" !in answer) { "$expression: ${answer["exceptionDetails"]}" }
        return answer.getValue("result").jsonObject["value"] ?: JsonNull
    }

    /** Scrolls the element that [selector] finds first into the window's middle and returns the point [x], [y] (shares of its size) of it. */
    fun pointOf(selector: String, x: Double = 0.5, y: Double = 0.5): Pair<Double, Double> {
        val box =
            evaluate(
                "(() => { const e = document.querySelector(${JsonPrimitive(selector)}); e.scrollIntoView({ block: 'center' });" +
                    " const b = e.getBoundingClientRect(); return [b.left + $x * b.width, b.top + $y * b.height]; })()",
            ).jsonArray
        return box[0].jsonPrimitive.content.toDouble() to box[1].jsonPrimitive.content.toDouble()
    }

    /** Presses the left button at the first of [points], moves to the others, and lets it go at the last. */
    fun drag(vararg points: Pair<Double, Double>) {
        mouse("mousePressed", points.first())
        points.drop(1).forEach { mouse("mouseMoved", it) }
        mouse("mouseReleased", points.last())
    }

    /** Clicks in the middle of what [selector] finds first. */
    fun click(selector: String) = drag(pointOf(selector))

    private fun mouse(type: String, at: Pair<Double, Double>) {
        call(
            "Input.dispatchMouseEvent", "type" to type, "x" to at.first, "y" to at.second, "button" to "left", "buttons" to 1,
            "clickCount" to 1,
        )
    }

    /** Presses and releases a key, as `ArrowLeft`; [code] is its number in the DOM. */
    fun key(name: String, code: Int) {
        for (type in listOf("rawKeyDown", "keyUp")) {
            call("Input.dispatchKeyEvent", "type" to type, "key" to name, "code" to name, "windowsVirtualKeyCode" to code)
        }
    }

    /** A PNG of the whole page, as far down as it goes. */
    fun screenshot(): ByteArray {
        val answer = call("Page.captureScreenshot", "captureBeyondViewport" to true)
        return Base64.getDecoder().decode(answer.text("data"))
    }

    private fun events(method: String) = received.filter { it.text("method") == method }.map { it.getValue("params").jsonObject }

    private fun call(method: String, vararg parameters: Pair<String, Any>): JsonObject {
        val id = ++calls
        val answer = CompletableFuture<JsonObject>().also { answers[id] = it }
        val values = parameters.associate { (name, value) -> name to json(value) }
        val call = mapOf("id" to JsonPrimitive(id), "method" to JsonPrimitive(method), "params" to JsonObject(values))
        socket.sendText("${JsonObject(call)}", true).get(LIMIT_SECONDS, SECONDS)
        val result = answer.get(LIMIT_SECONDS, SECONDS)
        return checkNotNull(result["result"]) { "$method: ${result["error"]}" }.jsonObject
    }

    private fun json(value: Any): JsonElement =
        when (value) {
            is JsonElement -> value
            is Number -> JsonPrimitive(value)
            is Boolean -> JsonPrimitive(value)
            else -> JsonPrimitive("$value")
        }

    override fun onText(socket: WebSocket, data: CharSequence, last: Boolean): CompletionStage<*>? {
        message.append(data)
        if (last) {
            val whole = Json.parseToJsonElement("$message").jsonObject
            message.clear()
            whole["id"]?.let { answers.remove(it.jsonPrimitive.content.toInt())?.complete(whole) } ?: received.add(whole)
        }
        socket.request(1)
        return null
    }

    /** Chromium chooses a free port and writes it to a file. */
    private fun port(): String {
        val file = profile.resolve("DevToolsActivePort")
        awaitUntil("Chromium listens") { Files.exists(file) && file.readText().contains('\n') }
        return file.readLines().first()
    }

    private fun awaitUntil(what: String, isSo: () -> Boolean) {
        val end = System.nanoTime() + SECONDS.toNanos(LIMIT_SECONDS)
        while (!isSo()) {
            check(System.nanoTime() < end && process.isAlive) { "waited in vain until $what" }
            Thread.sleep(10)
        }
    }

    private fun JsonObject.text(name: String) = getValue(name).jsonPrimitive.content

    @OptIn(ExperimentalPathApi::class)
    override fun close() {
        call("Browser.close")
        if (!process.waitFor(LIMIT_SECONDS, SECONDS)) process.destroyForcibly().waitFor()
        profile.deleteRecursively()
    }

    companion object {
        private const val LIMIT_SECONDS = 30L

        /** A new browser. Where there is none the test is skipped, and in CI it fails. */
        fun openOrSkip(): Browser = Browser(find() ?: Need.BROWSER.skip("needs Chromium or Chrome: apt-get install chromium"))

        private fun find() =
            listOf("chromium", "chromium-browser", "google-chrome").firstNotNullOfOrNull { name ->
                System.getenv("PATH").split(':').map { Path(it, name) }.firstOrNull { it.isExecutable() }
            }
    }
}
